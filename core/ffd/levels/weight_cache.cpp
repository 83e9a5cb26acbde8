#include "core/ffd/levels/weight_cache.h"

#include <list>
#include <mutex>
#include <utility>

namespace pbffd {
namespace {

constexpr std::size_t keptParameterizations = 4;
constexpr std::size_t keptBindings = 8;

/// Whether two points weigh the same vertices the same.
bool weighsAlike(const ControlPoint& a, const ControlPoint& b) {
  if (!a.enabled || !b.enabled) {
    return a.enabled == b.enabled;
  }
  return a.rest == b.rest && a.strength == b.strength && a.reach == b.reach;
}

template <class Alike>
bool areAlike(const Level& a, const Level& b, const Alike& alike) {
  if (a.size() != b.size()) {
    return false;
  }
  for (Index j = 0; j < a.size(); ++j) {
    if (!a.shares(j, b) && !alike(a[j], b[j])) {
      return false;
    }
  }
  return true;
}

bool isBoundAlike(const ControlPoint& a, const ControlPoint& b) {
  return a.binding.at == b.binding.at;
}

bool areAlike(const Master& a, const Master& b) {
  if (a.mode != b.mode) {
    return false;
  }
  return a.mode == MasterMode::paper ? a.rest == b.rest : a.value == b.value;
}

/// What weights follow from. The mesh is watched and not held: a mesh that nobody has any more is never asked
/// for.
struct Key {
  std::weak_ptr<const RestMesh> mesh;
  Basis basis;
  Master master;
  std::vector<Level> levels;

  bool matches(const std::shared_ptr<const RestMesh>& wanted, const ControlSet& set) const {
    return !mesh.expired() && mesh.lock() == wanted && basis == set.basis && areAlike(master, set.master);
  }
};

Key keyOf(const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set, std::vector<Level> levels) {
  return {mesh, set.basis, set.master, std::move(levels)};
}

/// The last few results, the most recently used first.
template <class Value>
class Recent {
 public:
  explicit Recent(std::size_t kept) : kept_(kept) {}

  template <class Matches>
  std::shared_ptr<const Value> find(const Matches& matches) {
    const std::lock_guard lock(mutex_);
    entries_.remove_if([](const Entry& entry) { return entry.key.mesh.expired(); });
    for (auto at = entries_.begin(); at != entries_.end(); ++at) {
      if (matches(at->key)) {
        entries_.splice(entries_.begin(), entries_, at);
        return at->value;
      }
    }
    return nullptr;
  }

  void keep(Key key, std::shared_ptr<const Value> value) {
    const std::lock_guard lock(mutex_);
    entries_.push_front({std::move(key), std::move(value)});
    if (entries_.size() > kept_) {
      entries_.pop_back();
    }
  }

 private:
  struct Entry {
    Key key;
    std::shared_ptr<const Value> value;
  };
  std::size_t kept_;
  std::mutex mutex_;
  std::list<Entry> entries_;
};

}  // namespace

struct WeightCache::Entries {
  Recent<Parameterization> parameterizations{keptParameterizations};
  Recent<std::vector<PointWeights>> bindings{keptBindings};
};

WeightCache::WeightCache() : entries_(std::make_unique<Entries>()) {}
WeightCache::~WeightCache() = default;

std::shared_ptr<const Parameterization> WeightCache::parameterization(
    const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set, const Progress& progress) {
  const auto matches = [&](const Key& key) {
    return key.matches(mesh, set) && areAlike(key.levels.front(), set.finest(), weighsAlike);
  };
  if (auto known = entries_->parameterizations.find(matches)) {
    return known;
  }
  // Two threads that ask at once both compute: neither waits for what the other may cancel.
  auto made = std::make_shared<const Parameterization>(
      parameterize(*mesh, set.basis, set.master, set.finest(), progress));
  entries_->parameterizations.keep(keyOf(mesh, set, {set.finest()}), made);
  return made;
}

std::shared_ptr<const std::vector<PointWeights>> WeightCache::bindings(
    const std::shared_ptr<const RestMesh>& mesh, const ControlSet& set, const Progress& progress) {
  const auto matches = [&](const Key& key) {
    if (!key.matches(mesh, set) || key.levels.size() != set.levels.size()) {
      return false;
    }
    // A level weighs the next finer one by its regions, and is bound to the next coarser one by `at`.
    for (std::size_t l = 0; l < set.levels.size(); ++l) {
      const bool isAlike =
          areAlike(key.levels[l], set.levels[l], [&](const ControlPoint& a, const ControlPoint& b) {
            return (l + 1 == set.levels.size() || weighsAlike(a, b)) && (l == 0 || isBoundAlike(a, b));
          });
      if (!isAlike) {
        return false;
      }
    }
    return true;
  };
  if (auto known = entries_->bindings.find(matches)) {
    return known;
  }
  auto made = std::make_shared<const std::vector<PointWeights>>(levelBindings(*mesh, set, progress));
  entries_->bindings.keep(keyOf(mesh, set, set.levels), made);
  return made;
}

}  // namespace pbffd

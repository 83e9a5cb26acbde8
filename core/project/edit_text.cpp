#include "core/base/figures.h"
#include "core/base/text.h"
#include "core/project/edit.h"

#include <algorithm>
#include <cmath>

// The undo texts: verb, what, how much.

namespace pbffd {
namespace {

std::string vector(const Vec3& v) {
  return format("{}, {}, {}", figures(v.x()), figures(v.y()), figures(v.z()));
}

std::string percent(double factor) {
  return figures(100.0 * factor) + " %";
}

const char* plural(std::size_t count) {
  return count == 1 ? "" : "s";
}

std::string axisWords(const Vec3& axis) {
  static constexpr const char* names[] = {"X", "Y", "Z"};
  for (int k = 0; k < 3; ++k) {
    if (axis == Vec3(axis[k] * Vec3::Unit(k))) {
      return axis[k] < 0.0 ? format("\u2212{}", names[k]) : names[k];
    }
  }
  return vector(axis.stableNormalized());
}

std::string kernelWords(const Basis& basis) {
  switch (basis.kernel) {
    case Kernel::smooth:
      return "Smooth";
    case Kernel::wendland:
      return "Wendland";
    case Kernel::gaussian:
      return format("Gaussian, sigma {}", figures(basis.sigma));
  }
  return {};
}

class Describer {
 public:
  explicit Describer(const Project& before) : before_(before) {}

  std::string operator()(const Place& edit) const {
    const PlacementOptions& options = edit.options;
    return format("Place {} point{} on {} level{}", counted(options.points), plural(options.points),
                  options.levels, plural(options.levels));
  }

  std::string operator()(const Move& edit) const {
    const std::string words = "Move " + points(edit.where);
    return edit.by.size() == 1 ? format("{} by {}", words, vector(edit.by[0])) : words;
  }

  std::string operator()(const Transform& edit) const {
    const std::string who = points(edit.where);
    const std::string rotation = format("{}° about {}", figures(edit.degrees), axisWords(edit.rotationAxis));
    if (edit.scale == Vec3::Ones()) {
      return format("Rotate {} {}", who, rotation);
    }
    const Vec3& s = edit.scale;
    const std::string scale = s == Vec3(Vec3::Constant(s.x()))
                                  ? percent(s.x())
                                  : format("{}, {}, {}", percent(s.x()), percent(s.y()), percent(s.z()));
    return edit.degrees == 0.0 ? format("Scale {} to {}", who, scale)
                               : format("Scale {} to {}, rotate {}", who, scale, rotation);
  }

  std::string operator()(const SetPose& edit) const { return "Set pose of " + name(edit.level, edit.point); }

  std::string operator()(const SetRegion& edit) const {
    return "Edit region of " + name(edit.level, edit.point);
  }

  std::string operator()(const Add& edit) const {
    return edit.name.empty() ? format("Add point {}", edit.id.value_or(before_.nextId)) : "Add " + edit.name;
  }

  std::string operator()(const Remove& edit) const { return "Remove " + points(edit.where); }

  std::string operator()(const Enable& edit) const {
    return (edit.enabled ? "Enable " : "Disable ") + points(edit.where);
  }

  std::string operator()(const Lock& edit) const {
    return (edit.locked ? "Lock " : "Unlock ") + points(edit.where);
  }

  std::string operator()(const Strength& edit) const {
    return format("Set strength of {} to {}", points(edit.where), figures(edit.value));
  }

  std::string operator()(const SetReach& edit) const {
    return format("Let {} reach {}", points(edit.where),
                  edit.value == Reach::all ? "all of the region" : "connected parts");
  }

  std::string operator()(const Refine& edit) const {
    const std::size_t wanted = edit.where.points.size() * static_cast<std::size_t>(std::max(edit.factor, 0));
    return format("Refine {} to {} points", points(edit.where), counted(wanted));
  }

  std::string operator()(const Rename& edit) const {
    const std::string who = name(edit.level, edit.point);
    return edit.name.empty() ? format("Remove the name of {}", who) : format("Rename {} to {}", who, edit.name);
  }

  std::string operator()(const SetLevels& edit) const {
    const int more = edit.count - static_cast<int>(before_.controls.levels.size());
    if (edit.keep && (more == 1 || more == -1)) {
      return more > 0 ? "Add a coarser level" : "Remove the coarsest level";
    }
    return format("Build {} level{}", edit.count, plural(edit.count));
  }

  std::string operator()(const SetMaster& edit) const {
    return format("Set master to {}", edit.mode == MasterMode::paper ? "the paper's" : figures(edit.value));
  }

  std::string operator()(const SetKernel& edit) const { return "Change kernel to " + kernelWords(edit.basis); }

  std::string operator()(const Reset& edit) const {
    return edit.where ? format("Move {} back to rest", points(*edit.where)) : "Reset all points";
  }

  std::string operator()(const Group& edit) const {
    return edit.text.empty() ? format("{} edit{}", counted(edit.edits.size()), plural(edit.edits.size()))
                             : edit.text;
  }

 private:
  /// The point's name, or its number.
  std::string name(const std::optional<int>& level, PointId id) const {
    const auto& levels = before_.controls.levels;
    const int place = level.value_or(static_cast<int>(levels.size())) - 1;
    if (place >= 0 && place < static_cast<int>(levels.size())) {
      const auto found = levels[place].find(id);
      if (found && !levels[place][*found].name.empty()) {
        return levels[place][*found].name;
      }
    }
    return format("point {}", id);
  }

  std::string points(const PointSelection& where) const {
    return where.points.size() == 1 ? name(where.level, where.points[0])
                                    : format("{} points", counted(where.points.size()));
  }

  const Project& before_;
};

}  // namespace

std::string describe(const Project& before, const Edit& edit) {
  return std::visit(Describer(before), edit.value());
}

}  // namespace pbffd

#include "tests/quality/solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <span>
#include <vector>

namespace pbffd::test {
namespace {

constexpr double fullTurn = 2.0 * std::numbers::pi;

/// A mesh that grows by a vertex or a face at a time.
class Growing {
 public:
  Index addVertex(const Vec3& place) {
    places_.push_back(place);
    return static_cast<Index>(places_.size() - 1);
  }
  void addFace(std::initializer_list<Index> corners) {
    faces_.add(std::span<const Index>(corners.begin(), corners.size()));
  }
  /// Quads between two rings of as many vertices; `outer` lies further along the rings' normal.
  void addBand(const std::vector<Index>& inner, const std::vector<Index>& outer) {
    for (std::size_t i = 0; i < inner.size(); ++i) {
      const std::size_t next = (i + 1) % inner.size();
      addFace({inner[i], inner[next], outer[next], outer[i]});
    }
  }
  void addFan(const std::vector<Index>& ring, const Vec3& tip) {
    const Index at = addVertex(tip);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      addFace({ring[i], ring[(i + 1) % ring.size()], at});
    }
  }
  const Vec3& place(Index vertex) const { return places_[vertex]; }

  Mesh mesh() const {
    Mesh mesh;
    mesh.positions.resize(static_cast<Eigen::Index>(places_.size()), 3);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      mesh.positions.row(static_cast<Eigen::Index>(i)) = places_[i];
    }
    mesh.faces = faces_;
    return mesh;
  }

 private:
  std::vector<Vec3> places_;
  decltype(Mesh::faces) faces_;
};

/// The surface of a grid of cells; vertices are named by their place in the grid.
class GridSurface {
 public:
  explicit GridSurface(const BarSize& size) : size_(size) {}

  Mesh mesh() {
    const int a = size_.across;
    for (int i = 0; i < size_.along; ++i) {
      for (int j = 0; j < a; ++j) {
        addQuad({i, j, 0}, {i, j + 1, 0}, {i + 1, j + 1, 0}, {i + 1, j, 0});
        addQuad({i, j, a}, {i + 1, j, a}, {i + 1, j + 1, a}, {i, j + 1, a});
        addQuad({i, 0, j}, {i + 1, 0, j}, {i + 1, 0, j + 1}, {i, 0, j + 1});
        addQuad({i, a, j}, {i, a, j + 1}, {i + 1, a, j + 1}, {i + 1, a, j});
      }
    }
    const int end = size_.along;
    for (int i = 0; i < a; ++i) {
      for (int j = 0; j < a; ++j) {
        addQuad({0, i, j}, {0, i, j + 1}, {0, i + 1, j + 1}, {0, i + 1, j});
        addQuad({end, i, j}, {end, i + 1, j}, {end, i + 1, j + 1}, {end, i, j + 1});
      }
    }
    return growing_.mesh();
  }

 private:
  using Cell = std::array<int, 3>;

  Index vertex(const Cell& cell) {
    const auto [at, isNew] = vertices_.try_emplace(cell, 0);
    if (isNew) {
      const auto across = [&](int i) { return size_.width * (static_cast<double>(i) / size_.across - 0.5); };
      at->second = growing_.addVertex({size_.length * cell[0] / size_.along, across(cell[1]), across(cell[2])});
    }
    return at->second;
  }
  void addQuad(const Cell& a, const Cell& b, const Cell& c, const Cell& d) {
    growing_.addFace({vertex(a), vertex(b), vertex(c), vertex(d)});
  }

  BarSize size_;
  Growing growing_;
  std::map<Cell, Index> vertices_;
};

/// The rings of a trunk, without the vertices inside the branch's patch, which starts at segment 0.
class Trunk {
 public:
  Trunk(const CactusSize& size, Growing& growing)
      : size_(size), firstRing_(size.branchRing - size.across / 2), growing_(growing) {
    for (int r = 0; r < size.rings; ++r) {
      for (int s = 0; s < size.segments; ++s) {
        const double around = fullTurn * (s - 0.5 * size.across) / size.segments;
        const Vec3 place(size.length * r / (size.rings - 1), size.radius * std::cos(around),
                         size.radius * std::sin(around));
        vertices_.push_back(isInsidePatch(r, s) ? Index{} : growing.addVertex(place));
      }
    }
  }

  void addFaces() {
    for (int r = 0; r + 1 < size_.rings; ++r) {
      for (int s = 0; s < size_.segments; ++s) {
        const bool inPatch = r >= firstRing_ && r < firstRing_ + size_.across && s < size_.across;
        if (!inPatch) {
          growing_.addFace({at(r, s), at(r, s + 1), at(r + 1, s + 1), at(r + 1, s)});
        }
      }
    }
    std::vector<Index> first;
    std::vector<Index> last;
    for (int s = 0; s < size_.segments; ++s) {
      first.push_back(at(0, size_.segments - s));
      last.push_back(at(size_.rings - 1, s));
    }
    growing_.addFan(first, Vec3::Zero());
    growing_.addFan(last, {size_.length, 0.0, 0.0});
  }

  /// The patch's border, around +y in the order of the trunk's faces.
  std::vector<Index> border() const {
    const int n = size_.across;
    std::vector<Index> ring;
    for (int side = 0; side < 4; ++side) {
      for (int i = 0; i < n; ++i) {
        const std::array<int, 4> rings = {0, i, n, n - i};
        const std::array<int, 4> segments = {i, n, n - i, 0};
        ring.push_back(at(firstRing_ + rings[side], segments[side]));
      }
    }
    return ring;
  }

 private:
  bool isInsidePatch(int r, int s) const {
    return r > firstRing_ && r < firstRing_ + size_.across && s > 0 && s < size_.across;
  }
  Index at(int r, int s) const { return vertices_[r * size_.segments + s % size_.segments]; }

  CactusSize size_;
  int firstRing_;
  Growing& growing_;
  std::vector<Index> vertices_;
};

/// Where the branch's ring at `share` of its length lies that starts at `root`: the patch's square outline
/// turns into a circle over the first part.
Vec3 branchPlace(const CactusSize& size, const Vec3& root, double around, double share) {
  constexpr double roundFrom = 0.15;
  const double u = std::min(1.0, share / roundFrom);
  const double roundness = u * u * (3.0 - 2.0 * u);
  const double x = size.branchAt() - size.branchRadius * std::cos(around);
  const double z = size.branchRadius * std::sin(around);
  return {std::lerp(root.x(), x, roundness), std::lerp(root.y(), size.reach, share),
          std::lerp(root.z(), z, roundness)};
}

}  // namespace

Mesh squareBar(const BarSize& size) {
  return GridSurface(size).mesh();
}

Mesh cactus(const CactusSize& size) {
  Growing growing;
  Trunk trunk(size, growing);
  trunk.addFaces();
  const std::vector<Index> roots = trunk.border();
  std::vector<Index> ring = roots;
  for (int j = 1; j <= size.branchRings; ++j) {
    std::vector<Index> next;
    for (std::size_t i = 0; i < roots.size(); ++i) {
      const double around =
          fullTurn * (static_cast<double>(i) - 0.5 * size.across) / static_cast<double>(roots.size());
      const double share = static_cast<double>(j) / size.branchRings;
      next.push_back(growing.addVertex(branchPlace(size, growing.place(roots[i]), around, share)));
    }
    growing.addBand(ring, next);
    ring = next;
  }
  growing.addFan(ring, {size.branchAt(), size.reach, 0.0});
  return growing.mesh();
}

}  // namespace pbffd::test

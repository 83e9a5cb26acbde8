#include "resources/samples/generator/sample.h"
#include "resources/samples/generator/surface_details.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pbffd::samples {
namespace {

const Vec3 halfSize{3.0, 0.4, 0.4};
constexpr double rounding = 0.16;
constexpr double grooveDepth = 0.035;
constexpr double grooveWidth = 0.05;

/// Where the bar is cut into faces along an axis: evenly, with three cuts in each rounded edge.
std::vector<double> cutsAlong(double half, int between) {
  std::vector<double> cuts;
  for (const double edge : {0.0, 0.3, 0.65}) {
    cuts.push_back(-half + edge * rounding);
  }
  for (int i = 0; i <= between; ++i) {
    cuts.push_back((half - rounding) * (2.0 * i / between - 1.0));
  }
  for (const double edge : {0.65, 0.3, 0.0}) {
    cuts.push_back(half - edge * rounding);
  }
  return cuts;
}

/// A place on the box, moved onto the box with rounded edges and shallow grooves around it.
Vec3 shaped(const Vec3& onBox) {
  const Vec3 inner =
      onBox.cwiseMax((rounding - halfSize.array()).matrix()).cwiseMin((halfSize.array() - rounding).matrix());
  Vec3 point = inner + rounding * (onBox - inner).normalized();
  const double fromGroove = point.x() - std::round(point.x());
  const bool isEnd = std::abs(point.x()) > halfSize.x() - 0.5;
  const double depth = isEnd ? 0.0 : grooveDepth * std::exp(-std::pow(fromGroove / grooveWidth, 2));
  point.tail<2>() *= 1.0 - depth / halfSize.y();
  return point;
}

/// Vertices of the box's grid, each made when a face first needs it.
class BoxGrid {
 public:
  using Node = std::array<int, 3>;

  explicit BoxGrid(std::array<std::vector<double>, 3> cuts) : cuts_(std::move(cuts)) {}

  int last(int axis) const { return static_cast<int>(cuts_[axis].size()) - 1; }

  Index vertexAt(const Node& node) {
    const auto [entry, isNew] = vertexOf_.emplace(node, static_cast<Index>(points_.size()));
    if (isNew) {
      points_.push_back(shaped({cuts_[0][node[0]], cuts_[1][node[1]], cuts_[2][node[2]]}));
    }
    return entry->second;
  }

  Points points() const {
    Points points(static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      points.row(static_cast<Eigen::Index>(i)) = points_[i];
    }
    return points;
  }

 private:
  std::array<std::vector<double>, 3> cuts_;
  std::map<Node, Index> vertexOf_;
  std::vector<Vec3> points_;
};

/// The faces on one side of the box: across `axis`, at its low or its high end.
void addSide(BoxGrid& grid, int axis, bool isHigh, Polygons& faces) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  for (int j = 0; j < grid.last(v); ++j) {
    for (int i = 0; i < grid.last(u); ++i) {
      std::array<Index, 4> quad;
      for (int c = 0; c < 4; ++c) {
        BoxGrid::Node node;
        node[axis] = isHigh ? grid.last(axis) : 0;
        node[u] = i + (c == 1 || c == 2 ? 1 : 0);
        node[v] = j + (c >= 2 ? 1 : 0);
        quad[isHigh ? c : 3 - c] = grid.vertexAt(node);
      }
      faces.add(quad);
    }
  }
}

}  // namespace

Sample makeBar() {
  Sample sample;
  sample.name = "bar";
  sample.about = "A long bar with rounded edges and grooves";
  BoxGrid grid({cutsAlong(halfSize.x(), 120), cutsAlong(halfSize.y(), 6), cutsAlong(halfSize.z(), 6)});
  for (int axis = 0; axis < 3; ++axis) {
    addSide(grid, axis, false, sample.faces);
    addSide(grid, axis, true, sample.faces);
  }
  sample.positions = grid.points();
  addCreasedNormals(sample, 60.0);
  addBoxTextures(sample);
  addSingleGroup(sample);
  return sample;
}

}  // namespace pbffd::samples

#include "resources/samples/generator/solid_mesh.h"

#include "resources/samples/generator/surface_net.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace pbffd::samples {
namespace {

/// The share of a tile's width that stays free on each side, for faces across the seam.
constexpr double tileMargin = 0.08;

/// Every quad as two triangles, cut along its shorter diagonal.
Polygons cutQuads(const QuadMesh& mesh) {
  Polygons triangles;
  const auto length = [&](Index a, Index b) { return (mesh.positions.row(a) - mesh.positions.row(b)).norm(); };
  for (Index f = 0; f < mesh.faces.size(); ++f) {
    const auto quad = mesh.faces[f];
    const int first = length(quad[0], quad[2]) <= length(quad[1], quad[3]) ? 0 : 1;
    const std::array<Index, 4> from{quad[first], quad[first + 1], quad[first + 2], quad[(first + 3) % 4]};
    triangles.add(std::array<Index, 3>{from[0], from[1], from[2]});
    triangles.add(std::array<Index, 3>{from[0], from[2], from[3]});
  }
  return triangles;
}

/// A bone's cylinder coordinates: x the angle in turns, y the place along the bone, 0 to 1 on the stretch
/// that is its own.
class Unroller {
 public:
  /// The balls at the ends count where `hasStart`, `hasEnd`.
  Unroller(const Bone& bone, bool hasStart, bool hasEnd) : from_(bone.from) {
    const Vec3 axis = bone.to - bone.from;
    along_ = axis.norm() > 1e-9 ? Vec3(axis.normalized()) : Vec3::UnitX();
    low_ = hasStart ? -bone.fromRadius : 0.0;
    length_ = axis.norm() - low_ + (hasEnd ? bone.toRadius : 0.0);
    // The seam runs along the side that is seen least.
    const Vec3 down = std::abs(along_.y()) < 0.9 ? Vec3(-Vec3::UnitY()) : Vec3(-Vec3::UnitX());
    seam_ = (down - along_.dot(down) * along_).normalized();
    side_ = along_.cross(seam_);
  }

  Eigen::Vector2d operator()(const Vec3& point) const {
    const Vec3 d = point - from_;
    const double turns = std::atan2(d.dot(side_), d.dot(seam_)) / (2.0 * std::numbers::pi);
    return {turns < 0.0 ? turns + 1.0 : turns, std::clamp((d.dot(along_) - low_) / length_, 0.0, 1.0)};
  }

  double length() const { return length_; }

 private:
  Vec3 from_;
  Vec3 along_;
  Vec3 seam_;
  Vec3 side_;
  double low_;
  double length_;
};

/// Where a bone is unrolled to: a tile of the texture, and the stretch of its height.
struct Strip {
  Unroller unroll;
  Index tile;
  double bottom;
  double top;
};

/// A chain of bones shares a tile, one above the other; any other bone has a tile of its own.
void appendStrips(const Limb& limb, Index& tiles, std::vector<Strip>& strips) {
  const std::size_t first = strips.size();
  double length = 0.0;
  for (std::size_t b = 0; b < limb.bones.size(); ++b) {
    const bool isFirst = b == 0 || !limb.isChain;
    const bool isLast = b + 1 == limb.bones.size() || !limb.isChain;
    const Unroller unroll(limb.bones[b], isFirst, isLast);
    const double bottom = isFirst ? 0.0 : length;
    length = bottom + unroll.length();
    strips.push_back({unroll, tiles, bottom, length});
    tiles += isLast ? 1 : 0;
  }
  for (std::size_t s = first; s < strips.size(); ++s) {
    const double whole = limb.isChain ? length : strips[s].top;
    strips[s].bottom /= whole;
    strips[s].top /= whole;
  }
}

/// Gives every corner a texture coordinate in the tile of its face's bone.
class Atlas {
 public:
  explicit Atlas(const Solid& solid) {
    Index tiles = 0;
    for (const Limb& limb : solid.limbs()) {
      firstStrip_.push_back(static_cast<Index>(strips_.size()));
      appendStrips(limb, tiles, strips_);
    }
    tilesARow_ = static_cast<Index>(std::ceil(std::sqrt(static_cast<double>(tiles))));
  }

  void addFace(std::span<const Index> corners, const Points& positions, const Solid::Place& place,
               Sample& sample) {
    const Index strip = firstStrip_[place.limb] + place.bone;
    double first = -1.0;
    for (const Index vertex : corners) {
      Eigen::Vector2d at = strips_[strip].unroll(positions.row(vertex));
      if (first < 0.0) {
        first = at.x();
      }
      // All corners of a face lie on the same side of the seam as its first.
      const int turn = at.x() - first > 0.5 ? -1 : at.x() - first < -0.5 ? 1 : 0;
      at.x() += turn;
      sample.textureOfCorner.push_back(rowOf({strip, vertex, turn}, at));
    }
  }

  TextureCoordinates table() const {
    TextureCoordinates table(static_cast<Eigen::Index>(rows_.size()), 2);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      table.row(static_cast<Eigen::Index>(i)) = rows_[i];
    }
    return table;
  }

 private:
  using Key = std::tuple<Index, Index, int>;  ///< strip, vertex, turns added

  Index rowOf(const Key& key, const Eigen::Vector2d& at) {
    const auto [entry, isNew] = rowOf_.emplace(key, static_cast<Index>(rows_.size()));
    if (isNew) {
      const Strip& strip = strips_[std::get<0>(key)];
      const Eigen::Vector2d corner(strip.tile % tilesARow_, strip.tile / tilesARow_);
      const Eigen::Array2d share(at.x(), strip.bottom + (strip.top - strip.bottom) * at.y());
      const Eigen::Array2d inside = (tileMargin + (1.0 - 2.0 * tileMargin) * share).cwiseMax(0.0).cwiseMin(1.0);
      rows_.push_back((corner + inside.matrix()) / tilesARow_);
    }
    return entry->second;
  }

  std::vector<Strip> strips_;
  std::vector<Index> firstStrip_;  ///< one a limb
  Index tilesARow_ = 1;
  std::map<Key, Index> rowOf_;
  std::vector<Eigen::Vector2d> rows_;
};

}  // namespace

Sample meshOfSolid(const Solid& solid, const SolidMeshOptions& options) {
  QuadMesh net = surfaceNet(solid, options.edge);
  Sample sample;
  sample.faces = options.asTriangles ? cutQuads(net) : std::move(net.faces);
  sample.positions = std::move(net.positions);
  sample.normals.resize(sample.positions.rows(), 3);
  for (Eigen::Index v = 0; v < sample.positions.rows(); ++v) {
    sample.normals.row(v) = solid.gradient(sample.positions.row(v)).normalized();
  }
  sample.normalOfCorner = sample.faces.vertices();
  for (const Limb& limb : solid.limbs()) {
    sample.groups.push_back(limb.name);
  }
  Atlas atlas(solid);
  for (Index f = 0; f < sample.faces.size(); ++f) {
    Vec3 middle = Vec3::Zero();
    for (const Index vertex : sample.faces[f]) {
      middle += sample.positions.row(vertex).transpose() / static_cast<double>(sample.faces[f].size());
    }
    const Solid::Place place = solid.nearestBone(middle);
    sample.groupOfFace.push_back(place.limb);
    atlas.addFace(sample.faces[f], sample.positions, place, sample);
  }
  sample.textures = atlas.table();
  return sample;
}

}  // namespace pbffd::samples

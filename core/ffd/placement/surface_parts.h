#pragma once

#include "core/base/lazy.h"
#include "core/ffd/placement/placement.h"
#include "core/ffd/placement/round_space.h"
#include "core/mesh/winding_number.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace pbffd {

/// The connected parts of a mesh, each taken as closed or open, and what is inside the closed ones: the
/// ground that placement stands on. Holds the mesh.
class SurfaceParts {
 public:
  SurfaceParts(std::shared_ptr<const RestMesh> mesh, Surface how);

  const RestMesh& mesh() const { return *mesh_; }
  /// Of the vertices that have a face: others are no place to be near to.
  const Bounds& bounds() const { return bounds_; }
  double diagonal() const { return bounds_.diagonal(); }
  Index count() const { return static_cast<Index>(isClosed_.size()); }
  bool isClosed(Index part) const { return isClosed_[part]; }
  double area(Index part) const { return area_[part]; }
  /// Of all closed or of all open parts.
  double areaOf(bool closed) const;
  Index countOf(bool closed) const;
  /// Parts that are taken as open only because their faces do not agree on which side is out.
  Index inconsistentCount() const { return inconsistentCount_; }
  /// What the closed parts enclose.
  double volume() const { return volume_; }

  /// One a vertex; -1 for a vertex of no face.
  const std::vector<Index>& partOfVertex() const { return partOfVertex_; }
  /// One a triangle of the mesh.
  const std::vector<Index>& partOfTriangle() const { return partOfTriangle_; }

  /// The normal that looks out of the part: turned over where a closed part lies inside out.
  Vec3 vertexNormal(Index vertex) const;
  Vec3 triangleNormal(Index triangle) const;

  /// Whether the point is inside the closed parts, by the winding number.
  bool isInside(const Vec3& point) const { return inside().isInside(working(point)); }
  /// The same for each of the points, in parallel. Throws Cancelled.
  std::vector<bool> insideFlags(const Points& points, const Progress& progress) const;
  /// As insideFlags() for many points in much less time: what no wall parts from a point beside it is on the
  /// same side. One point in 16 is checked by the winding number; if any is wrong, that decides everywhere.
  std::vector<bool> likelyInsideFlags(const Points& points, const Progress& progress) const;
  double windingNumber(const Vec3& point) const { return inside().at(working(point)); }
  /// Whether any part, closed or open, lies between the two points.
  bool isBetween(const Vec3& from, const Vec3& to) const;

 private:
  void nameParts(const std::vector<Index>& partOfFace);
  /// Made when first asked for, so that it can be made beside other work.
  const WindingNumber& inside() const;
  std::vector<Index> closedCorners() const;
  std::vector<std::uint8_t> flagsAlong(const std::vector<Index>& order, const Points& points,
                                       const Progress& progress) const;
  void measure();
  bool isInsideOut(Index triangle) const;
  void turnPartsInsideOut();

  /// Where questions of sides are decided.
  const Points& workingPositions() const { return round_ ? round_->positions() : mesh_->positions(); }
  Vec3 working(const Vec3& point) const { return round_ ? (*round_)(point) : point; }

  std::shared_ptr<const RestMesh> mesh_;
  std::vector<bool> isClosed_;
  std::vector<bool> isWhole_;  ///< closed, whatever it is taken as
  Index inconsistentCount_ = 0;
  Bounds bounds_;
  std::optional<RoundSpace> round_;
  std::vector<bool> isTurned_;
  std::vector<double> area_;
  std::vector<double> signedVolume_;
  double volume_ = 0.0;
  std::vector<Index> partOfVertex_;
  std::vector<Index> partOfTriangle_;
  std::unique_ptr<Lazy<WindingNumber>> inside_;  ///< of the closed parts
  std::unique_ptr<TriangleTree> openParts_;      ///< none where all are closed
};

}  // namespace pbffd

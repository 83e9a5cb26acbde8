#pragma once

#include "core/ffd/placement/placement.h"
#include "core/mesh/winding_number.h"

#include <memory>
#include <vector>

namespace pbffd {

/// The connected parts of a mesh, each taken as closed or open, and what is inside the closed ones: the
/// ground that placement stands on. Holds the mesh.
class SurfaceParts {
 public:
  SurfaceParts(std::shared_ptr<const RestMesh> mesh, Surface how);

  const RestMesh& mesh() const { return *mesh_; }
  Index count() const { return static_cast<Index>(isClosed_.size()); }
  bool isClosed(Index part) const { return isClosed_[part]; }
  double area(Index part) const { return area_[part]; }
  /// Of all closed or of all open parts.
  double areaOf(bool closed) const;
  Index countOf(bool closed) const;
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
  bool isInside(const Vec3& point) const { return inside_->isInside(point); }
  /// The same for each of the points, in parallel. Throws Cancelled.
  std::vector<bool> insideFlags(const Points& points, const Progress& progress) const;
  double windingNumber(const Vec3& point) const { return inside_->at(point); }
  /// Whether any part, closed or open, lies between the two points.
  bool isBetween(const Vec3& from, const Vec3& to) const;

 private:
  std::vector<Index> closedCorners() const;
  void measure();
  void turnPartsInsideOut();

  std::shared_ptr<const RestMesh> mesh_;
  std::vector<bool> isClosed_;
  std::vector<bool> isTurned_;
  std::vector<double> area_;
  std::vector<double> signedVolume_;
  double volume_ = 0.0;
  std::vector<Index> partOfVertex_;
  std::vector<Index> partOfTriangle_;
  std::unique_ptr<WindingNumber> inside_;    ///< of the closed parts
  std::unique_ptr<TriangleTree> openParts_;  ///< none where all are closed
};

}  // namespace pbffd

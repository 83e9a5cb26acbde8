#pragma once

#include "core/mesh/rest_mesh.h"
#include "ui/document/job_runner.h"
#include "ui/views/mesh_actor.h"

#include <QObject>

#include <memory>
#include <vector>

namespace pbffd::ui {

/// A coarse mesh between some vertices of another, built off the UI thread, which goes where that goes. Its
/// normals are those of the whole: of all triangles around.
class StandIn : public QObject {
  Q_OBJECT

 public:
  explicit StandIn(QObject* parent = nullptr);

  /// Begins to build one; what is there stays until it is ready. Of the same mesh and number it is built once.
  void build(const std::shared_ptr<const RestMesh>& mesh, Index mostTriangles);
  void clear();

  bool isReady() const { return !made_.triangles.empty(); }
  bool isBuilding() const { return jobs_.isRunning(); }
  Index triangleCount() const { return static_cast<Index>(made_.triangles.size() / 3); }

  /// Takes its vertices from those of the whole mesh, 3 a slot.
  void follow(const std::vector<float>& positions);
  SurfaceBuffers buffers() const { return {&positions_, &normals_, &made_.triangles}; }

 Q_SIGNALS:
  void ready();

 private:
  struct Made {
    std::vector<Index> slots;  ///< of its vertices, ascending
    std::vector<Index> triangles;
    /// The triangles of the whole mesh around vertex i are [fanStart[i], fanStart[i + 1]): of each the two
    /// other slots.
    std::vector<Index> fanStart;
    std::vector<Index> fans;
  };
  static Made make(const RestMesh& mesh, Index mostTriangles, const Progress& progress);
  static void listFans(const std::vector<Index>& corners, const std::vector<Index>& placeOfVertex, Made& made);

  JobRunner jobs_;
  std::shared_ptr<const RestMesh> mesh_;
  Index mostTriangles_ = 0;
  Made made_;
  std::vector<float> positions_;
  std::vector<float> normals_;
};

}  // namespace pbffd::ui

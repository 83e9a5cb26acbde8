#pragma once

#include "core/mesh/coarse_mesh.h"
#include "ui/document/job_runner.h"
#include "ui/views/mesh_actor.h"

#include <QObject>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace pbffd::ui {

/// A coarse mesh between some vertices of another, built off the UI thread, which goes where that goes. Its
/// normals are those of the whole, of all triangles around, evened out between neighbours: one vertex of a
/// rough surface may look anywhere, and must not darken all that it stands for.
class StandIn : public QObject {
  Q_OBJECT

 public:
  /// What makes the coarse mesh: another one for tests.
  using Coarsen = std::function<CoarseMesh(const RestMesh&, Index mostTriangles, const Progress&)>;
  explicit StandIn(QObject* parent = nullptr, Coarsen coarsen = coarseMesh);

  /// Begins to build one; what is there stays until it is ready. Of the same mesh and number it is built once,
  /// unless that failed.
  void build(const std::shared_ptr<const RestMesh>& mesh, Index mostTriangles);
  void clear();

  bool isReady() const { return !made_.triangles.empty(); }
  bool isBuilding() const { return jobs_.isRunning(); }
  Index triangleCount() const { return static_cast<Index>(made_.triangles.size() / 3); }
  /// As many as were allowed when it was built last; 0 before that.
  Index trianglesAllowed() const { return mostTriangles_; }

  /// Takes its vertices from those of the whole mesh, 3 a slot.
  void follow(const std::vector<float>& positions);
  SurfaceBuffers buffers() const { return {&positions_, &normals_, &made_.triangles}; }

 Q_SIGNALS:
  void ready();
  /// It could not be built; what was there is there still.
  void failed(const QString& message);

 private:
  /// Of each triangle around vertex i the two other corners: [start[i], start[i + 1]) of `others`.
  struct Fans {
    std::vector<Index> start;
    std::vector<Index> others;
  };
  struct Made {
    std::vector<Index> slots;  ///< of its vertices, ascending
    std::vector<Index> triangles;
    Fans whole;   ///< triangles of the whole mesh; the others are slots
    Fans coarse;  ///< its own triangles; the others are vertices of it
  };
  static Made made(const CoarseMesh& coarse, const RestMesh& mesh, const Progress& progress);
  /// Around those vertices that have a place, which is not -1, of so many.
  static Fans fansAround(std::span<const Index> triangles, const std::vector<Index>& placeOfVertex,
                         std::size_t places, const Progress& progress);
  void takePositionsAndNormals(const std::vector<float>& positions);
  void evenNormals();

  Coarsen coarsen_;
  std::shared_ptr<const RestMesh> mesh_;
  Index mostTriangles_ = 0;
  Made made_;
  std::vector<float> positions_;
  std::vector<float> normals_;
  std::vector<float> unevenNormals_;
  /// Last, so that its work ends before what the work reads is gone.
  JobRunner jobs_;
};

}  // namespace pbffd::ui

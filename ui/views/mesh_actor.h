#pragma once

#include "core/mesh/rest_mesh.h"
#include "ui/document/view_state.h"
#include "ui/views/color.h"
#include "ui/views/pass_mapper.h"

#include <memory>
#include <vector>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkFloatArray;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;

namespace pbffd::ui {

/// The buffers that a surface is drawn from, in slots. They are read where they lie, each time that they
/// are said to have changed.
struct SurfaceBuffers {
  const std::vector<float>* positions = nullptr;  ///< 3 a slot
  const std::vector<float>* normals = nullptr;    ///< 3 a slot
  const std::vector<Index>* triangles = nullptr;  ///< 3 a triangle
};

/// The deformed mesh: shaded, with the edges of its polygons, or see-through. A mesh without faces shows its
/// vertices as points.
class MeshActor {
 public:
  explicit MeshActor(vtkRenderer& renderer);
  ~MeshActor();

  /// Null: nothing is drawn. The buffers must live until the next call.
  void setMesh(std::shared_ptr<const RestMesh> mesh, const SurfaceBuffers& buffers);
  /// The floats in the buffers changed: they alone go to the graphics card again, and while a stand-in is shown
  /// not before the mesh is seen again.
  void positionsChanged();

  /// A coarse mesh that can be shown in place of the whole, without edges. Null buffers: none. The buffers must
  /// live until the next call.
  void setStandIn(const SurfaceBuffers& buffers);
  void standInMoved();
  void showStandIn(bool shown);
  /// Whether edges are drawn in the mode that has them.
  void setEdgesWanted(bool wanted);

  struct Colors {
    Rgba surface{};
    Rgba edges{};
    Rgba seeThrough{};
  };
  void setColors(const Colors& colors);
  void setMode(DisplayMode mode);
  void setVisible(bool visible);
  /// How many logical pixels a unit of length has at depth 1 (anywhere, for an orthographic camera), and at
  /// the depth where the mesh is nearest.
  void setPixelsPerUnit(double atUnitDepth, double atNearest);
  void setPixelRatio(double ratio);

 private:
  void clear();
  void setBuffers(const SurfaceBuffers& buffers);
  void updateActors();
  void makeEdges();
  bool areEdgesSeen() const;

  vtkNew<PassMapper> surfaceMapper_;
  vtkNew<vtkActor> surface_;
  vtkNew<vtkPolyData> surfaceData_;
  vtkNew<PassMapper> standInMapper_;
  vtkNew<vtkActor> standIn_;
  vtkNew<vtkPolyData> standInData_;
  vtkNew<PassMapper> edgeMapper_;
  vtkNew<vtkActor> edges_;
  vtkNew<vtkPolyData> edgeData_;
  vtkNew<PassMapper> vertexMapper_;
  vtkNew<vtkActor> vertices_;
  vtkNew<vtkPolyData> vertexData_;
  vtkSmartPointer<vtkPoints> points_;
  vtkSmartPointer<vtkFloatArray> normals_;

  std::shared_ptr<const RestMesh> mesh_;
  Colors colors_;
  DisplayMode mode_ = DisplayMode::wire;
  bool isVisible_ = true;
  bool hasEdges_ = false;
  bool areEdgesWanted_ = true;
  bool isStoodIn_ = false;
  bool movedUnseen_ = false;  ///< while it was stood in for
  double pixelsPerUnitNearest_ = 0.0;
  double roughEdgeLength_ = 0.0;
};

/// The rest mesh as a flat, faint shape behind the present one.
class GhostActor {
 public:
  explicit GhostActor(vtkRenderer& renderer);
  ~GhostActor();

  /// `triangles` in slots. Positions are taken relative to `origin`.
  void setMesh(const RestMesh& mesh, const Vec3& origin, const std::vector<Index>& triangles);
  void clear();
  void setColor(const Rgba& color);
  void setVisible(bool visible);

 private:
  vtkNew<PassMapper> depthMapper_;
  vtkNew<vtkActor> depth_;
  vtkNew<PassMapper> colorMapper_;
  vtkNew<vtkActor> color_;
  vtkNew<vtkPolyData> data_;
};

}  // namespace pbffd::ui

#include "ui/views/mesh_actor.h"

#include "ui/views/mesh_edges.h"
#include "ui/views/shaders.h"
#include "ui/views/vertex_data.h"

#include <algorithm>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace pbffd::ui {
namespace {

/// Edges of this many pixels have faded out: there they lie so close that they would be but dirt.
constexpr float fadedPixels = 4.0F;
/// Edges are not even listed where their mean is so much less than that, that hardly one is seen.
constexpr double farLess = 0.5;
constexpr double vertexPixels = 3.0;

/// The mean length of some of the edges; longest sides count, since they fade last.
double roughEdgeLength(const RestMesh& mesh) {
  const Polygons& faces = mesh.mesh().faces;
  const Index step = std::max<Index>(1, faces.size() / 2000);
  double sum = 0.0;
  int count = 0;
  for (Index f = 0; f < faces.size(); f += step) {
    const auto corners = faces[f];
    double longest = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Index next = corners[(i + 1) % corners.size()];
      longest = std::max(longest, (mesh.positions().row(corners[i]) - mesh.positions().row(next)).norm());
    }
    sum += longest;
    ++count;
  }
  return count > 0 ? sum / count : 0.0;
}

std::vector<Index> countedTo(std::size_t count) {
  std::vector<Index> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = static_cast<Index>(i);
  }
  return numbers;
}

void clearData(vtkPolyData& data) {
  data.Initialize();
  data.Modified();
}

/// Positions and normals; both are borrowed.
void setFloats(vtkPolyData& data, const SurfaceBuffers& buffers) {
  data.SetPoints(borrowedPoints(*buffers.positions));
  data.GetPointData()->SetNormals(borrowedArray(*buffers.normals, 3, "Normals"));
}

void markFloats(vtkPolyData& data) {
  data.GetPoints()->GetData()->Modified();
  data.GetPoints()->Modified();
  data.GetPointData()->GetNormals()->Modified();
}

}  // namespace

MeshActor::MeshActor(vtkRenderer& renderer) {
  useShaders(*surface_, *surfaceMapper_, shaders::meshVertex, shaders::meshFragment);
  surfaceMapper_->SetInputData(surfaceData_);
  useShaders(*standIn_, *standInMapper_, shaders::meshVertex, shaders::meshFragment);
  standInMapper_->SetInputData(standInData_);
  useShaders(*edges_, *edgeMapper_, shaders::edgeVertex, shaders::flatFragment);
  edgeMapper_->SetInputData(edgeData_);
  edgeMapper_->MapDataArrayToVertexAttribute("edgeLength", "length", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  edgeMapper_->setDepth(PassMapper::DepthTest::inFront, false);
  edgeMapper_->setUniform("fadedPixels", fadedPixels);
  useShaders(*vertices_, *vertexMapper_, shaders::flatVertex, shaders::flatFragment);
  vertexMapper_->SetInputData(vertexData_);
  for (vtkActor* actor : {surface_.Get(), standIn_.Get(), edges_.Get(), vertices_.Get()}) {
    actor->VisibilityOff();
    renderer.AddActor(actor);
  }
}

MeshActor::~MeshActor() = default;

void MeshActor::setMesh(std::shared_ptr<const RestMesh> mesh, const SurfaceBuffers& buffers) {
  if (mesh != mesh_) {
    clear();
    mesh_ = std::move(mesh);
  }
  if (mesh_ != nullptr && !buffers.positions->empty()) {
    setBuffers(buffers);
  }
  updateActors();
}

void MeshActor::clear() {
  hasEdges_ = false;
  isStoodIn_ = false;
  clearData(*surfaceData_);
  clearData(*standInData_);
  clearData(*edgeData_);
  clearData(*vertexData_);
  points_ = nullptr;
  normals_ = nullptr;
}

/// Cells and edges stay where they are of the same mesh.
void MeshActor::setBuffers(const SurfaceBuffers& buffers) {
  const bool isFirst = points_ == nullptr;
  movedUnseen_ = false;
  points_ = borrowedPoints(*buffers.positions);
  if (isFirst) {
    roughEdgeLength_ = roughEdgeLength(*mesh_);
  }
  if (buffers.triangles->empty()) {
    vertexData_->SetPoints(points_);
    if (isFirst) {
      vertexData_->SetVerts(cellsOf(countedTo(buffers.positions->size() / 3), 1));
    }
    return;
  }
  normals_ = borrowedArray(*buffers.normals, 3, "Normals");
  surfaceData_->SetPoints(points_);
  surfaceData_->GetPointData()->SetNormals(normals_);
  if (isFirst) {
    surfaceData_->SetPolys(cellsOf(*buffers.triangles, 3));
  }
  if (hasEdges_) {
    edgeData_->SetPoints(points_);
    edgeData_->GetPointData()->SetNormals(normals_);
  }
}

void MeshActor::positionsChanged() {
  movedUnseen_ = isStoodIn_;
  if (points_ == nullptr || isStoodIn_) {
    return;
  }
  points_->GetData()->Modified();
  points_->Modified();
  if (normals_ != nullptr) {
    normals_->Modified();
  }
}

void MeshActor::setStandIn(const SurfaceBuffers& buffers) {
  clearData(*standInData_);
  if (buffers.positions == nullptr) {
    showStandIn(false);
    return;
  }
  setFloats(*standInData_, buffers);
  standInData_->SetPolys(cellsOf(*buffers.triangles, 3));
}

void MeshActor::standInMoved() {
  markFloats(*standInData_);
}

void MeshActor::showStandIn(bool shown) {
  if (shown == isStoodIn_) {
    return;
  }
  isStoodIn_ = shown;
  if (movedUnseen_) {
    positionsChanged();
  }
  updateActors();
}

void MeshActor::setEdgesWanted(bool wanted) {
  if (wanted != areEdgesWanted_) {
    areEdgesWanted_ = wanted;
    updateActors();
  }
}

void MeshActor::setColors(const Colors& colors) {
  colors_ = colors;
  edgeMapper_->setUniform("flatColor", colors.edges);
  vertexMapper_->setUniform("flatColor", colors.surface);
  updateActors();
}

void MeshActor::setMode(DisplayMode mode) {
  mode_ = mode;
  updateActors();
}

void MeshActor::setVisible(bool visible) {
  isVisible_ = visible;
  updateActors();
}

void MeshActor::setPixelsPerUnit(double atUnitDepth, double atNearest) {
  edgeMapper_->setUniform("pixelsPerUnit", static_cast<float>(atUnitDepth));
  pixelsPerUnitNearest_ = atNearest;
  updateActors();
}

void MeshActor::setPixelRatio(double ratio) {
  vertices_->GetProperty()->SetPointSize(static_cast<float>(vertexPixels * ratio));
}

bool MeshActor::areEdgesSeen() const {
  return mode_ == DisplayMode::wire && surfaceData_->GetNumberOfPoints() > 0 &&
         roughEdgeLength_ * pixelsPerUnitNearest_ > farLess * fadedPixels;
}

void MeshActor::makeEdges() {
  const MeshEdges edges = meshEdges(*mesh_);
  edgeData_->SetPoints(points_);
  edgeData_->GetPointData()->SetNormals(normals_);
  edgeData_->SetLines(cellsOf(edges.slots, 2));
  setAttribute(*edgeData_, edges.meanLengths, 1, "length");
  hasEdges_ = true;
}

void MeshActor::updateActors() {
  const bool isSeeThrough = mode_ == DisplayMode::seeThrough;
  for (PassMapper* mapper : {surfaceMapper_.Get(), standInMapper_.Get()}) {
    mapper->setUniform("meshColor", isSeeThrough ? colors_.seeThrough : colors_.surface);
  }
  for (vtkActor* actor : {surface_.Get(), standIn_.Get()}) {
    actor->SetForceOpaque(!isSeeThrough);
    actor->SetForceTranslucent(isSeeThrough);
  }
  surface_->SetVisibility(isVisible_ && !isStoodIn_ && surfaceData_->GetNumberOfPoints() > 0);
  standIn_->SetVisibility(isVisible_ && isStoodIn_);
  vertices_->SetVisibility(isVisible_ && vertexData_->GetNumberOfPoints() > 0);
  const bool edgesSeen = isVisible_ && areEdgesWanted_ && !isStoodIn_ && areEdgesSeen();
  if (edgesSeen && !hasEdges_) {
    makeEdges();
  }
  edges_->SetVisibility(edgesSeen);
}

GhostActor::GhostActor(vtkRenderer& renderer) {
  useShaders(*depth_, *depthMapper_, shaders::flatVertex, shaders::flatFragment);
  depthMapper_->setDrawsColor(false);
  useShaders(*color_, *colorMapper_, shaders::flatVertex, shaders::flatFragment);
  colorMapper_->setDepth(PassMapper::DepthTest::inFront, false);
  for (PassMapper* mapper : {depthMapper_.Get(), colorMapper_.Get()}) {
    mapper->SetInputData(data_);
  }
  for (vtkActor* actor : {depth_.Get(), color_.Get()}) {
    actor->VisibilityOff();
    renderer.AddActor(actor);
  }
}

GhostActor::~GhostActor() = default;

void GhostActor::setMesh(const RestMesh& mesh, const Vec3& origin, const std::vector<Index>& triangles) {
  std::vector<float> positions;
  positions.reserve(3 * static_cast<std::size_t>(mesh.vertexCount()));
  for (const Index vertex : mesh.mortonOrder()) {
    const Vec3 position = mesh.positions().row(vertex).transpose() - origin;
    for (int i = 0; i < 3; ++i) {
      positions.push_back(static_cast<float>(position[i]));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(ownedArray(positions, 3, "Points"));
  data_->SetPoints(points);
  data_->SetPolys(cellsOf(triangles, 3));
}

void GhostActor::clear() {
  clearData(*data_);
}

void GhostActor::setColor(const Rgba& color) {
  colorMapper_->setUniform("flatColor", color);
}

void GhostActor::setVisible(bool visible) {
  const bool isSeen = visible && data_->GetNumberOfPoints() > 0;
  depth_->SetVisibility(isSeen);
  color_->SetVisibility(isSeen);
}

}  // namespace pbffd::ui

#include "ui/views/stroke_actor.h"

#include "ui/views/shaders.h"
#include "ui/views/vertex_data.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>

namespace pbffd::ui {
namespace {

/// Replaces what `data` draws; VTK uploads it once.
void setGeometry(vtkPolyData& data, const VertexList& vertices, const std::vector<Index>& triangles) {
  vtkNew<vtkPoints> points;
  points->SetData(ownedArray(vertices.positions, 3, "Points"));
  data.SetPoints(points);
  data.SetPolys(cellsOf(triangles, 3));
  setAttribute(data, vertices.colors, 4, "color");
  data.Modified();
}

void appendPoint(std::vector<float>& list, const Vec3& point) {
  for (int i = 0; i < 3; ++i) {
    list.push_back(static_cast<float>(point[i]));
  }
}

}  // namespace

void appendPolyline(std::vector<Stroke>& strokes, const std::vector<Vec3>& points, bool closed,
                    const Stroke& like) {
  const std::size_t count = points.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
    Stroke stroke = like;
    stroke.cap = Stroke::Cap::joined;
    stroke.from = points[i];
    stroke.to = points[(i + 1) % count];
    strokes.push_back(stroke);
  }
}

StrokeActor::StrokeActor(vtkRenderer& renderer) {
  useShaders(*actor_, *mapper_, shaders::strokeVertex, shaders::strokeFragment);
  mapper_->SetInputData(data_);
  mapper_->MapDataArrayToVertexAttribute("colorIn", "color", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  mapper_->MapDataArrayToVertexAttribute("ownMC", "own", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  mapper_->MapDataArrayToVertexAttribute("otherMC", "other", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  mapper_->MapDataArrayToVertexAttribute("strokeIn", "stroke", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  mapper_->MapDataArrayToVertexAttribute("styleIn", "style", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  mapper_->setDepth(PassMapper::DepthTest::inFront, false);
  setPixelRatio(1.0);
  setOpacity(1.0);
  actor_->VisibilityOff();
  renderer.AddActor(actor_);
}

StrokeActor::~StrokeActor() = default;

void StrokeActor::setStrokes(const std::vector<Stroke>& strokes) {
  VertexList vertices;
  std::vector<float> owns;
  std::vector<float> others;
  std::vector<float> shapes;
  std::vector<float> styles;
  std::vector<Index> triangles;
  for (const Stroke& stroke : strokes) {
    const auto first = static_cast<Index>(vertices.positions.size() / 3);
    for (int corner = 0; corner < 4; ++corner) {
      const bool isEnd = corner >= 2;
      // VTK drops triangles whose corners coincide, so the ends are attributes and the positions a mere square.
      vertices.add(Vec3(corner % 2, corner / 2, 0), (isEnd ? stroke.colorTo : stroke.colorFrom).data());
      appendPoint(owns, isEnd ? stroke.to : stroke.from);
      appendPoint(others, isEnd ? stroke.from : stroke.to);
      const float side = corner % 2 == 0 ? 1.0F : -1.0F;
      const float own = 0.5F * (isEnd ? stroke.widthTo : stroke.widthFrom);
      const float other = 0.5F * (isEnd ? stroke.widthFrom : stroke.widthTo);
      shapes.insert(shapes.end(), {side, isEnd ? 1.0F : 0.0F, own, other});
      styles.insert(styles.end(), {stroke.dash, stroke.gap, static_cast<float>(stroke.cap)});
    }
    triangles.insert(triangles.end(), {first, first + 1, first + 2, first + 1, first + 3, first + 2});
  }
  setAttribute(*data_, owns, 3, "own");
  setAttribute(*data_, others, 3, "other");
  setAttribute(*data_, shapes, 4, "stroke");
  setAttribute(*data_, styles, 3, "style");
  setGeometry(*data_, vertices, triangles);
  setVisible(!strokes.empty());
}

void StrokeActor::setPixelRatio(double ratio) {
  mapper_->setUniform("pixelRatio", static_cast<float>(ratio));
}

void StrokeActor::setOpacity(double opacity) {
  mapper_->setUniform("opacity", static_cast<float>(opacity));
}

void StrokeActor::setVisible(bool visible) {
  actor_->SetVisibility(visible && data_->GetNumberOfPoints() > 0);
}

FillActor::FillActor(vtkRenderer& renderer) {
  useShaders(*actor_, *mapper_, shaders::fillVertex, shaders::fillFragment);
  mapper_->SetInputData(data_);
  mapper_->MapDataArrayToVertexAttribute("colorIn", "color", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  mapper_->setDepth(PassMapper::DepthTest::inFront, false);
  actor_->VisibilityOff();
  renderer.AddActor(actor_);
}

FillActor::~FillActor() = default;

void FillActor::setFills(const std::vector<Fill>& fills) {
  VertexList vertices;
  std::vector<Index> triangles;
  for (const Fill& fill : fills) {
    for (const Vec3& corner : fill.corners) {
      triangles.push_back(static_cast<Index>(triangles.size()));
      vertices.add(corner, fill.color.data());
    }
  }
  setGeometry(*data_, vertices, triangles);
  setVisible(!fills.empty());
}

void FillActor::setVisible(bool visible) {
  actor_->SetVisibility(visible && data_->GetNumberOfPoints() > 0);
}

}  // namespace pbffd::ui

#include "ui/views/point_actor.h"

#include "ui/views/shaders.h"
#include "ui/views/vertex_data.h"

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

constexpr float hiddenStrength = 0.34F;
/// Room for the widest ring and its halo.
constexpr float spritePixels = 30.0F;

int shapeCode(PointKind kind) {
  switch (kind) {
    case PointKind::interior:
      return 0;
    case PointKind::exterior:
      return 1;
    case PointKind::manual:
      return 2;
    case PointKind::merged:
      return 3;
    case PointKind::curve:
      return 4;
  }
  return 0;
}

void setData(vtkPolyData& data, const std::vector<PointSprite>& sprites, bool onTop) {
  VertexList vertices;
  std::vector<float> styles;
  std::vector<Index> cells;
  for (const PointSprite& sprite : sprites) {
    if (sprite.isOnTop != onTop) {
      continue;
    }
    cells.push_back(static_cast<Index>(cells.size()));
    vertices.add(sprite.position, sprite.color.data());
    const int shape = shapeCode(sprite.shape) + (sprite.isHollow ? 8 : 0);
    styles.insert(styles.end(),
                  {static_cast<float>(shape), sprite.size, static_cast<float>(sprite.marks), sprite.opacity});
  }
  vtkNew<vtkPoints> points;
  points->SetData(ownedArray(vertices.positions, 3, "Points"));
  data.SetPoints(points);
  data.SetVerts(cellsOf(cells, 1));
  setAttribute(data, vertices.colors, 4, "color");
  setAttribute(data, styles, 4, "style");
  data.Modified();
}

}  // namespace

PointActor::PointActor(vtkRenderer& renderer) {
  addPass(hidden_, *plain_, renderer, PassMapper::DepthTest::behind, hiddenStrength);
  addPass(visible_, *plain_, renderer, PassMapper::DepthTest::inFront, 1.0F);
  addPass(onTop_, *top_, renderer, PassMapper::DepthTest::always, 1.0F);
  setPixelRatio(1.0);
}

PointActor::~PointActor() = default;

void PointActor::addPass(Pass& pass, vtkPolyData& data, vtkRenderer& renderer, PassMapper::DepthTest test,
                         float opacity) {
  useShaders(*pass.actor, *pass.mapper, shaders::pointVertex, shaders::pointFragment);
  pass.mapper->SetInputData(&data);
  pass.mapper->MapDataArrayToVertexAttribute("colorIn", "color", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  pass.mapper->MapDataArrayToVertexAttribute("styleIn", "style", vtkDataObject::FIELD_ASSOCIATION_POINTS);
  pass.mapper->setDepth(test, test == PassMapper::DepthTest::inFront);
  pass.mapper->setUniform("opacity", opacity);
  pass.mapper->setUniform("spriteSize", spritePixels);
  pass.actor->VisibilityOff();
  renderer.AddActor(pass.actor);
}

void PointActor::setSprites(const std::vector<PointSprite>& sprites) {
  setData(*plain_, sprites, false);
  setData(*top_, sprites, true);
  hidden_.actor->SetVisibility(plain_->GetNumberOfPoints() > 0);
  visible_.actor->SetVisibility(plain_->GetNumberOfPoints() > 0);
  onTop_.actor->SetVisibility(top_->GetNumberOfPoints() > 0);
}

void PointActor::setColors(const Colors& colors) {
  for (Pass* pass : {&hidden_, &visible_, &onTop_}) {
    pass->mapper->setUniform("haloColor", colors.halo);
    pass->mapper->setUniform("ringColor", colors.ring);
    pass->mapper->setUniform("activeColor", colors.active);
  }
}

void PointActor::setPixelRatio(double ratio) {
  for (Pass* pass : {&hidden_, &visible_, &onTop_}) {
    pass->mapper->setUniform("pixelRatio", static_cast<float>(ratio));
    pass->actor->GetProperty()->SetPointSize(static_cast<float>(spritePixels * ratio));
  }
}

}  // namespace pbffd::ui

#include "ui/views/pass_mapper.h"

#include <qopengl.h>

#include <algorithm>

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLCamera.h>
#include <vtkOpenGLHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>

namespace pbffd::ui {
namespace {

template <class Value>
void setEntry(std::vector<std::pair<std::string, Value>>& list, const std::string& name, const Value& value) {
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.first == name; });
  if (at != list.end()) {
    at->second = value;
  } else {
    list.emplace_back(name, value);
  }
}

GLenum depthFunction(PassMapper::DepthTest test) {
  switch (test) {
    case PassMapper::DepthTest::behind:
      return GL_GREATER;
    case PassMapper::DepthTest::always:
      return GL_ALWAYS;
    case PassMapper::DepthTest::inFront:
      break;
  }
  return GL_LEQUAL;
}

}  // namespace

vtkStandardNewMacro(PassMapper);

PassMapper::PassMapper() {
  SetScalarVisibility(0);
  SetStatic(1);
  // Positions are near the origin already (see LiveDeformation::origin).
  SetVBOShiftScaleMethod(0);
  SetResolveCoincidentTopologyToOff();
}

void PassMapper::setDepth(DepthTest test, bool writes) {
  depthTest_ = test;
  writesDepth_ = writes;
}

void PassMapper::setUniform(const std::string& name, const std::array<float, 4>& value) {
  setEntry(vectors_, name, value);
}

void PassMapper::setUniform(const std::string& name, float value) {
  setEntry(numbers_, name, value);
}

void PassMapper::GetBounds(double bounds[6]) {
  std::copy(bounds_.begin(), bounds_.end(), bounds);
}

void PassMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor) {
  vtkOpenGLState* state = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
  // The peeling of translucent layers sets depth rules of its own.
  const bool hasOwnRules = !actor->IsRenderingTranslucentPolygonalGeometry();
  if (hasOwnRules) {
    state->vtkglDepthFunc(depthFunction(depthTest_));
    state->vtkglDepthMask(writesDepth_ ? GL_TRUE : GL_FALSE);
    if (!drawsColor_) {
      state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    }
  }
  Superclass::RenderPiece(renderer, actor);
  if (hasOwnRules) {
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
}

void PassMapper::SetMapperShaderParameters(vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) {
  Superclass::SetMapperShaderParameters(cells, renderer, actor);
  vtkShaderProgram* program = cells.Program;
  if (program->IsUniformUsed("viewSize")) {
    const int* size = renderer->GetSize();
    const float viewSize[2] = {static_cast<float>(size[0]), static_cast<float>(size[1])};
    program->SetUniform2f("viewSize", viewSize);
  }
  if (program->IsUniformUsed("VCDCMatrix")) {
    vtkMatrix4x4* worldToView = nullptr;
    vtkMatrix3x3* normals = nullptr;
    vtkMatrix4x4* viewToScreen = nullptr;
    vtkMatrix4x4* worldToScreen = nullptr;
    static_cast<vtkOpenGLCamera*>(renderer->GetActiveCamera())
        ->GetKeyMatrices(renderer, worldToView, normals, viewToScreen, worldToScreen);
    program->SetUniformMatrix("VCDCMatrix", viewToScreen);
  }
  for (const auto& [name, value] : vectors_) {
    if (program->IsUniformUsed(name.c_str())) {
      program->SetUniform4f(name.c_str(), value.data());
    }
  }
  for (const auto& [name, value] : numbers_) {
    if (program->IsUniformUsed(name.c_str())) {
      program->SetUniformf(name.c_str(), value);
    }
  }
}

void useShaders(vtkActor& actor, PassMapper& mapper, const char* vertexCode, const char* fragmentCode) {
  actor.SetMapper(&mapper);
  actor.UseBoundsOff();
  actor.PickableOff();
  actor.ForceOpaqueOn();
  actor.GetShaderProperty()->SetVertexShaderCode(vertexCode);
  actor.GetShaderProperty()->SetFragmentShaderCode(fragmentCode);
}

}  // namespace pbffd::ui

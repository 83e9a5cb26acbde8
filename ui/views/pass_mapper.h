#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <vtkOpenGLPolyDataMapper.h>

class vtkActor;

namespace pbffd::ui {

/// The mapper of everything in the view: it draws with shaders of our own, under the depth rule it is
/// told, and never asks its data for bounds (which would cost a pass over all vertices after each change).
class PassMapper : public vtkOpenGLPolyDataMapper {
 public:
  static PassMapper* New();
  vtkTypeMacro(PassMapper, vtkOpenGLPolyDataMapper) PassMapper(const PassMapper&) = delete;
  PassMapper& operator=(const PassMapper&) = delete;

  enum class DepthTest { inFront, behind, always };
  void setDepth(DepthTest test, bool writes);
  /// False: only the depth is drawn.
  void setDrawsColor(bool draws) { drawsColor_ = draws; }

  /// Values for uniforms of that name, where the shader has one. "viewSize" (device pixels) is always
  /// given.
  void setUniform(const std::string& name, const std::array<float, 4>& value);
  void setUniform(const std::string& name, float value);

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  double* GetBounds() override { return bounds_.data(); }
  void GetBounds(double bounds[6]) override;

 protected:
  PassMapper();
  ~PassMapper() override = default;
  void SetMapperShaderParameters(vtkOpenGLHelper& cells, vtkRenderer* renderer, vtkActor* actor) override;

 private:
  DepthTest depthTest_ = DepthTest::inFront;
  bool writesDepth_ = true;
  bool drawsColor_ = true;
  std::vector<std::pair<std::string, std::array<float, 4>>> vectors_;
  std::vector<std::pair<std::string, float>> numbers_;
  std::array<double, 6> bounds_{-1, 1, -1, 1, -1, 1};
};

/// Makes `actor` draw `mapper` with these shaders, in the opaque pass (in the order of adding) whatever its
/// colours' alpha. Nothing of VTK's own lights and materials then counts.
void useShaders(vtkActor& actor, PassMapper& mapper, const char* vertexCode, const char* fragmentCode);

}  // namespace pbffd::ui

// Eye-dome lighting: points are darkened where others nearby stand before them, which shows shapes without normals.
#pragma once

#include <vtkDepthImageProcessingPass.h>
#include <vtkNew.h>

#include <memory>

class vtkOpenGLFramebufferObject;
class vtkOpenGLQuadHelper;
class vtkTextureObject;

namespace remount::scene {

/// After Boucheny (2009). VTK's own vtkEDLShading clears the whole window, so that of two pictures side by side only
/// the last is left; and it draws black rims around everything, also around lines. This one keeps to its viewport,
/// leaves the background and what stands before it as they are, and hands on the depth, so that an overlay still finds
/// it.
class EyeDomePass : public vtkDepthImageProcessingPass {
 public:
  static EyeDomePass* New();
  vtkTypeMacro(EyeDomePass, vtkDepthImageProcessingPass);
  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  /// Distance of the neighbours that are compared, in pixels.
  void set_radius(double pixels) { radius_px_ = pixels; }

 protected:
  EyeDomePass();
  ~EyeDomePass() override;

 private:
  void shade(const vtkRenderState& state, int x, int y);

  vtkNew<vtkOpenGLFramebufferObject> target_;
  vtkNew<vtkTextureObject> color_, depth_;
  std::unique_ptr<vtkOpenGLQuadHelper> quad_;
  double radius_px_ = 1.5;
};

}  // namespace remount::scene

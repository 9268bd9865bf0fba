#include "widgets/scene/eye_dome_pass.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderUtilities.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>

namespace remount::scene {
namespace {

// Of OpenGL, whose header lies elsewhere on every system.
constexpr unsigned kBlend = 0x0BE2, kDepthTest = 0x0B71, kAlways = 0x0207, kLessOrEqual = 0x0203;

constexpr const char* kDeclarations = R"(
uniform sampler2D colors;
uniform sampler2D depths;
uniform vec2 step_of_neighbour;
uniform vec2 clipping_range;
float log_distance(vec2 at) {
  float depth = texture(depths, at).r;
  return log2(clipping_range.x * clipping_range.y /
              (clipping_range.y - depth * (clipping_range.y - clipping_range.x)));
}
)";

constexpr const char* kShading = R"(
  float depth = texture(depths, texCoord).r;
  vec4 color = texture(colors, texCoord);
  gl_FragDepth = depth;
  if (depth < 1.0) {
    float here = log_distance(texCoord), before = 0.0;
    for (int i = 0; i < 8; ++i) {
      float angle = 0.7853982 * float(i);
      before += max(0.0, here - log_distance(texCoord + vec2(cos(angle), sin(angle)) * step_of_neighbour));
    }
    color.rgb *= max(0.25, exp(-12.0 * before));
  }
  gl_FragData[0] = color;
)";

std::string fragment_shader() {
  std::string source = vtkOpenGLRenderUtilities::GetFullScreenQuadFragmentShaderTemplate();
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Decl", kDeclarations);
  vtkShaderProgram::Substitute(source, "//VTK::FSQ::Impl", kShading);
  return source;
}

}  // namespace

vtkStandardNewMacro(EyeDomePass);

EyeDomePass::EyeDomePass() = default;
EyeDomePass::~EyeDomePass() = default;

void EyeDomePass::Render(const vtkRenderState* state) {
  NumberOfRenderedProps = 0;
  vtkRenderer& renderer = *state->GetRenderer();
  auto& window = static_cast<vtkOpenGLRenderWindow&>(*renderer.GetRenderWindow());
  if (!DelegatePass) return;
  int width = 0, height = 0, x = 0, y = 0;
  renderer.GetTiledSizeAndOrigin(&width, &height, &x, &y);
  if (width < 1 || height < 1) return;
  target_->SetContext(&window);
  color_->SetContext(&window);
  depth_->SetContext(&window);
  const auto size = [](int pixels) { return static_cast<unsigned>(pixels); };
  if (color_->GetHandle() != 0) {
    color_->Resize(size(width), size(height));
    depth_->Resize(size(width), size(height));
  } else {
    color_->Allocate2D(size(width), size(height), 4, VTK_UNSIGNED_CHAR);
    depth_->AllocateDepth(size(width), size(height), vtkTextureObject::Float32);
  }
  window.GetState()->PushFramebufferBindings();
  RenderDelegate(state, width, height, width, height, target_, color_, depth_);
  window.GetState()->PopFramebufferBindings();
  shade(*state, x, y);
}

void EyeDomePass::shade(const vtkRenderState& state, int x, int y) {
  vtkRenderer& renderer = *state.GetRenderer();
  auto& window = static_cast<vtkOpenGLRenderWindow&>(*renderer.GetRenderWindow());
  if (!quad_)
    quad_ = std::make_unique<vtkOpenGLQuadHelper>(
        &window, vtkOpenGLRenderUtilities::GetFullScreenQuadVertexShader().c_str(), fragment_shader().c_str(), "");
  else
    window.GetShaderCache()->ReadyShaderProgram(quad_->Program);
  if (!quad_->Program || !quad_->Program->GetCompiled()) return;
  const auto width = static_cast<int>(color_->GetWidth()), height = static_cast<int>(color_->GetHeight());
  vtkOpenGLState& gl = *window.GetState();
  const vtkOpenGLState::ScopedglEnableDisable keep_blend(&gl, kBlend), keep_test(&gl, kDepthTest);
  gl.vtkglDisable(kBlend);
  gl.vtkglEnable(kDepthTest);  // without the test no depth is written
  gl.vtkglDepthFunc(kAlways);
  gl.vtkglViewport(x, y, width, height);
  gl.vtkglScissor(x, y, width, height);
  color_->Activate();
  depth_->Activate();
  quad_->Program->SetUniformi("colors", color_->GetTextureUnit());
  quad_->Program->SetUniformi("depths", depth_->GetTextureUnit());
  const float step[2] = {static_cast<float>(radius_px_ / width), static_cast<float>(radius_px_ / height)};
  quad_->Program->SetUniform2f("step_of_neighbour", step);
  double range[2];
  renderer.GetActiveCamera()->GetClippingRange(range);
  const float near_far[2] = {static_cast<float>(range[0]), static_cast<float>(range[1])};
  quad_->Program->SetUniform2f("clipping_range", near_far);
  quad_->Render();
  depth_->Deactivate();
  color_->Deactivate();
  gl.vtkglDepthFunc(kLessOrEqual);
}

void EyeDomePass::ReleaseGraphicsResources(vtkWindow* window) {
  Superclass::ReleaseGraphicsResources(window);
  quad_.reset();
  target_->ReleaseGraphicsResources(window);
  color_->ReleaseGraphicsResources(window);
  depth_->ReleaseGraphicsResources(window);
}

}  // namespace remount::scene

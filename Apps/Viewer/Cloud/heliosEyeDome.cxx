// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosEyeDome.h"

#include <vtkCamera.h>
#include <vtkCameraPass.h>
#include <vtkDepthImageProcessingPass.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLQuadHelper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkOverlayPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkShaderProgram.h>
#include <vtkTextureObject.h>
#include <vtkTranslucentPass.h>

#include <GL/gl.h>

#include <memory>

namespace helios::viewer
{

namespace
{

// Depth buffer values become distances along the view direction; 1 is the background.
const char* const Shader = R"(//VTK::System::Dec
//VTK::Output::Dec
in vec2 texCoord;
uniform sampler2D colors;
uniform sampler2D depths;
uniform vec2 pixel;
uniform vec2 range;
uniform int isParallel;

float findDistance(vec2 at)
{
  float depth = texture2D(depths, at).r;
  if (depth >= 1.0)
  {
    return -1.0;
  }
  return isParallel != 0 ? mix(range.x, range.y, depth)
                         : range.x * range.y / (range.y - depth * (range.y - range.x));
}

void main()
{
  vec4 color = texture2D(colors, texCoord);
  float depth = texture2D(depths, texCoord).r;
  float here = findDistance(texCoord);
  float sum = 0.0;
  if (here > 0.0)
  {
    for (int i = 0; i < 8; ++i)
    {
      float angle = 0.785398163 * float(i);
      float radius = (i % 2 == 0) ? 1.5 : 3.0;
      float there = findDistance(texCoord + radius * pixel * vec2(cos(angle), sin(angle)));
      sum += there > 0.0 ? clamp(log2(here / there), 0.0, 0.05) : 0.0;
    }
  }
  float shade = 0.45 + 0.55 * exp(-20.0 * sum);
  gl_FragData[0] = vec4(color.rgb * shade, color.a);
  gl_FragDepth = depth;
}
)";

class EyeDomePass : public vtkDepthImageProcessingPass
{
public:
  static EyeDomePass* New();
  vtkTypeMacro(EyeDomePass, vtkDepthImageProcessingPass);

  void Render(const vtkRenderState* state) override
  {
    this->NumberOfRenderedProps = 0;
    vtkRenderer* renderer = state->GetRenderer();
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    this->ReadWindowSize(state);
    this->W = this->Width;
    this->H = this->Height;
    this->SetUpTextures(window);
    vtkOpenGLState* openGl = window->GetState();
    openGl->PushFramebufferBindings();
    this->RenderDelegate(
      state, this->W, this->H, this->W, this->H, this->Target, this->Colors, this->Depths);
    openGl->PopFramebufferBindings();
    this->DrawShaded(renderer, window);
  }

  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Superclass::ReleaseGraphicsResources(window);
    this->Quad.reset();
    this->Target->ReleaseGraphicsResources(window);
    this->Colors->ReleaseGraphicsResources(window);
    this->Depths->ReleaseGraphicsResources(window);
    this->Size[0] = this->Size[1] = 0;
  }

private:
  void SetUpTextures(vtkOpenGLRenderWindow* window)
  {
    if (this->Size[0] == this->W && this->Size[1] == this->H)
    {
      return;
    }
    this->Size[0] = this->W;
    this->Size[1] = this->H;
    const auto width = static_cast<unsigned int>(this->W),
               height = static_cast<unsigned int>(this->H);
    for (vtkTextureObject* texture : { this->Colors.Get(), this->Depths.Get() })
    {
      texture->ReleaseGraphicsResources(window);
      texture->SetContext(window);
      texture->SetMinificationFilter(vtkTextureObject::Nearest);
      texture->SetMagnificationFilter(vtkTextureObject::Nearest);
      texture->SetWrapS(vtkTextureObject::ClampToEdge);
      texture->SetWrapT(vtkTextureObject::ClampToEdge);
    }
    this->Colors->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR);
    this->Depths->AllocateDepth(width, height, vtkTextureObject::Float32);
    this->Target->SetContext(window);
  }

  void DrawShaded(vtkRenderer* renderer, vtkOpenGLRenderWindow* window)
  {
    vtkOpenGLState* openGl = window->GetState();
    if (!this->Quad)
    {
      this->Quad = std::make_unique<vtkOpenGLQuadHelper>(window, nullptr, Shader, nullptr);
    }
    else
    {
      window->GetShaderCache()->ReadyShaderProgram(this->Quad->Program);
    }
    vtkShaderProgram* program = this->Quad->Program;
    if (!program || !program->GetCompiled())
    {
      vtkErrorMacro("The shader of eye-dome lighting cannot be compiled; use --no-eye-dome.");
      return;
    }
    vtkOpenGLState::ScopedglEnableDisable blending(openGl, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable testing(openGl, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglDepthFunc function(openGl);
    openGl->vtkglDisable(GL_BLEND);
    openGl->vtkglEnable(GL_DEPTH_TEST); // depth is written only if it is tested
    openGl->vtkglDepthFunc(GL_ALWAYS);
    openGl->vtkglDepthMask(GL_TRUE);
    openGl->vtkglViewport(this->Origin[0], this->Origin[1], this->W, this->H);
    this->Colors->Activate();
    this->Depths->Activate();
    program->SetUniformi("colors", this->Colors->GetTextureUnit());
    program->SetUniformi("depths", this->Depths->GetTextureUnit());
    const float pixel[2] = { 1.0F / static_cast<float>(this->W),
      1.0F / static_cast<float>(this->H) };
    vtkCamera* camera = renderer->GetActiveCamera();
    const double* ends = camera->GetClippingRange();
    const float range[2] = { static_cast<float>(ends[0]), static_cast<float>(ends[1]) };
    program->SetUniform2f("pixel", pixel);
    program->SetUniform2f("range", range);
    program->SetUniformi("isParallel", camera->GetParallelProjection());
    this->Quad->Render();
    this->Colors->Deactivate();
    this->Depths->Deactivate();
  }

  vtkNew<vtkOpenGLFramebufferObject> Target;
  vtkNew<vtkTextureObject> Colors;
  vtkNew<vtkTextureObject> Depths;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  int Size[2] = { 0, 0 };
};
vtkStandardNewMacro(EyeDomePass);

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkRenderPass> MakeEyeDomePass()
{
  vtkNew<vtkRenderPassCollection> solid;
  solid->AddItem(vtkNew<vtkLightsPass>());
  solid->AddItem(vtkNew<vtkOpaquePass>());
  solid->AddItem(vtkNew<vtkTranslucentPass>());
  vtkNew<vtkSequencePass> steps;
  steps->SetPasses(solid);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(steps);
  vtkNew<EyeDomePass> shading;
  shading->SetDelegatePass(camera);
  vtkNew<vtkRenderPassCollection> all;
  all->AddItem(shading);
  all->AddItem(vtkNew<vtkOverlayPass>());
  auto pass = vtkSmartPointer<vtkSequencePass>::New();
  pass->SetPasses(all);
  return pass;
}

} // namespace helios::viewer

#include "widgets/scene/pair_picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace remount::scene {

struct PairPainter::Parts {
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderWindowInteractor> interactor;  // the scene hangs its mouse style on it
  PairScene scene;
};

PairPainter::PairPainter(int width, int height) : parts_(std::make_unique<Parts>()) {
  parts_->window->SetOffScreenRendering(1);
  parts_->window->SetSize(width, height);
  parts_->interactor->SetRenderWindow(parts_->window);
  parts_->scene.stage().attach(*parts_->window);
  parts_->scene.set_dark(false);
}

PairPainter::~PairPainter() = default;

RgbImage PairPainter::paint(PairSceneDataPtr data, const PairTransforms& transforms, PairAlignment alignment) {
  PairScene& scene = parts_->scene;
  scene.set_pair(std::move(data), transforms);
  scene.show(alignment, alignment == PairAlignment::Before ? 0.0 : 1.0, false);
  scene.stage().look(StandardView::Top);
  parts_->window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(parts_->window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  vtkImageData* image = grab->GetOutput();
  RgbImage picture;
  picture.width = image->GetDimensions()[0];
  picture.height = image->GetDimensions()[1];
  auto* bytes = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (!bytes) return {};
  const std::size_t row = 3U * static_cast<std::size_t>(picture.width);
  picture.rgb.resize(row * static_cast<std::size_t>(picture.height));
  const unsigned char* from = bytes->GetPointer(0);
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height); ++y)  // VTK's rows begin at the bottom
    std::copy_n(from + row * (static_cast<std::size_t>(picture.height) - 1 - y), row,
                picture.rgb.begin() + static_cast<std::ptrdiff_t>(row * y));
  return picture;
}

}  // namespace remount::scene

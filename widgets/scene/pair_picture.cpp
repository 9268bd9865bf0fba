#include "widgets/scene/pair_picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>

namespace remount {

RgbImage picture_of_pair(const PairClouds& clouds, const PairTransforms& transforms, PairAlignment alignment, int width,
                         int height) {
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(width, height);
  vtkNew<vtkRenderWindowInteractor> interactor;  // the scene hangs its mouse style on it
  interactor->SetRenderWindow(window);
  PairScene scene;
  scene.stage().attach(*window);
  scene.set_dark(false);
  // Not owned: the scene ends before this function does.
  scene.set_pair(prepare_pair_scene(std::shared_ptr<const PairClouds>(std::shared_ptr<void>(), &clouds), {}),
                 transforms);
  scene.show(alignment, alignment == PairAlignment::Before ? 0.0 : 1.0, false);
  window->Render();  // the camera is fitted to a window that has its size
  scene.stage().look(StandardView::Top);
  window->Render();
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
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

}  // namespace remount

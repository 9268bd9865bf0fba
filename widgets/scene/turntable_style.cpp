#include "widgets/scene/turntable_style.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace remount::scene {
namespace {
constexpr double kHighestElevation_rad = 1.5690;  // 0.1 degree from the pole
}

vtkStandardNewMacro(TurntableStyle);

void place_camera(vtkCamera& camera, const double focal_point[3], double distance_m, double azimuth_rad,
                  double elevation_rad) {
  const double elevation = std::clamp(elevation_rad, -kHighestElevation_rad, kHighestElevation_rad);
  camera.SetFocalPoint(focal_point[0], focal_point[1], focal_point[2]);
  camera.SetPosition(focal_point[0] + distance_m * std::cos(elevation) * std::cos(azimuth_rad),
                     focal_point[1] + distance_m * std::cos(elevation) * std::sin(azimuth_rad),
                     focal_point[2] + distance_m * std::sin(elevation));
  // The upward tangent of the sphere, not z itself, which VTK refuses close to the poles.
  camera.SetViewUp(-std::sin(elevation) * std::cos(azimuth_rad), -std::sin(elevation) * std::sin(azimuth_rad),
                   std::cos(elevation));
}

Eigen::Vector3d TurntableStyle::under_cursor() const {
  double focus[3];
  CurrentRenderer->GetActiveCamera()->GetFocalPoint(focus);
  CurrentRenderer->SetWorldPoint(focus[0], focus[1], focus[2], 1.0);
  CurrentRenderer->WorldToDisplay();
  const double depth = CurrentRenderer->GetDisplayPoint()[2];
  const int* const cursor = Interactor->GetEventPosition();
  CurrentRenderer->SetDisplayPoint(cursor[0], cursor[1], depth);
  CurrentRenderer->DisplayToWorld();
  const double* const world = CurrentRenderer->GetWorldPoint();
  return Eigen::Vector3d(world[0], world[1], world[2]) / world[3];
}

void TurntableStyle::Dolly(double factor) {
  if (!CurrentRenderer) return;
  vtkCamera& camera = *CurrentRenderer->GetActiveCamera();
  const Eigen::Vector3d before = under_cursor();
  camera.GetParallelProjection() ? camera.SetParallelScale(camera.GetParallelScale() / factor) : camera.Dolly(factor);
  const Eigen::Vector3d shift = before - under_cursor();
  double position[3], focus[3];
  camera.GetPosition(position);
  camera.GetFocalPoint(focus);
  camera.SetPosition(position[0] + shift.x(), position[1] + shift.y(), position[2] + shift.z());
  camera.SetFocalPoint(focus[0] + shift.x(), focus[1] + shift.y(), focus[2] + shift.z());
  Interactor->Render();
}

void TurntableStyle::Rotate() {
  if (!CurrentRenderer) return;
  const int* const now = Interactor->GetEventPosition();
  const int* const before = Interactor->GetLastEventPosition();
  const int* const size = CurrentRenderer->GetRenderWindow()->GetSize();
  if (size[0] < 1 || size[1] < 1) return;
  vtkCamera& camera = *CurrentRenderer->GetActiveCamera();
  double position[3], focal_point[3];
  camera.GetPosition(position);
  camera.GetFocalPoint(focal_point);
  const double x = position[0] - focal_point[0], y = position[1] - focal_point[1], z = position[2] - focal_point[2];
  const double distance_m = std::sqrt(x * x + y * y + z * z);
  const double azimuth = std::atan2(y, x) - 4.0 * (now[0] - before[0]) / size[0];
  const double elevation = std::atan2(z, std::hypot(x, y)) - 4.0 * (now[1] - before[1]) / size[1];
  place_camera(camera, focal_point, distance_m, azimuth, elevation);
  if (AutoAdjustCameraClippingRange) CurrentRenderer->ResetCameraClippingRange();
  Interactor->Render();
}

}  // namespace remount::scene

// Mouse in the 3-D views: orbit with the horizon kept level, pan, zoom.
#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <Eigen/Core>

class vtkCamera;

namespace remount::scene {

/// Places a camera on a sphere. Azimuth from +x counter-clockwise to where the camera stands, elevation above the
/// horizon, both rad. Elevation is kept off the poles, so that "up" stays z in every view.
void place_camera(vtkCamera& camera, const double focal_point[3], double distance_m, double azimuth_rad,
                  double elevation_rad);

/// Left drag orbits about z, middle or shift drag pans, wheel or right drag zooms to what is under the cursor. VTK's
/// own keys do nothing.
class TurntableStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static TurntableStyle* New();
  vtkTypeMacro(TurntableStyle, vtkInteractorStyleTrackballCamera);
  void Rotate() override;
  void OnChar() override {}  // w, s, r, 3 … would change the scene behind the user's back

 protected:
  TurntableStyle() = default;
  void Dolly(double factor) override;

 private:
  Eigen::Vector3d under_cursor() const;  ///< as far away as the focal point
};

}  // namespace remount::scene

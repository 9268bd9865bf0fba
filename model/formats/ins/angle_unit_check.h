// Whether logged angles can have the unit that a manifest declares for them.
#pragma once

#include <filesystem>
#include <vector>

#include "model/drive/attitude_convention.h"
#include "model/drive/session.h"

namespace remount::formats {

/// Compares the declared unit of the angles with what radians allow, and the heading with the direction of travel under
/// either unit. `logged[i]` are the angles of samples[i] in the unit that was declared; `unit_rad` is 1 or pi / 180.
/// Throws Error(Format) that says what to declare where the unit is clearly the other one; adds a finding where that is
/// only likely. A sensor that is mounted sideways or backwards, and driving in reverse, are no reason for either.
void check_angle_unit(const std::vector<motion::InsSample>& samples, const std::vector<drive::AttitudeAngles>& logged,
                      double unit_rad, drive::AttitudeConvention convention, const std::filesystem::path& path,
                      std::vector<drive::Finding>& findings);

}  // namespace remount::formats

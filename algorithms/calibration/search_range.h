// Where X is looked for.
#pragma once

#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"
#include "messages/options.h"

namespace remount::calibration {

/// Search range of the six parameters of X = ins_from_lidar, in the navigation (INS) frame. Angles are compared as they
/// are stated, yaw and roll within +-180 deg and pitch within +-90 deg: from -180 to 180 deg is every angle.
struct SearchRange {
  double x_min_m = -5.0, x_max_m = 5.0;
  double y_min_m = -5.0, y_max_m = 5.0;
  double z_min_m = -5.0, z_max_m = 5.0;
  double yaw_min_rad = -kPi, yaw_max_rad = kPi;
  double pitch_min_rad = -kPi, pitch_max_rad = kPi;
  double roll_min_rad = -kPi, roll_max_rad = kPi;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor({"x_min_m", "m", say::option_range_x_min_m, say::option_range_x_help, -1000.0, 1000.0}, self.x_min_m);
    visitor({"x_max_m", "m", say::option_range_x_max_m, say::option_range_x_help, -1000.0, 1000.0}, self.x_max_m);
    visitor({"y_min_m", "m", say::option_range_y_min_m, say::option_range_y_help, -1000.0, 1000.0}, self.y_min_m);
    visitor({"y_max_m", "m", say::option_range_y_max_m, say::option_range_y_help, -1000.0, 1000.0}, self.y_max_m);
    visitor({"z_min_m", "m", say::option_range_z_min_m, say::option_range_z_help, -1000.0, 1000.0}, self.z_min_m);
    visitor({"z_max_m", "m", say::option_range_z_max_m, say::option_range_z_help, -1000.0, 1000.0}, self.z_max_m);
    visitor({"yaw_min_rad", "rad", say::option_range_yaw_min_rad, say::option_range_yaw_help, -kPi, kPi},
            self.yaw_min_rad);
    visitor({"yaw_max_rad", "rad", say::option_range_yaw_max_rad, say::option_range_yaw_help, -kPi, kPi},
            self.yaw_max_rad);
    visitor({"pitch_min_rad", "rad", say::option_range_pitch_min_rad, say::option_range_pitch_help, -kPi, kPi},
            self.pitch_min_rad);
    visitor({"pitch_max_rad", "rad", say::option_range_pitch_max_rad, say::option_range_pitch_help, -kPi, kPi},
            self.pitch_max_rad);
    visitor({"roll_min_rad", "rad", say::option_range_roll_min_rad, say::option_range_roll_help, -kPi, kPi},
            self.roll_min_rad);
    visitor({"roll_max_rad", "rad", say::option_range_roll_max_rad, say::option_range_roll_help, -kPi, kPi},
            self.roll_max_rad);
  }
};

/// Parameters of X outside the range, in words ("x 6.20 m above 5.00 m"); empty where inside.
Message outside_range(const RigidTransform& ins_from_lidar, const SearchRange& range);

}  // namespace remount::calibration

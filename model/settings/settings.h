// Everything a user can set, in one value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/measured.h"
#include "algorithms/calibration/search_range.h"
#include "algorithms/calibration/slew/slew_options.h"
#include "algorithms/calibration/solve_options.h"
#include "algorithms/calibration/trajectory/trajectory_options.h"
#include "algorithms/calibration/vehicle_frame/vehicle_frame_options.h"
#include "algorithms/cloud/beam_options.h"
#include "algorithms/cloud/objects.h"
#include "algorithms/core/options.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"
#include "algorithms/motion/keyframes.h"
#include "algorithms/motion/pairing.h"
#include "algorithms/odometry/fusion/fusion_options.h"
#include "algorithms/odometry/lidar/lidar_odometry_options.h"
#include "algorithms/registration/registration_options.h"
#include "messages/options.h"
#include "model/method_registry/method_choice.h"

namespace remount::settings {

enum class DeskewMode { Auto, On, Off };

struct RunOptions {
  method_registry::MethodChoice method;
  DeskewMode deskew = DeskewMode::Auto;
  int cache_mb = 1024;
  bool map_check = true;

  template <class Self, class Visitor>
  static void visit(Self& self, Visitor&& visitor) {
    visitor.choice({"method", "", say::option_run_method, say::option_run_method_help}, self.method,
                   method_registry::method_ids());
    visitor.choice({"deskew", "", say::option_run_deskew, say::option_run_deskew_help}, self.deskew,
                   {"auto", "on", "off"});
    visitor({"cache_mb", "MB", say::option_run_cache_mb, say::option_run_cache_mb_help, 64, 1000000}, self.cache_mb);
    visitor({"map_check", "", say::option_run_map_check, say::option_run_map_check_help}, self.map_check);
  }
};

struct Settings {
  RunOptions run;
  motion::KeyframeOptions keyframes;
  motion::PairingOptions pairing;
  cloud::ObjectOptions objects;
  cloud::BeamOptions beams;
  registration::RegistrationOptions registration;
  calibration::SearchRange range;
  calibration::SolveOptions solve;
  calibration::MeasuredOptions measured;
  odometry::LidarOdometryOptions lidar_odometry;
  calibration::TrajectoryOptions trajectory;
  odometry::FusionOptions fusion;
  calibration::VehicleFrameOptions vehicle_frame;
  calibration::SlewOptions slew;

  /// visitor(section name, option struct) for each section; the names are the sections of a configuration file.
  template <class Self, class Visitor>
  static void visit_sections(Self& self, Visitor&& visitor) {
    visitor("run", self.run);
    visitor("keyframes", self.keyframes);
    visitor("pairing", self.pairing);
    visitor("objects", self.objects);
    visitor("beams", self.beams);
    visitor("registration", self.registration);
    visitor("range", self.range);
    visitor("solve", self.solve);
    visitor("measured", self.measured);
    visitor("lidar_odometry", self.lidar_odometry);
    visitor("trajectory", self.trajectory);
    visitor("fusion", self.fusion);
    visitor("vehicle_frame", self.vehicle_frame);
    visitor("slew", self.slew);
  }

  /// Every problem, prefixed by its section ("range.x_min_m ..."); includes settings that contradict each other: a
  /// minimum above its maximum.
  std::vector<Message> check() const;
};

/// Throws Error(Contract) that names every problem.
void require_valid(const Settings& settings);

/// What is wrong with starting from this nominal: which parameter lies outside the search range, in m and degrees.
/// Empty where nothing is, or where there is no nominal.
Message nominal_problem(const std::optional<RigidTransform>& nominal_ins_from_lidar,
                        const calibration::SearchRange& range);

}  // namespace remount::settings

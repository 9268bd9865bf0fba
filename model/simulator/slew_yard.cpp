#include "model/simulator/slew_yard.h"

#include <algorithm>
#include <cmath>

#include "model/simulator/random_stream.h"

namespace remount::simulator {

using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr std::uint64_t kYardStream = 30;
constexpr double kYardBury_m = 1.5;

/// Share of the turn that is done at a share of the drive; see speed_profile.cpp for the polynomial.
double turned_share(double drive_share) {
  constexpr double kRamp = 1.0 / 6.0;
  const auto speeding_up = [](double since_start) {
    const double u = std::clamp(since_start / kRamp, 0.0, 1.0), u2 = u * u, u4 = u2 * u2;
    const double beyond = std::max(0.0, since_start - kRamp);
    return kRamp * u4 * u * (7.0 + u * (-14.0 + u * (10.0 - 2.5 * u))) + beyond;
  };
  const double whole = 1.0 - kRamp;
  return drive_share < 0.5 ? speeding_up(drive_share) / whole : 1.0 - speeding_up(1.0 - drive_share) / whole;
}

/// A member of the arm from `start` along a direction that rises by `elevation_rad`, in the upper body's frame.
TiltedBox member(const RigidTransform& road_from_body, const Vector3d& start, double elevation_rad, double length_m,
                 const Vector2d& half_m) {
  const Eigen::Matrix3d body_from_box = rotation_from_yaw_pitch_roll({0.0, -elevation_rad, 0.0});
  const Vector3d middle = start + body_from_box * Vector3d(0.5 * length_m, 0.0, 0.0);
  return {road_from_body * make_rigid(body_from_box, middle), {0.5 * length_m, half_m.x(), half_m.y()}, 0.55f};
}

}  // namespace

World yard_world(int seed) {
  RandomStream random(static_cast<std::uint64_t>(seed), kYardStream);
  std::vector<Box> boxes;
  std::vector<Cylinder> cylinders;
  constexpr int kPlaces = 16;
  for (int i = 0; i < kPlaces; ++i) {
    const double bearing = 2.0 * kPi * (i + random.uniform(0.1, 0.9)) / kPlaces;
    const double away_m = random.uniform(16.0, 34.0);
    Box box;
    box.centre = away_m * Vector2d(std::cos(bearing), std::sin(bearing));
    box.yaw_rad = random.uniform(0.0, kPi);
    const bool shed = random.uniform() < 0.3;
    box.half = shed ? Vector2d(random.uniform(3.0, 5.0), random.uniform(2.0, 4.0)) : Vector2d(3.03, 1.22);
    box.bottom_m = -kYardBury_m;
    box.top_m = shed ? random.uniform(3.5, 6.0) : 2.6 * (random.uniform() < 0.3 ? 2.0 : 1.0);
    box.albedo = static_cast<float>(random.uniform(0.3, 0.8));
    boxes.push_back(box);
    Cylinder post;
    const double post_bearing = bearing + kPi / kPlaces;
    post.centre = random.uniform(12.0, 26.0) * Vector2d(std::cos(post_bearing), std::sin(post_bearing));
    post.radius_m = random.uniform(0.08, 0.2);
    post.bottom_m = -kYardBury_m;
    post.top_m = random.uniform(3.0, 7.0);
    cylinders.push_back(post);
  }
  return World(Ground({}), std::move(boxes), std::move(cylinders));
}

RigidTransform road_from_upper_body(const SlewYardOptions& options, double duration_s, double time_s) {
  const double share = options.recording == SlewRecording::FullTurn ? turned_share(time_s / duration_s) : 0.0;
  const Eigen::Matrix3d tilt = rotation_from_yaw_pitch_roll({0.0, degrees_to_radians(options.uneven_deg), 0.0});
  const Eigen::Matrix3d slew = rotation_from_yaw_pitch_roll({degrees_to_radians(options.arc_deg) * share, 0.0, 0.0});
  return make_rigid(tilt * slew, Vector3d::Zero());
}

std::vector<TiltedBox> arm_boxes(const SlewYardOptions& options, double duration_s, double time_s) {
  if (!options.arm) return {};
  constexpr double kLow_rad = -0.15, kHigh_rad = 0.75, kBoom_m = 5.2, kStick_m = 2.6, kBucket_m = 1.0;
  const double swing = 0.5 - 0.5 * std::cos(4.0 * kPi * std::clamp(time_s / duration_s, 0.0, 1.0));
  const double boom_rad =
      options.recording == SlewRecording::ArmSweep ? kLow_rad + (kHigh_rad - kLow_rad) * swing : 0.35;
  const double stick_rad = boom_rad - 1.35, bucket_rad = stick_rad - 0.7;
  const RigidTransform road_from_body = road_from_upper_body(options, duration_s, time_s);
  const auto ahead = [](double elevation_rad) -> Vector3d {
    return {std::cos(elevation_rad), 0.0, std::sin(elevation_rad)};
  };
  const Vector3d foot(0.6, 0.0, 1.9), elbow = foot + kBoom_m * ahead(boom_rad),
                                      wrist = elbow + kStick_m * ahead(stick_rad);
  return {member(road_from_body, foot, boom_rad, kBoom_m, {0.22, 0.35}),
          member(road_from_body, elbow, stick_rad, kStick_m, {0.18, 0.25}),
          member(road_from_body, wrist, bucket_rad, kBucket_m, {0.22, 0.3})};
}

}  // namespace remount::simulator

#include "model/conventions/impossible_motion.h"

#include <algorithm>
#include <cmath>

#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "messages/checks.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"

namespace remount::conventions {
namespace {

constexpr double kFarthestFromRest_m = 250e3;
constexpr double kMostMeasured = 1e6;  // m/s, rad/s, m/s^2 and m of height, none of which a vehicle reaches

bool is_measurable(double value) { return std::abs(value) < kMostMeasured; }
/// NaN stands for what a log does not have.
bool is_measurable_or_unknown(const Eigen::Vector3d& value) {
  return std::all_of(value.begin(), value.end(), [](double v) { return std::isnan(v) || is_measurable(v); });
}

bool is_possible(const motion::StampedPose& pose) { return is_possible_motion(pose.pose); }
bool is_possible(const motion::InsSample& sample) {
  return drive::plausible_geodetic(sample.latitude_rad, sample.longitude_rad, sample.height_m) &&
         sample.enu_from_ins.coeffs().allFinite();
}
bool is_possible(const motion::GnssFix& fix) {
  return drive::plausible_geodetic(fix.latitude_rad, fix.longitude_rad, fix.height_m) &&
         fix.covariance_enu_m2.allFinite();
}
bool is_possible(const motion::ImuSample& sample) {
  return is_measurable_or_unknown(sample.angular_rate_radps) && is_measurable_or_unknown(sample.specific_force_mps2);
}
bool is_possible(const motion::WheelSample& sample) {
  return is_measurable(sample.rear_left_mps) && is_measurable(sample.rear_right_mps);
}
bool is_possible(const motion::BarometerSample& sample) { return is_measurable(sample.height_m); }

template <class Item>
bool all_possible(const std::vector<Item>& items) {
  return std::all_of(items.begin(), items.end(), [](const Item& item) { return is_possible(item); });
}

/// Of poses that are possible each for itself.
Eigen::Vector3d middle_of(const std::vector<motion::StampedPose>& poses) {
  Eigen::Vector3d middle;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> places;
    for (const motion::StampedPose& pose : poses) places.push_back(pose.pose.translation()[axis]);
    middle[axis] = median_of(std::move(places));
  }
  return middle;
}

bool all_together(const std::vector<motion::StampedPose>& poses) {
  if (poses.empty()) return true;
  const Eigen::Vector3d any = poses.front().pose.translation();
  // Twice as near to one of them is near enough to the middle, and the middle costs memory.
  return std::all_of(poses.begin(), poses.end(), [&](const motion::StampedPose& pose) {
    return (pose.pose.translation() - any).norm() < 0.5 * kFarthestFromRest_m;
  });
}

bool is_possible(const drive::Session& session) {
  return all_possible(session.ins) && all_possible(session.world_from_ins) &&
         all_possible(session.odometry_from_lidar) && all_possible(session.gnss) && all_possible(session.imu) &&
         all_possible(session.wheels) && all_possible(session.barometer) && all_together(session.world_from_ins) &&
         all_together(session.odometry_from_lidar);
}

/// What is impossible about samples.
using What = Message (*)();

void report_left_out(std::size_t count, const std::string& stream, What what, drive::Session& session) {
  if (count == 0) return;
  session.findings.push_back(
      drive::make_finding(drive::Severity::Warning, "off-earth", stream, say::samples_off_earth(count, what())));
}

template <class Item>
void keep_possible(std::vector<Item>& items, const std::string& stream, What what, drive::Session& session) {
  report_left_out(std::erase_if(items, [](const Item& item) { return !is_possible(item); }), stream, what, session);
}

/// @param none_possible what is said where none of them is
void keep_possible(std::vector<motion::StampedPose>& poses, const char* stream, What none_possible,
                   drive::Session& session) {
  if (poses.empty()) return;
  std::size_t left_out = std::erase_if(poses, [](const motion::StampedPose& pose) { return !is_possible(pose); });
  if (!poses.empty() && !all_together(poses)) {
    const Eigen::Vector3d middle = middle_of(poses);
    left_out += std::erase_if(poses, [&](const motion::StampedPose& pose) {
      return !((pose.pose.translation() - middle).norm() < kFarthestFromRest_m);
    });
  }
  if (poses.empty()) throw Error(ErrorCode::Format, drive::path_or_name(session), none_possible());
  report_left_out(left_out, stream, say::off_earth_far_poses, session);
}

}  // namespace

bool is_possible_position(const Eigen::Vector3d& position_m) {
  return std::all_of(position_m.begin(), position_m.end(), [](double v) { return std::abs(v) < kFarthestPosition_m; });
}

bool is_possible_motion(const RigidTransform& motion) {
  return motion.linear().allFinite() && is_possible_position(motion.translation());
}

void leave_out_impossible(drive::Session& session) {
  if (is_possible(session)) return;
  const bool had_ins = !session.ins.empty();
  keep_possible(session.ins, "INS", say::off_earth_no_places, session);
  if (had_ins && session.ins.empty())
    throw Error(ErrorCode::Format, drive::path_or_name(session), say::no_ins_place_on_earth());
  keep_possible(session.world_from_ins, "INS", say::no_ins_pose_on_earth, session);
  keep_possible(session.odometry_from_lidar, "LiDAR", say::no_lidar_pose_on_earth, session);
  keep_possible(session.gnss, "GNSS", say::off_earth_no_places, session);
  keep_possible(session.imu, "IMU", say::off_earth_no_measurements, session);
  keep_possible(session.wheels, "wheels", say::off_earth_no_measurements, session);
  keep_possible(session.barometer, "barometer", say::off_earth_no_measurements, session);
}

std::vector<std::shared_ptr<const drive::Session>> possible_sessions(
    std::vector<std::shared_ptr<const drive::Session>> sessions) {
  for (std::shared_ptr<const drive::Session>& session : sessions) {
    if (!session || is_possible(*session)) continue;
    auto without = std::make_shared<drive::Session>(*session);
    leave_out_impossible(*without);
    session = std::move(without);
  }
  return sessions;
}

}  // namespace remount::conventions

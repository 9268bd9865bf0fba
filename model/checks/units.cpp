// Degrees taken for radians and the like, as far as the motion gives them away.
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/checks/check_times.h"

namespace remount::checks {
namespace {

constexpr double kDegreesPerRadian = 57.29578;
constexpr double kGravity_mps2 = 9.81;

/// Radians that are taken for degrees shrink the Earth: all of it lies within a few degrees of where Greenwich meets
/// the equator, in the open sea.
void check_positions(const std::vector<motion::InsSample>& ins, std::vector<drive::Finding>& findings) {
  if (ins.empty()) return;
  const double latitude_deg = radians_to_degrees(ins.front().latitude_rad);
  const double longitude_deg = radians_to_degrees(ins.front().longitude_rad);
  if (std::abs(latitude_deg) > 0.5 * kPi || std::abs(longitude_deg) > kPi) return;
  if (latitude_deg == 0.0 && longitude_deg == 0.0) return;  // a local frame that was given a place
  findings.push_back({drive::Severity::Problem, "position-unit", say::place_ins(),
                      say::position_unit(Angle{ins.front().latitude_rad}, Angle{ins.front().longitude_rad})});
}

/// How much the rate of rotation varies about its mean, rad/s; NaN where there is none.
double varying_rate(const conventions::MetricPoses& poses) {
  double sum = 0.0, time_s = 0.0;
  Eigen::Vector3d turned_rad = Eigen::Vector3d::Zero();
  for (std::size_t from = 0, i = 1; i < poses.size(); ++i) {
    const double step_s = seconds_between(poses[from].stamp_ns, poses[i].stamp_ns);
    if (step_s < 0.2) continue;
    const Eigen::Vector3d turn_rad = so3_log(poses[from].pose.linear().transpose() * poses[i].pose.linear());
    sum += turn_rad.squaredNorm() / step_s;
    turned_rad += turn_rad;
    time_s += step_s;
    from = i;
  }
  if (!(time_s > 0.0)) return std::nan("");
  return std::sqrt(std::max(0.0, sum / time_s - (turned_rad / time_s).squaredNorm()));
}

void check_imu(const CheckedSession& checked, std::vector<drive::Finding>& findings) {
  const std::vector<motion::ImuSample>& imu = checked.session.imu;
  if (imu.size() < 100) return;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const motion::ImuSample& sample : imu) mean += sample.angular_rate_radps / static_cast<double>(imu.size());
  double rates = 0.0;
  std::vector<double> forces;
  for (const motion::ImuSample& sample : imu) {
    rates += (sample.angular_rate_radps - mean).squaredNorm() / static_cast<double>(imu.size());
    if (const double force = sample.specific_force_mps2.norm(); std::isfinite(force)) forces.push_back(force);
  }
  // Means are left out, for an IMU has a bias: an even bend then tells as little as no turn at all, where noise is all
  // that the IMU has.
  const double imu_rate = std::sqrt(rates), ins_rate = varying_rate(checked.poses);
  const double ratio = ins_rate > 0.05 ? imu_rate / ins_rate : 1.0;
  if (ratio > 0.4 * kDegreesPerRadian || ratio < 2.5 / kDegreesPerRadian)
    findings.push_back({drive::Severity::Problem, "imu-rate-unit", say::place_imu(), say::imu_rate_unit(ratio)});
  if (forces.empty()) return;
  const double force = median_of(forces);
  if (force < 0.15 * kGravity_mps2)
    findings.push_back({drive::Severity::Problem, "imu-force-unit", say::place_imu(),
                        say::imu_force_unit(Acceleration{force}, Acceleration{kGravity_mps2})});
}

void look_at_units(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  check_positions(checked.session.ins, findings);
  check_imu(checked, findings);
}

}  // namespace

DataCheck unit_check() {
  return {.kinds = {{"angle-unit", say::angle_unit_meaning, say::angle_unit_remedy},
                    {"position-unit", say::position_unit_meaning, say::position_unit_remedy},
                    {"imu-rate-unit", say::imu_rate_unit_meaning, say::imu_rate_unit_remedy},
                    {"imu-force-unit", say::imu_force_unit_meaning, say::imu_force_unit_remedy}},
          .look = look_at_units};
}

}  // namespace remount::checks

// Degrees taken for radians and the like, as far as the motion gives them away.
#include <cmath>

#include "algorithms/core/median.h"
#include "algorithms/geometry/rotation.h"
#include "model/checks/builtin.h"
#include "model/checks/check_text.h"

namespace remount {
namespace {

constexpr double kDegreesPerRadian = 57.29578;
constexpr double kGravity_mps2 = 9.81;

/// Radians that are taken for degrees shrink the Earth: all of it lies within a few degrees of where Greenwich meets
/// the equator, in the open sea.
void check_positions(const std::vector<InsSample>& ins, std::vector<Finding>& findings) {
  if (ins.empty()) return;
  const double latitude_deg = radians_to_degrees(ins.front().latitude_rad);
  const double longitude_deg = radians_to_degrees(ins.front().longitude_rad);
  if (std::abs(latitude_deg) > 0.5 * kPi || std::abs(longitude_deg) > kPi) return;
  if (latitude_deg == 0.0 && longitude_deg == 0.0) return;  // a local frame that was given a place
  findings.push_back({Severity::Problem, "position-unit", "INS",
                      check_text("The drive would lie in the sea at latitude %.4f, longitude %.4f degrees: these are "
                                 "radians that are taken for degrees.",
                                 latitude_deg, longitude_deg)});
}

/// How much the rate of rotation varies about its mean, rad/s; NaN where there is none.
double varying_rate(const MetricPoses& poses) {
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

void check_imu(const CheckedSession& checked, std::vector<Finding>& findings) {
  const std::vector<ImuSample>& imu = checked.session.imu;
  if (imu.size() < 100) return;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const ImuSample& sample : imu) mean += sample.angular_rate_radps / static_cast<double>(imu.size());
  double rates = 0.0;
  std::vector<double> forces;
  for (const ImuSample& sample : imu) {
    rates += (sample.angular_rate_radps - mean).squaredNorm() / static_cast<double>(imu.size());
    if (const double force = sample.specific_force_mps2.norm(); std::isfinite(force)) forces.push_back(force);
  }
  // Means are left out, for an IMU has a bias: an even bend then tells as little as no turn at all, where noise is all
  // that the IMU has.
  const double imu_rate = std::sqrt(rates), ins_rate = varying_rate(checked.poses);
  const double ratio = ins_rate > 0.05 ? imu_rate / ins_rate : 1.0;
  if (ratio > 0.4 * kDegreesPerRadian || ratio < 2.5 / kDegreesPerRadian)
    findings.push_back(
        {Severity::Problem, "imu-rate-unit", "IMU",
         check_text("The IMU turns %.3g times as fast as the INS: degrees and radians are mixed up.", ratio)});
  if (forces.empty()) return;
  const double force = median_of(forces);
  if (force < 0.15 * kGravity_mps2)
    findings.push_back(
        {Severity::Problem, "imu-force-unit", "IMU",
         check_text("The IMU reads a specific force of %.2f, where gravity alone is 9.8 m/s^2: these are "
                    "units of g, or gravity was taken out.",
                    force)});
}

void look_at_units(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  check_positions(checked.session.ins, findings);
  check_imu(checked, findings);
}

}  // namespace

DataCheck unit_check() {
  return {.kinds = {{"angle-unit", "Angles in the wrong unit make every attitude wrong.",
                     "Declare attitude: {unit: deg} or {unit: rad} as the log has it."},
                    {"position-unit", "The whole drive shrinks to centimetres, and nothing agrees with the LiDAR.",
                     "Declare the unit of latitude and longitude as the log has it."},
                    {"imu-rate-unit", "Odometry that lives on the IMU turns dozens of times too far, or hardly.",
                     "Declare the unit of the angular rate as the log has it."},
                    {"imu-force-unit",
                     "The direction of gravity is found, but forces are taken for a tenth of what they are.",
                     "Declare the unit of the specific force; record raw values, with gravity in them."}},
          .look = look_at_units};
}

}  // namespace remount

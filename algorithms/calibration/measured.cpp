#include "algorithms/calibration/measured.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/calibration_result.h"
#include "messages/calibration.h"

namespace remount::calibration {
namespace {

struct Value {
  double value, sigma;  // m, rad
};

// No tape and no level is better: smaller sigmas would only make the equations singular.
constexpr double kLeastSigma = 1e-5;

PerParameter<Value> values(const MeasuredOptions& o) {
  const auto known = [](double value, double sigma) {
    return Value{value, sigma > 0.0 ? std::max(sigma, kLeastSigma) : 0.0};
  };
  const auto angle = [&](double value_deg, double sigma_deg) {
    return known(degrees_to_radians(value_deg), degrees_to_radians(sigma_deg));
  };
  PerParameter<Value> out;
  out[Parameter::X] = known(o.x_m, o.x_sigma_m);
  out[Parameter::Y] = known(o.y_m, o.y_sigma_m);
  out[Parameter::Z] = known(o.z_m, o.z_sigma_m);
  out[Parameter::Yaw] = angle(o.yaw_deg, o.yaw_sigma_deg);
  out[Parameter::Pitch] = angle(o.pitch_deg, o.pitch_sigma_deg);
  out[Parameter::Roll] = angle(o.roll_deg, o.roll_sigma_deg);
  return out;
}

Message name_of(const MeasuredRow& known) {
  return known.of == MeasuredRow::Of::GroundHeight ? say::measured_ground_height()
         : known.of == MeasuredRow::Of::GroundTilt ? say::measured_ground_tilt()
                                                   : say::measured_parameter(parameter_word(known.parameter));
}

double shorter_way(double angle_rad) { return std::remainder(angle_rad, 2.0 * kPi); }

}  // namespace

ParameterSet Measured::parameters() const {
  ParameterSet out;
  const PerParameter<Value> all = values(options_);
  for (const Parameter parameter : kParameters)
    if (all[parameter].sigma > 0.0) out.insert(parameter);
  if (!uses_ground()) return out;
  for (const Parameter by_ground : {Parameter::Z, Parameter::Pitch, Parameter::Roll}) out.insert(by_ground);
  return out;
}

std::vector<MeasuredRow> Measured::rows(const RigidTransform& x) const {
  std::vector<MeasuredRow> out;
  const PerParameter<double> said = parameters_of(x);
  Matrix6d to_parameters = Matrix6d::Identity();
  to_parameters.bottomRightCorner<3, 3>() = yaw_pitch_roll_jacobian(yaw_pitch_roll_from_rotation(x.linear()));
  const PerParameter<Value> known = values(options_);
  for (const Parameter parameter : kParameters) {
    const auto row = to_parameters.row(row_of(parameter));
    // Where pitch stands at 90 degrees, yaw and roll are no angles of their own.
    if (!(known[parameter].sigma > 0.0) || !row.allFinite()) continue;
    const double residual = known[parameter].value - said[parameter];
    out.push_back({is_angle(parameter) ? shorter_way(residual) : residual, row.transpose(), known[parameter].sigma,
                   MeasuredRow::Of::Parameter, parameter});
  }
  if (!uses_ground()) return out;
  // The plane in INS axes: up . p = up . t - lidar height. It passes below the INS at its height, and its normal is z.
  const Eigen::Vector3d up = x.linear() * ground_->up_in_lidar, t = x.translation();
  MeasuredRow height;
  height.residual = -options_.ins_height_m - (up.dot(t) - ground_->lidar_height_m);
  height.row << up, up.cross(t);
  height.of = MeasuredRow::Of::GroundHeight;
  height.sigma = std::hypot(options_.ins_height_sigma_m, ground_->height_sigma_m);
  out.push_back(height);
  for (int i = 0; i < 2; ++i) {
    MeasuredRow lean;
    lean.of = MeasuredRow::Of::GroundTilt;
    lean.residual = -up[i];
    lean.row.tail<3>() = up.cross(Eigen::Vector3d::Unit(i));
    lean.sigma = std::hypot(degrees_to_radians(options_.ins_tilt_sigma_deg), ground_->up_sigma_rad);
    out.push_back(lean);
  }
  return out;
}

Matrix6d Measured::information(const RigidTransform& x) const {
  Matrix6d information = Matrix6d::Zero();
  for (const MeasuredRow& known : rows(x))
    information += known.row * known.row.transpose() / (known.sigma * known.sigma);
  return information;
}

std::vector<Contradiction> contradictions(const Measured& measured, const RigidTransform& x, const Matrix6d& joint,
                                          const Matrix6d& trusted) {
  constexpr double kContradicts = 3.0;
  std::vector<Contradiction> out;
  for (const MeasuredRow& known : measured.rows(x)) {
    // What is left of a measurement after it took part is its distance from the pairs, shrunk as the joint solution
    // weighed the two; how large that distance may be is what is believed of the pairs. docs/maths/covariance.md (C26)
    const double sigma2 = known.sigma * known.sigma;
    const double joint2 = known.row.dot(joint * known.row), left_joint = sigma2 - joint2;
    const Vector6d reach = trusted * known.row;
    const double said2 = known.row.dot(reach), left_trusted = sigma2 - said2;
    if (!(left_joint > 0.0 && left_trusted > 0.0)) continue;
    const double score = std::abs(known.residual) * std::sqrt(left_trusted) / left_joint;
    if (!(score > kContradicts)) continue;
    const bool angle = known.of == MeasuredRow::Of::GroundTilt ||
                       (known.of == MeasuredRow::Of::Parameter && is_angle(known.parameter));
    const double scatter = std::sqrt((score * score - 1.0) * said2);
    const double drawn = std::abs(known.residual) * joint2 / left_joint;
    out.push_back({angle ? say::measured_angle_contradicts(name_of(known), score, Angle{known.residual})
                         : say::measured_length_contradicts(name_of(known), score, Length{known.residual}),
                   reach * (std::max(scatter, drawn) / said2)});
  }
  return out;
}

}  // namespace remount::calibration

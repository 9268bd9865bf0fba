#include "algorithms/calibration/observability.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "algorithms/core/index.h"
#include "algorithms/core/symmetric_eigen.h"
#include "messages/calibration.h"
#include "messages/parameters.h"

namespace remount::calibration {
namespace {

constexpr std::array<Message (*)(), 6> kDirectionWords{say::direction_x,    say::direction_y,     say::direction_z,
                                                       say::direction_roll, say::direction_pitch, say::direction_yaw};

Message direction_names(const Vector6d& direction) {
  Message names;
  for (int i = 0; i < 6; ++i) {
    if (std::abs(direction[i]) < 0.4) continue;
    Message name = kDirectionWords[index_at(i)]();
    names = names.empty() ? std::move(name) : say::direction_with(std::move(names), std::move(name));
  }
  return names;
}

// Height, roll and pitch show in how an INS leans: one that is taken to be level shows none of them.
bool needs_tilt(const Vector6d& direction) { return direction.segment<3>(2).cwiseAbs().maxCoeff() >= 0.4; }

Message direction_words(const Vector6d& direction, bool observed, const MotionSummary& motion) {
  Message names = direction_names(direction);
  if (observed) return say::direction_observed(std::move(names));
  if (motion.tilt_assumed && needs_tilt(direction))
    return say::direction_not_known(std::move(names), say::unknown_tilt_assumed());
  const bool straight = motion.largest_rotation_rad < degrees_to_radians(3.0);
  const bool flat = motion.largest_tilt_rad < degrees_to_radians(1.0);
  return say::direction_not_observable(std::move(names), straight ? say::hardly_turned()
                                                         : flat   ? say::flat_driving()
                                                                  : say::too_little_motion());
}

void sort_directions(CalibrationResult& result) {
  std::stable_sort(result.directions.begin(), result.directions.end(),
                   [](const auto& left, const auto& right) { return left.sigma > right.sigma; });
}

void add_advice(const MotionSummary& motion, CalibrationResult& result) {
  const ParameterSet observed = result.observed();
  const auto sees = [&](Parameter parameter) { return observed.contains(parameter); };
  const bool straight = motion.largest_rotation_rad < degrees_to_radians(3.0);
  if (std::vector<Message> level = parameter_words(~observed & ParameterSet{Parameter::X, Parameter::Y});
      !level.empty()) {
    const std::size_t number = level.size();
    result.advice.push_back((straight ? say::need_turns : say::need_rotation)(std::move(level), number));
  }
  // Many slopes average the guess; what they show so is still poor.
  const bool tilt_vague = motion.tilt_assumed &&
                          (!(sees(Parameter::Z) && sees(Parameter::Pitch) && sees(Parameter::Roll)) ||
                           std::max(*result.estimate(Parameter::Pitch).sigma, *result.estimate(Parameter::Roll).sigma) >
                               degrees_to_radians(0.5));
  if (tilt_vague) result.advice.push_back(say::need_tilt_vague());
  if (!sees(Parameter::Z) && !tilt_vague) result.advice.push_back(say::need_pitch_or_roll());
  // Of an INS that is taken to be level no travel shows pitch.
  const bool pitch_missing = !sees(Parameter::Pitch) && !tilt_vague;
  if (!sees(Parameter::Yaw) || pitch_missing)
    result.advice.push_back(!pitch_missing         ? say::need_travel_yaw()
                            : sees(Parameter::Yaw) ? say::need_travel_pitch()
                                                   : say::need_travel_yaw_pitch());
  if (!sees(Parameter::Roll) && !tilt_vague) result.advice.push_back(say::need_slopes_roll());
}

// After the covariance has grown: what is no longer observed by it.
void withdraw_unobserved(const SolveOptions& options, const Message& reason, CalibrationResult& result) {
  const Vector6d limits = observation_limits(options);
  for (const Parameter parameter : kParameters) {
    const int row = row_of(parameter);
    if (result.known[parameter].observed && !(result.covariance(row, row) < limits[row] * limits[row]))
      result.withdraw(parameter, reason);
  }
}

// Its place in a perturbation, whose turns are about x, y and z.
int row_of_direction(Parameter parameter) {
  return is_angle(parameter) ? row_of(Parameter::Roll) + row_of(Parameter::Yaw) - row_of(parameter) : row_of(parameter);
}

}  // namespace

Vector6d observation_limits(const SolveOptions& options) {
  Vector6d limits;
  limits << Eigen::Vector3d::Constant(options.max_translation_sigma_m),
      Eigen::Vector3d::Constant(degrees_to_radians(options.max_rotation_sigma_deg));
  return limits;
}

MotionSummary summarise_motion(const std::vector<motion::Pair>& pairs) {
  MotionSummary summary;
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const motion::Pair& pair : pairs) {
    if (pair.state != motion::PairState::Accepted) continue;
    const Eigen::Vector3d phi = so3_log(pair.ins_b_from_ins_a.linear());
    summary.largest_rotation_rad = std::max(summary.largest_rotation_rad, phi.norm());
    scatter += phi * phi.transpose();
  }
  const Eigen::Vector3d main_axis = symmetric_eigen(scatter).eigenvectors().col(2);
  for (const motion::Pair& pair : pairs) {
    if (pair.state != motion::PairState::Accepted) continue;
    const Eigen::Vector3d phi = so3_log(pair.ins_b_from_ins_a.linear());
    summary.largest_tilt_rad = std::max(summary.largest_tilt_rad, (phi - main_axis * main_axis.dot(phi)).norm());
  }
  return summary;
}

Matrix6d parameter_covariance(const RigidTransform& ins_from_lidar, const Matrix6d& perturbation_covariance) {
  Matrix6d jacobian = Matrix6d::Identity();
  jacobian.bottomRightCorner<3, 3>() = yaw_pitch_roll_jacobian(yaw_pitch_roll_from_rotation(ins_from_lidar.linear()));
  return jacobian * perturbation_covariance * jacobian.transpose();
}

std::vector<ObservabilityDirection> observed_directions(const Matrix6d& information,
                                                        const SpuriousInformation& spurious,
                                                        const MotionSummary& motion, const SolveOptions& options) {
  const Vector6d limits = observation_limits(options);
  const Matrix6d scaled = limits.asDiagonal() * information * limits.asDiagonal();
  const auto eigen = symmetric_eigen(Matrix6d(0.5 * (scaled + scaled.transpose())));
  std::vector<ObservabilityDirection> directions;
  for (int i = 0; i < 6; ++i) {
    ObservabilityDirection direction;
    direction.direction = eigen.eigenvectors().col(i);
    const Vector6d physical = limits.cwiseProduct(direction.direction);
    const double apparent = physical.dot(spurious.apparent * physical);
    const double share = apparent > 0.0 ? physical.dot(spurious.spurious * physical) / apparent : 0.0;
    // Half of the excitation being noise leaves nothing to trust: its size is itself uncertain.
    const double value = eigen.eigenvalues()[i] * std::max(0.0, 1.0 - 2.0 * share);
    direction.sigma = value > 0.0 ? 1.0 / std::sqrt(value) : std::numeric_limits<double>::infinity();
    direction.observed = direction.sigma < 1.0;
    direction.words = direction_words(direction.direction, direction.observed, motion);
    directions.push_back(direction);
  }
  std::stable_sort(directions.begin(), directions.end(),
                   [](const auto& left, const auto& right) { return left.sigma > right.sigma; });
  return directions;
}

Matrix6d trusted_information(const std::vector<ObservabilityDirection>& directions, const SolveOptions& options) {
  const Vector6d inverse_limits = observation_limits(options).cwiseInverse();
  Matrix6d information = Matrix6d::Zero();
  for (const ObservabilityDirection& direction : directions) {
    const Vector6d row = inverse_limits.cwiseProduct(direction.direction);
    if (std::isfinite(direction.sigma)) information += row * row.transpose() / (direction.sigma * direction.sigma);
  }
  return information;
}

Matrix6d weak_prior(bool nominal_known) {
  constexpr double kPriorTranslation_m = 2.0, kPriorRotation_rad = 0.1, kUnknownYaw_rad = 1.0;
  Vector6d information;
  information << Eigen::Vector3d::Constant(1.0 / (kPriorTranslation_m * kPriorTranslation_m)),
      Eigen::Vector3d::Constant(1.0 / (kPriorRotation_rad * kPriorRotation_rad));
  // On an arc X may turn about the middle of the arc: where that is far from where it was linearised, the others
  // follow.
  if (!nominal_known) information[5] = 1.0 / (kUnknownYaw_rad * kUnknownYaw_rad);
  return information.asDiagonal();
}

Matrix6d assumed_tilt_covariance(const RigidTransform& ins_from_lidar, double tilt_rad) {
  Eigen::Matrix<double, 6, 2> turned;
  turned << -skew(ins_from_lidar.translation()).leftCols<2>(), Eigen::Matrix<double, 3, 2>::Identity();
  return tilt_rad * tilt_rad * turned * turned.transpose();
}

Vector6d turned_by_north(const RigidTransform& ins_from_lidar, double north_rad) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  Vector6d turned;
  turned << up.cross(ins_from_lidar.translation()), up;
  return north_rad * turned;
}

Matrix6d beyond_first_order(const RigidTransform& ins_from_lidar, const Matrix6d& covariance, double tilt_rad) {
  const auto open2 = [&](int axis) { return std::min(tilt_rad * tilt_rad, covariance(axis, axis)); };
  const double height2 = std::max(0.0, covariance(2, 2)), roll2 = open2(3), pitch2 = open2(4);
  Matrix6d out = Matrix6d::Zero();
  out(0, 0) = pitch2 * height2;
  out(1, 1) = roll2 * height2;
  // exp(a) exp(b) = exp(a + b + a x b / 2 + ...) (Baker, Campbell, Hausdorff), of what the mounting has and what the
  // INS.
  const double yaw2 = 0.5 * roll2 * pitch2;
  const Eigen::Vector3d arm = ins_from_lidar.translation();
  Vector6d turned;
  turned << -arm.y(), arm.x(), 0.0, 0.0, 0.0, 1.0;
  return out + yaw2 * turned * turned.transpose();
}

bool is_advice_on_motion(const Message& advice) {
  static const std::set<std::string> codes{say::need_turns({}, 0).code(),       say::need_rotation({}, 0).code(),
                                           say::need_tilt_vague().code(),       say::need_pitch_or_roll().code(),
                                           say::need_travel_yaw().code(),       say::need_travel_pitch().code(),
                                           say::need_travel_yaw_pitch().code(), say::need_slopes_roll().code()};
  return codes.contains(advice.code());
}

void judge_parameters(const Matrix6d& covariance, const MotionSummary& motion, const SolveOptions& options,
                      CalibrationResult& result) {
  const Vector6d limits = observation_limits(options);
  result.covariance = parameter_covariance(result.mounting.reference_from_sensor, covariance);
  ParameterSet observed;
  for (const Parameter parameter : kParameters) {
    const int row = row_of(parameter);
    const double variance = result.covariance(row, row);
    if (std::isfinite(variance) && variance < limits[row] * limits[row]) observed.insert(parameter);
  }
  result.set_observed(observed, say::unknown_sigma_above_limit());
  // The directions then say what the parameters do: the final sigma includes more than the pairs' information.
  for (ObservabilityDirection& direction : result.directions) {
    const Vector6d row = limits.cwiseInverse().cwiseProduct(direction.direction);
    const double sigma = std::sqrt(row.dot(covariance * row));
    const bool by_drive = direction.observed;
    // The weak prior bounds every sigma; a direction that the pairs leave open stays so unless a measurement closes it.
    direction.sigma = std::isfinite(direction.sigma) || sigma < 1.0 ? sigma : direction.sigma;
    direction.observed = direction.sigma < 1.0;
    direction.words = direction.observed && !by_drive && is_any_measured(result)
                          ? say::direction_measured(direction_names(direction.direction))
                          : direction_words(direction.direction, direction.observed, motion);
  }
  sort_directions(result);
  for (const Parameter parameter : kParameters)
    if (Message why = said_of_direction(parameter, result); !why.empty() && !observed.contains(parameter))
      result.known[parameter].why_not_observed = std::move(why);
  add_advice(motion, result);
}

Message said_of_direction(Parameter parameter, const CalibrationResult& result) {
  constexpr double kAlong = 0.4;  // as directions are named
  for (const ObservabilityDirection& direction : result.directions)
    if (!direction.observed && std::abs(direction.direction[row_of_direction(parameter)]) >= kAlong)
      return direction.words;
  return {};
}

void claim_nothing(const Message& reason, CalibrationResult& result) {
  for (const Parameter parameter : kParameters) result.withdraw(parameter, reason);
  for (ObservabilityDirection& direction : result.directions) {
    if (!direction.observed) continue;
    direction.sigma = std::numeric_limits<double>::infinity();
    direction.observed = false;
    direction.words = say::direction_not_known(direction_names(direction.direction), reason);
  }
  sort_directions(result);
}

bool is_any_measured(const CalibrationResult& result) { return !result.measured().empty(); }

Message solved_message(const CalibrationResult& result) {
  std::vector<Message> missing = parameter_words(~result.observed());
  if (!missing.empty()) return say::solved_but_for(std::move(missing));
  return is_any_measured(result) ? say::solved_all_known() : say::solved_all_observed();
}

bool yaw_is_open(const CalibrationResult& result) { return !result.known[Parameter::Yaw].observed; }

void add_sigma_part(const Message& source, const Vector6d& variance, CalibrationResult& result) {
  const auto same = std::ranges::find(result.sigma_parts, source, &SigmaPart::source);
  SigmaPart& part = same != result.sigma_parts.end() ? *same : result.sigma_parts.emplace_back(SigmaPart{source, {}});
  for (const Parameter parameter : kParameters) {
    double& sigma = part.sigma[parameter];
    sigma = std::sqrt(std::max(0.0, sigma * sigma + variance[row_of(parameter)]));
  }
}

void widen_angles(const Eigen::Vector3d& off_rad, const SolveOptions& options, CalibrationResult& result) {
  if (!result.sigma_parts.empty()) {
    Vector6d variance = Vector6d::Zero();
    variance.tail<3>() = off_rad.cwiseAbs2();
    add_sigma_part(say::sigma_part_open_rotation(), variance, result);
  }
  result.covariance.diagonal().tail<3>() += off_rad.cwiseAbs2();
  withdraw_unobserved(options, say::unknown_turns_with_rotation(), result);
}

void add_doubt(const Vector6d& doubt, const Message& reason, const SolveOptions& options, CalibrationResult& result) {
  const Vector6d limits = observation_limits(options);
  const Matrix6d added = parameter_covariance(result.mounting.reference_from_sensor, doubt * doubt.transpose());
  result.covariance += added;
  if (!result.sigma_parts.empty()) add_sigma_part(reason, added.diagonal(), result);
  withdraw_unobserved(options, reason, result);
  for (ObservabilityDirection& direction : result.directions) {
    if (!direction.observed) continue;
    direction.sigma = std::hypot(direction.sigma, limits.cwiseInverse().cwiseProduct(direction.direction).dot(doubt));
    direction.observed = direction.sigma < 1.0;
    if (!direction.observed) direction.words = say::direction_not_known(direction_names(direction.direction), reason);
  }
  sort_directions(result);
}

}  // namespace remount::calibration

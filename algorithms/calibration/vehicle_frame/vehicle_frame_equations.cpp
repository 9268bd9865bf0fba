#include "algorithms/calibration/vehicle_frame/vehicle_frame_equations.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/core/index.h"
#include "algorithms/geometry/lasting_errors.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int kUnknowns = VehicleFrameState::kUnknowns;
constexpr int kLevelRow = 10;
constexpr double kOutlierSigma = 3.0;
constexpr double kLeastSpread = 1e-9;  // exact data: no division by zero

// Turn and maps of the interval under other errors of the rates, to first order.
motion::WheelPreintegration with_errors(const IntegratedInterval& interval, const RateErrors& errors) {
  motion::WheelPreintegration sum = interval.nominal;
  const RateErrors change = errors - interval.errors;
  Vector3d turn = Vector3d::Zero();
  for (int k = 0; k < 6; ++k) {
    const IntegratedInterval::Slope& slope = interval.by_error[index_at(k)];
    turn += change[k] * slope.turn;
    sum.turn_in_imu_rad += change[k] * slope.turn_sum;
    sum.travel_map_m += change[k] * slope.map;
    sum.difference_map_m += change[k] * slope.difference_map;
    for (std::size_t axis = 0; axis < 3; ++axis) sum.turn_maps_rad[axis] += change[k] * slope.turn_maps[axis];
  }
  sum.imu_start_from_imu_end = so3_exp(turn) * sum.imu_start_from_imu_end;
  return sum;
}

using KindWeights = std::array<double, kResidualKinds>;

struct Linearised {
  IntervalResidual residual;
  IntervalJacobian jacobian;
};

// Fewer rows than intervals: cancelled.
std::vector<Linearised> linearise(const VehicleFrameProblem& problem, const VehicleFrameState& state,
                                  const Progress& progress) {
  std::vector<Linearised> rows;
  rows.reserve(problem.intervals->size());
  for (const VehicleInterval& interval : *problem.intervals) {
    if (progress.cancelled()) return rows;
    const IntegratedInterval sum = integrate(interval, rate_errors(state));
    rows.push_back({residual_of(sum, state), jacobian_of(sum, state)});
  }
  return rows;
}

bool has_rows(const VehicleFrameProblem& problem, std::size_t interval, std::size_t kind) {
  return problem.used[kind] && (kind != kReferenceTurn || (*problem.intervals)[interval].reference_begin_from_end);
}

double norm_of(const IntervalResidual& residual, std::size_t kind) {
  int first = 0;
  for (std::size_t k = 0; k < kind; ++k) first += kResidualRows[k];
  return residual.segment(first, kResidualRows[kind]).norm();
}

// Sigma of one row: the median of the norms at first, then the mean square of what is no outlier. How a vehicle leans
// on its road is no error with outliers: all of it counts.
std::array<double, kResidualKinds> estimate_sigma(const VehicleFrameProblem& problem,
                                                  const std::vector<IntervalResidual>& residuals, double unknowns) {
  constexpr std::array<double, 4> kMedianOfNorm{0.0, 0.6745, 1.1774, 1.5382};
  std::array<double, kResidualKinds> sigma{};
  for (std::size_t kind = 0; kind < kResidualKinds; ++kind) {
    std::vector<double> norms;
    for (std::size_t i = 0; i < residuals.size(); ++i)
      if (has_rows(problem, i, kind)) norms.push_back(norm_of(residuals[i], kind));
    sigma[kind] = kLeastSpread;
    if (norms.empty()) continue;
    const int rows = kResidualRows[kind];
    std::vector<double> sorted = norms;
    std::sort(sorted.begin(), sorted.end());
    const double rough = sorted[sorted.size() / 2] / kMedianOfNorm[index_at(rows)];
    const double limit = kind == kLevel ? sorted.back() : 4.0 * std::sqrt(static_cast<double>(rows)) * rough;
    double sum = 0.0;
    std::size_t count = 0;
    for (const double norm : norms)
      if (norm <= limit) sum += norm * norm, ++count;
    const double degrees = std::max(1.0, rows * static_cast<double>(count) - unknowns);
    sigma[kind] = std::max(kLeastSpread, std::sqrt(sum / degrees));
  }
  return sigma;
}

// How the vehicle leans from interval to interval is linked, and so is how it turns: what the level rows say of the IMU
// counts for as many intervals as are independent.
double lasting_of_level(const std::vector<Linearised>& rows) {
  const auto score = [&](std::size_t i) { return rows[i].jacobian(kLevelRow, 11) * rows[i].residual[kLevelRow]; };
  double power = 0.0, factor = 1.0;
  for (std::size_t i = 0; i < rows.size(); ++i) power += score(i) * score(i);
  for (std::size_t lag = 1; lag < rows.size() / 4 && power > 0.0; ++lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < rows.size(); ++i) sum += score(i) * score(i - lag);
    if (sum < 0.05 * power) break;
    factor += 2.0 * sum / power;
  }
  return factor;
}

double robust_weight(double norm, int rows, double sigma) {
  const double limit = kOutlierSigma * std::sqrt(static_cast<double>(rows)) * sigma;
  return norm <= limit ? 1.0 : limit * limit / (norm * norm);
}

struct Normal {
  StateMatrix hessian = StateMatrix::Zero();
  StateVector gradient = StateVector::Zero();
  std::vector<StateVector> scores;  // of each interval, for errors that last
  int outliers = 0;
};

Normal normal_equations(const VehicleFrameProblem& problem, const std::vector<Linearised>& rows,
                        const std::array<double, kResidualKinds>& sigma, const VehicleFrameState& state) {
  Normal normal;
  normal.scores.assign(rows.size(), StateVector::Zero());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double least = 1.0;
    int first = 0;
    for (std::size_t kind = 0; kind < kResidualKinds; first += kResidualRows[kind++]) {
      if (!has_rows(problem, i, kind)) continue;
      const int count = kResidualRows[kind];
      const double robust = kind == kLevel ? 1.0 : robust_weight(norm_of(rows[i].residual, kind), count, sigma[kind]);
      const double weight = robust / (sigma[kind] * sigma[kind]);
      const auto jacobian = rows[i].jacobian.middleRows(first, count);
      const StateVector score = weight * jacobian.transpose() * rows[i].residual.segment(first, count);
      normal.hessian += weight * jacobian.transpose() * jacobian;
      normal.gradient += score;
      normal.scores[i] += score;
      least = std::min(least, robust);
    }
    if (least < 0.5) ++normal.outliers;
  }
  const StateVector from_prior = state_difference(problem.prior, state);
  for (int k = 0; k < kUnknowns; ++k) {
    if (problem.free[k]) {
      const double weight = 1.0 / (problem.prior_sigma[k] * problem.prior_sigma[k]);
      normal.hessian(k, k) += weight;
      normal.gradient[k] += weight * from_prior[k];
      continue;
    }
    normal.hessian.row(k).setZero();
    normal.hessian.col(k).setZero();
    normal.gradient[k] = 0.0;
    for (StateVector& score : normal.scores) score[k] = 0.0;
  }
  return normal;
}

StateMatrix inverse_of_free(const VehicleFrameProblem& problem, const StateMatrix& hessian) {
  std::vector<int> free;
  for (int k = 0; k < kUnknowns; ++k)
    if (problem.free[k]) free.push_back(k);
  const auto n = static_cast<Eigen::Index>(free.size());
  // Scaled to a unit diagonal: unknowns are metres, radians and rates.
  const StateVector scale = hessian.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd reduced = (scale.asDiagonal() * hessian * scale.asDiagonal()).eval()(free, free);
  const Eigen::MatrixXd inverse = symmetric_solution(reduced, Eigen::MatrixXd::Identity(n, n));
  StateMatrix out = StateMatrix::Zero();
  out(free, free) = inverse;
  return scale.asDiagonal() * out * scale.asDiagonal();
}

// Errors of wheels and odometry last longer than an interval.
StateMatrix widened_by_lasting_errors(const StateMatrix& covariance, const std::vector<StateVector>& scores) {
  Eigen::MatrixXd rows(scores.size(), kUnknowns);
  for (std::size_t i = 0; i < scores.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = scores[i].transpose();
  const StateVector factor = lasting_widening(covariance, rows);
  return factor.asDiagonal() * covariance * factor.asDiagonal();
}

// How much of what the rows say of X would be there if the vehicle had not moved: noise of turns and ways, squared,
// looks like turns and ways. The noise of a residual is the most that either side of it can have.
SpuriousInformation excitation_of(const VehicleFrameProblem& problem, const VehicleFrameSolution& solution) {
  SpuriousInformation out;
  const Vector6d prior = problem.prior_sigma.head<6>().cwiseAbs2().cwiseInverse();
  out.apparent = symmetric_inverse(solution.covariance.topLeftCorner<6, 6>());
  for (int k = 0; k < 6; ++k)
    if (problem.free[k]) out.apparent(k, k) -= prior[k];
  const auto count = static_cast<double>(problem.intervals->size());
  const double ratio = problem.used[kTurn] ? solution.sigma[kTurn] / solution.sigma[kWay] : 0.0;
  // Two axes of three are square to each direction of noise. A rotation is seen by ways and by turns.
  out.spurious.topLeftCorner<3, 3>() = 2.0 * count * ratio * ratio * Matrix3d::Identity();
  out.spurious.bottomRightCorner<3, 3>() = (problem.used[kTurn] ? 4.0 : 2.0) * count * Matrix3d::Identity();
  return out;
}

}  // namespace

VehicleFrameState state_after(const VehicleFrameState& state, const StateVector& delta) {
  VehicleFrameState out = state;
  out.vehicle_from_sensor = perturb(state.vehicle_from_sensor, delta.head<6>());
  out.log_scale += delta[6];
  out.log_wheel_scale += delta[7];
  out.gyro_bias_radps += delta.segment<3>(8);
  out.vehicle_from_imu = so3_exp(delta.segment<3>(11)) * state.vehicle_from_imu;
  out.track_m += delta[14];
  out.vehicle_from_reference = so3_exp(delta.segment<3>(15)) * state.vehicle_from_reference;
  out.pitch_centre_m += delta[18];
  out.log_gyro_scale += delta[19];
  out.gyro_scale_apart += delta.segment<3>(20);
  out.wheel_asymmetry += delta[23];
  return out;
}

StateVector state_difference(const VehicleFrameState& from, const VehicleFrameState& to) {
  StateVector delta;
  delta << difference(from.vehicle_from_sensor, to.vehicle_from_sensor), to.log_scale - from.log_scale,
      to.log_wheel_scale - from.log_wheel_scale, to.gyro_bias_radps - from.gyro_bias_radps,
      so3_log(to.vehicle_from_imu * from.vehicle_from_imu.transpose()), to.track_m - from.track_m,
      so3_log(to.vehicle_from_reference * from.vehicle_from_reference.transpose()),
      to.pitch_centre_m - from.pitch_centre_m, to.log_gyro_scale - from.log_gyro_scale,
      to.gyro_scale_apart - from.gyro_scale_apart, to.wheel_asymmetry - from.wheel_asymmetry;
  return delta;
}

RateErrors rate_errors(const VehicleFrameState& state) {
  RateErrors errors;
  errors << state.gyro_bias_radps, state.log_gyro_scales();
  return errors;
}

IntegratedInterval integrate(const VehicleInterval& interval, const RateErrors& errors) {
  constexpr double kStep = 1e-5;
  const auto under = [&](const RateErrors& each) {
    return motion::preintegrate(interval.steps, each.head<3>(), each.tail<3>().array().exp());
  };
  IntegratedInterval out;
  out.interval = &interval;
  out.errors = errors;
  out.nominal = under(errors);
  for (int k = 0; k < 6; ++k) {
    const motion::WheelPreintegration up = under(errors + kStep * RateErrors::Unit(k));
    const motion::WheelPreintegration down = under(errors - kStep * RateErrors::Unit(k));
    IntegratedInterval::Slope& slope = out.by_error[index_at(k)];
    slope.turn = so3_log(up.imu_start_from_imu_end * down.imu_start_from_imu_end.transpose()) / (2.0 * kStep);
    slope.turn_sum = (up.turn_in_imu_rad - down.turn_in_imu_rad) / (2.0 * kStep);
    slope.map = (up.travel_map_m - down.travel_map_m) / (2.0 * kStep);
    slope.difference_map = (up.difference_map_m - down.difference_map_m) / (2.0 * kStep);
    for (std::size_t axis = 0; axis < 3; ++axis)
      slope.turn_maps[axis] = (up.turn_maps_rad[axis] - down.turn_maps_rad[axis]) / (2.0 * kStep);
  }
  return out;
}

IntervalResidual residual_of(const IntegratedInterval& interval, const VehicleFrameState& state) {
  const motion::WheelPreintegration sum = with_errors(interval, rate_errors(state));
  const double wheel_scale = std::exp(state.log_wheel_scale);
  const RigidTransform p =
      sum.start_from_end(state.vehicle_from_imu, wheel_scale, state.pitch_centre_m, state.wheel_asymmetry);
  const RigidTransform& q = interval.interval->sensor_begin_from_sensor_end;
  const Matrix3d& rotation = state.vehicle_from_sensor.linear();
  const Vector3d lever_m = state.vehicle_from_sensor.translation();
  IntervalResidual residual = IntervalResidual::Zero();
  residual.segment<3>(0) = p * lever_m - rotation * (std::exp(state.log_scale) * q.translation()) - lever_m;
  residual.segment<3>(3) = so3_log(p.linear() * (rotation * q.linear() * rotation.transpose()).transpose());
  const Vector3d turn_rad = state.vehicle_from_imu * sum.turn_in_imu_rad;
  const double difference_m = sum.wheel_difference_m + 2.0 * state.wheel_asymmetry * sum.travel_m;
  residual[6] = wheel_scale * difference_m - state.track_m * turn_rad.z();
  if (interval.interval->reference_begin_from_end) {
    const Matrix3d& s = state.vehicle_from_reference;
    residual.segment<3>(7) =
        so3_log(p.linear() * (s * *interval.interval->reference_begin_from_end * s.transpose()).transpose());
  }
  residual[kLevelRow] = turn_rad.y();
  return residual;
}

IntervalJacobian jacobian_of(const IntegratedInterval& interval, const VehicleFrameState& state) {
  constexpr double kStep = 1e-5;
  IntervalJacobian jacobian;
  for (int k = 0; k < kUnknowns; ++k) {
    const StateVector step = kStep * StateVector::Unit(k);
    jacobian.col(k) =
        (residual_of(interval, state_after(state, step)) - residual_of(interval, state_after(state, -step))) /
        (2.0 * kStep);
  }
  return jacobian;
}

VehicleFrameSolution solve_problem(const VehicleFrameProblem& problem, const VehicleFrameState& start,
                                   const Progress& progress) {
  constexpr int kRounds = 60;
  VehicleFrameSolution solution;
  solution.state = start;
  double unknowns_per_kind = 0.0;
  for (const bool free : problem.free) unknowns_per_kind += free ? 1.0 / 3.0 : 0.0;
  Normal normal;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Linearised> rows = linearise(problem, solution.state, progress);
    if (rows.size() < problem.intervals->size()) {
      solution.cancelled = true;
      return solution;
    }
    std::vector<IntervalResidual> residuals;
    for (const Linearised& row : rows) residuals.push_back(row.residual);
    solution.sigma = estimate_sigma(problem, residuals, unknowns_per_kind);
    if (problem.used[kLevel]) solution.sigma[kLevel] *= std::sqrt(lasting_of_level(rows));
    normal = normal_equations(problem, rows, solution.sigma, solution.state);
    solution.covariance = inverse_of_free(problem, normal.hessian);
    const StateVector step = -solution.covariance * normal.gradient;
    if (!step.allFinite()) return solution;
    // A step of a radian is no small one: it is cut, and the next round linearises anew.
    const double turn = std::max(step.segment<3>(3).norm(), step.segment<3>(11).norm());
    solution.state = state_after(solution.state, turn > 0.3 ? StateVector(0.3 / turn * step) : step);
    const StateVector sigma = solution.covariance.diagonal().cwiseMax(1e-24).cwiseSqrt();
    // Directions that noise alone holds creep, and the noise is estimated anew: a fraction of their sigma is as good as
    // any other point.
    const double near = round < 15 ? 1e-2 : round < 30 ? 5e-2 : 0.2;
    if (round > 2 && step.cwiseQuotient(sigma).cwiseAbs().maxCoeff() < near) {
      solution.converged = true;
      break;
    }
  }
  solution.information = normal.hessian;
  solution.outliers = normal.outliers;
  if (problem.free[0] && problem.free[1] && problem.free[2]) solution.excitation = excitation_of(problem, solution);
  solution.covariance = widened_by_lasting_errors(solution.covariance, normal.scores);
  return solution;
}

Matrix6d stated_covariance(const Matrix6d& widened, const Vector6d& prior_information,
                           const std::vector<ObservabilityDirection>& directions, const SolveOptions& solve) {
  Matrix6d information = trusted_information(directions, solve);
  information.diagonal() += prior_information;
  const Matrix6d covariance = symmetric_inverse(information);
  const Vector6d factors = widened.diagonal().cwiseQuotient(covariance.diagonal()).cwiseMax(1.0).cwiseSqrt();
  return factors.asDiagonal() * covariance * factors.asDiagonal();
}

}  // namespace remount::calibration

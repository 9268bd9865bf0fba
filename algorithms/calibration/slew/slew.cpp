#include "algorithms/calibration/slew/slew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/slew/slew_details.h"
#include "algorithms/core/error.h"
#include "messages/calibration.h"
#include "messages/parameters.h"
#include "messages/stages.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kMostLean_rad = degrees_to_radians(30.0);  // of the rough up direction

void require_valid(const SlewOptions& options) {
  if (Message all = in_one(option_problems(options)); !all.empty())
    throw Error(ErrorCode::Contract, "slew options", std::move(all));
}

void refuse(Status status, Message message, Message advice, SlewResult& result) {
  result.calibration.conclude(status, std::move(message));
  result.calibration.advice.push_back(std::move(advice));
  claim_nothing(say::unknown_recordings_refused(), result.calibration);
}

/// What the frame is made of.
struct Pieces {
  Vector3d up, across;                    // normals of the first plane and of the arm's
  Vector3d centre_m;                      // of the slew circle
  Vector3d arm_m;                         // somewhere on the arm: says which way is forward
  std::optional<Vector3d> ground_normal;  // where the origin lies on the ground
  Vector3d ground_m = Vector3d::Zero();
};

// Axes n1, n2, n1 x n2: the first plane is kept, the arm's is made square to it. docs/maths/slew.md (M6)
RigidTransform frame_of(const Pieces& pieces) {
  Vector3d y = (pieces.across - pieces.across.dot(pieces.up) * pieces.up).normalized();
  Vector3d x = y.cross(pieces.up);
  if (x.dot(pieces.arm_m - pieces.centre_m) < 0.0) {
    x = -x;
    y = -y;
  }
  Matrix3d machine_from_lidar;
  machine_from_lidar << x.transpose(), y.transpose(), pieces.up.transpose();
  Vector3d origin_m = pieces.centre_m;
  if (pieces.ground_normal) {
    const Vector3d& normal = *pieces.ground_normal;
    origin_m -= normal.dot(pieces.centre_m - pieces.ground_m) / normal.dot(pieces.up) * pieces.up;
  }
  return make_rigid(machine_from_lidar, -machine_from_lidar * origin_m);
}

// An error of the pieces, [m; rad] as `apply` takes them, and its covariance.
struct PieceError {
  std::function<void(Pieces&, const Vector6d&)> apply;
  Matrix6d spread;
};

// Covariance of the frame under `perturb`: each error carried through `frame_of`.
Matrix6d propagate(const Pieces& pieces, const std::vector<PieceError>& errors) {
  constexpr double kStep = 1e-6;
  const RigidTransform frame = frame_of(pieces);
  Matrix6d covariance = Matrix6d::Zero();
  for (const PieceError& error : errors) {
    Matrix6d jacobian;
    for (int k = 0; k < 6; ++k) {
      Pieces up = pieces, down = pieces;
      error.apply(up, kStep * Vector6d::Unit(k));
      error.apply(down, -kStep * Vector6d::Unit(k));
      jacobian.col(k) = (difference(frame, frame_of(up)) - difference(frame, frame_of(down))) / (2.0 * kStep);
    }
    covariance += jacobian * error.spread * jacobian.transpose();
  }
  return covariance;
}

// Which of the points were measured along neighbouring rays: a LiDAR that stands still sees the same spots in every
// scan, whose roughness and errors of its beams no repetition averages out. What repeats is seen by what it does.
std::vector<std::size_t> spots_of(const std::vector<Vector3d>& points) {
  constexpr double kSpot_rad = 0.01;
  std::map<std::array<long, 3>, std::size_t> numbers;
  std::vector<std::size_t> spots;
  spots.reserve(points.size());
  for (const Vector3d& point : points) {
    const Vector3d ray = point.normalized() / kSpot_rad;
    spots.push_back(
        numbers.try_emplace({std::lround(ray.x()), std::lround(ray.y()), std::lround(ray.z())}, numbers.size())
            .first->second);
  }
  return spots;
}

bool fit_ground_plane(const SlewData& data, const SlewOptions& options, const Progress& progress, SlewResult& result) {
  PlaneFitOptions fit;
  fit.inlier_m = options.plane_inlier_m;
  fit.near_normal = data.up_in_lidar;
  fit.most_lean_rad = kMostLean_rad;
  result.ground = fit_plane(data.ground_points, fit, spots_of(data.ground_points), progress);
  constexpr double kLeastExtent_m = 0.5;
  if (result.ground.found && result.ground.short_extent_m < kLeastExtent_m) {
    result.ground.found = false;
    result.ground.why = say::slew_ground_strip();
  }
  return result.ground.found;
}

bool arm_is_missing(const SlewData& data, const Vector3d& up, const SlewOptions& options, const Progress& progress,
                    SlewResult& result) {
  PlaneFitOptions fit;
  fit.inlier_m = options.plane_inlier_m;
  fit.square_to = up;
  fit.most_lean_rad = degrees_to_radians(15.0);
  fit.trials = 1500;
  result.arm = fit_plane(data.arm_points, fit, spots_of(data.arm_points), progress);
  constexpr std::size_t kFewest = 50;
  constexpr double kLeastLong_m = 0.5, kLeastShort_m = 0.2;
  Message why = result.arm.why;
  if (result.arm.found && result.arm.inliers < kFewest)
    why = say::slew_few_arm_points(result.arm.inliers);
  else if (result.arm.found && (result.arm.long_extent_m < kLeastLong_m || result.arm.short_extent_m < kLeastShort_m))
    why = say::slew_small_arm({result.arm.long_extent_m}, {result.arm.short_extent_m});
  if (why.empty()) return false;
  result.arm.found = false;
  refuse(Status::TooLittleData, say::slew_no_arm(std::move(why)), say::slew_record_arm(), result);
  return true;
}

void refuse_short_arc(const SlewData& data, const SlewOptions& options, SlewResult& result) {
  const Angle arc{result.circle.arc_rad}, least{degrees_to_radians(options.min_arc_deg)};
  // Scans that are missing leave a hole in a turn that may well have been a whole one.
  const bool scans_are_missing = 20 * data.turn_scans_failed > data.turn_scans;
  if (scans_are_missing)
    refuse(Status::TooLittleData, say::slew_hole_in_turn(data.turn_scans_failed, data.turn_scans, arc, least),
           say::slew_turn_slowly(), result);
  else
    refuse(Status::TooLittleData, say::slew_short_arc(arc, least), say::slew_record_turn(), result);
}

bool turn_is_unusable(const SlewData& data, const SlewOptions& options, SlewResult& result) {
  const CircleFit& circle = result.circle;
  if (!circle.found) {
    refuse(Status::TooLittleData, say::slew_no_circle(circle.why), say::slew_record_turn(), result);
    return true;
  }
  if (circle.arc_rad < degrees_to_radians(options.min_arc_deg)) {
    refuse_short_arc(data, options, result);
    return true;
  }
  const double residual_m = std::hypot(circle.in_plane_rms_m, circle.off_plane_rms_m);
  if (circle.radius_m < 10.0 * residual_m && circle.radius_m < 0.5) {
    refuse(Status::TooLittleData, say::slew_small_circle({circle.radius_m}, {residual_m}), say::slew_mount_farther(),
           result);
    return true;
  }
  return false;
}

Matrix3d make_of_surfaces(const SlewOptions& options) {
  return std::pow(degrees_to_radians(options.surface_sigma_deg), 2) * Matrix3d::Identity();
}

// The lean of the ground as far as its noise does not explain it: nothing up to two and a half sigma, all of it far
// beyond. docs/maths/slew.md (M9)
void doubt_ground(const Vector3d& lean_rad, const Matrix3d& spread_rad2, SlewResult& result) {
  constexpr double kByChance = 6.0;  // squared sigmas
  const Vector3d& normal = result.ground.normal;
  Eigen::Matrix<double, 3, 2> across;
  across.col(0) = normal.unitOrthogonal();
  across.col(1) = normal.cross(across.col(0));
  const Eigen::Vector2d lean = across.transpose() * lean_rad;
  const Eigen::Matrix2d spread = across.transpose() * spread_rad2 * across;
  const double squared_sigmas = lean.dot(spread.inverse() * lean);
  if (!(squared_sigmas > kByChance)) return;
  result.ground_lean_variance_rad2 = (1.0 - kByChance / squared_sigmas) * lean_rad * lean_rad.transpose();
}

// Whether ground and turn contradict each other; with the ground as first plane that is a refusal, or a doubt of it.
bool ground_is_tilted(const SlewOptions& options, SlewResult& result) {
  Vector3d axis = result.axis.direction_in_lidar;
  if (axis.dot(result.ground.normal) < 0.0) axis = -axis;
  const Vector3d lean = result.ground.normal.cross(axis);
  result.ground_to_turn_rad = std::atan2(lean.norm(), result.ground.normal.dot(axis));
  const Matrix3d spread = result.ground.normal_covariance_rad2 + result.axis.covariance.bottomRightCorner<3, 3>();
  result.ground_to_turn_sigma_rad = std::sqrt(std::max(0.0, 0.5 * spread.trace()));
  doubt_ground(lean, spread + 2.0 * make_of_surfaces(options), result);
  if (options.first_plane != FirstPlane::Ground) return false;
  // A turn that is too noisy would let any ground pass.
  const double allowed_rad = degrees_to_radians(options.max_plane_angle_deg);
  const Angle sigma{result.ground_to_turn_sigma_rad};
  if (sigma.rad > 0.5 * allowed_rad) {
    refuse(Status::TooLittleData, say::slew_ground_vague(sigma, {allowed_rad}), say::slew_record_turn(), result);
    return true;
  }
  if (result.ground_to_turn_rad <= std::max(allowed_rad, 3.5 * sigma.rad)) return false;
  refuse(Status::Inconsistent, say::slew_ground_tilted({result.ground_to_turn_rad}, sigma, {allowed_rad}),
         say::slew_repeat_on_level(), result);
  return true;
}

bool arm_leans(const Vector3d& up, const SlewOptions& options, SlewResult& result) {
  result.arm_square_error_rad = std::asin(std::clamp(result.arm.normal.dot(up), -1.0, 1.0));
  const double lean_rad = std::abs(result.arm_square_error_rad);
  const double allowed_rad = degrees_to_radians(options.max_square_error_deg);
  if (lean_rad <= allowed_rad) return false;
  refuse(Status::Inconsistent, say::slew_arm_leans({lean_rad}, {allowed_rad}), say::slew_record_arm_again(), result);
  return true;
}

void fill_calibration(const Pieces& pieces, const Matrix6d& covariance, const SolveOptions& solve,
                      const std::optional<RigidTransform>& nominal, Message words, CalibrationResult& result) {
  const RigidTransform found = frame_of(pieces);
  result.covariance = parameter_covariance(found, covariance);
  const Vector6d limits = observation_limits(solve);
  ParameterSet observed;
  for (const Parameter parameter : kParameters) {
    const int row = row_of(parameter);
    if (result.covariance(row, row) < limits[row] * limits[row])
      observed.insert(parameter);
    else
      result.advice.push_back(say::slew_not_known_well(parameter_word(parameter)));
  }
  result.set_observed(observed, say::unknown_sigma_above_limit());
  result.mounting.reference_from_sensor = with_kept(found, nominal.value_or(RigidTransform::Identity()), ~observed);
  result.conclude(observed.is_all() ? Status::Ok : Status::Degenerate, std::move(words));
}

void fit_turn(const SlewData& data, SlewResult& result) {
  std::vector<Vector3d> positions;
  for (const RigidTransform& pose : data.first_from_lidar) positions.push_back(pose.translation());
  result.circle = fit_circle(positions);
  result.axis = fit_slew_axis(data.first_from_lidar);
  CircleFit& circle = result.circle;
  if (circle.found && !result.axis.found) {
    circle.found = false;
    circle.why = say::slew_attitude_stands();
  }
  // The height of the origin is that of the circle: known as well as its poses lie in a plane.
  const double height2 = circle.axis.dot(circle.centre_covariance_m2 * circle.axis);
  const Vector3d& along = result.axis.direction_in_lidar;
  result.axis.covariance.topLeftCorner<3, 3>() += height2 * along * along.transpose();
}

// Whether the recordings fit together; the arm's plane is fitted on the way. Otherwise refused.
bool are_usable(const SlewData& data, const SlewOptions& options, const Progress& progress, Pieces& pieces,
                SlewResult& result) {
  const auto cancelled = [&] {
    if (progress.cancelled()) refuse(Status::Cancelled, say::calibration_cancelled(), say::slew_start_again(), result);
    return progress.cancelled();
  };
  const bool needs_ground = options.first_plane == FirstPlane::Ground || options.origin == MachineOrigin::Ground;
  const bool ground = fit_ground_plane(data, options, progress, result);
  if (cancelled() || turn_is_unusable(data, options, result)) return false;
  if (needs_ground && !ground) {
    refuse(Status::TooLittleData, say::slew_no_ground(result.ground.why), say::slew_record_ground(), result);
    return false;
  }
  if (ground && ground_is_tilted(options, result)) return false;
  const Vector3d up_hint = ground ? result.ground.normal : data.up_in_lidar;
  for (Vector3d* axis : {&result.circle.axis, &result.axis.direction_in_lidar})
    if (axis->dot(up_hint) < 0.0) *axis = -*axis;
  pieces.up = options.first_plane == FirstPlane::Ground ? result.ground.normal : result.axis.direction_in_lidar;
  if (arm_is_missing(data, pieces.up, options, progress, result) || arm_leans(pieces.up, options, result) ||
      cancelled())
    return false;
  pieces.across = result.arm.normal;
  pieces.centre_m = result.axis.centre_in_lidar_m;
  pieces.arm_m = result.arm.centre_m;
  if (options.origin == MachineOrigin::Ground) {
    pieces.ground_normal = result.ground.normal;
    pieces.ground_m = result.ground.centre_m;
  }
  return true;
}

Matrix6d as_turn(const Matrix3d& spread_rad2) {
  Matrix6d spread = Matrix6d::Zero();
  spread.bottomRightCorner<3, 3>() = spread_rad2;
  return spread;
}

Matrix6d covariance_of(const Pieces& pieces, const SlewOptions& options, const SlewResult& result) {
  const Matrix3d make = make_of_surfaces(options);
  const bool by_ground = options.first_plane == FirstPlane::Ground;
  const auto ground = [by_ground](Pieces& p, const Vector6d& error) {
    const Matrix3d turn = so3_exp(error.tail<3>());
    p.ground_m += error.head<3>();
    if (p.ground_normal) p.ground_normal = turn * *p.ground_normal;
    if (by_ground) p.up = turn * p.up;  // one plane, one error
  };
  const auto axis = [by_ground](Pieces& p, const Vector6d& error) {
    p.centre_m += error.head<3>();
    if (!by_ground) p.up = so3_exp(error.tail<3>()) * p.up;
  };
  const auto arm = [](Pieces& p, const Vector6d& error) { p.across = so3_exp(error.tail<3>()) * p.across; };
  // Where the turn gives the first plane, the lean of the ground is known and no error.
  const Matrix3d lean = by_ground ? result.ground_lean_variance_rad2 : Matrix3d::Zero();
  Matrix6d of_ground = as_turn(result.ground.normal_covariance_rad2 + make + lean);
  of_ground.diagonal().head<3>().setConstant(std::pow(result.ground.offset_sigma_m, 2));
  return propagate(pieces, {{ground, of_ground},
                            {axis, result.axis.covariance + as_turn(make)},
                            {arm, as_turn(result.arm.normal_covariance_rad2 + make)}});
}

}  // namespace

SlewResult solve_slew(const SlewData& data, const std::optional<RigidTransform>& nominal_machine_from_lidar,
                      const SlewOptions& options, const SolveOptions& solve, Progress& progress) {
  require_valid(options);
  SlewResult result;
  CalibrationResult& calibration = result.calibration;
  calibration.mounting.reference = BodyFrame::Machine;
  if (nominal_machine_from_lidar) calibration.mounting.reference_from_sensor = *nominal_machine_from_lidar;
  progress.report(say::stage_fitting_planes_and_circle, 0, 0);
  fit_turn(data, result);
  Pieces pieces;
  if (!are_usable(data, options, progress, pieces, result)) return result;
  const auto words = options.first_plane == FirstPlane::Ground ? say::slew_by_ground : say::slew_by_turn;
  fill_calibration(pieces, covariance_of(pieces, options, result), solve, nominal_machine_from_lidar,
                   words({result.circle.arc_rad}), calibration);
  calibration.translation_rms_m = std::hypot(result.circle.in_plane_rms_m, result.circle.off_plane_rms_m);
  name_slew_quantities(result);
  draw_slew(data, result);
  return result;
}

}  // namespace remount::calibration

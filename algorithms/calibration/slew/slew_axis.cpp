#include "algorithms/calibration/slew/slew_axis.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

#include "algorithms/core/decompositions.h"
#include "algorithms/core/index.h"
#include "algorithms/core/median.h"

namespace remount::calibration {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Matrix4d = Eigen::Matrix4d;

constexpr std::size_t kFewest = 8;

/// Two unit vectors across a unit vector.
Eigen::Matrix<double, 3, 2> across(const Vector3d& axis) {
  Eigen::Matrix<double, 3, 2> both;
  both.col(0) = axis.unitOrthogonal();
  both.col(1) = axis.cross(both.col(0));
  return both;
}

/// Turns M_i in the plane across the axis, and what is to follow them: |M_i x + offset_i - common|, x in the LiDAR's
/// frame, `common` in that of the first scan.
struct Turns {
  Vector3d in_lidar, in_first;  // the axis
  std::vector<Matrix2d> turn;
  std::vector<Vector2d> place_m, tilt;  // offsets: of the LiDAR's place, and of the axis as each pose has it
};

Turns turns_of(const std::vector<RigidTransform>& poses, const std::vector<double>& weights) {
  Matrix3d sum = Matrix3d::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) sum += weights[i] * poses[i].linear();
  // |R_i v - w| is least for all together where v' sum' w is greatest.
  const Eigen::JacobiSVD<Matrix3d> svd = singular_values(sum);
  Turns turns{svd.matrixV().col(0), svd.matrixU().col(0), {}, {}, {}};
  const auto from_lidar = across(turns.in_lidar), from_first = across(turns.in_first);
  for (const RigidTransform& pose : poses) {
    turns.turn.push_back(from_first.transpose() * pose.linear() * from_lidar);
    turns.place_m.push_back(from_first.transpose() * pose.translation());
    turns.tilt.push_back(from_first.transpose() * pose.linear() * turns.in_lidar);
  }
  return turns;
}

template <class Value>
Value mean_of(const std::vector<Value>& values, const std::vector<double>& weights) {
  Value sum = Value::Zero();
  double weight = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) sum += weights[i] * values[i], weight += weights[i];
  return sum / weight;
}

/// Least squares of one kind of offset, with a soft limit (Tukey).
struct Fit {
  Vector2d x = Vector2d::Zero();
  std::vector<Vector2d> residuals;
  std::vector<double> weights;
  double limit = std::numeric_limits<double>::infinity();  ///< residuals as long as this have no weight
};

/// False where the poses do not turn. docs/maths/slew.md (M5)
bool solve(const Turns& turns, const std::vector<Vector2d>& offsets, Fit& fit) {
  const Matrix2d mean_turn = mean_of(turns.turn, fit.weights);
  const Vector2d mean_offset = mean_of(offsets, fit.weights);
  Matrix2d normal = Matrix2d::Zero();
  Vector2d gradient = Vector2d::Zero();
  double weight = 0.0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const Matrix2d back = fit.weights[i] * (turns.turn[i] - mean_turn).transpose();
    normal += back * (turns.turn[i] - mean_turn);
    gradient += back * (offsets[i] - mean_offset);
    weight += fit.weights[i];
  }
  constexpr double kLeastTurn = 1e-6;
  if (!(normal.determinant() > kLeastTurn * weight * weight)) return false;
  fit.x = -normal.ldlt().solve(gradient);
  fit.residuals.clear();
  for (std::size_t i = 0; i < offsets.size(); ++i)
    fit.residuals.push_back((turns.turn[i] - mean_turn) * fit.x + offsets[i] - mean_offset);
  return true;
}

/// Weights for the next round; `least`: exact poses are not told apart by rounding.
void weigh(double least, Fit& fit) {
  std::vector<double> sizes;
  for (const Vector2d& residual : fit.residuals) sizes.push_back(residual.norm());
  constexpr double kMedianOfTwo = 1.1774;  // of the length of two unit normal errors
  constexpr double kTukey = 4.685;
  fit.limit = std::max(least, kTukey * median_of(sizes) / kMedianOfTwo);
  for (std::size_t i = 0; i < sizes.size(); ++i)
    fit.weights[i] = sizes[i] < fit.limit ? std::pow(1.0 - std::pow(sizes[i] / fit.limit, 2), 2) : 0.0;
}

/// What each pose pulls, and how stiff they all are together; pulls fall off beyond the limit, and so does stiffness
/// (Huber 1964).
struct Pulls {
  std::array<std::vector<double>, 2> by_axis;
  Matrix2d stiffness = Matrix2d::Zero();
};

Pulls pulls_of(const Turns& turns, const Fit& fit) {
  const Matrix2d mean_turn = mean_of(turns.turn, fit.weights);
  Pulls pulls;
  for (std::size_t i = 0; i < fit.residuals.size(); ++i) {
    const Matrix2d by_x = turns.turn[i] - mean_turn;
    const Vector2d share = fit.residuals[i] / fit.limit;
    const Vector2d pull = fit.weights[i] * by_x.transpose() * fit.residuals[i];
    for (int k = 0; k < 2; ++k) pulls.by_axis[index_at(k)].push_back(pull[k]);
    if (fit.weights[i] <= 0.0) continue;
    const Matrix2d slope =
        fit.weights[i] * Matrix2d::Identity() - 4.0 * (1.0 - share.squaredNorm()) * share * share.transpose();
    pulls.stiffness += by_x.transpose() * slope * by_x;
  }
  return pulls;
}

/// By how much the variance of all pulls together is larger than that of independent ones. What shifts the axis stays
/// the same in the LiDAR's axes, and leaves no residual; what changes slowly over the turn does, and stands for it: the
/// spectrum of the pulls about that place, over its mean. The first scan's side takes what goes around once backwards.
double lasting_of(const Turns& turns, const Pulls& pulls) {
  constexpr std::array<int, 5> kSlow{1, 2, -2, 3, -3};  // times around in the turn
  std::array<std::complex<double>, kSlow.size()> sums{};
  double power = 0.0;
  for (std::size_t i = 0; i < turns.turn.size(); ++i) {
    const Matrix2d& turn = turns.turn[i];
    const double angle_rad = std::atan2(turn(1, 0) - turn(0, 1), turn(0, 0) + turn(1, 1));
    const std::complex<double> pull(pulls.by_axis[0][i], pulls.by_axis[1][i]);
    power += std::norm(pull);
    for (std::size_t k = 0; k < kSlow.size(); ++k) sums[k] += pull * std::polar(1.0, -kSlow[k] * angle_rad);
  }
  double slow = 0.0;
  for (const std::complex<double>& sum : sums) slow += std::norm(sum) / static_cast<double>(kSlow.size());
  if (power <= 0.0) return 1.0;
  // Errors over a spread that was estimated from n numbers have squares n / (n - 2) as large (Student). Where
  // independent errors may look so by chance, theirs is known from all poses.
  constexpr double kNumbers = 2.0 * kSlow.size(), kByChance = 1.6;
  const double ratio = slow / power;
  return ratio > kByChance ? kNumbers / (kNumbers - 2.0) * ratio : std::max(1.0, ratio);
}

/// Of the centre (two axes across) and the direction.
Matrix4d spread_of(const Turns& turns, const Fit& centre, const Fit& direction) {
  const std::array<Pulls, 2> both{pulls_of(turns, centre), pulls_of(turns, direction)};
  // Two offsets a pose, and two unknowns on either side.
  constexpr double kTaken = 2.0;
  const auto count = static_cast<double>(turns.turn.size());
  Matrix4d squares = Matrix4d::Zero(), inverse = Matrix4d::Zero();
  Eigen::Vector4d wider;
  for (int k = 0; k < 4; ++k) {
    const auto part = [&](int at) -> const std::vector<double>& {
      return both[index_at(at / 2)].by_axis[index_at(at % 2)];
    };
    wider[k] = std::sqrt(lasting_of(turns, both[index_at(k / 2)]) * count / (count - kTaken));
    for (int m = 0; m < 4; ++m)
      squares(k, m) = std::inner_product(part(k).begin(), part(k).end(), part(m).begin(), 0.0);
  }
  inverse.topLeftCorner<2, 2>() = both[0].stiffness.inverse();
  inverse.bottomRightCorner<2, 2>() = both[1].stiffness.inverse();
  return inverse * wider.asDiagonal() * squares * wider.asDiagonal() * inverse.transpose();
}

}  // namespace

SlewAxis fit_slew_axis(const std::vector<RigidTransform>& first_from_lidar) {
  const std::size_t count = first_from_lidar.size();
  if (count < kFewest) return {};
  Fit centre, direction;
  centre.weights = direction.weights = std::vector<double>(count, 1.0);
  Turns turns;
  constexpr int kRounds = 30;
  constexpr double kLeast_m = 1e-5, kLeast_rad = 1e-6;
  for (int round = 0; round < kRounds; ++round) {
    if (round > 0) weigh(kLeast_m, centre), weigh(kLeast_rad, direction);
    turns = turns_of(first_from_lidar, direction.weights);
    if (!solve(turns, turns.place_m, centre) || !solve(turns, turns.tilt, direction)) return {};
  }
  const auto from_lidar = across(turns.in_lidar);
  SlewAxis axis;
  axis.found = true;
  axis.direction_in_lidar = turns.in_lidar;  // its own fit moves it no further
  axis.centre_in_lidar_m = from_lidar * centre.x;
  Eigen::Matrix<double, 6, 4> by_parts = Eigen::Matrix<double, 6, 4>::Zero();
  by_parts.topLeftCorner<3, 2>() = from_lidar;
  by_parts.bottomRightCorner<3, 2>() = skew(turns.in_lidar) * from_lidar;
  axis.covariance = by_parts * spread_of(turns, centre, direction) * by_parts.transpose();
  axis.found = axis.covariance.allFinite();
  return axis;
}

}  // namespace remount::calibration

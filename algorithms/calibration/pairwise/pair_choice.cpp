#include "algorithms/calibration/pairwise/pair_choice.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/linear_solutions.h"
#include "algorithms/calibration/observability.h"
#include "algorithms/calibration/pairwise/joint_problem.h"
#include "algorithms/calibration/pairwise/uncertainty.h"
#include "algorithms/motion/pairing.h"

namespace remount::calibration {
namespace {

constexpr std::size_t kSectors = 8;  // of headings
constexpr std::size_t kLengths = 4;  // classes of how far the scans of a pair are apart
constexpr std::size_t kWaysTurned = 3;
constexpr std::ptrdiff_t kNeighbours = 20;  // registered pairs before and after one that is not
constexpr double kStretch_s = 10.0;         // of time
constexpr double kCostOfScan = 1.5;         // of preparing one, in registrations
constexpr double kUsual_m = 3e-3;           // of a registration whose scans nobody has looked at yet
constexpr double kUsual_rad = 2.5e-4;       // likewise

Matrix6d usual_information() {
  Vector6d sigmas;
  sigmas << Eigen::Vector3d::Constant(kUsual_m), Eigen::Vector3d::Constant(kUsual_rad);
  return sigmas.cwiseAbs2().cwiseInverse().asDiagonal();
}

// Of the motions of two pairs: what two scans show together depends on how far they are apart.
double unlikeness(const motion::Pair& one, const motion::Pair& other) {
  constexpr double kWay_m = 1.0, kTurn_rad = 0.1;
  return std::abs(one.baseline_m - other.baseline_m) / kWay_m +
         std::abs(one.rotation_rad - other.rotation_rad) / kTurn_rad;
}

std::size_t sector_of(const RigidTransform& local_from_ins) {
  const Eigen::Vector3d forward = local_from_ins.linear().col(0);
  const double share = std::atan2(forward.y(), forward.x()) / (2.0 * std::numbers::pi) + 0.5;
  return std::min(kSectors - 1, static_cast<std::size_t>(share * static_cast<double>(kSectors)));
}

// To the right, hardly, or to the left.
std::size_t way_turned(const RigidTransform& ins_b_from_ins_a) {
  constexpr double kHardly_rad = 0.01;
  const double to_right_rad = so3_log(ins_b_from_ins_a.linear()).z();
  return to_right_rad > kHardly_rad ? 0 : to_right_rad < -kHardly_rad ? 2 : 1;
}

// Between classes of length that hold equally many pairs.
std::vector<double> length_bounds_m(const std::vector<motion::Pair>& pairs) {
  std::vector<double> lengths_m, bounds_m;
  for (const motion::Pair& pair : pairs) lengths_m.push_back(pair.baseline_m);
  std::ranges::sort(lengths_m);
  for (std::size_t i = 1; i < kLengths && !pairs.empty(); ++i)
    bounds_m.push_back(lengths_m[i * pairs.size() / kLengths]);
  return bounds_m;
}

}  // namespace

void expect_registrations(const RigidTransform& ins_from_lidar, std::vector<motion::Pair>& pairs) {
  std::vector<motion::PairIndex> accepted;
  for (motion::PairIndex i; i < pairs.size(); ++i)
    if (pairs[i].registration.attempted && pairs[i].state == motion::PairState::Accepted) accepted.push_back(i);
  for (motion::PairIndex i; i < pairs.size(); ++i) {
    motion::Pair& pair = pairs[i];
    if (pair.registration.attempted) continue;
    pair.lidar_b_from_lidar_a = predicted_lidar_motion(pair.ins_b_from_ins_a, ins_from_lidar);
    pair.registration.information = usual_information();
    const auto after = std::ranges::lower_bound(accepted, i);
    const auto first = after - std::min<std::ptrdiff_t>(kNeighbours, after - accepted.begin()),
               last = after + std::min<std::ptrdiff_t>(kNeighbours, accepted.end() - after);
    const auto most_alike = std::min_element(first, last, [&](motion::PairIndex one, motion::PairIndex other) {
      return unlikeness(pair, pairs[one]) < unlikeness(pair, pairs[other]);
    });
    if (most_alike == last) continue;
    pair.registration.information = pairs[*most_alike].registration.information;
  }
}

Matrix6d expected_information(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                              const std::vector<double>& weights, const NoiseModel& noise,
                              const RigidTransform& ins_from_lidar, const Progress& progress) {
  std::vector<motion::Pair> counted;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (weights[i] > 0.0) counted.emplace_back(pairs[i]).weight = weights[i];
  const std::vector<motion::KeyframeIndex> kept = motion::keyframes_of(counted, input.nodes.size());
  motion::renumber_keyframes(kept, counted);
  PairwiseInput of_these = input;
  of_these.beams = {};
  of_these.nodes.clear();
  for (const motion::KeyframeIndex k : kept) of_these.nodes.push_back(input.nodes[k]);
  std::vector<motion::PairIndex> all;
  for (motion::PairIndex i; i < counted.size(); ++i) all.push_back(i);
  const JointProblem problem = make_joint_problem(of_these, counted, all, ins_from_lidar, ins_from_lidar);
  return solve_joint(problem, noise, ins_from_lidar, 1, progress).information;
}

PairChooser::PairChooser(const PairwiseInput& input, const std::vector<motion::Pair>& pairs, const NoiseModel& noise,
                         const RigidTransform& ins_from_lidar, std::vector<bool> taken)
    : taken_(std::move(taken)),
      uses_(input.nodes.size(), 0),
      sector_taken_(kSectors, 0),
      length_taken_(kLengths, 0),
      way_turned_taken_(kWaysTurned, 0) {
  const std::vector<double> bounds_m = length_bounds_m(pairs);
  const Vector6d units = observation_limits(input.options);
  const auto scaled = [&](const Matrix6d& information) {
    return Matrix6d(units.asDiagonal() * information * units.asDiagonal());
  };
  known_ = triangle_of(scaled(weak_prior(input.nominal_ins_from_lidar.has_value())), 1.0);
  invert_known();
  const PairTilts tilts_rad = assumed_tilts_rad(input, pairs);
  std::map<std::pair<motion::SessionIndex, int>, std::size_t> stretch_at;
  for (motion::PairIndex i; i < pairs.size(); ++i) {
    const motion::Pair& pair = pairs[i];
    const JointNode& node = input.nodes[pair.keyframe_a];
    const PairEquation equation = linearise_pair(pair.ins_b_from_ins_a, pair.lidar_b_from_lidar_a, ins_from_lidar);
    const Matrix6d information = residual_information(pair, equation, noise, tilts_rad[i]);
    adds_.push_back(triangle_of(scaled(equation.d_x.transpose() * information * equation.d_x), 1.0));
    keyframe_a_.push_back(pair.keyframe_a);
    keyframe_b_.push_back(pair.keyframe_b);
    sector_.push_back(sector_of(node.local_from_ins));
    way_turned_.push_back(way_turned(pair.ins_b_from_ins_a));
    length_.push_back(static_cast<std::size_t>(std::ranges::lower_bound(bounds_m, pair.baseline_m) - bounds_m.begin()));
    const auto [place, is_new] = stretch_at.try_emplace(
        {node.session, static_cast<int>(std::floor(node.time_s / kStretch_s))}, stretches_.size());
    if (is_new) stretches_.emplace_back();
    stretches_[place->second].pairs.push_back(i);
  }
  for (Stretch& stretch : stretches_)
    for (const motion::PairIndex i : stretch.pairs)
      if (taken_[i]) count_in(i, stretch);
}

PairChooser::Triangle PairChooser::triangle_of(const Matrix6d& symmetric, double doubled) {
  Triangle triangle;
  Eigen::Index at = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column)
      triangle[at++] = (row == column ? 1.0 : doubled) * symmetric(row, column);
  return triangle;
}

// What it adds, over the work it is; the less, the more of its keyframes, its stretch and its heading are taken.
double PairChooser::worth_of(motion::PairIndex pair, const Stretch& stretch) const {
  const std::size_t a = uses_[keyframe_a_[pair]], b = uses_[keyframe_b_[pair]];
  const auto crowded = [this](std::size_t taken, std::size_t places) {
    return static_cast<double>(taken * places) / static_cast<double>(taken_count_ + 1);
  };
  const double cost = 1.0 + kCostOfScan * ((a == 0 ? 1.0 : 0.0) + (b == 0 ? 1.0 : 0.0));
  return adds_[pair].dot(covariance_) /
         (cost * (1.0 + 0.5 * static_cast<double>(a + b)) * (1.0 + crowded(stretch.taken, stretches_.size())) *
          (1.0 + crowded(sector_taken_[sector_[pair]], kSectors)) *
          (1.0 + std::pow(crowded(length_taken_[length_[pair]], kLengths), 4)) *
          (1.0 + crowded(way_turned_taken_[way_turned_[pair]], kWaysTurned)));
}

void PairChooser::find_best(Stretch& stretch) const {
  stretch.best.reset();
  stretch.worth = -1.0;  // of one that has no more
  for (const motion::PairIndex i : stretch.pairs) {
    if (taken_[i]) continue;
    const double worth = worth_of(i, stretch);
    if (stretch.best && worth <= stretch.worth) continue;
    stretch.best = i;
    stretch.worth = worth;
  }
}

void PairChooser::count_in(motion::PairIndex pair, Stretch& stretch) {
  taken_[pair] = true;
  ++taken_count_;
  ++stretch.taken;
  ++sector_taken_[sector_[pair]];
  ++length_taken_[length_[pair]];
  ++way_turned_taken_[way_turned_[pair]];
  ++uses_[keyframe_a_[pair]];
  ++uses_[keyframe_b_[pair]];
  known_ += adds_[pair];
  invert_known();
}

void PairChooser::invert_known() {
  Matrix6d information;
  Eigen::Index at = 0;
  for (int row = 0; row < 6; ++row)
    for (int column = row; column < 6; ++column) information(row, column) = information(column, row) = known_[at++];
  covariance_ = triangle_of(symmetric_inverse(information), 2.0);
}

void PairChooser::take(std::size_t count) {
  for (Stretch& stretch : stretches_) find_best(stretch);
  const auto by_worth = [](const Stretch& one, const Stretch& other) { return one.worth < other.worth; };
  for (std::size_t more = 0; more < count && taken_count_ < taken_.size();) {
    Stretch& best = *std::ranges::max_element(stretches_, by_worth);
    if (!best.best) return;
    // What is taken elsewhere since has made it worth less: it is taken once it has been looked for under the present.
    const double before = best.worth;
    find_best(best);
    if (best.worth < before && &*std::ranges::max_element(stretches_, by_worth) != &best) continue;
    count_in(*best.best, best);
    find_best(best);
    ++more;
  }
}

}  // namespace remount::calibration

// Solving from motions that were computed elsewhere.
#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <map>

#include "algorithms/calibration/pairwise/pairwise.h"
#include "algorithms/core/error.h"
#include "messages/pairs.h"
#include "messages/pipeline.h"
#include "model/conventions/impossible_motion.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/solve_stage.h"

namespace remount::pipeline {
namespace {

// Local frame of each keyframe's group from its INS, chained through the pairs; nothing where keyframes that share
// numbers do not share poses: P of a loop does not close, a pair names one keyframe twice, or no loop tells.
std::optional<std::vector<RigidTransform>> chained_poses(std::size_t keyframes,
                                                         const std::vector<motion::Pair>& pairs) {
  constexpr double kClosed_m = 2e-3, kClosed_rad = 1e-4;  // digits that were not printed, and their sum along a chain
  std::vector<std::vector<motion::PairIndex>> pairs_of(keyframes);
  for (motion::PairIndex i; i < pairs.size(); ++i) {
    if (pairs[i].keyframe_a == pairs[i].keyframe_b) return std::nullopt;
    pairs_of[pairs[i].keyframe_a].push_back(i);
    pairs_of[pairs[i].keyframe_b].push_back(i);
  }
  std::vector<RigidTransform> poses(keyframes, RigidTransform::Identity());
  std::size_t tree_pairs = 0;
  std::vector<bool> placed(keyframes, false);
  for (motion::KeyframeIndex start; start < keyframes; ++start) {
    if (placed[start]) continue;
    placed[start] = true;
    for (std::deque<motion::KeyframeIndex> queue{start}; !queue.empty(); queue.pop_front()) {
      const motion::KeyframeIndex here = queue.front();
      for (const motion::PairIndex i : pairs_of[here]) {
        const motion::KeyframeIndex a = pairs[i].keyframe_a, b = pairs[i].keyframe_b;
        const RigidTransform& p = pairs[i].ins_b_from_ins_a;
        const motion::KeyframeIndex other = here == a ? b : a;
        const RigidTransform pose = poses[here] * (here == a ? RigidTransform(p.inverse()) : p);
        if (!placed[other]) {
          poses[other] = pose;
          placed[other] = true;
          ++tree_pairs;
          queue.push_back(other);
        }
        const Vector6d gap = difference(poses[other], pose);
        if (!(gap.head<3>().norm() < kClosed_m && gap.tail<3>().norm() < kClosed_rad)) return std::nullopt;
      }
    }
  }
  if (tree_pairs == pairs.size()) return std::nullopt;
  return poses;
}

// One node a keyframe, in the order of their numbers. Fills the pairs' nodes.
void add_shared_nodes(const std::vector<motion::Keyframe>& keyframes, const std::vector<RigidTransform>& poses,
                      calibration::PairwiseInput& input, std::vector<motion::Pair>& pairs) {
  std::vector<std::size_t> order(keyframes.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t left, std::size_t right) {
    return std::pair(keyframes[left].session, keyframes[left].scan) <
           std::pair(keyframes[right].session, keyframes[right].scan);
  });
  std::vector<motion::KeyframeIndex> node_of(keyframes.size());
  motion::ScanIndex first_scan;
  for (motion::KeyframeIndex place; place < order.size(); ++place) {
    const std::size_t k = order[place];
    node_of[k] = place;
    calibration::JointNode node;
    node.session = keyframes[k].session;
    const bool first = place == 0 || keyframes[order[place - 1]].session != node.session;
    if (first) first_scan = keyframes[k].scan;
    node.time_s = static_cast<double>(signed_of(keyframes[k].scan) - signed_of(first_scan));
    node.local_from_ins = poses[k];
    input.nodes.push_back(node);
  }
  for (motion::Pair& pair : pairs) {
    pair.keyframe_a = node_of[pair.keyframe_a];
    pair.keyframe_b = node_of[pair.keyframe_b];
  }
}

// Two nodes a pair, in the order of the list. Fills the pairs' nodes.
void add_own_nodes(const std::vector<motion::Keyframe>& keyframes, calibration::PairwiseInput& input,
                   std::vector<motion::Pair>& pairs) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    motion::Pair& pair = pairs[i];
    calibration::JointNode node;
    node.session = keyframes[pair.keyframe_b].session;
    node.time_s = static_cast<double>(i);
    input.nodes.push_back(node);
    pair.keyframe_b = motion::KeyframeIndex(2 * i);
    node.local_from_ins = pair.ins_b_from_ins_a;
    input.nodes.push_back(node);
    pair.keyframe_a = motion::KeyframeIndex(2 * i + 1);
  }
}

calibration::PairwiseInput motions_input(const std::vector<motion::Keyframe>& keyframes,
                                         std::vector<motion::Pair>& pairs, const settings::Settings& settings) {
  calibration::PairwiseInput input;
  input.range = settings.range;
  input.options = settings.solve;
  input.measured = calibration::Measured(settings.measured, std::nullopt);
  input.motions_only = true;
  // Places in the list are no seconds: as many blocks as a drive has.
  input.options.bootstrap_block_s = std::numeric_limits<double>::infinity();
  const std::optional<std::vector<RigidTransform>> poses = chained_poses(keyframes.size(), pairs);
  input.pairs_share_scans = poses.has_value();
  if (poses)
    add_shared_nodes(keyframes, *poses, input, pairs);
  else
    add_own_nodes(keyframes, input, pairs);
  for (const calibration::JointNode& node : input.nodes)
    if (node.session >= input.sessions.size()) input.sessions.resize(node.session + 1);
  for (calibration::SessionNoise& session : input.sessions) {
    // An attitude error common to all cannot be told from X. Poses that are shared drift as those of a log do, by what
    // is assumed of an INS in the time from one number to the next; motions that stand for themselves do not.
    session.attitude_bias_sigma_rad = 0.0;
    if (!input.pairs_share_scans) session.position_drift = session.attitude_drift = 0.0;
  }
  return input;
}

// Rows of a list that was put together of others: what is there twice is no second measurement. Returns how many.
std::size_t refuse_repeated(std::vector<motion::Pair>& pairs) {
  std::map<std::array<double, 24>, std::size_t> rows;
  std::size_t repeated = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    motion::Pair& pair = pairs[i];
    if (!pair.registration.failure.empty() ||
        (pair.decided_by == motion::DecidedBy::User && pair.state == motion::PairState::Rejected))
      continue;
    std::array<double, 24> row{};
    Eigen::Map<Eigen::Matrix<double, 3, 8>> values(row.data());
    values << pair.ins_b_from_ins_a.matrix().topRows<3>(), pair.lidar_b_from_lidar_a.matrix().topRows<3>();
    const auto [first, is_new] = rows.try_emplace(row, i);
    if (is_new) continue;
    ++repeated;
    pair.registration.failure = say::motion_pair_repeats(first->second + 1);
    pair.state = motion::PairState::Rejected;
    pair.decided_by = motion::DecidedBy::Program;
    pair.reason = pair.registration.failure;
  }
  return repeated;
}

}  // namespace

calibration::CalibrationResult solve_motion_pairs(const std::vector<motion::Keyframe>& keyframes,
                                                  std::vector<motion::Pair>& pairs, const settings::Settings& settings,
                                                  const std::optional<RigidTransform>& nominal_ins_from_lidar,
                                                  Progress& progress) {
  const Message problem = settings::nominal_problem(nominal_ins_from_lidar, settings.range);
  if (!problem.empty()) throw Error(ErrorCode::Contract, "nominal mounting", problem);
  if (settings.measured.ins_height_sigma_m > 0.0)
    throw Error(ErrorCode::Contract, "measured.ins_height_m", say::pipeline_pairs_show_no_ground());
  for (motion::Pair& pair : pairs) {
    pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
    pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
    pair.registration.attempted = pair.registration.converged = true;
    if (pair.registration.information.isZero(0.0)) pair.registration.information = Matrix6d::Identity() * 1e8;
    if (!conventions::is_possible_motion(pair.ins_b_from_ins_a) ||
        !conventions::is_possible_motion(pair.lidar_b_from_lidar_a))
      pair.registration.failure = say::pipeline_impossible_motion();
  }
  // The solver's nodes are not the caller's keyframes; squares of what is impossible would not be finite.
  std::vector<motion::Pair> solved = pairs;
  for (motion::Pair& pair : solved) {
    if (pair.registration.failure.empty()) continue;
    pair.ins_b_from_ins_a = pair.lidar_b_from_lidar_a = RigidTransform::Identity();
    if (pair.decided_by == motion::DecidedBy::User && pair.state == motion::PairState::Rejected) continue;
    pair.state = motion::PairState::Rejected;
    pair.decided_by = motion::DecidedBy::Program;
    pair.reason = pair.registration.failure;
  }
  const std::size_t repeated = refuse_repeated(solved);
  calibration::PairwiseInput input = motions_input(keyframes, solved, settings);
  input.nominal_ins_from_lidar = nominal_ins_from_lidar;
  calibration::CalibrationResult result = calibration::solve_pairwise(input, solved, progress);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    solved[i].keyframe_a = pairs[i].keyframe_a;
    solved[i].keyframe_b = pairs[i].keyframe_b;
    solved[i].ins_b_from_ins_a = pairs[i].ins_b_from_ins_a;
    solved[i].lidar_b_from_lidar_a = pairs[i].lidar_b_from_lidar_a;
  }
  pairs = std::move(solved);
  drop_clock(result);  // motion pairs carry no time
  if (repeated > 0) result.advice.push_back(say::motion_pairs_repeat(repeated, pairs.size()));
  return result;
}

}  // namespace remount::pipeline

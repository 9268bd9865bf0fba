#include "model/pipeline/coarse_start.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/pairwise/robust_start.h"
#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/motion/pairing.h"
#include "algorithms/registration/registration.h"
#include "messages/pipeline.h"
#include "messages/stages.h"
#include "model/pipeline/first_ground.h"
#include "model/pipeline/step_finder.h"

namespace remount::pipeline {
namespace {

constexpr std::size_t kMostScans = 160;  // of each session

// The stretch of consecutive scans with the most turning: turns are what shows X.
std::pair<std::size_t, std::size_t> busiest_stretch(const DriveMotion& motion, motion::SessionIndex session,
                                                    const std::vector<std::int64_t>& stamps) {
  if (stamps.size() <= kMostScans) return {0, stamps.size()};
  std::vector<double> turned_rad(stamps.size(), 0.0);
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const auto from = motion.local_from_ins(session, stamps[i - 1]), to = motion.local_from_ins(session, stamps[i]);
    turned_rad[i] = turned_rad[i - 1] + (from && to ? rotation_angle_between_rad(*from, *to) : 0.0);
  }
  std::size_t best = 0;
  for (std::size_t begin = 0; begin + kMostScans <= stamps.size(); ++begin)
    if (turned_rad[begin + kMostScans - 1] - turned_rad[begin] > turned_rad[best + kMostScans - 1] - turned_rad[best])
      best = begin;
  return {best, best + kMostScans};
}

// Chained lidar poses of a stretch; a failed registration starts a new chain.
struct Chain {
  std::vector<motion::Keyframe> keyframes;
  std::vector<RigidTransform> first_from_lidar;
};

registration::RegistrationOptions coarse_options(const registration::RegistrationOptions& options) {
  registration::RegistrationOptions coarse = options;
  coarse.algorithm = registration::RegistrationAlgorithm::PlaneToPlane;
  coarse.voxel_m = std::max(options.voxel_m, 0.4);
  coarse.max_correspondence_m = 2.0;
  coarse.max_iterations = 60;
  return coarse;
}

std::vector<Chain> chain_session(const DriveMotion& motion, ScanStore& scans, motion::SessionIndex session,
                                 const registration::RegistrationOptions& options, const Eigen::Vector3d& up_in_lidar,
                                 motion::KeyframeIndex& key, CoarseStart& out, int threads, Progress& progress) {
  const std::vector<std::int64_t> stamps = motion.lidar_stamps_ns(session);
  // Names of their own: clang 14 gives those of a structured binding to no lambda.
  const auto stretch = busiest_stretch(motion, session, stamps);
  const std::size_t begin = stretch.first, end = stretch.second;
  // Every scan of a stretch counts as a keyframe.
  const motion::KeyframeIndex first_key = key;
  key = motion::KeyframeIndex(key + (end - begin));
  std::vector<Chain> chains;
  StepFinder steps(options, up_in_lidar, progress);
  std::shared_ptr<const registration::PreparedCloud> previous;
  RigidTransform previous_local_from_ins = RigidTransform::Identity();
  // Preparation is what takes time and needs no order: a few scans ahead on all workers.
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = begin; i < end && !progress.cancelled(); ++i) {
    const auto keyframe_of = [&](std::size_t scan) {
      return motion::Keyframe{session, motion::ScanIndex(scan), stamps[scan], 0.0};
    };
    const auto key_of = [&](std::size_t scan) { return motion::KeyframeIndex(first_key + (scan - begin)); };
    if ((i - begin) % kAhead == 0)
      parallel_for(std::min(kAhead, end - i), threads, [&](std::size_t k) {
        try {
          scans.prepare(key_of(i + k), keyframe_of(i + k), {}, progress);
        } catch (const Error&) {
          // Asked for again below, where the failure is counted.
        }
      });
    progress.report(say::stage_finding_the_mounting, i - begin, end - begin);
    std::shared_ptr<const registration::PreparedCloud> current;
    try {
      current = scans.prepare(key_of(i), keyframe_of(i), {}, progress);
      ++out.readable;
    } catch (const Error& error) {
      if (out.unreadable++ == 0) out.first_unreadable = error.message();
      ++out.failures;
      previous.reset();
      continue;
    }
    const std::optional<RigidTransform> local_from_ins = motion.local_from_ins(session, stamps[i]);
    if (!local_from_ins) {
      previous.reset();
      continue;
    }
    bool linked = false;
    if (previous) {
      const registration::RegistrationResult step =
          steps.find(*current, *previous, previous_local_from_ins.inverse() * *local_from_ins);
      ++out.registrations;
      linked = step.quality.failure.empty();
      if (linked) {
        chains.back().first_from_lidar.push_back(chains.back().first_from_lidar.back() * step.target_from_source);
        chains.back().keyframes.push_back(keyframe_of(i));
      } else {
        ++out.failures;
      }
    }
    if (!linked) chains.push_back({{keyframe_of(i)}, {RigidTransform::Identity()}});
    previous = std::move(current);
    previous_local_from_ins = *local_from_ins;
  }
  return chains;
}

std::vector<motion::Pair> pairs_of_chain(const DriveMotion& motion, const Chain& chain,
                                         const motion::PairingOptions& options) {
  std::vector<RigidTransform> local_from_ins;
  for (const motion::Keyframe& keyframe : chain.keyframes)
    local_from_ins.push_back(
        motion.local_from_ins(keyframe.session, keyframe.stamp_ns).value_or(RigidTransform::Identity()));
  std::vector<motion::Pair> pairs = motion::propose_pairs(chain.keyframes, local_from_ins, options);
  for (motion::Pair& pair : pairs) {
    pair.lidar_b_from_lidar_a =
        chain.first_from_lidar[pair.keyframe_b].inverse() * chain.first_from_lidar[pair.keyframe_a];
    pair.registration.attempted = pair.registration.converged = true;
    // A step of the wrong length is no part of the same screw motion: the first round is to do without it.
    pair.screw.passed = as_long_as(pair.lidar_b_from_lidar_a, pair.ins_b_from_ins_a);
    // Chained odometry: a few centimetres and a quarter of a degree are enough for a start.
    pair.registration.information.diagonal() << Eigen::Vector3d::Constant(1.0 / (0.03 * 0.03)),
        Eigen::Vector3d::Constant(1.0 / (0.004 * 0.004));
  }
  return pairs;
}

// The rotation of the longest chain tells the clock of a session.
void judge_clock(const DriveMotion& motion, motion::SessionIndex session, const std::vector<Chain>& chains,
                 CoarseStart& out) {
  const auto longest = std::max_element(chains.begin(), chains.end(), [](const Chain& a, const Chain& b) {
    return a.keyframes.size() < b.keyframes.size();
  });
  if (longest == chains.end()) return;
  std::vector<motion::StampedPose> poses;
  for (std::size_t i = 0; i < longest->keyframes.size(); ++i)
    poses.push_back({longest->keyframes[i].stamp_ns, longest->first_from_lidar[i]});
  if (auto far = find_far_clock(motion, session, poses)) out.far_clocks.push_back(*std::move(far));
}

// Of the first session that shows a ground.
std::optional<Eigen::Vector3d> up_of_sessions(const DriveMotion& motion) {
  std::optional<Eigen::Vector3d> up_in_lidar;
  for (motion::SessionIndex session; session < motion.session_count() && !up_in_lidar; ++session)
    up_in_lidar = up_of_first_scans(motion.session(session));
  return up_in_lidar;
}

}  // namespace

CoarseStart find_coarse_start(const DriveMotion& motion, const settings::Settings& settings, int threads,
                              Progress& progress) {
  CoarseStart out;
  const registration::RegistrationOptions options = coarse_options(settings.registration);
  ScanStore scans(motion, options, static_cast<std::size_t>(settings.run.cache_mb) << 20);
  motion::PairingOptions pairing = settings.pairing;
  pairing.limit = motion::PairLimit::Either;
  pairing.max_gap_s = 2.0;
  pairing.max_distance_m = 15.0;
  pairing.min_distance_m = 0.5;
  pairing.max_partners = 4;
  std::vector<motion::Pair> pairs;
  out.up_in_lidar = up_of_sessions(motion);
  // Most stand upright; of a start, not of what is known, that is a fair guess.
  const Eigen::Vector3d likely_up = out.up_in_lidar.value_or(Eigen::Vector3d::UnitZ());
  motion::KeyframeIndex key;
  for (motion::SessionIndex session; session < motion.session_count() && !progress.cancelled(); ++session) {
    if (!motion.session(session).scans) continue;
    const std::vector<Chain> chains =
        chain_session(motion, scans, session, options, likely_up, key, out, threads, progress);
    judge_clock(motion, session, chains, out);
    for (const Chain& chain : chains) {
      const std::vector<motion::Pair> more = pairs_of_chain(motion, chain, pairing);
      pairs.insert(pairs.end(), more.begin(), more.end());
    }
  }
  if (pairs.size() < 3) {
    out.problem = say::pipeline_neighbours_not_registered(out.failures, out.registrations + out.failures);
    return out;
  }
  std::vector<motion::PairIndex> usable;
  for (motion::PairIndex i; i < pairs.size(); ++i) usable.push_back(i);
  calibration::NoiseModel noise;
  noise.registration_scale = 1.0;
  noise.registration_floor_m = 0.02;
  noise.registration_floor_rad = 0.002;
  out.ins_from_lidar = calibration::robust_start(pairs, usable, noise, std::nullopt, {std::nullopt, likely_up},
                                                 Eigen::Vector3d::Zero(), progress)
                           .ins_from_lidar;
  return out;
}

}  // namespace remount::pipeline

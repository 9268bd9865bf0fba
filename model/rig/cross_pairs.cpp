#include "model/rig/cross_pairs.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/core/error.h"
#include "algorithms/core/parallel.h"
#include "algorithms/core/stamps.h"
#include "algorithms/registration/registration.h"
#include "messages/stages.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/register_stage.h"
#include "model/pipeline/shared_field.h"
#include "model/pipeline/solve_stage.h"

namespace remount::rig {
namespace {

// Scans of a LiDAR that may be compared with those of others: a scan that is prepared once serves many pairs.
constexpr std::size_t kMostAnchors = 60;
// Pairs of two LiDARs at most, and of one with all others together.
constexpr std::size_t kMostOfTwo = 60, kMostOfOne = 240;
constexpr double kFarthestInTime_s = 20.0;   // until then the INS has hardly drifted
constexpr double kFarthestInPlace_m = 40.0;  // surfaces are seen from other sides then

struct Anchor {
  motion::KeyframeIndex keyframe;
  motion::SessionIndex recording;
  std::int64_t stamp_ns;
  RigidTransform local_from_ins = RigidTransform::Identity();
};

// Of the keyframes that stood their test within the LiDAR, some that are spread evenly over the drives.
std::vector<Anchor> anchors_of(const CalibratedLidar& lidar) {
  const std::vector<motion::Keyframe>& keyframes = lidar.output.keyframes;
  std::vector<bool> good(keyframes.size(), false);
  for (const motion::Pair& pair : lidar.output.pairs)
    if (pair.state == motion::PairState::Accepted) good[pair.keyframe_a] = good[pair.keyframe_b] = true;
  std::vector<Anchor> all;
  for (motion::KeyframeIndex k; k < keyframes.size(); ++k) {
    const auto pose = lidar.motion.local_from_ins(keyframes[k].session, keyframes[k].stamp_ns);
    if (good[k] && pose) all.push_back({k, lidar.recording(keyframes[k]), lidar.ins_stamp_ns(keyframes[k]), *pose});
  }
  if (all.size() <= kMostAnchors) return all;
  std::vector<Anchor> some;
  for (std::size_t i = 0; i < kMostAnchors; ++i) some.push_back(all[(2 * i + 1) * all.size() / (2 * kMostAnchors)]);
  return some;
}

// A pair that could be made, and how much may be hoped of it.
struct Possible {
  double worth;
  std::size_t a, b;  // anchors
  double gap_s;
};

RigidTransform predicted(const CalibratedLidar& lidar_a, const CalibratedLidar& lidar_b, const Anchor& a,
                         const Anchor& b) {
  return calibration::predicted_cross_motion(b.local_from_ins.inverse() * a.local_from_ins, lidar_a.ins_from_lidar(),
                                             lidar_b.ins_from_lidar());
}

std::vector<Possible> possible_pairs(const CalibratedLidar& lidar_a, const CalibratedLidar& lidar_b,
                                     const std::vector<Anchor>& anchors_a, const std::vector<Anchor>& anchors_b) {
  std::vector<Possible> out;
  for (std::size_t i = 0; i < anchors_a.size(); ++i)
    for (std::size_t j = 0; j < anchors_b.size(); ++j) {
      const Anchor &a = anchors_a[i], &b = anchors_b[j];
      const double gap_s = std::abs(seconds(b.stamp_ns - a.stamp_ns));
      if (a.recording != b.recording || gap_s > kFarthestInTime_s) continue;
      const RigidTransform b_from_a = predicted(lidar_a, lidar_b, a, b);
      const double way_m = b_from_a.translation().norm();
      if (way_m > kFarthestInPlace_m) continue;
      // All that a narrow one sees may be a small part of what one sees that looks around.
      const double of_a = lidar_a.field.share_in(lidar_b.field, b_from_a),
                   of_b = lidar_b.field.share_in(lidar_a.field, b_from_a.inverse());
      constexpr double kLeastOfWider = 0.02;
      if (std::max(of_a, of_b) < pipeline::kLeastShare || std::min(of_a, of_b) < kLeastOfWider) continue;
      const double share = std::sqrt(of_a * of_b);
      constexpr double kSoon_s = 4.0, kNear_m = 15.0;
      out.push_back({share / ((1.0 + gap_s / kSoon_s) * (1.0 + way_m / kNear_m)), i, j, gap_s});
    }
  std::sort(out.begin(), out.end(), [](const Possible& one, const Possible& other) {
    return std::tuple(-one.worth, one.a, one.b) < std::tuple(-other.worth, other.a, other.b);
  });
  return out;
}

// The best of them, each anchor a few times. Every other one of scans that were not taken together: what two patterns
// make of the same surfaces is the same as long as the vehicle stays where it is.
std::vector<Possible> chosen(const std::vector<Possible>& possible, std::size_t most) {
  constexpr std::size_t kUses = 3;
  constexpr double kTogether_s = 0.5;
  std::map<std::size_t, std::size_t> uses_a, uses_b;
  std::vector<Possible> out;
  std::size_t together = 0;
  for (const Possible& one : possible) {
    if (out.size() == most) break;
    const bool at_once = one.gap_s < kTogether_s;
    if ((at_once && together >= (most + 1) / 2) || uses_a[one.a] >= kUses || uses_b[one.b] >= kUses) continue;
    ++uses_a[one.a], ++uses_b[one.b];
    together += at_once ? 1 : 0;
    out.push_back(one);
  }
  return out;
}

motion::Pair make_pair(const Anchor& a, const Anchor& b) {
  motion::Pair pair;
  pair.keyframe_a = a.keyframe;
  pair.keyframe_b = b.keyframe;
  pair.gap_s = std::abs(seconds(b.stamp_ns - a.stamp_ns));
  pair.ins_b_from_ins_a = b.local_from_ins.inverse() * a.local_from_ins;
  pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
  pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
  return pair;
}

// Of both LiDARs, prepared for registration.
struct Prepared {
  std::shared_ptr<const registration::PreparedCloud> a, b;
};
Prepared prepare(const CalibratedLidars& lidars, const calibration::CrossPair& cross, const Progress& progress) {
  CalibratedLidar &a = *lidars[cross.lidar_a], &b = *lidars[cross.lidar_b];
  const motion::KeyframeIndex at_a = cross.pair.keyframe_a, at_b = cross.pair.keyframe_b;
  return {a.scans.prepare(at_a, a.output.keyframes[at_a], {}, progress),
          b.scans.prepare(at_b, b.output.keyframes[at_b], {}, progress)};
}

void reject(const Message& reason, motion::Pair& pair) {
  pair.state = motion::PairState::Rejected;
  pair.decided_by = motion::DecidedBy::Program;
  pair.reason = reason;
}

}  // namespace

CalibratedLidar::CalibratedLidar(const LidarJob& from_job, const pipeline::PipelineOutput& from_output,
                                 std::size_t cache_bytes, const Progress& progress)
    : job(from_job),
      output(from_output),
      motion(pipeline::motion_as_solved(from_job.input, from_output)),
      field(from_job.input.sessions, progress),
      scans(motion, from_job.input.settings.registration, cache_bytes) {
  pipeline::compensate_as_solved(job.input, output, scans);
}

std::int64_t CalibratedLidar::ins_stamp_ns(const motion::Keyframe& keyframe) const {
  return keyframe.stamp_ns + std::llround(1e9 * motion.offset_s(keyframe.session));
}

std::vector<calibration::CrossPair> propose_cross_pairs(const CalibratedLidars& lidars) {
  std::vector<std::vector<Anchor>> anchors;
  for (const auto& lidar : lidars) anchors.push_back(anchors_of(*lidar));
  std::vector<calibration::CrossPair> out;
  const std::size_t most = std::min(kMostOfTwo, kMostOfOne / std::max<std::size_t>(1, lidars.size() - 1));
  for (motion::LidarIndex a; a < lidars.size(); ++a)
    for (motion::LidarIndex b(a + 1); b < lidars.size(); ++b)
      for (const Possible& one : chosen(possible_pairs(*lidars[a], *lidars[b], anchors[a], anchors[b]), most))
        out.push_back({a, b, make_pair(anchors[a][one.a], anchors[b][one.b])});
  return out;
}

void register_cross_pairs(const CalibratedLidars& lidars, std::vector<calibration::CrossPair>& cross_pairs, int threads,
                          Progress& progress) {
  std::atomic<std::size_t> done{0};
  progress.report(say::stage_registering_across_lidars, 0, cross_pairs.size());
  parallel_for(cross_pairs.size(), threads, [&](std::size_t i) {
    calibration::CrossPair& cross = cross_pairs[i];
    motion::Pair& pair = cross.pair;
    if (progress.cancelled()) return;
    const CalibratedLidar &a = *lidars[cross.lidar_a], &b = *lidars[cross.lidar_b];
    try {
      const Prepared clouds = prepare(lidars, cross, progress);
      const RigidTransform start =
          calibration::predicted_cross_motion(pair.ins_b_from_ins_a, a.ins_from_lidar(), b.ins_from_lidar());
      registration::RegistrationOptions options = a.job.input.settings.registration;
      options.min_overlap *= std::max(pipeline::kLeastShare, a.field.share_in(b.field, start));
      options.beam_nodes = {};
      const registration::RegistrationResult result =
          registration::align_scans(*clouds.a, *clouds.b, start, options, progress);
      pair.lidar_b_from_lidar_a = result.target_from_source;
      pair.registration = result.quality;
    } catch (const Error& error) {
      pair.registration.attempted = true;
      pair.registration.failure = error.message();
    }
    if (!pair.registration.failure.empty()) reject(pair.registration.failure, pair);
    progress.report(say::stage_registering_across_lidars, ++done, cross_pairs.size());
  });
}

void relinearise_cross_pairs(const CalibratedLidars& lidars, const std::vector<RigidTransform>& predicted_motions,
                             std::vector<calibration::CrossPair>& cross_pairs, int threads, Progress& progress) {
  parallel_for(cross_pairs.size(), threads, [&](std::size_t i) {
    calibration::CrossPair& cross = cross_pairs[i];
    motion::Pair& pair = cross.pair;
    if (pair.state != motion::PairState::Accepted || progress.cancelled()) return;
    try {
      const Prepared clouds = prepare(lidars, cross, progress);
      const CalibratedLidar &a = *lidars[cross.lidar_a], &b = *lidars[cross.lidar_b];
      const registration::AlignmentEquations equations = registration::alignment_equations_across(
          *clouds.a, *clouds.b, predicted_motions[i], 0.5 * a.job.input.settings.registration.max_correspondence_m,
          progress, pipeline::beams_believed(a.job.input, a.output).nodes,
          pipeline::beams_believed(b.job.input, b.output).nodes);
      if (progress.cancelled()) return;
      pipeline::take_equations(equations, predicted_motions[i], pair);
    } catch (const Error&) {
      // A scan that has become unreadable since its registration: the pair keeps what it has.
    }
  });
}

namespace {

// Of one pair under separate and common mountings; nothing where a scan has become unreadable.
std::optional<std::array<double, 2>> surface_squares_m2(const CalibratedLidars& lidars,
                                                        const calibration::CrossPair& cross,
                                                        const std::vector<RigidTransform>& together,
                                                        const Progress& progress) {
  const CalibratedLidar &a = *lidars[cross.lidar_a], &b = *lidars[cross.lidar_b];
  try {
    const Prepared clouds = prepare(lidars, cross, progress);
    const auto square_m2 = [&](const RigidTransform& x_a, const RigidTransform& x_b) {
      const RigidTransform b_from_a = calibration::predicted_cross_motion(cross.pair.ins_b_from_ins_a, x_a, x_b);
      const double rmse_m =
          registration::alignment_equations(*clouds.a, *clouds.b, b_from_a,
                                            0.5 * a.job.input.settings.registration.max_correspondence_m, progress)
              .rmse_m;
      return rmse_m * rmse_m;
    };
    return std::array{square_m2(a.ins_from_lidar(), b.ins_from_lidar()),
                      square_m2(together[cross.lidar_a], together[cross.lidar_b])};
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<SharedSurfaces> compare_surfaces(const CalibratedLidars& lidars,
                                             const std::vector<calibration::CrossPair>& cross_pairs,
                                             const std::vector<RigidTransform>& together, int threads,
                                             const Progress& progress) {
  constexpr std::size_t kMostOfEach = 8;
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> accepted;
  for (std::size_t i = 0; i < cross_pairs.size(); ++i)
    if (cross_pairs[i].pair.state == motion::PairState::Accepted)
      accepted[{cross_pairs[i].lidar_a, cross_pairs[i].lidar_b}].push_back(i);
  std::vector<SharedSurfaces> out;
  for (const auto& each : accepted) {
    const std::vector<std::size_t>& of_two = each.second;
    const std::size_t count = std::min(kMostOfEach, of_two.size());
    std::vector<std::optional<std::array<double, 2>>> squares_m2(count);  // apart and together
    parallel_for(count, threads, [&](std::size_t i) {
      const calibration::CrossPair& cross = cross_pairs[of_two[i * of_two.size() / count]];
      if (!progress.cancelled()) squares_m2[i] = surface_squares_m2(lidars, cross, together, progress);
    });
    SharedSurfaces surfaces{motion::LidarIndex(each.first.first), motion::LidarIndex(each.first.second)};
    double read = 0.0;
    for (const auto& squares : squares_m2) {
      if (!squares) continue;
      surfaces.separate_m += squares->at(0), surfaces.together_m += squares->at(1);
      read += 1.0;
    }
    if (read == 0.0 || progress.cancelled()) continue;
    surfaces.separate_m = std::sqrt(surfaces.separate_m / read);
    surfaces.together_m = std::sqrt(surfaces.together_m / read);
    out.push_back(surfaces);
  }
  return out;
}

pipeline::PairClouds load_cross_clouds(const LidarJob& job_a, const pipeline::PipelineOutput& output_a,
                                       const LidarJob& job_b, const pipeline::PipelineOutput& output_b,
                                       const motion::Pair& pair) {
  const auto load = [](const LidarJob& job, const pipeline::PipelineOutput& output, motion::KeyframeIndex keyframe) {
    const pipeline::DriveMotion motion = pipeline::motion_as_solved(job.input, output);
    pipeline::ScanStore scans(motion, job.input.settings.registration, 0);
    pipeline::compensate_as_solved(job.input, output, scans);
    const pipeline::StageContext context{motion, job.input.settings, output.keyframes,
                                         output.result.mounting.ins_from_lidar(), job.input.threads};
    const motion::Keyframe& at = output.keyframes.at(keyframe);
    return std::make_shared<const pipeline::KeyframeScan>(
        pipeline::KeyframeScan{scans.load(at), {}, pipeline::up_in_lidar(context, at)});
  };
  return {load(job_a, output_a, pair.keyframe_a), load(job_b, output_b, pair.keyframe_b), {}};
}

}  // namespace remount::rig

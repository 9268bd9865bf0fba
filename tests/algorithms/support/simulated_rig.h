// Several LiDARs on one vehicle with known mountings, an INS whose errors all of them share, and registrations within
// and across LiDARs that carry exactly the errors of a noise model.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "algorithms/calibration/joint/pair_equation.h"
#include "algorithms/calibration/rig/rig.h"
#include "tests/algorithms/support/simulated_drive.h"

namespace remount::testing {

struct RigOptions {
  DriveOptions drive;  ///< of each LiDAR; keyframes, partners and steps, and the INS's errors
  std::vector<RigidTransform> ins_from_lidars;
  std::vector<double> phases_s;  ///< of each LiDAR's first keyframe
  int cross_partners = 3;        ///< keyframes of each other LiDAR that each keyframe is registered to
  bool any_cross = true;
  double clock_sigma_s = 0.0;  ///< of each LiDAR's clock; an unknown where above 0
  /// How long the points of each LiDAR's keyframes are measured, around their times: their white error is the mean of
  /// the INS's over that, and as large as the noise says. Empty: at once.
  std::vector<double> sweeps_s = {};
};

struct SimulatedRig {
  std::vector<calibration::RigLidar> lidars;
  std::vector<calibration::CrossPair> cross_pairs;
};

namespace rig_details {

struct Seen {
  std::size_t lidar;
  int keyframe;
  double time_s;
  RigidTransform truth, by_ins;
};

/// Means over sweeps of what is white, each as large as the noise says, however long its sweep is.
class SweptErrors {
 public:
  SweptErrors(const RigOptions& options, std::uint64_t seed) : options_(options), random_(seed) {}

  Vector6d around(double time_s, double sweep_s) {
    const auto first = static_cast<std::int64_t>(std::llround((time_s - 0.5 * sweep_s) / kSample_s)),
               count = static_cast<std::int64_t>(std::llround(sweep_s / kSample_s));
    Vector6d sum = Vector6d::Zero();
    for (std::int64_t i = first; i < first + count; ++i) {
      const auto [sample, is_new] = samples_.emplace(i, Vector6d::Zero());
      if (is_new)
        sample->second = random_step(random_, options_.drive.noise.ins_position_sigma_m,
                                     options_.drive.noise.ins_attitude_sigma_rad);
      sum += sample->second;
    }
    return sum / std::sqrt(static_cast<double>(count));
  }

 private:
  static constexpr double kSample_s = 0.01;
  const RigOptions& options_;
  std::mt19937_64 random_;
  std::map<std::int64_t, Vector6d> samples_;
};

inline std::vector<Seen> drive_past(const RigOptions& options, std::mt19937_64& random) {
  const calibration::NoiseModel& noise = options.drive.noise;
  std::vector<Seen> all;
  for (std::size_t l = 0; l < options.ins_from_lidars.size(); ++l)
    for (int k = 0; k < options.drive.keyframes; ++k)
      all.push_back({l, k, options.phases_s[l] + k * options.drive.step_s, {}, {}});
  std::sort(all.begin(), all.end(),
            [](const Seen& a, const Seen& b) { return std::pair(a.time_s, a.lidar) < std::pair(b.time_s, b.lidar); });
  Vector6d bias = Vector6d::Zero(), drift = Vector6d::Zero(), white = Vector6d::Zero();
  bias.tail<3>() = random_vector(random, options.drive.attitude_bias_sigma_rad);
  double before_s = -1.0;
  SweptErrors swept(options, random());
  for (Seen& seen : all) {
    const double step_s = before_s < 0.0 ? 0.0 : seen.time_s - before_s;
    // Scans that are taken at once have one pose of the INS.
    if (!options.sweeps_s.empty())
      white = swept.around(seen.time_s, options.sweeps_s[seen.lidar]);
    else if (step_s > 1e-6 || before_s < 0.0)
      white = random_step(random, noise.ins_position_sigma_m, noise.ins_attitude_sigma_rad);
    drift += noise.drift_covariance(step_s).diagonal().cwiseSqrt().cwiseProduct(random_step(random, 1, 1));
    before_s = seen.time_s;
    seen.truth = true_pose(options.drive, seen.time_s);
    Vector6d error = white + bias + drift;
    error.head<3>() += seen.truth.linear().transpose() * drift.head<3>() - drift.head<3>();
    seen.by_ins = calibration::moved_in_body(seen.truth, -error);
  }
  std::sort(all.begin(), all.end(), [](const Seen& a, const Seen& b) {
    return std::pair(a.lidar, a.keyframe) < std::pair(b.lidar, b.keyframe);
  });
  return all;
}

inline motion::Pair registered(const RigOptions& options, const Seen& a, const Seen& b, std::mt19937_64& random) {
  const Matrix6d root = root_of_registration_errors(options.drive.noise);
  motion::Pair pair;
  pair.keyframe_a = index_at<motion::KeyframeIndex>(a.keyframe);
  pair.keyframe_b = index_at<motion::KeyframeIndex>(b.keyframe);
  pair.gap_s = std::abs(b.time_s - a.time_s);
  pair.ins_b_from_ins_a = b.by_ins.inverse() * a.by_ins;
  pair.baseline_m = pair.ins_b_from_ins_a.translation().norm();
  pair.rotation_rad = so3_log(pair.ins_b_from_ins_a.linear()).norm();
  pair.lidar_b_from_lidar_a =
      perturb(calibration::predicted_cross_motion(b.truth.inverse() * a.truth, options.ins_from_lidars[a.lidar],
                                                  options.ins_from_lidars[b.lidar]),
              root * random_step(random, 1, 1));
  pair.registration.attempted = pair.registration.converged = true;
  pair.registration.overlap = 0.9;
  pair.registration.information = registration_information();
  return pair;
}

}  // namespace rig_details

/// Each LiDAR is calibrated alone.
inline SimulatedRig simulate_rig(const RigOptions& options, int seed) {
  using rig_details::registered;
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<rig_details::Seen> all = rig_details::drive_past(options, random);
  std::vector<double> clocks_s;
  for (std::size_t l = 0; l < options.ins_from_lidars.size(); ++l)
    clocks_s.push_back(options.clock_sigma_s * random_vector(random, 1.0).x());
  for (rig_details::Seen& one : all)
    one.by_ins =
        calibration::moved_in_body(one.by_ins, -clocks_s[one.lidar] * true_velocity(options.drive, one.time_s));
  const auto seen = [&](std::size_t lidar, int keyframe) -> const rig_details::Seen& {
    return all[lidar * static_cast<std::size_t>(options.drive.keyframes) + static_cast<std::size_t>(keyframe)];
  };
  SimulatedRig rig;
  for (std::size_t l = 0; l < options.ins_from_lidars.size(); ++l) {
    calibration::RigLidar lidar;
    lidar.name = "lidar " + std::to_string(l);
    lidar.recordings = {motion::SessionIndex{0}};
    lidar.at_once_s = 1e-3;
    if (!options.sweeps_s.empty()) lidar.sweeps = {{-0.5 * options.sweeps_s[l], 0.5 * options.sweeps_s[l]}};
    SimulatedDrive drive;
    for (int k = 0; k < options.drive.keyframes; ++k) {
      calibration::JointNode node;
      node.time_s = k * options.drive.step_s;
      node.local_from_ins = seen(l, k).by_ins;
      node.body_velocity = true_velocity(options.drive, seen(l, k).time_s);
      drive.problem.nodes.push_back(node);
      lidar.keyframe_stamps_ns.push_back(std::llround(1e9 * seen(l, k).time_s));
      for (int p = 1; p <= options.drive.partners && k + p < options.drive.keyframes; ++p)
        lidar.pairs.push_back(registered(options, seen(l, k), seen(l, k + p), random));
    }
    lidar.input = input_of(drive, options.drive);
    lidar.input.clock_is_unknown = options.clock_sigma_s > 0.0;
    lidar.input.nominal_ins_from_lidar = perturb(options.ins_from_lidars[l], random_step(random, 0.05, 0.01));
    lidar.alone = calibration::solve_pairwise(lidar.input, lidar.pairs, lidar.details, {});
    rig.lidars.push_back(std::move(lidar));
  }
  for (std::size_t a = 0; options.any_cross && a < rig.lidars.size(); ++a)
    for (std::size_t b = a + 1; b < rig.lidars.size(); ++b)
      for (int k = 0; k < options.drive.keyframes; ++k)
        for (int p = 0; p < options.cross_partners && k + p < options.drive.keyframes; ++p)
          rig.cross_pairs.push_back(
              {motion::LidarIndex(a), motion::LidarIndex(b), registered(options, seen(a, k), seen(b, k + p), random)});
  return rig;
}

}  // namespace remount::testing

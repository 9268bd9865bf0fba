#include "model/conventions/held_positions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "algorithms/core/median.h"
#include "algorithms/motion/cubic_between.h"
#include "messages/checks.h"
#include "messages/places.h"

namespace remount::conventions {
namespace {

// Distance of the places of two samples, by their numbers.
auto place_difference(const drive::Session& session, const MetricPoses& poses) {
  return [&ins = session.ins, &poses](std::size_t a, std::size_t b) {
    const Eigen::Vector3d step = poses[a].pose.translation() - poses[b].pose.translation();
    if (ins.size() != poses.size()) return step.norm();
    const bool same = ins[a].latitude_rad == ins[b].latitude_rad && ins[a].longitude_rad == ins[b].longitude_rad;
    return same ? 0.0 : step.head<2>().norm();
  };
}

std::optional<HeldSteps> held_attitudes(const MetricPoses& poses) {
  return held_steps(poses, kSameAttitude_rad, kTurning_rad, kLeastTurn_rad, [&](std::size_t a, std::size_t b) {
    return rotation_angle_between_rad(poses[a].pose, poses[b].pose);
  });
}

// Numbers of the samples whose positions were measured: those at which a new one begins. At the start of the log and
// behind missing samples nobody knows when it began. One that stays for longer, as where the vehicle stands, was
// measured again and again.
std::vector<std::size_t> measured_samples(const drive::Session& session, const MetricPoses& poses, double hold_s) {
  constexpr double kInTime = 1.5, kNearlyAll = 0.99, kHalf = 0.5;  // of the usual step between samples; of the hold
  std::vector<double> steps_s;
  const auto time_s = [&](std::size_t from, std::size_t to) {
    return seconds(poses[to].stamp_ns - poses[from].stamp_ns);
  };
  for (std::size_t i = 1; i < poses.size(); ++i) steps_s.push_back(time_s(i - 1, i));
  const double step_s = median_of(std::move(steps_s));
  const std::vector<std::size_t> starts = starts_of_values(poses.size(), 0.0, place_difference(session, poses));
  std::vector<std::size_t> measured;
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const bool in_time = k > 0 && time_s(starts[k] - 1, starts[k]) < kInTime * step_s;
    if (in_time) measured.push_back(starts[k]);
    const std::size_t next = k + 1 < starts.size() ? starts[k + 1] : poses.size();
    for (std::size_t i = starts[k] + 1, last = starts[k]; i < next; ++i)
      if (time_s(last, i) > kNearlyAll * hold_s && time_s(i, next - 1) > kHalf * hold_s)
        measured.push_back(i), last = i;
  }
  return measured;
}

Eigen::Vector3d position_numbers(const motion::InsSample& sample) {
  return {sample.latitude_rad, sample.longitude_rad, sample.height_m};
}
Eigen::Vector3d position_numbers(const motion::StampedPose& sample) { return sample.pose.translation(); }

// What is near stays near also at the date line.
Eigen::Vector3d position_step(const motion::InsSample& from, const motion::InsSample& to) {
  const Eigen::Vector3d step = position_numbers(to) - position_numbers(from);
  return {step.x(), std::remainder(step.y(), 2.0 * kPi), step.z()};
}
Eigen::Vector3d position_step(const motion::StampedPose& from, const motion::StampedPose& to) {
  return position_numbers(to) - position_numbers(from);
}

void move_from(const motion::InsSample& from, const Eigen::Vector3d& step, motion::InsSample& sample) {
  sample.latitude_rad = from.latitude_rad + step.x();
  sample.longitude_rad = std::remainder(from.longitude_rad + step.y(), 2.0 * kPi);
  sample.height_m = from.height_m + step.z();
}
void move_from(const motion::StampedPose& from, const Eigen::Vector3d& step, motion::StampedPose& sample) {
  sample.pose.translation() = from.pose.translation() + step;
}

// Puts the samples between those that were measured on the way; leaves out those before, behind, and in gaps.
template <class Sample>
void interpolate_between(const std::vector<std::size_t>& measured, double longest_s, std::vector<Sample>& samples) {
  const auto apart_s = [&](std::size_t a, std::size_t b) {
    return seconds(samples[measured[b]].stamp_ns - samples[measured[a]].stamp_ns);
  };
  std::vector<bool> known(samples.size(), false);
  for (std::size_t k = 0; k < measured.size(); ++k) {
    known[measured[k]] = true;
    if (k + 1 == measured.size() || apart_s(k, k + 1) > longest_s) continue;
    const Sample& from = samples[measured[k]];
    motion::CubicNeighbours around;
    around.has_first = k > 0 && apart_s(k - 1, k) <= longest_s;
    around.has_last = k + 2 < measured.size() && apart_s(k + 1, k + 2) <= longest_s;
    for (std::size_t i = around.has_first ? 0 : 1; i < (around.has_last ? 4U : 3U); ++i) {
      const Sample& neighbour = samples[measured[k + i - 1]];
      around.times_s[i] = seconds(neighbour.stamp_ns - from.stamp_ns);
      around.values[i] = position_step(from, neighbour);
    }
    for (std::size_t i = measured[k] + 1; i < measured[k + 1]; ++i) {
      move_from(from, motion::cubic_between(around, seconds(samples[i].stamp_ns - from.stamp_ns)), samples[i]);
      known[i] = true;
    }
  }
  std::size_t at = 0;
  std::erase_if(samples, [&](const Sample&) { return !known[at++]; });
}

template <class Sample>
void leave_out_repeats(const std::vector<std::size_t>& measured, std::vector<Sample>& samples) {
  for (std::size_t k = 0; k < measured.size(); ++k) samples[k] = samples[measured[k]];
  samples.resize(measured.size());
}

void add_finding(const HeldSteps& held, bool attitudes_too, drive::Session& session) {
  session.findings.push_back({drive::Severity::Warning, kPositionsInterpolated, say::place_ins(),
                              (attitudes_too ? say::ins_poses_interpolated : say::ins_positions_interpolated)(
                                  Duration{held.hold_s}, held.samples, Length{held.jump})});
}

}  // namespace

std::optional<HeldSteps> held_positions(const drive::Session& session, const MetricPoses& poses) {
  return held_steps(poses, 0.0, kDriving_m, kLeastStep_m, place_difference(session, poses));
}

void interpolate_held_positions(drive::Session& session) {
  constexpr double kSameTime = 0.1, kGap = 5.0, kLeastGap_s = 0.25;
  if (!session.ins_fix_stamps_ns.empty()) return;  // a reader has done it
  std::vector<std::size_t> measured;
  std::optional<HeldSteps> held, attitudes;
  {
    const MetricPoses poses(session);
    held = held_positions(session, poses);
    if (!held || held->rounded || !held->even) return;
    attitudes = held_attitudes(poses);
    if (attitudes && std::abs(attitudes->hold_s - held->hold_s) > kSameTime * held->hold_s) return;
    measured = measured_samples(session, poses, held->hold_s);
  }
  const double longest_s = std::max(kLeastGap_s, kGap * held->hold_s);
  const auto settle_samples = [&](auto& samples) {
    if (attitudes) return leave_out_repeats(measured, samples);
    for (const std::size_t i : measured) session.ins_fix_stamps_ns.push_back(samples[i].stamp_ns);
    interpolate_between(measured, longest_s, samples);
  };
  session.ins.empty() ? settle_samples(session.world_from_ins) : settle_samples(session.ins);
  add_finding(*held, attitudes.has_value(), session);
}

}  // namespace remount::conventions

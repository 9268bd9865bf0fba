#include "model/pipeline/pair_clouds.h"

#include <algorithm>
#include <cmath>

#include "algorithms/calibration/joint/pair_equation.h"
#include "model/pipeline/as_solved_scans.h"
#include "model/pipeline/register_stage.h"
#include "model/pipeline/solve_stage.h"
#include "model/settings/settings_file.h"

namespace remount::pipeline {
namespace {

/// Scans look the same where their clocks differ by less.
constexpr double kSameClock_s = 1e-4;

bool same_clocks(const std::vector<double>& first_s, const std::vector<double>& second_s) {
  return std::equal(first_s.begin(), first_s.end(), second_s.begin(), second_s.end(),
                    [](double a, double b) { return std::abs(a - b) < kSameClock_s; });
}

bool same_sweeps(const std::vector<drive::SweepModel>& first, const std::vector<drive::SweepModel>& second) {
  return std::equal(first.begin(), first.end(), second.begin(), second.end(),
                    [](const drive::SweepModel& a, const drive::SweepModel& b) {
                      return a.period_s == b.period_s && a.stamp_azimuth_rad == b.stamp_azimuth_rad &&
                             a.clockwise == b.clockwise && a.by_order == b.by_order && a.by_times == b.by_times;
                    });
}

bool same_pairs(const PairEvidence& first, const PairEvidence& second) {
  return std::equal(first.keyframes.begin(), first.keyframes.end(), second.keyframes.begin(), second.keyframes.end(),
                    [](const motion::Keyframe& a, const motion::Keyframe& b) {
                      return a.session == b.session && a.scan == b.scan && a.stamp_ns == b.stamp_ns;
                    }) &&
         std::equal(first.pairs.begin(), first.pairs.end(), second.pairs.begin(), second.pairs.end(),
                    [](const motion::Pair& a, const motion::Pair& b) {
                      return a.keyframe_a == b.keyframe_a && a.keyframe_b == b.keyframe_b;
                    });
}

/// Whether scans are read and compensated alike.
bool same_reading(const PipelineOutput& first, const PipelineOutput& second) {
  const calibration::CalibrationResult &a = first.result, &b = second.result;
  return difference(first.compensation_ins_from_lidar, second.compensation_ins_from_lidar).isZero(0.0) &&
         difference(first.initial_ins_from_lidar, second.initial_ins_from_lidar).isZero(0.0) &&
         first.mended_beams.values == second.mended_beams.values && first.session_frames == second.session_frames &&
         first.session_uses_sweep == second.session_uses_sweep &&
         same_sweeps(first.session_sweeps, second.session_sweeps) && a.time_offset.applied == b.time_offset.applied &&
         a.position_lag_applied == b.position_lag_applied &&
         same_clocks(a.session_time_offset_s, b.session_time_offset_s) &&
         same_clocks(a.session_position_lag_s, b.session_position_lag_s);
}

/// But for the search range, which changes no scan.
bool same_settings(const settings::Settings& first, settings::Settings second) {
  second.range = first.range;
  return settings::settings_text(first, false) == settings::settings_text(second, false);
}

}  // namespace

struct SolvedPairs::Reading {
  DriveMotion motion;
  ScanStore store;
  StageContext context;

  Reading(const PipelineInput& input, const PipelineOutput& output)
      : motion(motion_as_solved(input, output)),
        store(motion, input.settings.registration, 0),
        context{motion, input.settings, output.keyframes, output.initial_ins_from_lidar, input.threads} {
    compensate_as_solved(input, output, store);
  }
};

SolvedPairs::SolvedPairs(PipelineInput input, std::shared_ptr<const PipelineOutput> output)
    : input_(std::move(input)), output_(std::move(output)) {}

SolvedPairs::~SolvedPairs() = default;

const SolvedPairs::Reading& SolvedPairs::reading() const {
  const std::scoped_lock guard(mutex_);
  if (!reading_) reading_ = std::make_unique<const Reading>(input_, *output_);
  return *reading_;
}

KeyframeScanPtr SolvedPairs::scan_of(motion::KeyframeIndex keyframe, const Progress& progress) const {
  {
    const std::scoped_lock guard(mutex_);
    if (KeyframeScanPtr held = read_[keyframe].lock()) return held;
  }
  const Reading& all = reading();
  auto scan = std::make_shared<KeyframeScan>();
  scan->cloud = all.store.load(output_->keyframes.at(keyframe), progress);
  if (progress.cancelled()) return std::make_shared<const KeyframeScan>();
  scan->up_in_lidar = up_in_lidar(all.context, output_->keyframes.at(keyframe));
  scan->objects = cloud::find_objects(scan->cloud, scan->up_in_lidar, input_.settings.objects);
  const std::scoped_lock guard(mutex_);
  // Of two that read it at once the first is kept, for its holders and those of the second share it then.
  if (KeyframeScanPtr held = read_[keyframe].lock()) return held;
  read_[keyframe] = scan;
  return scan;
}

PairClouds SolvedPairs::load(motion::PairIndex index, const Progress& progress) const {
  const motion::Pair& pair = output_->pairs.at(index);
  PairClouds clouds;
  if (!input_.sessions.at(output_->keyframes.at(pair.keyframe_a).session)->scans) return clouds;
  clouds.scan_a = scan_of(pair.keyframe_a, progress);
  clouds.scan_b = scan_of(pair.keyframe_b, progress);
  if (progress.cancelled()) return {};
  clouds.matches =
      cloud::match_objects(clouds.scan_a->objects, clouds.scan_b->objects,
                           calibration::predicted_lidar_motion(pair.ins_b_from_ins_a, output_->initial_ins_from_lidar),
                           input_.settings.objects);
  return clouds;
}

bool SolvedPairs::serves(const PipelineInput& input, const PipelineOutput& output) const {
  return input.sessions == input_.sessions && same_pairs(*output_, output) && same_reading(*output_, output) &&
         same_settings(input_.settings, input.settings);
}

}  // namespace remount::pipeline

#include "app/gui/jobs/engine.h"

#include <algorithm>

#include "model/formats/session_readers.h"
#include "model/methods/calibrate.h"
#include "model/pipeline/input_checks.h"
#include "model/rig/cross_pairs.h"

namespace remount::gui {

pipeline::PipelineOutput run_without_map_check(const Engine& engine, const pipeline::PipelineInput& input,
                                               Progress& progress) {
  if (!engine.check_map || !input.settings.run.map_check) return engine.run(input, progress);
  pipeline::PipelineInput without = input;
  without.settings.run.map_check = false;
  pipeline::PipelineOutput output = engine.run(without, progress);
  if (output.map_check == pipeline::MapCheck::SwitchedOff) output.map_check = pipeline::MapCheck::NotReached;
  return output;
}

namespace {

/// A recording that has one LiDAR is not looked through again where none of the others has several.
std::vector<rig::RecordedLidar> lidars_of(const std::vector<std::shared_ptr<const drive::Session>>& sessions,
                                          const std::vector<std::filesystem::path>& recordings, Progress& progress) {
  const bool several =
      recordings.size() > sessions.size() || std::any_of(sessions.begin(), sessions.end(), [&](const auto& session) {
        return !rig::lidars_of_several(*session, progress).empty();
      });
  return several ? rig::find_lidars(recordings, {}, progress).sensors : std::vector<rig::RecordedLidar>();
}

}  // namespace

Engine model_engine() {
  const auto open = [](const std::filesystem::path& path, const drive::TopicChoice& topics, Progress& progress) {
    return formats::open_session(path, topics, progress);
  };
  const auto offer = [](const std::filesystem::path& path, Progress& progress) {
    return formats::offer_topics(path, progress);
  };
  return {open,
          methods::calibrate,
          pipeline::solve_again,
          [](const pipeline::PipelineInput& input, std::shared_ptr<const pipeline::PipelineOutput> output) {
            return std::make_shared<const pipeline::SolvedPairs>(input, std::move(output));
          },
          pipeline::solve_at_once,
          pipeline::load_map_scans,
          pipeline::load_keyframe_scan,
          pipeline::check_hold_out,
          pipeline::check_map,
          offer,
          pipeline::same_recording,
          lidars_of,
          rig::calibrate_rig,
          rig::solve_rig_again,
          rig::load_cross_clouds};
}

}  // namespace remount::gui

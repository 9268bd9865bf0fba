#include "app/gui/jobs/engine.h"

#include "model/formats/session_readers.h"
#include "model/methods/calibrate.h"
#include "model/pipeline/input_checks.h"

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
          pipeline::load_pair_clouds,
          pipeline::solve_at_once,
          pipeline::load_map_scans,
          pipeline::load_keyframe_scan,
          pipeline::check_hold_out,
          pipeline::check_map,
          offer,
          pipeline::same_recording};
}

}  // namespace remount::gui

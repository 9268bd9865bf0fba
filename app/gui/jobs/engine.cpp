#include "app/gui/jobs/engine.h"

#include "model/formats/session_readers.h"
#include "model/methods/calibrate.h"
#include "model/pipeline/input_checks.h"

namespace remount {

PipelineOutput run_without_map_check(const Engine& engine, const PipelineInput& input, Progress& progress) {
  if (!engine.check_map || !input.settings.run.map_check) return engine.run(input, progress);
  PipelineInput without = input;
  without.settings.run.map_check = false;
  PipelineOutput output = engine.run(without, progress);
  if (output.map_check == MapCheck::SwitchedOff) output.map_check = MapCheck::NotReached;
  return output;
}

Engine model_engine() {
  const auto open = [](const std::filesystem::path& path, const TopicChoice& topics, Progress& progress) {
    return open_session(path, topics, progress);
  };
  const auto offer = [](const std::filesystem::path& path, Progress& progress) { return offer_topics(path, progress); };
  return {open,           calibrate, solve_again, load_pair_clouds, solve_at_once, load_map_scans, load_keyframe_scan,
          check_hold_out, check_map, offer,       same_recording};
}

}  // namespace remount

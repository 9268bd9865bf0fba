// What the window asks of the model, as replaceable functions: tests drive the window with short ones.
#pragma once

#include <filesystem>
#include <functional>

#include "model/drive/topic_offer.h"
#include "model/pipeline/hold_out.h"
#include "model/pipeline/pair_clouds.h"
#include "model/pipeline/pipeline.h"
#include "model/rig/recorded_lidars.h"
#include "model/rig/rig_calibration.h"

namespace remount::gui {

struct Engine {
  std::function<drive::Session(const std::filesystem::path&, const drive::TopicChoice&, Progress&)> open;
  std::function<pipeline::PipelineOutput(const pipeline::PipelineInput&, Progress&)> run;
  std::function<bool(const pipeline::PipelineInput&, pipeline::PipelineOutput&, Progress&)>
      solve_again;  ///< false: cancelled
  /// Where the scans of an output's pairs come from.
  std::function<std::shared_ptr<const pipeline::PairSource>(const pipeline::PipelineInput&,
                                                            std::shared_ptr<const pipeline::PipelineOutput>)>
      open_pairs;
  /// The first answer after a decision (solve_at_once); may be empty.
  std::function<bool(const pipeline::PipelineInput&, pipeline::PipelineOutput&, const Progress&)> solve_at_once;
  /// May be empty: then there are no maps.
  std::function<pipeline::SessionScans(const pipeline::PipelineInput&, const pipeline::PipelineOutput&,
                                       motion::SessionIndex, std::size_t, Progress&)>
      load_map_scans;
  std::function<cloud::PointCloud(const pipeline::PipelineInput&, const pipeline::PipelineOutput&,
                                  motion::KeyframeIndex, Progress&)>
      load_keyframe_scan;
  /// May be empty: then sessions are not compared.
  std::function<pipeline::HoldOut(const pipeline::PipelineInput&, const pipeline::PipelineOutput&, Progress&)>
      check_hold_out;
  /// May be empty: then a result that moved keeps no map check.
  std::function<void(const pipeline::PipelineInput&, pipeline::PipelineOutput&, Progress&)> check_map;
  /// May be empty: then topics are taken as they are suggested, and nobody is asked.
  std::function<std::optional<drive::TopicOffer>(const std::filesystem::path&, Progress&)> offer_topics;
  /// May be empty: then a copy of a session that is open is opened as well, and calibrating refuses it.
  std::function<bool(const drive::Session&, const drive::Session&)> same_recording;
  /// May be empty, and those below it: then each recording has the LiDAR that is read of it. Fewer than two: the same.
  /// The LiDARs of recordings, of which these sessions are open.
  std::function<std::vector<rig::RecordedLidar>(const std::vector<std::shared_ptr<const drive::Session>>&,
                                                const std::vector<std::filesystem::path>&, Progress&)>
      find_lidars;
  std::function<rig::RigOutput(const std::vector<rig::LidarJob>&, Progress&)> calibrate_rig;
  std::function<rig::RigOutput(const std::vector<rig::LidarJob>&,
                               const std::vector<std::shared_ptr<const pipeline::PipelineOutput>>&, Progress&)>
      solve_rig_again;
  std::function<pipeline::PairClouds(const rig::LidarJob&, const pipeline::PipelineOutput&, const rig::LidarJob&,
                                     const pipeline::PipelineOutput&, const motion::Pair&)>
      load_cross_clouds;
};

/// The result does not wait for the map check where that can be made beside it; it is then NotReached.
pipeline::PipelineOutput run_without_map_check(const Engine& engine, const pipeline::PipelineInput& input,
                                               Progress& progress);

/// The model's own: open_session, calibrate, solve_again, SolvedPairs, solve_at_once, load_map_scans,
/// load_keyframe_scan, check_hold_out, check_map, offer_topics, same_recording, find_lidars, calibrate_rig,
/// solve_rig_again, load_cross_clouds.
Engine model_engine();

}  // namespace remount::gui

// A calibration job as a file "*.remount": sessions, settings, nominal, decisions about pairs, and what was found.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/pipeline/pipeline.h"
#include "model/pipeline/verdicts.h"
#include "model/project/pair_note.h"
#include "model/results/result_file.h"
#include "model/results/vehicle_file.h"

namespace remount::project {

/// What a calibration was made with. A project keeps it beside what is set now, since that can be edited afterwards.
struct CalibrationBasis {
  std::size_t session_count = 0;  ///< the first so many of the sessions
  settings::Settings settings;
  std::optional<RigidTransform> nominal_ins_from_lidar;
};
CalibrationBasis basis_of(const pipeline::PipelineInput& input);

/// One for each, what is set now and was not so for the calibration ("pairing.max_gap_s 1.5, now 2.5"); empty
/// where the calibration would come out the same again.
std::vector<Message> changes_since(const CalibrationBasis& calibration, const CalibrationBasis& now);

/// Whether a result may come out otherwise where this option is another: how much memory is used is none of its
/// matters.
bool affects_result(std::string_view section, std::string_view name);

struct OtherLidar;

struct Project {
  std::vector<std::filesystem::path> sessions;  ///< absolute, or relative to the working directory
  std::vector<drive::TopicChoice> topics;       ///< of each session; may be shorter: of the others none were chosen
  settings::Settings settings;
  std::optional<RigidTransform> nominal_ins_from_lidar;
  std::vector<pipeline::PairVerdict> verdicts;
  std::vector<PairNote> notes;  ///< of all LiDARs
  std::optional<pipeline::PipelineOutput>
      output;                     ///< the last calibration, enough to review and solve again without scans
  bool solution_pending = false;  ///< `output` holds decisions that its result does not answer in full: solve again
  bool confirmed = false;         ///< the user said that the result of `output` is good
  bool exported = false;          ///< the result of `output` was written to a file for the vehicle
  CalibrationBasis basis;         ///< what `output` was made with
  std::vector<results::InputFile> inputs;  ///< hashes of what that calibration read
  /// Of a vehicle with several: those beside the one that all else is about.
  std::vector<OtherLidar> other_lidars;
  std::optional<results::VehicleFile> together;  ///< what was found of all of them together, without their pairs

  drive::TopicChoice topics_of(std::size_t session) const {
    return session < topics.size() ? topics[session] : drive::TopicChoice{};
  }

  /// changes_since of what is set in the project, and a pending solution; empty without a calibration.
  std::vector<Message> changes_since_calibration() const;
};

/// A LiDAR of the same recordings, with a job of its own.
struct OtherLidar {
  std::string name;
  bool ticked = true;  ///< calibrated together with the others
  Project job;         ///< without other LiDARs
};

/// Saves atomically; sessions below or beside the project's folder are written relative to it, so that the folder can
/// be moved. Throws Error(Io).
void save_project(const Project& project, const std::filesystem::path& path);

/// Sessions come back as paths that can be opened; they are not opened here. Throws Error(Io) where the file cannot be
/// read, Error(Format) with file and line where it is no project, of a later version, or damaged.
Project load_project(const std::filesystem::path& path);

/// Where `missing` must lie when what was at `from` lies at `to` now and both were moved with a folder above them;
/// empty where that folder is not above `missing`, or nothing lies there. Data that were moved together are asked for
/// once.
std::filesystem::path relocate(const std::filesystem::path& missing, const std::filesystem::path& from,
                               const std::filesystem::path& to);

/// The result of a run as a file holds it: with pairs, warnings of the findings, settings and nominal.
results::ResultFile make_result_file(const pipeline::PipelineInput& input, const pipeline::PipelineOutput& output,
                                     std::vector<results::InputFile> inputs);

}  // namespace remount::project

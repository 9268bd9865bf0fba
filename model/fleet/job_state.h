// Whether a job of a fleet is done: what there is already need not be calibrated again.
#pragma once

#include <filesystem>
#include <string>

#include "model/fleet/fleet.h"
#include "model/pipeline/pipeline.h"
#include "model/results/result_file.h"

namespace remount::fleet {

/// Why what made `stored` is not what `settings`, `nominal_ins_from_lidar` and `topics` ask for now: another version
/// of the program, settings, a nominal or topics that have changed, a run that was cancelled. Empty where nothing is.
/// @param topics that somebody asked for; which others would be suggested now is known only to the opened bag
Message why_other_job(const results::ResultFile& stored, const settings::Settings& settings,
                      const std::optional<RigidTransform>& nominal_ins_from_lidar, const drive::TopicChoice& topics);

/// Why the job must run (again); empty where its result answers `input` as it is now. Files that have not been written
/// since the result was are taken to be unchanged; others are compared by their hashes.
Message why_not_done(const FleetJob& job, const pipeline::PipelineInput& input, Progress& progress);

/// Whether anything where the job's sessions lie was written, added or taken away since its result was made, judged by
/// the files' times alone: only then need they be opened to be sure. True where it cannot be told.
bool may_have_changed(const FleetJob& job, const results::ResultFile& stored);

/// Whether a file was written at the time of the job's result or later; true where one of them is not there.
bool written_since_result(const std::filesystem::path& file, const FleetJob& job);

/// The first of these files and folders where something was written, added or taken away since the job failed, judged
/// by times alone; one that is not there (any more) has nothing new. Empty where there is none, or no failure.
std::string changed_since_failure(const FleetJob& job, const std::vector<std::filesystem::path>& read);

/// "session/file" of the first input that was written at `since_ns` (ns since 1970) or later; empty where none was.
std::string file_written_since(const std::vector<std::shared_ptr<const drive::Session>>& sessions,
                               std::int64_t since_ns);

}  // namespace remount::fleet

#include "model/batch/job_state.h"

#include <sys/stat.h>

#include <map>
#include <utility>

#include "algorithms/core/error.h"
#include "model/io/input_file.h"
#include "model/project.h"
#include "remount_version.h"

namespace remount {
namespace {

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

/// The first file that is not among both, or with another size; empty where there is none.
std::string other_file(const std::vector<InputFile>& then, const std::vector<InputFile>& now) {
  std::map<std::pair<std::string, std::string>, std::uint64_t> sizes;
  for (const InputFile& file : now) sizes[{file.session, file.file}] = file.bytes;
  for (const InputFile& file : then) {
    const auto found = sizes.find({file.session, file.file});
    if (found == sizes.end() || found->second != file.bytes) return file.session + "/" + file.file;
    sizes.erase(found);
  }
  return sizes.empty() ? "" : sizes.begin()->first.first + "/" + sizes.begin()->first.second;
}

std::string changed_input(const ResultFile& stored, std::int64_t stored_ns, const PipelineInput& input,
                          Progress& progress) {
  const std::string other = other_file(stored.inputs, list_inputs(input.sessions));
  if (!other.empty()) return other;
  if (file_written_since(input.sessions, stored_ns).empty()) return {};
  return changed_file(stored.inputs, hash_inputs(input.sessions, input.threads, progress));
}

}  // namespace

std::string why_other_job(const ResultFile& stored, const Settings& settings,
                          const std::optional<RigidTransform>& nominal_ins_from_lidar) {
  if (stored.result.status == Status::Cancelled) return "it was cancelled";
  if (stored.version != kVersion) return "version " + stored.version + " made it, now " + std::string(kVersion);
  const std::vector<std::string> changes =
      changes_since({0, stored.settings, stored.nominal_ins_from_lidar}, {0, settings, nominal_ins_from_lidar});
  return changes.empty() ? "" : changes.front();
}

std::string why_not_done(const FleetJob& job, const PipelineInput& input, Progress& progress) {
  struct stat status {};
  if (!is_file(job.result) || ::stat(job.result.c_str(), &status) != 0) return "there is no result yet";
  try {
    const ResultFile stored = load_result(job.result);
    const std::string other = why_other_job(stored, input.settings, input.nominal_ins_from_lidar);
    if (!other.empty()) return other;
    const std::string changed = changed_input(stored, nanoseconds(status.st_mtim), input, progress);
    return changed.empty() ? "" : changed + " has changed";
  } catch (const Error& error) {
    return error.what();
  }
}

std::string file_written_since(const std::vector<std::shared_ptr<const Session>>& sessions, std::int64_t since_ns) {
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files) {
      struct stat status {};
      // The time of the last change of any kind: copying may set the other one back, this one it cannot.
      if (::stat(file.c_str(), &status) != 0 || nanoseconds(status.st_ctim) >= since_ns)
        return session->name + "/" + file.filename().string();
    }
  return {};
}

}  // namespace remount

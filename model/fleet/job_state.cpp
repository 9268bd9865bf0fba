#include "model/fleet/job_state.h"

#include <sys/stat.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "algorithms/core/error.h"
#include "messages/fleet.h"
#include "model/formats/files/input_file.h"
#include "model/project/project.h"
#include "remount_version.h"

namespace remount::fleet {
namespace {

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

/// Time of the last change of any kind: copying may set the other one back, this one it cannot. Nothing where no file
/// is there.
std::optional<std::int64_t> changed_ns(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return nanoseconds(status.st_ctim);
}

/// When a file was written. Nothing where none is there.
std::optional<std::int64_t> written_ns(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return std::nullopt;
  return nanoseconds(status.st_mtim);
}

/// When the job's result was made.
std::optional<std::int64_t> made_ns(const FleetJob& job) { return written_ns(job.result); }

/// The first file that is not among both, or with another size; empty where there is none. Two sessions of one name may
/// have files of one name.
std::string other_file(const std::vector<results::InputFile>& then, const std::vector<results::InputFile>& now) {
  std::multiset<std::tuple<std::string, std::string, std::uint64_t>> left;
  for (const results::InputFile& file : now) left.emplace(file.session, file.file, file.bytes);
  for (const results::InputFile& file : then) {
    const auto found = left.find({file.session, file.file, file.bytes});
    if (found == left.end()) return file.session + "/" + file.file;
    left.erase(found);
  }
  return left.empty() ? "" : std::get<0>(*left.begin()) + "/" + std::get<1>(*left.begin());
}

/// Adds the names by which a result may know the files of a session. False where one of them, or a folder, was changed
/// at `since_ns` or later, or cannot be looked at.
bool unchanged_since(const std::filesystem::path& session, std::int64_t since_ns, std::set<std::string>& names) {
  const auto old = [&](const std::filesystem::path& file) {
    const auto changed = changed_ns(file);
    return changed && *changed < since_ns;
  };
  if (!old(session)) return false;
  std::error_code error;
  if (!formats::is_folder(session)) {
    // The other files of a log lie beside it.
    for (const std::filesystem::path& file : formats::files_in(session.parent_path()))
      if (old(file)) names.insert(file.filename().string());
    return true;
  }
  std::filesystem::recursive_directory_iterator entry(session, error), end;
  for (; !error && entry != end; entry.increment(error)) {
    const bool link = entry->is_symlink(error);
    if (error || !old(entry->path()) || (link && formats::is_folder(entry->path()))) return false;
    names.insert(entry->path().lexically_relative(session).generic_string());
  }
  return !error;
}

/// "lidar is /a, it was /b" of the first role that another topic served than is wanted for it; empty where none did.
/// Roles that nobody asks for do not count.
Message other_topic(const drive::TopicChoice& used, const drive::TopicChoice& wanted) {
  for (const auto& [role, topic] : wanted) {
    const auto found = used.find(role);
    const std::string before = found == used.end() ? std::string(drive::kNoTopic) : found->second;
    if (before != topic) return say::fleet_topic_is(role, Message::verbatim(topic), Message::verbatim(before));
  }
  return {};
}

/// Those of the opened bags, suggested ones as well.
Message other_topics(const std::vector<results::UsedTopics>& then, const std::vector<results::UsedTopics>& now) {
  const auto was_asked = [](const results::UsedTopics& used) { return !used.asked.empty(); };
  if (then.empty() && std::any_of(now.begin(), now.end(), was_asked)) return say::fleet_topics_unknown();
  for (std::size_t i = 0; i < std::min(then.size(), now.size()); ++i) {
    drive::TopicChoice all_roles = now[i].topics;
    for (const auto& [role, topic] : then[i].topics) all_roles.emplace(role, drive::kNoTopic);
    if (Message other = other_topic(then[i].topics, all_roles); !other.empty())
      return say::fleet_topics_of_session(now[i].session, std::move(other));
  }
  return {};
}

std::string changed_input(const results::ResultFile& stored, std::int64_t stored_ns,
                          const pipeline::PipelineInput& input, Progress& progress) {
  // No input of a session, and the settings hold its name alone.
  if (const std::string& beams = input.settings.beams.file; !beams.empty())
    if (const auto changed = changed_ns(beams); !changed || *changed >= stored_ns) return beams;
  const std::string other = other_file(stored.inputs, results::list_inputs(input.sessions));
  if (!other.empty()) return other;
  if (file_written_since(input.sessions, stored_ns).empty()) return {};
  return results::changed_file(stored.inputs, results::hash_inputs(input.sessions, input.threads, progress));
}

}  // namespace

Message why_other_job(const results::ResultFile& stored, const settings::Settings& settings,
                      const std::optional<RigidTransform>& nominal_ins_from_lidar, const drive::TopicChoice& topics) {
  if (stored.result.status == calibration::Status::Cancelled) return say::fleet_cancelled();
  if (stored.version != kVersion) return say::fleet_other_version(stored.version, std::string(kVersion));
  const auto changes = project::changes_since({0, stored.settings, stored.nominal_ins_from_lidar},
                                              {0, settings, nominal_ins_from_lidar});
  if (!changes.empty()) return changes.front();
  if (stored.topics.empty() && !topics.empty()) return say::fleet_topics_unknown();
  for (const results::UsedTopics& used : stored.topics)
    if (Message other = other_topic(used.topics, topics); !other.empty()) return say::fleet_topics(std::move(other));
  return {};
}

Message why_not_done(const FleetJob& job, const pipeline::PipelineInput& input, Progress& progress) {
  const auto made = made_ns(job);
  if (!formats::is_file(job.result) || !made) return say::fleet_no_result_yet();
  try {
    const results::ResultFile stored = results::load_result(job.result);
    Message other = why_other_job(stored, input.settings, input.nominal_ins_from_lidar, {});
    if (other.empty()) other = other_topics(stored.topics, results::used_topics(input.sessions));
    if (!other.empty()) return other;
    const std::string changed = changed_input(stored, *made, input, progress);
    return changed.empty() ? Message() : say::fleet_file_changed(changed);
  } catch (const Error& error) {
    return error.message();
  }
}

bool written_since_result(const std::filesystem::path& file, const FleetJob& job) {
  const auto made = made_ns(job), changed = changed_ns(file);
  return !made || !changed || *changed >= *made;
}

bool may_have_changed(const FleetJob& job, const results::ResultFile& stored) {
  const auto made = made_ns(job);
  std::set<std::string> names;
  for (const std::filesystem::path& session : job.sessions)
    if (!made || !unchanged_since(session, *made, names)) return true;
  return std::any_of(stored.inputs.begin(), stored.inputs.end(),
                     [&](const results::InputFile& file) { return !names.contains(file.file); });
}

std::string changed_since_failure(const FleetJob& job, const std::vector<std::filesystem::path>& read) {
  const auto failed = written_ns(job.failure);
  if (!failed) return {};
  std::set<std::string> names;
  for (const std::filesystem::path& path : read)
    if (changed_ns(path) && !unchanged_since(path, *failed, names)) return path.string();
  return {};
}

std::string file_written_since(const std::vector<std::shared_ptr<const drive::Session>>& sessions,
                               std::int64_t since_ns) {
  for (const auto& session : sessions)
    for (const std::filesystem::path& file : session->files) {
      const auto changed = changed_ns(file);
      if (!changed || *changed >= since_ns) return session->name + "/" + file.filename().string();
    }
  return {};
}

}  // namespace remount::fleet

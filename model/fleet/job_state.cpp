#include "model/fleet/job_state.h"

#include <sys/stat.h>

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>

#include "algorithms/core/error.h"
#include "messages/fleet.h"
#include "messages/general.h"
#include "model/fleet/lidar_keys.h"
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

/// @param lidars those of the result, in its order
std::string changed_input(const results::VehicleFile& stored, std::int64_t stored_ns,
                          const std::vector<rig::LidarJob>& lidars, Progress& progress) {
  std::vector<results::InputFile> then;
  std::vector<std::shared_ptr<const drive::Session>> sessions;
  for (std::size_t l = 0; l < lidars.size(); ++l) {
    const pipeline::PipelineInput& input = lidars[l].input;
    const std::vector<results::InputFile>& files = stored.lidars.at(l).file.inputs;
    // No input of a session, and the settings hold its name alone.
    if (const std::string& beams = input.settings.beams.file; !beams.empty())
      if (const auto changed = changed_ns(beams); !changed || *changed >= stored_ns) return beams;
    if (std::string other = other_file(files, results::list_inputs(input.sessions)); !other.empty()) return other;
    then.insert(then.end(), files.begin(), files.end());
    sessions.insert(sessions.end(), input.sessions.begin(), input.sessions.end());
  }
  if (file_written_since(lidars, stored_ns).empty()) return {};
  return results::changed_file(then, results::hash_inputs(sessions, lidars.front().input.threads, progress));
}

/// What a LiDAR's own result says, with its name where it has one.
Message of_lidar(const std::string& lidar, Message words) {
  return lidar.empty() || words.empty() ? words : say::of_file(lidar, std::move(words));
}

std::string in_one(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

Message other_lidars(const std::string& now, const results::VehicleFile& stored) {
  const std::string then = in_one(results::lidar_names(stored));
  const bool same = now == "all" ? !then.empty() : now == then;
  return same ? Message() : say::fleet_other_lidars(lidars_in_words(now), lidars_in_words(then));
}

/// What LiDARs have in common is said of none.
Message other_settings(const results::VehicleFile& stored, const settings::Settings& settings) {
  for (const results::LidarResult& lidar : stored.lidars) {
    if (lidar.file.result.status == calibration::Status::Cancelled) return say::fleet_cancelled();
    if (lidar.file.version != kVersion) return say::fleet_other_version(lidar.file.version, std::string(kVersion));
    const auto changes = project::changes_since({0, lidar.file.settings, {}}, {0, settings, {}});
    if (!changes.empty()) return changes.front();
  }
  return {};
}

Message other_nominal(const results::ResultFile& stored, const std::optional<RigidTransform>& nominal_ins_from_lidar) {
  const auto changes = project::changes_since({0, {}, stored.nominal_ins_from_lidar}, {0, {}, nominal_ins_from_lidar});
  return changes.empty() ? Message() : changes.front();
}

Message other_asked_topics(const results::ResultFile& stored, const drive::TopicChoice& topics) {
  if (stored.topics.empty() && !topics.empty()) return say::fleet_topics_unknown();
  for (const results::UsedTopics& used : stored.topics)
    if (Message other = other_topic(used.topics, topics); !other.empty()) return say::fleet_topics(std::move(other));
  return {};
}

Message other_input(const results::ResultFile& stored, const pipeline::PipelineInput& input) {
  Message other = other_nominal(stored, input.nominal_ins_from_lidar);
  return other.empty() ? other_topics(stored.topics, results::used_topics(input.sessions)) : other;
}

}  // namespace

Message why_other_job(const FleetJob& job, const FleetVehicle& vehicle, const results::VehicleFile& stored,
                      const AskedNominal& nominal_of) {
  if (Message other = other_lidars(job.lidars, stored); !other.empty()) return other;
  if (Message other = other_settings(stored, vehicle.settings); !other.empty()) return other;
  for (const results::LidarResult& lidar : stored.lidars) {
    Message other = other_nominal(lidar.file, nominal_of(lidar));
    if (other.empty()) other = other_asked_topics(lidar.file, vehicle.topics);
    if (!other.empty()) return of_lidar(lidar.name, std::move(other));
  }
  return {};
}

Message why_not_done(const FleetJob& job, const std::vector<rig::LidarJob>& lidars, Progress& progress) {
  const auto made = made_ns(job);
  if (!formats::is_file(job.result) || !made) return say::fleet_no_result_yet();
  try {
    const results::VehicleFile stored = results::load_any_result(job.result);
    std::vector<std::string> names;
    for (const rig::LidarJob& lidar : lidars) names.push_back(lidar.name);
    if (Message other = other_lidars(in_one(names), stored); !other.empty()) return other;
    if (Message other = other_settings(stored, lidars.front().input.settings); !other.empty()) return other;
    for (std::size_t l = 0; l < lidars.size(); ++l)
      if (Message other = other_input(stored.lidars[l].file, lidars[l].input); !other.empty())
        return of_lidar(lidars[l].name, std::move(other));
    const std::string changed = changed_input(stored, *made, lidars, progress);
    return changed.empty() ? Message() : say::fleet_file_changed(changed);
  } catch (const Error& error) {
    return error.message();
  }
}

bool written_since_result(const std::filesystem::path& file, const FleetJob& job) {
  const auto made = made_ns(job), changed = changed_ns(file);
  return !made || !changed || *changed >= *made;
}

bool may_have_changed(const FleetJob& job, const results::VehicleFile& stored) {
  const auto made = made_ns(job);
  std::set<std::string> names;
  for (const std::filesystem::path& session : job.sessions)
    if (!made || !unchanged_since(session, *made, names)) return true;
  const auto is_gone = [&](const results::InputFile& file) { return !names.contains(file.file); };
  return std::ranges::any_of(stored.lidars, [&](const results::LidarResult& lidar) {
    return std::ranges::any_of(lidar.file.inputs, is_gone);
  });
}

std::string changed_since_failure(const FleetJob& job, const std::vector<std::filesystem::path>& read) {
  const auto failed = written_ns(job.failure);
  if (!failed) return {};
  std::set<std::string> names;
  for (const std::filesystem::path& path : read)
    if (changed_ns(path) && !unchanged_since(path, *failed, names)) return path.string();
  return {};
}

std::string file_written_since(const std::vector<rig::LidarJob>& lidars, std::int64_t since_ns) {
  for (const rig::LidarJob& lidar : lidars)
    for (const auto& session : lidar.input.sessions)
      for (const std::filesystem::path& file : session->files) {
        const auto changed = changed_ns(file);
        if (!changed || *changed >= since_ns) return session->name + "/" + file.filename().string();
      }
  return {};
}

}  // namespace remount::fleet

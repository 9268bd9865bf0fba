#include "model/fleet/failed_job.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "algorithms/core/error.h"
#include "messages/fleet.h"
#include "model/fleet/job_state.h"
#include "model/fleet/lidar_keys.h"
#include "model/formats/documents/message_document.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/project/project.h"
#include "model/results/topic_document.h"
#include "model/settings/settings_file.h"
#include "remount_version.h"

namespace remount::fleet {
namespace {

constexpr std::string_view kBelow = "\n---\n";
constexpr std::uint64_t kMaxFailureBytes = std::uint64_t{1} << 20;

formats::DocumentNode failure_document(const FleetVehicle& vehicle, const FleetJob& job, const Message& reason) {
  formats::DocumentNode root = formats::DocumentNode::map();
  root.add("message", formats::message_document(reason));
  root.add("version", formats::DocumentNode::string(kVersion));
  root.add("nominal", formats::DocumentNode::string(nominal_text(vehicle)));
  root.add("lidars", formats::DocumentNode::string(job.lidars));
  formats::DocumentNode& topics = root.add("topics", formats::DocumentNode::map());
  for (const auto& [role, topic] : vehicle.topics) topics.add(role, formats::DocumentNode::string(topic));
  root.add("settings", settings::settings_document(vehicle.settings));
  return root;
}

Message nominal_in_words(const std::string& nominal) {
  return nominal.empty() ? say::fleet_left_to_sessions() : Message::verbatim(nominal);
}

/// A file, with its format before it where the fleet names one; of six numbers there is none.
void add_file_of(const std::string& nominal, std::vector<std::filesystem::path>& files) {
  if (const std::size_t path = nominal.find('/'); path != std::string::npos) files.emplace_back(nominal.substr(path));
}

Message changed_topic(const drive::TopicChoice& then, const drive::TopicChoice& now) {
  std::set<std::string> roles;
  for (const drive::TopicChoice* topics : {&then, &now})
    for (const auto& [role, topic] : *topics) roles.insert(role);
  const auto named = [](const drive::TopicChoice& topics, const std::string& role) {
    const auto found = topics.find(role);
    return found == topics.end() ? say::fleet_left_to_be_suggested() : Message::verbatim(found->second);
  };
  for (const std::string& role : roles)
    if (named(then, role) != named(now, role))
      return say::fleet_topics(say::fleet_topic_is(role, named(now, role), named(then, role)));
  return {};
}

Message other_wish(const formats::DocumentView& then, const FleetVehicle& now, const FleetJob& job) {
  const std::string version = then.at("version").string(), nominal = then.at("nominal").string();
  const std::string lidars = then.has("lidars") ? then.at("lidars").string() : "";  // former versions had one
  if (version != kVersion) return say::fleet_version_was(version, std::string(kVersion));
  if (lidars != job.lidars) return say::fleet_other_lidars(lidars_in_words(job.lidars), lidars_in_words(lidars));
  if (nominal != nominal_text(now))
    return say::fleet_nominal_is(nominal_in_words(nominal_text(now)), nominal_in_words(nominal));
  if (Message topic = changed_topic(results::topic_choice_from_document(then.at("topics")), now.topics); !topic.empty())
    return topic;
  const auto changes = project::changes_since({0, settings::settings_from_document(then.at("settings")), std::nullopt},
                                              {0, now.settings, std::nullopt});
  return changes.empty() ? Message() : changes.front();
}

struct FailureFile {
  std::string words;                      ///< for people
  std::optional<std::string> below = {};  ///< nothing where somebody else wrote the file

  explicit FailureFile(const FleetJob& job) {
    const std::string text =
        formats::is_file(job.failure) ? formats::read_regular_file(job.failure, kMaxFailureBytes) : std::string();
    const std::size_t end = text.rfind(kBelow);
    words = formats::trim(std::string_view(text).substr(0, end));
    if (end != std::string::npos) below = text.substr(end + kBelow.size());
  }
};

}  // namespace

void note_failure(const Fleet& fleet, const FleetJob& job, const Message& reason) {
  const formats::DocumentNode below = failure_document(fleet.vehicles.at(job.vehicle), job, reason);
  try {
    formats::save_atomically(job.failure, english(reason) + std::string(kBelow) + formats::to_yaml(below));
  } catch (const Error&) {
    // The folder that refuses it is what the job itself has failed of, or will.
  }
}

Message failure_message(const FleetJob& job) {
  const FailureFile file(job);
  if (file.below) try {
      const formats::DocumentNode below = formats::parse_yaml(*file.below, job.failure.string());
      const formats::DocumentView view(below, job.failure.string());
      if (view.has("message")) return formats::message_from_document(view.at("message"));
    } catch (const Error&) {
      // Damaged: the words above are still there.
    }
  return Message::verbatim(file.words);
}

Message why_failure_is_old(const Fleet& fleet, const FleetJob& job) {
  const FailureFile file(job);
  const FleetVehicle& vehicle = fleet.vehicles.at(job.vehicle);
  if (file.below) try {
      const formats::DocumentNode wish = formats::parse_yaml(*file.below, job.failure.string());
      if (Message other = other_wish(formats::DocumentView(wish, job.failure.string()), vehicle, job); !other.empty())
        return other;
    } catch (const Error& error) {
      return error.message();  // of another version, or damaged: it tells nothing of what is asked for now
    }
  std::vector<std::filesystem::path> read = job.sessions;
  add_file_of(vehicle.nominal, read);
  for (const auto& [lidar, nominal] : vehicle.nominal_of_lidars) add_file_of(nominal, read);
  const std::string changed = changed_since_failure(job, read);
  return changed.empty() ? Message() : say::fleet_file_changed(changed);
}

}  // namespace remount::fleet

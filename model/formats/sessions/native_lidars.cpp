#include "model/formats/sessions/native_lidars.h"

#include <algorithm>
#include <array>
#include <optional>

#include "algorithms/core/error.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/lidar_offer.h"

namespace remount::formats {
namespace {

constexpr std::string_view kLidars = "lidars", kRoleOfLidars = "lidar";
constexpr std::array<std::string_view, 4> kOfOneLidar{"scans", "lidar_poses", "lidar", "nominal"};

std::vector<std::string> names_of(const std::vector<DeclaredLidar>& lidars) {
  std::vector<std::string> names;
  for (const DeclaredLidar& lidar : lidars) names.push_back(lidar.name);
  return names;
}

}  // namespace

std::vector<DeclaredLidar> declared_lidars(const DocumentView& root) {
  const auto several = root.find(kLidars);
  if (!several) return {{"", root}};
  for (const std::string_view key : kOfOneLidar)
    if (const auto beside = root.find(key)) beside->fail(say::native_beside_lidars(std::string(key)));
  if (!several->is_map() || several->node().items.empty() || several->node().items.size() > drive::kMostLidars)
    several->fail(say::native_lidars_count(drive::kMostLidars));
  std::vector<DeclaredLidar> lidars;
  for (const auto& [name, node] : several->entries()) {
    if (!drive::can_name_lidar(name)) node.fail(say::native_lidar_name(name.substr(0, 80), drive::kLongestLidarName));
    node.allow_only({kOfOneLidar.begin(), kOfOneLidar.end()});
    if (node.has("scans") == node.has("lidar_poses")) node.fail(say::native_either("scans", "lidar_poses"));
    lidars.push_back({name, node});
  }
  return lidars;
}

const DeclaredLidar* choose_lidar(const std::vector<DeclaredLidar>& lidars, const drive::TopicChoice& topics,
                                  drive::Session& session) {
  session.topic_choice = topics;
  const bool named = !lidars.front().name.empty();
  for (const auto& [role, name] : topics)
    if (!named || (role != kRoleOfLidars && name != drive::kNoTopic))
      throw Error(ErrorCode::Contract, session.path.string(), say::session_no_topics(session.format));
  const auto asked = topics.find(kRoleOfLidars);
  if (asked != topics.end() && asked->second == drive::kNoTopic) return nullptr;
  auto chosen = lidars.begin();
  if (asked != topics.end()) {
    chosen =
        std::find_if(chosen, lidars.end(), [&](const DeclaredLidar& lidar) { return lidar.name == asked->second; });
    if (chosen == lidars.end())
      throw Error(ErrorCode::Contract, asked->second, say::native_no_such_lidar(names_of(lidars)));
  } else if (lidars.size() > 1) {
    std::vector<std::string> others = names_of(lidars);
    others.erase(others.begin());
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "lidar-chosen", chosen->name,
                                                   say::native_lidar_chosen(std::move(others))));
  }
  session.lidar_name = chosen->name;
  return &*chosen;
}

drive::SessionTopic lidar_topic(const DeclaredLidar& lidar, std::optional<std::size_t> scans) {
  const auto listed = lidar.node.find("scans");
  drive::SessionTopic topic;
  topic.name = lidar.name;
  topic.type = !listed ? "lidar_poses" : listed->has("capture") ? "capture" : "scans";
  topic.count = scans.value_or(0);
  topic.can_be = {std::string(kRoleOfLidars)};
  return topic;
}

}  // namespace remount::formats

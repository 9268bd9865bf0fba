#include "model/io/bag/topic_roles.h"

#include <algorithm>

#include "model/io/bag/cloud_message.h"
#include "model/io/pose_session_reader.h"
#include "model/io/stream_tools.h"

namespace remount {
namespace {

/// A topic that can serve as something, and what tells it from others of its kind.
struct Candidate {
  std::size_t topic = 0;
  MessageKind kind = MessageKind::Other;
  std::vector<std::string> can_be;
  bool oriented = false;     ///< IMU: its orientation is measured
  bool inertial = false;     ///< IMU: its rates are measured
  bool timed = false;        ///< cloud: its points have times or rings
  std::uint64_t points = 0;  ///< cloud
  std::size_t messages = 0;
};

/// Looks at the first message.
void examine(const BagFile& bag, Candidate& candidate) {
  constexpr std::size_t kHeadBytes = 16 * 1024;
  const BagTopic& topic = bag.topics()[candidate.topic];
  const std::string where = bag.files().front().string() + ": " + topic.name;
  if (candidate.kind == MessageKind::Imu) {
    const std::string bytes = bag.message(topic.entries.front());
    MessageReader reader(bytes, topic.encoding, where);
    const ImuMessage imu = read_imu(reader);
    candidate.oriented = imu.orientation.has_value();
    candidate.inertial = imu.angular_rate_radps.has_value();
  } else if (is_cloud(candidate.kind)) {
    const std::string bytes = bag.message(topic.entries.front(), kHeadBytes);
    MessageReader reader(bytes, topic.encoding, where);
    const CloudOutline outline = read_cloud_outline(reader, candidate.kind);
    candidate.timed = outline.timed || outline.ringed;
    candidate.points = outline.points;
  }
}

std::vector<std::string> roles_of(const Candidate& candidate) {
  switch (candidate.kind) {
    case MessageKind::PointCloud2:
    case MessageKind::LivoxCustom:
      return {"lidar"};
    case MessageKind::Imu: {
      std::vector<std::string> roles;
      if (candidate.oriented) roles.emplace_back("ins");
      if (candidate.inertial) roles.emplace_back("imu");
      return roles;
    }
    case MessageKind::NavSatFix:
      return {"ins-position", "gnss"};
    case MessageKind::Inspvax:
      return {"ins"};
    default:
      return is_pose(candidate.kind) ? std::vector<std::string>{"ins", "lidar"} : std::vector<std::string>{};
  }
}

std::vector<Candidate> candidates_of(const BagFile& bag) {
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    Candidate candidate;
    candidate.topic = i;
    candidate.kind = message_kind(topic.type);
    candidate.messages = topic.entries.size();
    if (topic.entries.empty() || topic.encoding == MessageEncoding::Other) continue;
    try {
      examine(bag, candidate);
    } catch (const Error&) {
      // Its first message is damaged, perhaps no other: it can still be what its type says.
      candidate.oriented = candidate.inertial = true;
    }
    candidate.can_be = roles_of(candidate);
    if (!candidate.can_be.empty()) candidates.push_back(std::move(candidate));
  }
  return candidates;
}

bool can_be(const Candidate& candidate, std::string_view role) {
  return std::find(candidate.can_be.begin(), candidate.can_be.end(), role) != candidate.can_be.end();
}

/// Higher is better; 0: not without being asked.
double lidar_score(const Candidate& candidate, std::size_t most_messages) {
  if (!is_cloud(candidate.kind)) return 0.0;
  // A map that is published now and then is a cloud, too.
  const bool steady = candidate.messages * 3 >= most_messages;
  return 1.0 + (steady ? 1e12 : 0.0) + (candidate.timed ? 1e11 : 0.0) + static_cast<double>(candidate.points);
}

double pose_score(const std::string& topic, MessageKind kind) {
  const std::initializer_list<std::string_view> ins_words{"ins",  "gnss",       "gps",      "novatel", "span",
                                                          "oxts", "septentrio", "applanix", "pos",     "nav"};
  const std::initializer_list<std::string_view> other_words{"lidar",  "laser", "loam",   "lio", "visual",
                                                            "camera", "wheel", "wheels", "icp", "mapped"};
  if (name_has_word(topic, other_words)) return 0.0;
  double score = kind == MessageKind::Odometry ? 30.0 : kind == MessageKind::TransformStamped ? 10.0 : 20.0;
  if (name_has_word(topic, ins_words)) score += 100.0;
  return score;
}

double ins_score(const BagFile& bag, const Candidate& candidate, bool positions) {
  if (!can_be(candidate, "ins")) return 0.0;
  if (candidate.kind == MessageKind::Inspvax) return 1000.0;
  if (candidate.kind == MessageKind::Imu) return positions ? 50.0 : 0.0;
  std::string words = bag.topics()[candidate.topic].name;
  std::replace(words.begin(), words.end(), '/', '_');
  return pose_score(words, candidate.kind);
}

class Chooser {
 public:
  Chooser(const BagFile& bag, const TopicChoice& choice, std::vector<Finding>& findings)
      : bag_(bag), choice_(choice), findings_(findings), candidates_(candidates_of(bag)) {}

  TopicRoles choose() {
    TopicRoles roles;
    std::size_t most_clouds = 0;
    bool positions = false;
    for (const Candidate& candidate : candidates_) {
      if (is_cloud(candidate.kind)) most_clouds = std::max(most_clouds, candidate.messages);
      positions = positions || candidate.kind == MessageKind::NavSatFix;
    }
    roles.lidar = take("lidar", [&](const Candidate& c) { return lidar_score(c, most_clouds); });
    const bool fixes_allowed = positions && !left_out("ins-position");
    roles.ins = take(
        "ins", [&](const Candidate& c) { return roles.lidar == c.topic ? 0.0 : ins_score(bag_, c, fixes_allowed); });
    if (roles.ins && kind(*roles.ins) == MessageKind::Imu)
      roles.ins_position = take("ins-position", [&](const Candidate& c) { return of_same_device(c, *roles.ins); });
    else if (choice_.contains("ins-position") && !left_out("ins-position"))
      throw Error(ErrorCode::Contract, "ins-position",
                  "goes with an IMU whose orientation serves as ins; give --topic ins=TOPIC of that IMU");
    roles.gnss = take(
        "gnss", [&](const Candidate& c) { return roles.ins_position == c.topic ? 1.0 : 2.0; }, false);
    roles.imu = take(
        "imu", [&](const Candidate& c) { return 1.0 + static_cast<double>(c.messages); }, false);
    return roles;
  }

 private:
  MessageKind kind(std::size_t topic) const { return message_kind(bag_.topics()[topic].type); }
  bool left_out(std::string_view role) const {
    const auto chosen = choice_.find(role);
    return chosen != choice_.end() && chosen->second == kNoTopic;
  }

  /// Devices publish under one name: "/ins/imu" and "/ins/fix". As long a common beginning as can be.
  double of_same_device(const Candidate& candidate, std::size_t other) const {
    const std::string &a = bag_.topics()[candidate.topic].name, &b = bag_.topics()[other].name;
    const auto differs = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    return 1.0 + static_cast<double>(differs.first - a.begin()) +
           1e-9 * static_cast<double>(std::min<std::size_t>(candidate.messages, 100'000'000));
  }

  const Candidate& chosen(std::string_view role, const std::string& name) const {
    bool there = false;
    for (const BagTopic& topic : bag_.topics()) there = there || topic.name == name;
    if (!there) {
      std::string names;
      for (const BagTopic& topic : bag_.topics()) names += "\n  " + topic.name + " (" + topic.type + ")";
      throw Error(ErrorCode::Contract, name, "is no topic of this bag. It has:" + names);
    }
    for (const Candidate& candidate : candidates_)
      if (bag_.topics()[candidate.topic].name == name && can_be(candidate, role)) return candidate;
    throw Error(ErrorCode::Contract, name, "cannot serve as " + std::string(role) + ": see what inspect says of it");
  }

  /// The topic that was chosen for a role, or the one that scores best.
  template <class Score>
  std::optional<std::size_t> take(std::string_view role, Score&& score, bool tell = true) {
    if (left_out(role)) return std::nullopt;
    if (const auto asked = choice_.find(role); asked != choice_.end()) return chosen(role, asked->second).topic;
    const Candidate* best = nullptr;
    double best_score = 0.0;
    std::vector<std::string> in_question;
    for (const Candidate& candidate : candidates_) {
      if (!can_be(candidate, role)) continue;
      const double points = score(candidate);
      if (points <= 0.0) continue;
      in_question.push_back(bag_.topics()[candidate.topic].name);
      if (points > best_score) best = &candidate, best_score = points;
    }
    if (!best) return std::nullopt;
    if (tell && in_question.size() > 1) report(role, bag_.topics()[best->topic].name, in_question);
    return best->topic;
  }

  void report(std::string_view role, const std::string& taken, const std::vector<std::string>& in_question) {
    std::string others;
    for (const std::string& name : in_question)
      if (name != taken) others += (others.empty() ? "" : ", ") + name;
    findings_.push_back(make_finding(Severity::Note, "topic-chosen", taken,
                                     "Of several topics this one serves as " + std::string(role) + "; not used: " +
                                         others + ". --topic " + std::string(role) + "=TOPIC takes another."));
  }

  const BagFile& bag_;
  const TopicChoice& choice_;
  std::vector<Finding>& findings_;
  std::vector<Candidate> candidates_;
};

}  // namespace

TopicRoles choose_topics(const BagFile& bag, const TopicChoice& choice, std::vector<Finding>& findings) {
  return Chooser(bag, choice, findings).choose();
}

std::vector<SessionTopic> list_topics(const BagFile& bag, const TopicRoles& roles) {
  const std::vector<Candidate> candidates = candidates_of(bag);
  std::vector<SessionTopic> topics;
  for (std::size_t i = 0; i < bag.topics().size(); ++i) {
    const BagTopic& topic = bag.topics()[i];
    SessionTopic listed{topic.name, topic.type, topic.entries.size(), 0.0, {}, {}};
    std::vector<std::int64_t> steps;
    for (std::size_t k = 1; k < topic.entries.size(); ++k)
      steps.push_back(topic.entries[k].log_time_ns - topic.entries[k - 1].log_time_ns);
    if (!steps.empty()) {
      const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
      std::nth_element(steps.begin(), middle, steps.end());
      if (*middle > 0) listed.rate_hz = 1e9 / static_cast<double>(*middle);
    }
    for (const Candidate& candidate : candidates)
      if (candidate.topic == i) listed.can_be = candidate.can_be;
    const auto all = roles.all();
    for (std::size_t role = 0; role < kTopicRoles.size(); ++role)
      if (*all[role] == i) listed.used_as.emplace_back(kTopicRoles[role]);
    topics.push_back(std::move(listed));
  }
  return topics;
}

}  // namespace remount

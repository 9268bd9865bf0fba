#include "model/io/bag/topic_roles.h"

#include <algorithm>

#include "algorithms/core/median.h"
#include "model/io/bag/cloud_message.h"
#include "model/io/pose_session_reader.h"
#include "model/io/stream_tools.h"

namespace remount {
namespace {

/// A topic that can serve as something, and what tells it from others of its kind.
struct Candidate {
  std::size_t topic = 0;
  MessageKind kind = MessageKind::Other;
  bool damaged = false;      ///< its first message cannot be read, perhaps others can
  bool oriented = true;      ///< IMU: its orientation is measured
  bool inertial = true;      ///< IMU: its rates are measured
  bool timed = false;        ///< cloud: its points have times or rings
  std::uint64_t points = 0;  ///< cloud
  std::size_t messages = 0;
};

/// How well a topic serves as something: higher is better; 0: not without being asked.
struct Fitness {
  double points = 0.0;
  std::string why;
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

bool can_be(const Candidate& candidate, std::string_view role) {
  switch (candidate.kind) {
    case MessageKind::PointCloud2:
    case MessageKind::LivoxCustom:
      return role == "lidar";
    case MessageKind::Imu:
      return (role == "ins" && candidate.oriented) || (role == "imu" && candidate.inertial);
    case MessageKind::NavSatFix:
      return role == "ins-position" || role == "gnss";
    case MessageKind::Inspvax:
      return role == "ins";
    default:
      return is_pose(candidate.kind) && (role == "ins" || role == "lidar");
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
    } catch (const Error& error) {
      if (error.code() == ErrorCode::Io) throw;  // a disk that fails for a moment must not choose another topic
      candidate.damaged = true;                  // it can still be what its type says
    }
    candidates.push_back(candidate);
  }
  return candidates;
}

/// Why a topic that no role can have has none.
std::string unusable_reason(const BagTopic& topic) {
  if (topic.entries.empty()) return "it has no messages";
  if (topic.encoding == MessageEncoding::Other) return "its messages are serialised in a way that is not read";
  const MessageKind kind = message_kind(topic.type);
  if (kind == MessageKind::Transforms) return "transforms that change with time are not read";
  if (kind == MessageKind::Imu) return "neither its orientation nor its rates are measured";
  return "messages of this type are not read";
}

Fitness fit_lidar(const Candidate& candidate, std::size_t most_messages) {
  if (!is_cloud(candidate.kind)) return {0.0, "poses: they stand for the LiDAR where they are asked for"};
  const std::string size = std::to_string(candidate.points) + " points";
  // A map that is published now and then is a cloud, too.
  const bool steady = candidate.messages * 3 >= most_messages;
  const double points =
      1.0 + (steady ? 1e12 : 0.0) + (candidate.timed ? 1e11 : 0.0) + static_cast<double>(candidate.points);
  if (candidate.damaged) return {points, "scans; the first cannot be read"};
  if (!steady) return {points, "rare, as maps are: " + size};
  return {points, "scans of " + size + (candidate.timed ? " that have times" : " without times")};
}

Fitness fit_pose(std::string topic, MessageKind kind) {
  const std::initializer_list<std::string_view> ins_words{"ins",  "gnss",       "gps",      "novatel", "span",
                                                          "oxts", "septentrio", "applanix", "pos",     "nav"};
  const std::initializer_list<std::string_view> other_words{"lidar",  "laser", "loam",   "lio", "visual",
                                                            "camera", "wheel", "wheels", "icp", "mapped"};
  std::replace(topic.begin(), topic.end(), '/', '_');
  if (name_has_word(topic, other_words)) return {0.0, "its name speaks of another sensor than an INS"};
  const double score = kind == MessageKind::Odometry ? 30.0 : kind == MessageKind::TransformStamped ? 10.0 : 20.0;
  if (name_has_word(topic, ins_words)) return {score + 100.0, "poses; the name speaks of an INS"};
  return {score, "poses; the name does not say of what"};
}

class Chooser {
 public:
  Chooser(const BagFile& bag, const TopicChoice& choice, std::vector<Finding>& findings)
      : bag_(bag), choice_(choice), findings_(findings), candidates_(candidates_of(bag)), uses_(bag.topics().size()) {}

  ChosenTopics choose() {
    TopicRoles roles;
    std::size_t most_clouds = 0;
    for (const Candidate& candidate : candidates_) {
      if (is_cloud(candidate.kind)) most_clouds = std::max(most_clouds, candidate.messages);
      fixes_ = fixes_ || (candidate.kind == MessageKind::NavSatFix && !left_out("ins-position"));
    }
    roles.lidar = take("lidar", [&](const Candidate& c) { return fit_lidar(c, most_clouds); });
    roles.ins = take("ins", [&](const Candidate& c) { return fit_ins(c, roles.lidar); });
    if (roles.lidar && roles.lidar == roles.ins)
      throw Error(ErrorCode::Contract, bag_.topics()[*roles.ins].name,
                  "was chosen for lidar and for ins: a motion that is compared with itself tells nothing");
    const bool completes = roles.ins && kind(*roles.ins) == MessageKind::Imu;
    if (!completes && choice_.contains("ins-position") && !left_out("ins-position"))
      throw Error(ErrorCode::Contract, "ins-position",
                  "goes with an IMU whose orientation serves as ins; give --topic ins=TOPIC of that IMU");
    const auto position = take(
        "ins-position", [&](const Candidate& c) { return fit_position(c, roles.ins); }, completes);
    if (completes) roles.ins_position = position;
    roles.gnss = take(
        "gnss", [&](const Candidate& c) { return fit_gnss(c, roles.ins_position); }, false);
    roles.imu = take(
        "imu", [&](const Candidate& c) { return fit_imu(c); }, false);
    return {roles, list(roles)};
  }

 private:
  MessageKind kind(std::size_t topic) const { return message_kind(bag_.topics()[topic].type); }
  bool left_out(std::string_view role) const {
    const auto chosen = choice_.find(role);
    return chosen != choice_.end() && chosen->second == kNoTopic;
  }

  Fitness fit_ins(const Candidate& candidate, const std::optional<std::size_t>& lidar) const {
    if (lidar == candidate.topic) return {0.0, "it stands for the LiDAR"};
    if (candidate.kind == MessageKind::Inspvax) return {1000.0, "position and attitude of the INS itself"};
    if (candidate.kind != MessageKind::Imu) return fit_pose(bag_.topics()[candidate.topic].name, candidate.kind);
    return fixes_ ? Fitness{50.0, "an orientation, to which fixes give the position"}
                  : Fitness{0.0, "an orientation, but no fixes are there to give the position"};
  }

  /// Devices publish under one name: "/ins/imu" and "/ins/fix". As long a common beginning as can be.
  Fitness fit_position(const Candidate& candidate, const std::optional<std::size_t>& ins) const {
    const std::string& own = bag_.topics()[candidate.topic].name;
    const std::string other = ins ? bag_.topics()[*ins].name : std::string();
    const auto alike = std::mismatch(own.begin(), own.end(), other.begin(), other.end()).first - own.begin();
    const std::string device = own.substr(0, own.rfind('/') + 1);
    const bool same = device.size() > 1 && static_cast<std::ptrdiff_t>(device.size()) <= alike;
    return {1.0 + static_cast<double>(alike) + 1e-9 * few_messages(candidate),
            same ? "fixes; by its name of the device of the orientation" : "fixes of a receiver"};
  }

  static Fitness fit_gnss(const Candidate& candidate, const std::optional<std::size_t>& ins_position) {
    return ins_position == candidate.topic ? Fitness{1.0, "fixes that place the INS already"}
                                           : Fitness{2.0, "fixes of a receiver"};
  }
  static Fitness fit_imu(const Candidate& candidate) {
    return {1.0 + few_messages(candidate), "turn rates and accelerations"};
  }
  static double few_messages(const Candidate& candidate) {
    return static_cast<double>(std::min<std::size_t>(candidate.messages, 100'000'000));
  }

  std::size_t chosen(std::string_view role, const std::string& name) const {
    bool there = false;
    for (const BagTopic& topic : bag_.topics()) there = there || topic.name == name;
    if (!there) {
      std::string names;
      for (const BagTopic& topic : bag_.topics()) names += "\n  " + topic.name + " (" + topic.type + ")";
      throw Error(ErrorCode::Contract, name, "is no topic of this bag. It has:" + names);
    }
    for (const Candidate& candidate : candidates_)
      if (bag_.topics()[candidate.topic].name == name && can_be(candidate, role)) return candidate.topic;
    throw Error(ErrorCode::Contract, name, "cannot serve as " + std::string(role) + ": see what inspect says of it");
  }

  /// The topic that was chosen for a role, or the one that fits best; notes how all of them fit.
  template <class Fit>
  std::optional<std::size_t> take(std::string_view role, Fit&& fit, bool tell = true) {
    std::optional<std::size_t> best;
    double best_points = 0.0;
    std::vector<std::string> in_question;
    for (const Candidate& candidate : candidates_) {
      if (!can_be(candidate, role)) continue;
      Fitness fitness = fit(candidate);
      const bool unasked = fitness.points > 0.0;
      uses_[candidate.topic].push_back(
          {std::string(role), std::move(fitness.why), unasked, role == "ins" && candidate.kind == MessageKind::Imu});
      if (!unasked) continue;
      in_question.push_back(bag_.topics()[candidate.topic].name);
      if (fitness.points > best_points) best = candidate.topic, best_points = fitness.points;
    }
    if (left_out(role)) return std::nullopt;
    if (const auto asked = choice_.find(role); asked != choice_.end()) return chosen(role, asked->second);
    if (best && tell && in_question.size() > 1) report(role, bag_.topics()[*best].name, in_question);
    return best;
  }

  void report(std::string_view role, const std::string& taken, const std::vector<std::string>& in_question) {
    std::string others;
    for (const std::string& name : in_question)
      if (name != taken) others += (others.empty() ? "" : ", ") + name;
    findings_.push_back(make_finding(Severity::Note, "topic-chosen", taken,
                                     "Of several topics this one serves as " + std::string(role) + "; not used: " +
                                         others + ". --topic " + std::string(role) + "=TOPIC takes another."));
  }

  std::vector<OfferedTopic> list(const TopicRoles& roles) {
    std::vector<OfferedTopic> topics;
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const BagTopic& topic = bag_.topics()[i];
      OfferedTopic offered{
          {topic.name, topic.type, topic.entries.size(), rate_hz(topic), {}, {}}, std::move(uses_[i]), {}};
      if (is_static_transforms(topic) && !topic.entries.empty())
        offered.uses.push_back({std::string(kNominalRole), "where the transforms lead from the LiDAR to the INS"});
      if (offered.uses.empty()) offered.unusable = unusable_reason(topic);
      for (const TopicUse& use : offered.uses) offered.topic.can_be.push_back(use.role);
      for (std::size_t role = 0; role < kTopicRoles.size(); ++role)
        if (roles.all()[role] == i) offered.topic.used_as.emplace_back(kTopicRoles[role]);
      topics.push_back(std::move(offered));
    }
    return topics;
  }

  static double rate_hz(const BagTopic& topic) {
    std::vector<std::int64_t> steps;
    for (std::size_t k = 1; k < topic.entries.size(); ++k)
      steps.push_back(topic.entries[k].log_time_ns - topic.entries[k - 1].log_time_ns);
    const std::int64_t step = steps.empty() ? 0 : median_of(std::move(steps));
    return step > 0 ? 1e9 / static_cast<double>(step) : 0.0;
  }

  const BagFile& bag_;
  const TopicChoice& choice_;
  std::vector<Finding>& findings_;
  std::vector<Candidate> candidates_;
  std::vector<std::vector<TopicUse>> uses_;  ///< of each topic of the bag
  bool fixes_ = false;                       ///< there are some that may give positions
};

}  // namespace

ChosenTopics choose_topics(const BagFile& bag, const TopicChoice& choice, std::vector<Finding>& findings) {
  return Chooser(bag, choice, findings).choose();
}

bool is_static_transforms(const BagTopic& topic) {
  return message_kind(topic.type) == MessageKind::Transforms && topic.name.ends_with("tf_static") &&
         topic.encoding != MessageEncoding::Other;
}

}  // namespace remount

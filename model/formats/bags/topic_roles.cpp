#include "model/formats/bags/topic_roles.h"

#include <algorithm>
#include <span>
#include <utility>

#include "algorithms/core/median.h"
#include "messages/topics.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/apollo_messages.h"
#include "model/formats/bags/ins_messages.h"
#include "model/formats/bags/packet_clouds.h"
#include "model/formats/bags/topic_candidates.h"
#include "model/formats/bags/topic_fitness.h"
#include "model/formats/files/input_file.h"

namespace remount::bags {
namespace {

/// Between poses at a lower rate the motion of a vehicle is guessed rather than interpolated.
constexpr double kLeastInsRate_hz = 5.0;
constexpr double kMuchFaster = 3.0;

constexpr std::size_t kNoOffer = static_cast<std::size_t>(-1);
/// Of that many candidates fixes are looked for that go with an orientation, and what gives the INS more often: no
/// recording has as many topics, and a bag that is made to take for ever may have thousands of each.
constexpr std::size_t kMostPairings = 500;

bool is_much_faster(double rate_hz, double than_hz) {
  return rate_hz >= kLeastInsRate_hz && than_hz < kLeastInsRate_hz && rate_hz >= kMuchFaster * than_hz;
}

/// A name within a sentence: whoever wrote the bag may have made it as long as the bag.
std::string shown(const std::string& name) { return name.size() <= 200 ? name : name.substr(0, 200) + "..."; }

/// What can be the INS, and how often it has positions.
struct InsOffer {
  const TopicCandidate* candidate = nullptr;
  Fitness alone;  ///< without regard to that
  double rate_hz = 0.0;
  bool certain = false;  ///< it is of an INS by its type or its name
};

class Chooser {
 public:
  Chooser(const BagFile& bag, const drive::TopicChoice& choice, std::vector<drive::Finding>& findings,
          const PacketTopics& packets)
      : bag_(bag),
        choice_(choice),
        findings_(findings),
        candidates_(candidates_of(bag, packets)),
        packet_sensors_(sensors_of_packets(candidates_)),
        uses_(bag.topics().size()) {
    if (packet_sensors_.size() > kMostPacketLidars) packet_sensors_.clear();
  }

  ChosenTopics choose() {
    TopicRoles roles;
    std::size_t most_clouds = 0;
    for (const TopicCandidate& candidate : candidates_) {
      if (is_cloud(candidate.kind)) most_clouds = std::max(most_clouds, candidate.messages);
      if (candidate.kind == MessageKind::Inspvax) most_inspvax_ = std::max(most_inspvax_, candidate.messages);
      fixes_ = fixes_ || (is_fix(candidate.kind) && !left_out("ins-position"));
    }
    roles.lidar = take("lidar", [&](const TopicCandidate& c) {
      const bool packets = c.kind == MessageKind::LidarPackets && !packet_sensors_.empty();
      const TopicCandidate* cloud = packets ? cloud_of_packets(bag_, candidates_, packet_sensors_, c) : nullptr;
      return cloud ? Fitness{0.0, say::topic_packets_of_cloud(c.model, shown(name(*cloud)))}
                   : fit_scans(c, is_steady(c.messages, most_clouds) && is_whole_lidar(c));
    });
    find_ins_offers(roles.lidar);
    roles.ins = take("ins", [&](const TopicCandidate& c) { return fit_ins(c); });
    if (roles.lidar && roles.lidar == roles.ins)
      throw Error(ErrorCode::Contract, bag_.topics()[*roles.ins].name, say::topic_for_both());
    const bool completes = roles.ins && is_attitude(kind(*roles.ins));
    if (!completes && choice_.contains("ins-position") && !left_out("ins-position"))
      throw Error(ErrorCode::Contract, "ins-position", say::topic_position_of_no_imu());
    const auto position = take(
        "ins-position", [&](const TopicCandidate& c) { return fit_position(c, roles.ins); }, completes);
    if (completes) roles.ins_position = position;
    roles.gnss = take(
        "gnss", [&](const TopicCandidate& c) { return fit_gnss(c, roles.ins_position); }, false);
    roles.imu = take(
        "imu", [&](const TopicCandidate& c) { return fit_imu(c); }, false);
    if (!roles.lidar) report_raw_packets();
    if (!roles.ins || !roles.lidar) report_unoriented(!roles.ins);
    return {roles, list(roles), faster_than(roles), nullptr};
  }

 private:
  const std::string& name(const TopicCandidate& candidate) const { return bag_.topics()[candidate.topic].name; }
  MessageKind kind(std::size_t topic) const { return message_kind(bag_.topics()[topic].type); }
  bool left_out(std::string_view role) const {
    const auto chosen = choice_.find(role);
    return chosen != choice_.end() && chosen->second == drive::kNoTopic;
  }

  /// Whether packets that can be scans leave it to be one: not a cloud that has but a part of what there is.
  bool is_whole_lidar(const TopicCandidate& cloud) const {
    return std::ranges::none_of(packet_sensors_, [&](const TopicCandidate* packets) {
      return can_be(*packets, "lidar") && !is_whole_record(bag_, cloud, *packets);
    });
  }

  Fitness fit_scans(const TopicCandidate& candidate, bool steady) const {
    if (candidate.kind != MessageKind::ApolloCloud) return fit_lidar(candidate, steady);
    const bool raw_beside = std::ranges::any_of(candidates_, [&](const TopicCandidate& other) {
      return other.kind == MessageKind::ApolloCloud && !other.compensated && other.frame == candidate.frame &&
             !is_of_fusion(name(other)) && is_steady(other.messages, candidate.messages);
    });
    return fit_cloud_of_apollo(candidate, name(candidate), raw_beside, fit_lidar(candidate, steady));
  }

  /// Without regard to how often it comes.
  Fitness fit_ins_alone(const TopicCandidate& candidate, const std::optional<std::size_t>& lidar) const {
    if (lidar == candidate.topic) return {0.0, say::topic_is_lidar()};
    if (candidate.kind == MessageKind::Inspvax) return {1000.0, say::topic_inspvax()};
    // What comes more often is taken, for INSPVAX gives it its errors.
    if (candidate.kind == MessageKind::Inspva)
      return {candidate.messages > most_inspvax_ && most_inspvax_ > 0 ? 1100.0 : 900.0, say::topic_inspva()};
    if (candidate.kind == MessageKind::Gsof49) return {910.0, say::topic_inspva()};
    if (is_solution(candidate.kind)) return {920.0, say::topic_inspvax()};
    if (candidate.kind == MessageKind::NmeaSentence) return {120.0, say::topic_sentences()};
    if (!is_attitude(candidate.kind)) return fit_pose(name(candidate), candidate.kind);
    if (!fixes_) return {0.0, say::topic_orientation_alone()};
    // A driver of an INS has both as a matter of course: before Odometry, which is made of them.
    if (candidate.kind != MessageKind::Imu)
      return candidate.kind == MessageKind::SbgEuler ? Fitness{150.0, say::topic_orientation()}
                                                     : Fitness{140.0, say::topic_orientation()};
    // A driver that states an error has an orientation; one that does not may have left the field as it was.
    return candidate.orientation_sigma ? Fitness{50.0, say::topic_orientation()}
                                       : Fitness{45.0, say::topic_orientation_without_error()};
  }

  /// Once for each of them: a hostile bag has thousands.
  void find_ins_offers(const std::optional<std::size_t>& lidar) {
    offer_of_topic_.assign(bag_.topics().size(), kNoOffer);
    for (const TopicCandidate& candidate : candidates_) {
      if (!can_be(candidate, "ins")) continue;
      const bool certain = is_solution(candidate.kind) || has_open_axes(candidate.kind) ||
                           is_apollo_pose(candidate.kind) || name_speaks_of_ins(name(candidate));
      offer_of_topic_[candidate.topic] = ins_offers_.size();
      ins_offers_.push_back({&candidate, fit_ins_alone(candidate, lidar), ins_rate_hz(candidate), certain});
    }
  }

  /// What comes too rarely stands behind whatever else is of an INS for certain.
  Fitness fit_ins(const TopicCandidate& candidate) const {
    const InsOffer& offer = ins_offers_.at(offer_of_topic_[candidate.topic]);
    const InsOffer* faster = offer.alone.points > 0.0 ? faster_ins(offer.rate_hz, true) : nullptr;
    if (faster == nullptr) return offer.alone;
    return {1e-3 * offer.alone.points,
            say::topic_slow(Frequency{offer.rate_hz}, shown(name(*faster->candidate)), Frequency{faster->rate_hz})};
  }

  /// Of those that give the INS much more often the one that fits best; null where there is none.
  /// @param certain only what is of an INS by its type or its name
  const InsOffer* faster_ins(double than_hz, bool certain) const {
    const InsOffer* best = nullptr;
    for (const InsOffer& offer : std::span(ins_offers_).first(std::min(ins_offers_.size(), kMostPairings)))
      if (is_much_faster(offer.rate_hz, than_hz) && (offer.certain || !certain) &&
          offer.alone.points > (best ? best->alone.points : 0.0))
        best = &offer;
    return best;
  }

  /// Of positions: an orientation has those of its fixes.
  double ins_rate_hz(const TopicCandidate& candidate) const {
    if (!is_attitude(candidate.kind)) return candidate.rate_hz;
    const TopicCandidate* position = nullptr;
    double best_points = 0.0;
    const auto asked = choice_.find("ins-position");
    for (std::size_t i = 0; i < std::min(candidates_.size(), kMostPairings); ++i) {
      const TopicCandidate& other = candidates_[i];
      if (!can_be(other, "ins-position")) continue;
      const double points = asked != choice_.end() ? (asked->second == name(other) ? 1.0 : 0.0)
                                                   : fit_position(other, candidate.topic).points;
      if (points > best_points) position = &other, best_points = points;
    }
    return position ? std::min(candidate.rate_hz, position->rate_hz) : 0.0;
  }

  const TopicCandidate* candidate_of(const std::optional<std::size_t>& topic) const {
    const auto found = std::ranges::lower_bound(candidates_, topic.value_or(kNoOffer), {}, &TopicCandidate::topic);
    return found != candidates_.end() && topic == found->topic ? &*found : nullptr;
  }

  std::optional<FasterTopic> faster_than(const TopicRoles& roles) const {
    const TopicCandidate* ins = candidate_of(roles.ins);
    if (ins == nullptr) return std::nullopt;
    if (const TopicCandidate* position = candidate_of(roles.ins_position))
      for (const TopicCandidate& other : candidates_)
        if (can_be(other, "ins-position") && is_much_faster(other.rate_hz, position->rate_hz) &&
            ins->rate_hz >= kLeastInsRate_hz)
          return FasterTopic{"ins-position", shown(name(other)), other.rate_hz};
    const InsOffer* other = faster_ins(ins_rate_hz(*ins), false);
    return other ? std::optional(FasterTopic{"ins", shown(name(*other->candidate)), other->rate_hz}) : std::nullopt;
  }

  /// Devices publish under one name: "/ins/imu" and "/ins/fix". As long a common beginning as can be.
  Fitness fit_position(const TopicCandidate& candidate, const std::optional<std::size_t>& ins) const {
    const std::string& own = bag_.topics()[candidate.topic].name;
    const std::string other = ins ? bag_.topics()[*ins].name : std::string();
    const auto alike = std::mismatch(own.begin(), own.end(), other.begin(), other.end()).first - own.begin();
    return {1.0 + static_cast<double>(alike) + 1e-9 * few_messages(candidate),
            of_one_device(own, other) ? say::topic_fixes_of_device() : say::topic_fixes_of_receiver()};
  }

  static Fitness fit_gnss(const TopicCandidate& candidate, const std::optional<std::size_t>& ins_position) {
    if (candidate.kind == MessageKind::NmeaSentence) return {0.5, say::topic_sentences()};
    return ins_position == candidate.topic ? Fitness{1.0, say::topic_fixes_of_ins()}
                                           : Fitness{2.0, say::topic_fixes_of_receiver()};
  }
  static Fitness fit_imu(const TopicCandidate& candidate) {
    return {1.0 + few_messages(candidate), say::topic_rates()};
  }
  static double few_messages(const TopicCandidate& candidate) {
    return static_cast<double>(std::min<std::size_t>(candidate.messages, 100'000'000));
  }

  std::size_t chosen(std::string_view role, const std::string& name) const {
    bool there = false;
    for (const BagTopic& topic : bag_.topics()) there = there || topic.name == name;
    if (!there) {
      std::vector<std::string> names;
      for (const BagTopic& topic : bag_.topics()) names.push_back("  " + topic.name + " (" + topic.type + ")");
      throw Error(ErrorCode::Contract, name, say::topic_not_there(std::move(names)));
    }
    std::vector<std::string> serves_as;
    for (const TopicCandidate& candidate : candidates_) {
      if (bag_.topics()[candidate.topic].name != name) continue;
      if (may_be_asked_for(candidate, role)) return candidate.topic;
      for (const std::string_view other : drive::kTopicRoles)
        if (may_be_asked_for(candidate, other)) serves_as.emplace_back(other);
    }
    throw Error(ErrorCode::Contract, name,
                serves_as.empty() ? say::topic_serves_as_nothing(std::string(role))
                                  : say::topic_serves_as_other(std::string(role), std::move(serves_as)));
  }

  /// The topic that was chosen for a role, or the one that fits best; notes how all of them fit.
  template <class Fit>
  std::optional<std::size_t> take(std::string_view role, Fit&& fit, bool tell = true) {
    std::optional<std::size_t> best;
    double best_points = 0.0;
    std::vector<std::string> in_question;
    for (const TopicCandidate& candidate : candidates_) {
      if (!can_be(candidate, role)) continue;
      Fitness fitness = fit(candidate);
      const bool unasked = fitness.points > 0.0;
      uses_[candidate.topic].push_back(
          {std::string(role), std::move(fitness.why), unasked, role == "ins" && is_attitude(candidate.kind)});
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
    std::vector<std::string> others = in_question;
    std::erase(others, taken);
    findings_.push_back(drive::make_finding(drive::Severity::Note, "topic-chosen", taken,
                                            say::topic_chosen(std::string(role), std::move(others))));
  }

  void report_raw_packets() {
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const BagTopic& topic = bag_.topics()[i];
      if (!is_raw_packets(topic.type) || topic.entries.empty()) continue;
      const TopicCandidate* candidate = candidate_of(i);
      if (candidate && can_be(*candidate, "lidar")) continue;  // somebody wants no LiDAR
      findings_.push_back(drive::make_finding(drive::Severity::Warning, "raw-packets", topic.name,
                                              candidate && !candidate->refusal.empty()
                                                  ? candidate->refusal
                                                  : say::topic_raw_packets(topic.type, topic.entries.size())));
    }
  }

  void report_unoriented(bool without_ins) {
    for (const TopicCandidate& candidate : candidates_) {
      if (candidate.oriented) continue;
      if (candidate.kind == MessageKind::Imu && without_ins && fixes_)
        findings_.push_back(drive::make_finding(drive::Severity::Note, "no-orientation", name(candidate),
                                                say::topic_imu_without_orientation()));
      if (is_pose(candidate.kind))
        findings_.push_back(
            drive::make_finding(drive::Severity::Warning, "no-orientation", name(candidate), say::topic_unoriented()));
    }
  }

  std::vector<drive::OfferedTopic> list(const TopicRoles& roles) {
    std::vector<drive::OfferedTopic> topics;
    for (std::size_t i = 0; i < bag_.topics().size(); ++i) {
      const BagTopic& topic = bag_.topics()[i];
      drive::OfferedTopic offered{
          {topic.name, topic.type, topic.entries.size(), rate_hz(topic), {}, {}}, std::move(uses_[i]), {}};
      if (is_static_transforms(topic) && !topic.entries.empty())
        offered.uses.push_back({std::string(drive::kNominalRole), say::topic_transforms()});
      if (offered.uses.empty()) offered.unusable = unusable_reason(topic, candidate_of(i));
      for (const drive::TopicUse& use : offered.uses) offered.topic.can_be.push_back(use.role);
      for (std::size_t role = 0; role < drive::kTopicRoles.size(); ++role)
        if (roles.all()[role] == i) offered.topic.used_as.emplace_back(drive::kTopicRoles[role]);
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
  const drive::TopicChoice& choice_;
  std::vector<drive::Finding>& findings_;
  std::vector<TopicCandidate> candidates_;             ///< by their topics
  std::vector<const TopicCandidate*> packet_sensors_;  ///< none where these are too many
  std::vector<InsOffer> ins_offers_;
  std::vector<std::size_t> offer_of_topic_;         ///< index of ins_offers_, or kNoOffer
  std::vector<std::vector<drive::TopicUse>> uses_;  ///< of each topic of the bag
  bool fixes_ = false;                              ///< there are some that may give positions
  std::size_t most_inspvax_ = 0;                    ///< messages of the INSPVAX that has most
};

}  // namespace

ChosenTopics choose_topics(const BagFile& bag, const drive::TopicChoice& choice, std::vector<drive::Finding>& findings,
                           std::shared_ptr<const PacketTopics> packets) {
  ChosenTopics chosen = Chooser(bag, choice, findings, *packets).choose();
  chosen.packets = std::move(packets);
  return chosen;
}

bool is_steady(std::size_t messages, std::size_t most_messages) { return messages * 3 >= most_messages; }

bool is_of_novatel(const std::string& topic) {
  const std::string name = formats::lower_case(topic);
  return name.find("novatel") != std::string::npos || name.find("oem7") != std::string::npos;
}

bool is_static_transforms(const BagTopic& topic) {
  return message_kind(topic.type) == MessageKind::Transforms && topic.name.ends_with("tf_static") &&
         topic.encoding != MessageEncoding::Other;
}

}  // namespace remount::bags

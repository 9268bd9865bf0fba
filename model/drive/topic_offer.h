// What the topics of a bag can serve as, before a session is made of some of them.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/session.h"

namespace remount::drive {

/// What static transforms can give. Nothing to choose: all of them are read.
inline constexpr std::string_view kNominalRole = "nominal";

/// One thing that a topic can serve as.
struct TopicUse {
  std::string role;             ///< of kTopicRoles, or kNominalRole
  Message why;                  ///< what speaks for or against it
  bool unasked = true;          ///< comes into question by itself; false: only where it is asked for
  bool needs_position = false;  ///< as `ins`, it goes with a topic for `ins-position`
};

/// A topic of a bag with what speaks for each use of it.
struct OfferedTopic {
  SessionTopic topic;  ///< `used_as`: what is suggested
  std::vector<TopicUse> uses;
  Message unusable;  ///< why it can be nothing; empty where it can be something

  const TopicUse* use(std::string_view role) const;  ///< null where it cannot be that
};

/// A bag, opened as far as is needed to tell what its topics can serve as.
struct TopicOffer {
  std::filesystem::path path;
  std::vector<OfferedTopic> topics;
  /// The session of the topics that are chosen, as open_session gives it. The bag is not opened anew.
  std::function<Session(const TopicChoice&, Progress&)> open;
};

/// Whether a person should be asked: several topics come into question for a role, or LiDAR or INS has none and some
/// that would be taken where they are asked for.
bool is_ambiguous(const std::vector<OfferedTopic>& topics);

/// What `used_as` says, in full: roles that have a candidate and no topic are left out by name.
TopicChoice choice_in_use(const std::vector<SessionTopic>& topics);

}  // namespace remount::drive

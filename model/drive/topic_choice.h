// Which topics of a bag a session is made of, and which LiDAR of a recording that has several.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

namespace remount::drive {

/// What topics can serve as:
/// lidar         scans, or poses of an odometry; of other formats than bags the name of the LiDAR
/// ins           poses or INSPVAX, or an IMU with orientation whose positions are those of `ins-position`
/// ins-position  NavSatFix that goes with the orientation of such an IMU
/// gnss          NavSatFix of a receiver of its own
/// imu           angular rates and accelerations
inline constexpr std::array<std::string_view, 5> kTopicRoles{"lidar", "ins", "ins-position", "gnss", "imu"};

/// Topic by role. A role that is absent is suggested; kNoTopic leaves it out.
using TopicChoice = std::map<std::string, std::string, std::less<>>;
inline constexpr std::string_view kNoTopic = "none";

/// Adds "ROLE=TOPIC". Throws Error(Contract) where the text is no such thing or the role has a topic already.
void add_topic_choice(TopicChoice& choice, std::string_view text);

}  // namespace remount::drive

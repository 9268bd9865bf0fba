// An INS whose orientation comes more often than the fixes that go with it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/motion/ins_sample.h"

namespace remount::formats {

struct StampedAttitude {
  std::int64_t stamp_ns = 0;
  Eigen::Quaterniond enu_from_ins = Eigen::Quaterniond::Identity();
  Eigen::Vector3d sigma_rad = Eigen::Vector3d::Zero();
};

/// The attitude at a stamp.
struct AttitudeAt {
  Eigen::Quaterniond enu_from_ins = Eigen::Quaterniond::Identity();
  Eigen::Vector3d sigma_rad = Eigen::Vector3d::Zero();
  bool of_this_stamp = false;  ///< else turned between two
};
/// Nothing outside of the attitudes and across a gap. @param attitudes ascending stamps
std::optional<AttitudeAt> attitude_at(const std::vector<StampedAttitude>& attitudes, std::int64_t stamp_ns,
                                      double longest_s);
/// Across which attitudes are turned between two: three times their usual distance.
double longest_turn_s(const std::vector<StampedAttitude>& attitudes);

/// A sample at an attitude between fixes `before` and `before` + 1, its position on a cubic through these and their
/// neighbours where no gap parts them.
motion::InsSample sample_between(const std::vector<motion::InsSample>& fixes, std::size_t before,
                                 const StampedAttitude& attitude, double longest_s);
/// Across which positions are interpolated: five times their usual distance.
double longest_way_s(const std::vector<motion::InsSample>& fixes);

struct SamplesBetweenFixes {
  std::vector<motion::InsSample> ins;       ///< those given, and one at each attitude between two of them
  std::vector<std::int64_t> fix_stamps_ns;  ///< of those given; empty where nothing was added
};

/// Turns between slow fixes are measured, and not what a slerp from fix to fix makes of them. Positions there lie on a
/// cubic through the neighbours (Session::ins_fix_stamps_ns tells which they are). Nothing is added where fixes come
/// seven times a second, or attitudes hardly more often, nor across a gap: five times the usual distance of the fixes.
/// @param at_fixes ascending stamps
/// @param attitudes ascending stamps
SamplesBetweenFixes samples_between_fixes(std::vector<motion::InsSample> at_fixes,
                                          const std::vector<StampedAttitude>& attitudes);

}  // namespace remount::formats

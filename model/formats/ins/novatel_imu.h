// What the raw counts of a NovAtel's IMU mean, by its type.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/messages/message.h"
#include "algorithms/motion/sensor_samples.h"

namespace remount::formats {

/// Types of IMU that a recording names, by their numbers in NovAtel's manual.
class NovatelImuTypes {
 public:
  void add(int type);
  /// "EPSON_G320", "IMU_EPSON_G320", "41". A name that is not known is none.
  void add(std::string_view type);
  /// The one that is named; nothing where there is none, or several.
  std::optional<int> only() const;
  bool none() const { return types_.empty(); }
  std::vector<std::string> names() const;

 private:
  std::vector<int> types_;  // each once; of a made-up recording at most 256
};

/// Makes rates and forces of counts: what is in `samples` as counts of the change within one step, each stamp that of a
/// whole log. Axes as the log's: see NovatelBodies::raw_imu.
/// @return why it cannot be done, as a sentence, with `samples` empty: the type is none or has no known scale, or what
///   comes of it would not feel gravity. Empty where it was done.
Message scale_raw_imu(const NovatelImuTypes& types, const std::string& log, std::vector<motion::ImuSample>& samples);

}  // namespace remount::formats

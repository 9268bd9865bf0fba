// What a recording of NovAtel's logs holds, and how much of each.
#pragma once

#include <map>
#include <string>

#include "model/drive/bad_items.h"
#include "model/formats/ins/novatel_bodies.h"
#include "model/formats/ins/novatel_imu.h"
#include "model/formats/ins/novatel_log.h"

namespace remount::formats {

/// A recording in memory, with its places for messages.
class NovatelRecording {
 public:
  /// ASCII logs may be UTF-16.
  explicit NovatelRecording(const std::filesystem::path& path);
  std::string_view bytes() const { return bytes_; }
  bool is_text() const { return is_text_; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::string bytes_;
  bool is_text_ = true;
};

/// Where in a recording something is: "a.log:12", or "a.gps, byte 1234". Asked in ascending order.
class RecordingPlaces {
 public:
  explicit RecordingPlaces(const NovatelRecording& recording);
  std::string of(std::size_t at);

 private:
  const NovatelRecording& recording_;
  char line_end_ = '\n';
  std::size_t counted_ = 0, line_ = 1;
};

struct NovatelCount {
  NovatelUse use = NovatelUse::None;
  std::size_t whole = 0;   ///< with a right checksum
  std::size_t usable = 0;  ///< of these, that have a solution or a position, and a possible one
};

struct NovatelSurvey {
  std::map<std::string, NovatelCount, std::less<>> logs;  ///< by name
  std::size_t unnamed = 0;                                ///< beyond the names that are kept
  std::size_t stray_bytes = 0;                            ///< belong to no log, whole or broken
  drive::BadItems bad;                                    ///< of types that are used
  NovatelImuTypes imu_types;                              ///< as RAWIMUX and INSCONFIG name them

  /// The log of a use that has most that is usable, INSPVAX before others; empty where there is none.
  std::string most_of(std::initializer_list<NovatelUse> uses) const;
  /// "RAWIMUSX (3000)", the most frequent first, without those in `taken`.
  std::vector<std::string> others(const std::vector<std::string>& taken) const;
};
NovatelSurvey survey_novatel(const NovatelRecording& recording);

/// As it is listed: of an id without a name "ID 1234"; of the second antenna with "_1".
std::string novatel_name(const NovatelFrame& frame);

}  // namespace remount::formats

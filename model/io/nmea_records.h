// What an NMEA log holds, sentence by sentence.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/geometry/rotation.h"
#include "model/io/heading_times.h"
#include "model/io/nmea_sentence.h"
#include "model/io/stream_tools.h"

namespace remount {

/// As small as can be: there are as many as a log has epochs. Times count from midnight of the first day.
struct NmeaFix {
  std::int64_t time_ns = 0;
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0;
  float hdop = 1.0F;
  int quality = 0;
};

struct NmeaAttitude {
  std::int64_t time_ns = 0;
  Eigen::Quaterniond enu_from_ins;
  Eigen::Vector3d sigma_rad;
};

/// Standard deviations of a GST sentence, m.
struct NmeaErrors {
  double north_m = 0.0, east_m = 0.0, up_m = 0.0;
};

/// Takes the lines of a log in their order, with a clock that runs over midnight.
class NmeaRecords {
 public:
  /// Throws Error where the file cannot be read, and Error(Format) where it holds no fix, or no date.
  static NmeaRecords read(const std::filesystem::path& path);

  std::vector<NmeaFix> fixes;
  std::vector<NmeaAttitude> attitudes;
  HeadingPlaces places;  ///< of headings
  std::map<std::int64_t, NmeaErrors> errors;
  std::int64_t midnight_ns = 0;  ///< of the first day
  std::size_t without_geoid = 0;
  BadItems bad;
  std::size_t cut_line = 0;  ///< of the last line, where the log ends within a sentence; 0: it does not

 private:
  /// Of the sentences of one kind that came before.
  struct Usual {
    std::string_view type;
    bool checksum = false;
    std::size_t fields = 0;
  };

  explicit NmeaRecords(const std::filesystem::path& path) : path_(path) {}
  void reserve(std::string_view text);
  void take_lines(std::string_view text);
  void take_line(std::string_view line, bool at_end);
  void add_bad(std::string_view type, const std::string& why);
  void require_fixes_and_date() const;
  bool take(const NmeaSentence& sentence);
  bool take_kind(const NmeaSentence& sentence);
  std::optional<std::int64_t> running(std::string_view text);
  bool take_fix(const NmeaSentence& sentence);
  bool take_date(std::string_view time_text, std::string_view date);
  bool take_error(const NmeaSentence& sentence);
  bool take_heading(const NmeaSentence& sentence);
  bool take_attitude(const NmeaSentence& sentence);

  std::filesystem::path path_;
  std::size_t line_number_ = 0;
  std::array<Usual, 6> usual_{{{"GGA"}, {"RMC"}, {"ZDA"}, {"GST"}, {"HDT"}, {"PASHR"}}};
  BadItems bad_dates_;
  std::optional<std::int64_t> dated_;
  std::int64_t days_ = 0, last_ns_ = -1;
  bool timed_ = false;  ///< the sentence that is taken has a time
};

}  // namespace remount

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

#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/running_period.h"
#include "model/formats/ins/heading_times.h"
#include "model/formats/ins/nmea_sentence.h"

namespace remount::formats {

/// Who says so: the two letters of the talker, or two of a maker's sentence.
using NmeaTalker = std::array<char, 2>;

/// As small as can be: there are as many as a log has epochs. Times count from midnight of the first day.
struct NmeaFix {
  std::int64_t time_ns = 0;
  double latitude_rad = 0.0, longitude_rad = 0.0, height_m = 0.0;
  float hdop = 1.0F;
  std::int8_t quality = 0;  ///< as GGA has it; 0: not stated
  NmeaTalker talker{};
};

struct NmeaAttitude {
  std::int64_t time_ns = 0;
  Eigen::Quaterniond enu_from_ins;
  Eigen::Vector3d sigma_rad;
};

/// Sentences that have an attitude and its time.
enum class NmeaAttitudeKind { Pashr, Fpd, Chc, Hpr, Hrp, Ksxt, Avr };
inline constexpr std::size_t kNmeaAttitudeKinds = 7;

/// All attitudes of one kind.
struct NmeaAttitudes {
  std::vector<NmeaAttitude> samples;
  bool rolls = false;  ///< roll is measured: two antennas alone give heading and pitch, and leave it empty or zero
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
  /// The same of a text that was read already; `path` is for messages.
  static NmeaRecords parse(std::string_view text, const std::filesystem::path& path);

  std::vector<NmeaFix> fixes;
  std::array<NmeaAttitudes, kNmeaAttitudeKinds> attitudes;
  HeadingPlaces places;  ///< of headings
  std::map<std::pair<std::int64_t, NmeaTalker>, NmeaErrors> errors;
  std::int64_t midnight_ns = 0;  ///< of the first day
  std::size_t without_geoid = 0;
  std::size_t of_one_time = 0;  ///< fixes that gave way to others of the same time
  drive::BadItems bad;
  std::size_t cut_line = 0;  ///< of the last line, where the log ends within a sentence; 0: it does not

  /// Which of the attitudes there are serves: those with roll before those without, and of these the most. Nothing
  /// where the log has none.
  std::optional<NmeaAttitudeKind> best_attitudes() const;
  /// Whether sentences of a type (NmeaSentence::type) hold something that is taken.
  static bool reads(std::string_view type);
  /// Of the sentence: "PASHR", "PTNL,AVR".
  static std::string_view name(NmeaAttitudeKind kind);
  /// Whether its sentences have the position of the INS beside the attitude.
  static bool has_position(NmeaAttitudeKind kind);
  NmeaAttitudes& of(NmeaAttitudeKind kind) { return attitudes[index_of(kind)]; }
  /// Leaves the fixes that come with these attitudes alone. @return how many others there were
  std::size_t keep_fixes_of(NmeaAttitudeKind kind);
  /// Of the fixes of one time leaves the best, whoever wrote it.
  void keep_best_fixes();
  /// Of a fix, by its own talker or, where that is silent, by another; null where none is stated.
  const NmeaErrors* errors_of(const NmeaFix& fix) const;

 private:
  static constexpr std::array<std::string_view, 13> kTypes{
      "GGA", "RMC", "ZDA", "GST", "HDT", "THS", "PASHR", "PTNL,AVR", "PSAT,HPR", "PSSN,HRP", "KSXT", "FPD", "CHC"};

  /// Of the sentences of one kind that came before.
  struct Usual {
    std::string_view type;
    bool checksum = false;
    std::size_t fields = 0;
  };

  explicit NmeaRecords(const std::filesystem::path& path) : path_(path) {
    for (std::size_t i = 0; i < kTypes.size(); ++i) usual_[i].type = kTypes[i];
  }
  void reserve(std::string_view text);
  void take_lines(std::string_view text);
  void take_line(std::string_view line, bool at_end);
  void add_bad(std::string_view type, Message why);
  void require_fixes_and_date() const;
  bool take(const NmeaSentence& sentence);
  bool take_kind(const NmeaSentence& sentence);
  std::optional<std::int64_t> running(std::optional<std::int64_t> time_of_day_ns);
  bool take_fix(const NmeaSentence& sentence);
  bool take_date(std::string_view time_text, std::string_view date);
  bool take_date(std::int64_t running_ns, std::string_view date);
  bool take_error(const NmeaSentence& sentence);
  bool take_heading(const NmeaSentence& sentence);
  bool take_pashr(const NmeaSentence& sentence);
  bool take_two_antennas(const NmeaSentence& sentence);
  bool take_ksxt(const NmeaSentence& sentence);
  bool take_gps_time_record(const NmeaSentence& sentence);
  bool add_place(std::int64_t time_ns, const NmeaSentence& sentence, std::size_t latitude, std::size_t longitude,
                 std::size_t height, int quality, NmeaTalker talker);
  /// @param fields of heading, pitch and roll
  bool add_attitude(NmeaAttitudeKind kind, std::int64_t time_ns, const NmeaSentence& sentence,
                    const std::array<std::size_t, 3>& fields);

  std::filesystem::path path_;
  std::size_t line_number_ = 0;
  std::array<Usual, kTypes.size()> usual_;
  drive::BadItems bad_dates_;
  std::optional<std::int64_t> dated_;
  RunningPeriod day_ = count_days();
  bool timed_ = false;   ///< the sentence that is taken has a time
  bool jumped_ = false;  ///< it has one that is most of a day away from those before, and is not taken
};

}  // namespace remount::formats

#include "model/formats/poses/rtklib_solution.h"

#include <Eigen/Cholesky>
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/LocalCartesian.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/running_period.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kRtklibHeadBytes = 16 * 1024;

enum class RtklibPlace { Geodetic, Sexagesimal, EarthCentred, Baseline };

/// What the lines behind '%' say.
struct RtklibHead {
  RtklibPlace place = RtklibPlace::Geodetic;
  std::string_view time_scale;  ///< "GPST", "UTC", "JST"
  bool above_sea = false;
  std::optional<std::array<double, 3>> base_deg_m;  ///< latitude, longitude, height
};

/// Tokens between blanks and whatever else separates columns.
void split_solution(std::string_view line, std::string& blank, std::vector<std::string_view>& tokens) {
  blank.assign(line);
  for (char& c : blank)
    if (c == ',' || c == ';' || c == '\t') c = ' ';
  split_blanks(blank, tokens);
}

/// Degrees, minutes and seconds of three tokens; nothing where they are none.
std::optional<double> sexagesimal_deg(const std::vector<std::string_view>& tokens, std::size_t at) {
  if (at + 3 > tokens.size()) return std::nullopt;
  const auto degrees = parse_number(tokens[at]), minutes = parse_number(tokens[at + 1]),
             seconds = parse_number(tokens[at + 2]);
  if (!degrees || !minutes || !seconds || *minutes < 0.0 || *minutes >= 60.0 || *seconds < 0.0 || *seconds > 60.0)
    return std::nullopt;
  const double size_deg = std::abs(*degrees) + *minutes / 60.0 + *seconds / 3600.0;
  return tokens[at].starts_with('-') ? -size_deg : size_deg;
}

std::optional<std::array<double, 3>> base_of(const std::vector<std::string_view>& tokens, std::size_t at) {
  const bool sexagesimal = tokens.size() >= at + 7;
  const auto latitude = sexagesimal          ? sexagesimal_deg(tokens, at)
                        : at < tokens.size() ? parse_number(tokens[at])
                                             : std::nullopt,
             longitude = sexagesimal              ? sexagesimal_deg(tokens, at + 3)
                         : at + 1 < tokens.size() ? parse_number(tokens[at + 1])
                                                  : std::nullopt;
  const std::size_t height_at = at + (sexagesimal ? 6 : 2);
  const auto height_m = height_at < tokens.size() ? parse_number(tokens[height_at]) : std::nullopt;
  if (!latitude || !longitude || !height_m ||
      !drive::plausible_geodetic(degrees_to_radians(*latitude), degrees_to_radians(*longitude), *height_m))
    return std::nullopt;
  return std::array<double, 3>{*latitude, *longitude, *height_m};
}

/// Whether a line is that of the names; the head knows what they say then.
bool take_names(std::string_view line, RtklibHead& head) {
  std::string blank;
  std::vector<std::string_view> names;
  split_solution(line, blank, names);
  if (names.size() < 5) return false;
  for (const std::string_view scale : {"GPST", "UTC", "JST"})
    if (names[0] == scale) head.time_scale = scale;
  if (head.time_scale.empty()) return false;
  if (names[1].starts_with("latitude("))
    head.place = names[1] == "latitude(deg)" ? RtklibPlace::Geodetic : RtklibPlace::Sexagesimal;
  else if (names[1].starts_with("x-ecef"))
    head.place = RtklibPlace::EarthCentred;
  else if (names[1].starts_with("e-baseline"))
    head.place = RtklibPlace::Baseline;
  else
    return false;
  return true;
}

/// Nothing where the text is no solution of RTKLIB.
std::optional<RtklibHead> rtklib_head(std::string_view text) {
  RtklibHead head;
  LineReader lines(text);
  std::string blank;
  std::vector<std::string_view> tokens;
  for (std::string_view line; lines.next(line);) {
    line = trim(line);
    if (line.empty()) continue;
    if (!line.starts_with('%')) return std::nullopt;
    line.remove_prefix(1);
    if (take_names(line, head)) return head;
    head.above_sea = head.above_sea || line.find("height=WGS84/geodetic") != std::string_view::npos;
    split_solution(line, blank, tokens);
    if (tokens.size() > 3 && tokens[0] == "ref" && tokens[1] == "pos") head.base_deg_m = base_of(tokens, 3);
  }
  return std::nullopt;
}

/// What a solution of a quality usually is off by, m.
double usual_error_m(std::int64_t quality) {
  constexpr std::array<double, 7> kUsual_m{5.0, 0.02, 0.3, 0.8, 0.8, 3.0, 0.1};  // fix, float, SBAS, DGPS, single, PPP
  return kUsual_m.at(static_cast<std::size_t>(std::clamp<std::int64_t>(quality, 0, 6)));
}

class RtklibRows {
 public:
  RtklibRows(const RtklibHead& head, const fs::path& path) : head_(head), path_(path) {}

  std::size_t without_solution() const { return without_solution_; }
  std::size_t assumed() const { return assumed_; }

  /// Nothing where RTKLIB found no solution.
  std::optional<motion::GnssFix> fix(std::string_view line, std::size_t number) {
    line_ = number;
    split_solution(line, blank_, tokens_);
    const std::size_t quality_at = 2 + (head_.place == RtklibPlace::Sexagesimal ? 7 : 3);
    if (tokens_.size() <= quality_at) fail(say::csv_fields(tokens_.size(), quality_at + 1));
    const auto quality = parse_integer(tokens_[quality_at]);
    if (!quality || *quality < 0 || *quality > 99)
      fail(say::rtklib_no_quality(std::string(tokens_[quality_at].substr(0, 20))));
    if (*quality == 0) {
      ++without_solution_;
      return std::nullopt;
    }
    motion::GnssFix fix = place(*quality, quality_at + 2);
    if (!drive::plausible_geodetic(fix.latitude_rad, fix.longitude_rad, fix.height_m))
      fail(say::log_place_impossible());
    fix.stamp_ns = stamp_ns();
    return fix;
  }

 private:
  [[noreturn]] void fail(Message what) const { throw Error(ErrorCode::Format, at_line(path_, line_), std::move(what)); }

  double value(std::size_t at) const {
    const auto number = parse_number(tokens_[at]);
    if (!number) fail(say::rtklib_no_place());
    return *number;
  }

  /// Since the epoch of GPS, in the scale of the head: RTKLIB counts weeks and seconds of UTC and JST, too, as they
  /// stand on the clock, without leap seconds.
  std::optional<std::int64_t> since_epoch_ns() const {
    if (tokens_[0].find_first_of("/-") != std::string_view::npos) {
      const auto date = parse_date_ns(std::string(tokens_[0]) + " " + std::string(tokens_[1]));
      return date && *date > kGpsEpoch_ns ? std::optional(*date - kGpsEpoch_ns) : std::nullopt;
    }
    const auto week = parse_integer(tokens_[0]);
    const auto seconds_ns = parse_seconds_ns(tokens_[1]);
    if (!week || !seconds_ns || !unix_ns_from_gps_week(*week, *seconds_ns)) return std::nullopt;  // out of range
    return *week * kGpsWeek_ns + *seconds_ns;
  }

  std::int64_t stamp_ns() const {
    const auto time_ns = since_epoch_ns();
    if (!time_ns)
      fail(say::rtklib_no_time(std::string(tokens_[0].substr(0, 20)) + " " + std::string(tokens_[1].substr(0, 20))));
    if (head_.time_scale == "GPST") return unix_ns_from_gps_ns(*time_ns);
    constexpr std::int64_t kJapanAhead_ns = std::int64_t{9 * 3600} * 1'000'000'000;
    return *time_ns + kGpsEpoch_ns - (head_.time_scale == "JST" ? kJapanAhead_ns : 0);
  }

  /// Of three errors and three correlated ones, with their sign; in the axes of the columns.
  std::optional<Eigen::Matrix3d> covariance(std::size_t at) const {
    if (tokens_.size() < at + 6) return std::nullopt;
    std::array<double, 6> sigma{};
    for (std::size_t i = 0; i < 6; ++i) {
      const auto number = parse_number(tokens_[at + i]);
      if (!number || std::abs(*number) > 1e6 || (i < 3 && *number <= 0.0)) return std::nullopt;
      sigma[i] = *number;
    }
    const auto squared = [&](std::size_t i) { return std::copysign(sigma[i] * sigma[i], sigma[i]); };
    Eigen::Matrix3d c;
    c << squared(0), squared(3), squared(5), squared(3), squared(1), squared(4), squared(5), squared(4), squared(2);
    // Digits that were rounded off may have made it none.
    if (Eigen::LLT<Eigen::Matrix3d>(c).info() != Eigen::Success) c = Eigen::Matrix3d(c.diagonal().asDiagonal());
    return c;
  }

  motion::GnssFix place(std::int64_t quality, std::size_t errors_at) {
    const std::optional<Eigen::Matrix3d> stated = covariance(errors_at);
    assumed_ += !stated;
    const double usual_m = usual_error_m(quality);
    const Eigen::Matrix3d errors = stated.value_or(usual_m * usual_m * Eigen::Matrix3d::Identity());
    // Rows and columns of north, east, up; of east, north, up it is the same, exchanged.
    const auto exchanged = [&] {
      const Eigen::PermutationMatrix<3> swap(Eigen::Vector3i(1, 0, 2));
      return Eigen::Matrix3d(swap * errors * swap.transpose());
    };
    switch (head_.place) {
      case RtklibPlace::Geodetic:
        return {0, degrees_to_radians(value(2)), degrees_to_radians(value(3)), value(4), exchanged()};
      case RtklibPlace::Sexagesimal: {
        const auto latitude = sexagesimal_deg(tokens_, 2), longitude = sexagesimal_deg(tokens_, 5);
        if (!latitude || !longitude) fail(say::rtklib_no_place());
        return {0, degrees_to_radians(*latitude), degrees_to_radians(*longitude), value(8), exchanged()};
      }
      case RtklibPlace::Baseline:
        return at_baseline(errors);
      default:
        return earth_centred(errors);
    }
  }

  motion::GnssFix at_baseline(const Eigen::Matrix3d& covariance_enu_m2) const {
    constexpr double kLongest_m = 1e6;
    if (!(std::abs(value(2)) < kLongest_m && std::abs(value(3)) < kLongest_m && std::abs(value(4)) < kLongest_m))
      fail(say::log_place_impossible());
    const auto& [latitude, longitude, height] = *head_.base_deg_m;
    const GeographicLib::LocalCartesian level(latitude, longitude, height, GeographicLib::Geocentric::WGS84());
    double latitude_deg = 0.0, longitude_deg = 0.0, height_m = 0.0;
    level.Reverse(value(2), value(3), value(4), latitude_deg, longitude_deg, height_m);
    return {0, degrees_to_radians(latitude_deg), degrees_to_radians(longitude_deg), height_m, covariance_enu_m2};
  }

  motion::GnssFix earth_centred(const Eigen::Matrix3d& covariance_xyz_m2) const {
    constexpr double kFarthest_m = 1e8;
    if (!(std::abs(value(2)) < kFarthest_m && std::abs(value(3)) < kFarthest_m && std::abs(value(4)) < kFarthest_m))
      fail(say::log_place_impossible());
    double latitude_deg = 0.0, longitude_deg = 0.0, height_m = 0.0;
    std::vector<double> rows(9);
    GeographicLib::Geocentric::WGS84().Reverse(value(2), value(3), value(4), latitude_deg, longitude_deg, height_m,
                                               rows);
    const Eigen::Matrix3d xyz_from_enu = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
    return {0, degrees_to_radians(latitude_deg), degrees_to_radians(longitude_deg), height_m,
            xyz_from_enu.transpose() * covariance_xyz_m2 * xyz_from_enu};
  }

  const RtklibHead& head_;
  const fs::path& path_;
  std::string blank_;
  std::vector<std::string_view> tokens_;
  std::size_t line_ = 0, without_solution_ = 0, assumed_ = 0;
};

}  // namespace

bool recognise_rtklib(const fs::path& path) {
  try {
    return rtklib_head(read_text_head(path, kRtklibHeadBytes)).has_value();
  } catch (const Error&) {
    return false;  // not readable: not recognised
  }
}

std::vector<motion::GnssFix> read_rtklib(const fs::path& path, std::vector<drive::Finding>& findings) {
  const std::string text = read_text_file(path);
  const std::optional<RtklibHead> head = rtklib_head(text);
  if (!head) throw Error(ErrorCode::Format, path.string(), say::rtklib_no_head());
  if (head->place == RtklibPlace::Baseline && !head->base_deg_m)
    throw Error(ErrorCode::Format, path.string(), say::rtklib_no_base());
  constexpr std::size_t kShortestRow = 30;
  std::vector<motion::GnssFix> fixes;
  fixes.reserve(std::min(static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1, text.size() / kShortestRow + 1));
  drive::BadItems bad;
  RtklibRows rows(*head, path);
  LineReader lines(text);
  for (std::string_view line; lines.next(line);) {
    if (trim(line).empty() || trim(line).starts_with('%')) continue;
    try {
      if (const auto fix = rows.fix(line, lines.line_number())) fixes.push_back(*fix);
    } catch (const Error& error) {
      bad.add(error);
    }
  }
  if (fixes.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::rtklib_none_usable()));
  bad.report(findings, "bad-gnss", path.string(), say::left_out_lines);
  const auto note = [&](const char* code, Message words) {
    findings.push_back(drive::make_finding(drive::Severity::Note, code, path.string(), std::move(words)));
  };
  if (rows.without_solution() > 0) note("no-fix", say::rtklib_without_solution(rows.without_solution()));
  if (rows.assumed() > 0) note("gnss-sigma-assumed", say::rtklib_errors_assumed(rows.assumed()));
  if (head->above_sea) note("height-above-sea", say::trajectory_above_sea());
  drive::keep_near(fixes, path.string(), findings);
  drive::keep_ascending(fixes, "gnss", path.string(), findings);
  return fixes;
}

}  // namespace remount::formats

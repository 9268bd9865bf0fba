#include "model/formats/poses/gpx_track.h"

#include <algorithm>
#include <optional>
#include <string>

#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/files/time_stamp.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr double kSigma_m = 3.0, kSigmaUp_m = 5.0;

bool is_name_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

/// Where an element begins: its '<', and the prefix of its namespace with the colon ("ns2:", or nothing).
struct Tag {
  std::size_t at = std::string_view::npos;
  std::string_view prefix;
};

/// The first element of a name from a place on, whatever the prefix of its namespace.
Tag find_tag(std::string_view text, std::string_view name, std::size_t from) {
  for (std::size_t at = text.find(name, from); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if (end < text.size() && is_name_char(text[end])) continue;
    std::size_t begin = at;
    if (begin > 0 && text[begin - 1] == ':')
      for (--begin; begin > 0 && is_name_char(text[begin - 1]);) --begin;
    if (begin > 0 && text[begin - 1] == '<') return {begin - 1, text.substr(begin, at - begin)};
  }
  return {};
}

/// What stands behind is not looked at: there may be much of it behind each of many names.
std::string_view without_blanks_before(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
}

/// The value of name="..." or name='...' within a tag; nothing where there is none.
std::optional<std::string_view> attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    std::string_view rest = without_blanks_before(tag.substr(at + name.size()));
    const bool whole =
        at > 0 && (tag[at - 1] == ' ' || tag[at - 1] == '\t' || tag[at - 1] == '\n' || tag[at - 1] == '\r');
    if (!whole || !rest.starts_with('=')) continue;
    rest = without_blanks_before(rest.substr(1));
    if (rest.empty() || (rest.front() != '"' && rest.front() != '\'')) return std::nullopt;
    const std::size_t end = rest.find(rest.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    return rest.substr(1, end - 1);
  }
  return std::nullopt;
}

/// What stands between <name> and </name>; nothing where there is none.
std::optional<std::string_view> element(std::string_view text, std::string_view prefix, std::string_view name) {
  const std::string qualified = std::string(prefix).append(name);
  for (std::size_t at = text.find("<" + qualified); at != std::string_view::npos;
       at = text.find("<" + qualified, at + 1)) {
    const std::size_t end_of_name = at + 1 + qualified.size(), from = text.find('>', end_of_name);
    if (from == std::string_view::npos) return std::nullopt;
    if (is_name_char(text[end_of_name]) || text[end_of_name] == ':' || text[from - 1] == '/') continue;
    const std::size_t end = text.find("</" + qualified, from);
    if (end == std::string_view::npos) return std::nullopt;
    return trim(text.substr(from + 1, end - from - 1));
  }
  return std::nullopt;
}

/// "2026-11-22T10:00:00.25Z", or with "+01:00" for "Z".
std::optional<std::int64_t> time_ns(std::string_view text) {
  std::int64_t ahead_ns = 0;
  if (text.ends_with('Z')) {
    text.remove_suffix(1);
  } else if (text.size() > 6 && (text[text.size() - 6] == '+' || text[text.size() - 6] == '-')) {
    const std::string_view zone = text.substr(text.size() - 6);
    const auto hours = parse_integer(zone.substr(1, 2)), minutes = parse_integer(zone.substr(4, 2));
    if (!hours || !minutes || zone[3] != ':' || *hours > 14 || *minutes > 59) return std::nullopt;
    ahead_ns = (zone[0] == '-' ? -1 : 1) * (*hours * 60 + *minutes) * 60'000'000'000;
    text.remove_suffix(6);
  }
  const auto stamp = parse_date_ns(text);
  if (!stamp) return std::nullopt;
  return *stamp - ahead_ns;
}

/// A fix, and how good the receiver calls it: corrected before one without corrections.
struct TrackPoint {
  motion::GnssFix fix;
  int rank = 0;
  bool has_height = false;
};

/// Of <fix>: none, 2d, 3d, dgps or pps. Throws Error(Format) at `where` where there was none.
int rank_of(std::optional<std::string_view> fix, const std::string& where) {
  if (fix == "none") throw Error(ErrorCode::Format, where, say::gpx_no_fix());
  return fix == "dgps" || fix == "pps" ? 2 : fix == "3d" ? 1 : 0;
}

/// `point` reaches from its '<' to the next one. Throws Error(Format) at `where`.
TrackPoint point_of(std::string_view point, std::string_view prefix, const std::string& where) {
  point = point.substr(0, point.find("</" + std::string(prefix) + "trkpt"));  // what follows the last is not its own
  const std::size_t tag_end = point.find('>');
  if (tag_end == std::string_view::npos) throw Error(ErrorCode::Format, where, say::gpx_open_tag());
  const std::string_view tag = point.substr(0, tag_end);
  const auto latitude = attribute(tag, "lat"), longitude = attribute(tag, "lon");
  const auto latitude_deg = latitude ? parse_number(*latitude) : std::nullopt;
  const auto longitude_deg = longitude ? parse_number(*longitude) : std::nullopt;
  const auto time = element(point, prefix, "time"), height = element(point, prefix, "ele");
  const auto stamp = time ? time_ns(*time) : std::nullopt;
  const auto height_m = height ? parse_number(*height) : std::nullopt;
  if (!latitude_deg || !longitude_deg || !stamp) throw Error(ErrorCode::Format, where, say::gpx_point_incomplete());
  const motion::GnssFix fix{
      *stamp, degrees_to_radians(*latitude_deg), degrees_to_radians(*longitude_deg), height_m.value_or(0.0),
      Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigmaUp_m * kSigmaUp_m).asDiagonal()};
  if (!drive::plausible_geodetic(fix.latitude_rad, fix.longitude_rad, fix.height_m))
    throw Error(ErrorCode::Format, where, say::gpx_not_on_earth());
  return {fix, rank_of(element(point, prefix, "fix"), where), height_m.has_value()};
}

}  // namespace

bool recognise_gpx(const fs::path& path) {
  try {
    return find_tag(read_text_head(path, 8192), "gpx", 0).at != std::string::npos;
  } catch (const Error&) {
    return false;
  }
}

std::vector<motion::GnssFix> read_gpx(const fs::path& path, std::vector<drive::Finding>& findings) {
  const std::string bytes = read_text_file(path);
  const std::string_view text = bytes;
  std::vector<motion::GnssFix> fixes;
  drive::BadItems bad;
  std::size_t flat = 0, line = 1, counted = 0, repeated = 0;
  int last_rank = 0;
  const auto take = [&](const TrackPoint& point) {
    const bool again = !fixes.empty() && fixes.back().stamp_ns == point.fix.stamp_ns;
    repeated += again;
    if (again && point.rank <= last_rank) return;
    if (again) fixes.pop_back();
    fixes.push_back(point.fix);
    last_rank = point.rank;
    flat += !point.has_height;
  };
  for (Tag tag = find_tag(text, "trkpt", 0); tag.at != std::string_view::npos;) {
    const Tag next = find_tag(text, "trkpt", tag.at + tag.prefix.size() + 2);  // behind the beginning of its name
    line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                text.begin() + static_cast<std::ptrdiff_t>(tag.at), '\n'));
    counted = tag.at;
    try {
      const std::size_t length = next.at == std::string_view::npos ? next.at : next.at - tag.at;
      take(point_of(text.substr(tag.at, length), tag.prefix, at_line(path, line)));
    } catch (const Error& error) {
      bad.add(error);
    }
    tag = next;
  }
  if (fixes.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::gpx_none_usable()));
  bad.report(findings, "bad-gpx", path.string(), say::left_out_track_points);
  findings.push_back(drive::make_finding(drive::Severity::Note, "gnss-sigma-assumed", path.string(),
                                         say::gpx_errors_assumed(Length{kSigma_m}, Length{kSigmaUp_m})));
  if (flat > 0)
    findings.push_back(
        drive::make_finding(drive::Severity::Warning, "height-missing", path.string(), say::gpx_no_height(flat)));
  drive::report_one_stamp(repeated, true, "gnss", path.string(), findings);
  drive::keep_near(fixes, path.string(), findings);
  drive::keep_ascending(fixes, "gnss", path.string(), findings);
  return fixes;
}

}  // namespace remount::formats

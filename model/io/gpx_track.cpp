#include "model/io/gpx_track.h"

#include <algorithm>
#include <optional>
#include <string>

#include "algorithms/geometry/rotation.h"
#include "model/count_words.h"
#include "model/io/input_file.h"
#include "model/io/stream_tools.h"
#include "model/io/time_stamp.h"

namespace remount {

namespace fs = std::filesystem;

namespace {

constexpr double kSigma_m = 3.0, kSigmaUp_m = 5.0;
constexpr std::string_view kPoint = "<trkpt";

/// The value of name="..." or name='...' within a tag; nothing where there is none.
std::optional<std::string_view> attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    std::string_view rest = trimmed(tag.substr(at + name.size()));
    const bool whole =
        at > 0 && (tag[at - 1] == ' ' || tag[at - 1] == '\t' || tag[at - 1] == '\n' || tag[at - 1] == '\r');
    if (!whole || !rest.starts_with('=')) continue;
    rest = trimmed(rest.substr(1));
    if (rest.empty() || (rest.front() != '"' && rest.front() != '\'')) return std::nullopt;
    const std::size_t end = rest.find(rest.front(), 1);
    if (end == std::string_view::npos) return std::nullopt;
    return rest.substr(1, end - 1);
  }
  return std::nullopt;
}

/// What stands between <name> and </name>; nothing where there is none.
std::optional<std::string_view> element(std::string_view text, const std::string& name) {
  const std::size_t begin = text.find("<" + name + ">");
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t from = begin + name.size() + 2, end = text.find("</" + name, from);
  if (end == std::string_view::npos) return std::nullopt;
  return trimmed(text.substr(from, end - from));
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

/// `point` reaches from "<trkpt" to the next one. Throws Error(Format) at `where`.
GnssFix fix_of(std::string_view point, const std::string& where, bool& has_height) {
  point = point.substr(0, point.find("</trkpt"));  // what follows the last point is not its own
  const std::size_t tag_end = point.find('>');
  if (tag_end == std::string_view::npos) throw Error(ErrorCode::Format, where, "the tag <trkpt does not end");
  const std::string_view tag = point.substr(0, tag_end);
  const auto latitude = attribute(tag, "lat"), longitude = attribute(tag, "lon");
  const auto latitude_deg = latitude ? parse_number(*latitude) : std::nullopt;
  const auto longitude_deg = longitude ? parse_number(*longitude) : std::nullopt;
  const auto time = element(point, "time"), height = element(point, "ele");
  const auto stamp = time ? time_ns(*time) : std::nullopt;
  const auto height_m = height ? parse_number(*height) : std::nullopt;
  if (!latitude_deg || !longitude_deg || !stamp)
    throw Error(ErrorCode::Format, where, "a track point needs lat, lon and a time like 2026-11-22T10:00:00Z");
  has_height = height_m.has_value();
  GnssFix fix{*stamp, degrees_to_radians(*latitude_deg), degrees_to_radians(*longitude_deg), height_m.value_or(0.0),
              Eigen::Vector3d(kSigma_m * kSigma_m, kSigma_m * kSigma_m, kSigmaUp_m * kSigmaUp_m).asDiagonal()};
  if (!plausible_geodetic(fix.latitude_rad, fix.longitude_rad, fix.height_m))
    throw Error(ErrorCode::Format, where, "the position is not on the Earth");
  return fix;
}

}  // namespace

bool recognise_gpx(const fs::path& path) {
  try {
    return read_file_head(path, 4096).find("<gpx") != std::string::npos;
  } catch (const Error&) {
    return false;
  }
}

std::vector<GnssFix> read_gpx(const fs::path& path, std::vector<Finding>& findings) {
  const std::string bytes = read_regular_file(path);
  const std::string_view text = bytes;
  std::vector<GnssFix> fixes;
  BadItems bad;
  std::size_t flat = 0, line = 1, counted = 0;
  for (std::size_t at = text.find(kPoint); at != std::string_view::npos;) {
    const std::size_t next = text.find(kPoint, at + kPoint.size());
    line += static_cast<std::size_t>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                                text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    try {
      bool has_height = false;
      fixes.push_back(
          fix_of(text.substr(at, next == std::string_view::npos ? next : next - at), at_line(path, line), has_height));
      flat += !has_height;
    } catch (const Error& error) {
      bad.add(error);
    }
    at = next;
  }
  if (fixes.empty())
    throw Error(ErrorCode::Format, path.string(),
                "holds no track point with a time." + (bad.count() ? " First problem: " + bad.first() : ""));
  bad.report(findings, "bad-gpx", path.string(), "track points");
  findings.push_back(make_finding(Severity::Note, "gnss-sigma-assumed", path.string(),
                                  "GPX does not state errors: 3 m, and 5 m in height, are assumed."));
  if (flat > 0)
    findings.push_back(
        make_finding(Severity::Warning, "height-missing", path.string(),
                     number_of(flat, "track point has", "track points have") + " no height; it is taken to be zero."));
  keep_ascending(fixes, "gnss", path.string(), findings);
  return fixes;
}

}  // namespace remount

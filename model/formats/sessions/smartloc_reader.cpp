#include "model/formats/sessions/smartloc_reader.h"

#include <GeographicLib/Geocentric.hpp>
#include <limits>
#include <optional>

#include "algorithms/geometry/rotation.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "messages/stages.h"
#include "model/drive/bad_items.h"
#include "model/drive/plausible_values.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/sessions/several_sessions.h"

namespace remount::formats {

namespace fs = std::filesystem;

using Eigen::Vector3d;

namespace {

constexpr std::string_view kInput = "_Input.txt", kTruth = "_GT.txt";
constexpr double kTruthSigma_m = 0.1;

/// Calls `take(tokens, line number)` for every line that starts with `keyword`. What it throws is collected.
template <class Take>
void for_lines(const fs::path& path, std::string_view keyword, drive::BadItems& bad, Take&& take) {
  const std::string text = read_text_file(path);
  LineReader lines(text);
  std::string_view line;
  std::vector<std::string_view> tokens;
  while (lines.next(line)) {
    if (!line.starts_with(keyword)) continue;
    split_blanks(line, tokens);
    if (tokens[0] != keyword) continue;
    try {
      take(tokens, lines.line_number());
    } catch (const Error& error) {
      bad.add(error);
    }
  }
}

std::int64_t stamp_ns(const std::vector<std::string_view>& tokens, const fs::path& path, std::size_t line) {
  const auto stamp = tokens.size() > 1 ? parse_seconds_ns(tokens[1]) : std::nullopt;
  if (!stamp) throw Error(ErrorCode::Format, at_line(path, line), say::smartloc_no_time());
  return *stamp;
}

Vector3d vector(const std::vector<std::string_view>& tokens, std::size_t first, Message (*what)(), const fs::path& path,
                std::size_t line) {
  if (tokens.size() < first + 3)
    throw Error(ErrorCode::Format, at_line(path, line), say::smartloc_columns(tokens.size(), first + 3));
  Vector3d v;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = require_number(tokens[first + axis], what, path, line);
    if (drive::means_not_known(value))
      throw Error(ErrorCode::Format, at_line(path, line), say::log_not_known_number(what()));
    v[static_cast<Eigen::Index>(axis)] = value;
  }
  return v;
}

void read_odometry(const fs::path& path, drive::Session& session) {
  drive::BadItems bad;
  for_lines(path, "odom3", bad, [&](const std::vector<std::string_view>& tokens, std::size_t line) {
    const std::int64_t stamp = stamp_ns(tokens, path, line);
    const double speed_mps = vector(tokens, 2, say::smartloc_velocity, path, line).x();
    const Vector3d rate = vector(tokens, 5, say::smartloc_turn_rate, path, line);
    session.wheels.push_back({stamp, speed_mps, speed_mps});
    session.imu.push_back({stamp, rate, Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())});
  });
  if (session.wheels.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::smartloc_no_odometry()));
  bad.report(session.findings, "bad-odometry", path.string(), say::left_out_lines);
  drive::keep_ascending(session.wheels, "wheels", path.string(), session.findings);
  std::vector<drive::Finding> told_already;
  drive::keep_ascending(session.imu, "imu", path.string(), told_already);
  session.files.push_back(path);
}

void read_truth(const fs::path& path, drive::Session& session) {
  drive::BadItems bad;
  const GeographicLib::Geocentric earth = GeographicLib::Geocentric::WGS84();
  for_lines(path, "point3", bad, [&](const std::vector<std::string_view>& tokens, std::size_t line) {
    const std::int64_t stamp = stamp_ns(tokens, path, line);
    const Vector3d point_in_earth = vector(tokens, 2, say::smartloc_position, path, line);
    double latitude_deg = 0.0, longitude_deg = 0.0, height_m = 0.0;
    earth.Reverse(point_in_earth.x(), point_in_earth.y(), point_in_earth.z(), latitude_deg, longitude_deg, height_m);
    const motion::GnssFix fix{stamp, degrees_to_radians(latitude_deg), degrees_to_radians(longitude_deg), height_m,
                              kTruthSigma_m * kTruthSigma_m * Eigen::Matrix3d::Identity()};
    if (!drive::plausible_geodetic(fix.latitude_rad, fix.longitude_rad, fix.height_m))
      throw Error(ErrorCode::Format, at_line(path, line), say::smartloc_far_from_earth());
    session.gnss.push_back(fix);
  });
  if (session.gnss.empty()) throw Error(ErrorCode::Format, path.string(), bad.after(say::smartloc_no_truth()));
  bad.report(session.findings, "bad-truth", path.string(), say::left_out_lines);
  drive::keep_near(session.gnss, path.string(), session.findings);
  drive::keep_ascending(session.gnss, "gnss", path.string(), session.findings);
  session.files.push_back(path);
}

}  // namespace

namespace {

bool is_input(const fs::path& file) {
  if (!file.filename().string().ends_with(kInput) || !is_file(file)) return false;
  try {
    const std::string head = read_text_head(file, 4096);
    return head.starts_with("odom3 ") || head.starts_with("pseudorange3 ");
  } catch (const Error&) {
    return false;
  }
}

/// The file itself, or those of a folder.
std::vector<fs::path> inputs_at(const fs::path& path) {
  std::vector<fs::path> inputs;
  if (!is_folder(path)) {
    if (is_input(path)) inputs.push_back(path);
    return inputs;
  }
  for (const fs::path& file : files_in(path))
    if (is_input(file)) inputs.push_back(file);
  return inputs;
}

}  // namespace

int SmartlocReader::probe(const fs::path& path) const { return inputs_at(path).empty() ? 0 : 95; }

drive::Session SmartlocReader::open(const fs::path& given, Progress& progress) const {
  const std::vector<fs::path> inputs = inputs_at(given);
  if (inputs.size() > 1)
    throw SeveralSessions(given, say::smartloc_several(inputs.size(), inputs.front().filename().string()), inputs);
  const fs::path path = inputs.empty() ? given : inputs.front();
  drive::Session session;
  const std::string file = path.filename().string();
  session.name = file.ends_with(kInput) ? file.substr(0, file.size() - kInput.size()) : file;
  session.path = given;
  session.format = id();
  progress.report(say::stage_reading_odometry, 0, 2);
  read_odometry(path, session);
  session.findings.push_back(
      drive::make_finding(drive::Severity::Note, "one-speed", path.string(), say::smartloc_one_speed()));
  progress.report(say::stage_reading_ground_truth, 1, 2);
  const fs::path truth = path.parent_path() / (session.name + std::string(kTruth));
  if (is_file(truth)) {
    read_truth(truth, session);
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "truth-as-gnss", truth.string(),
                                                   say::smartloc_truth_as_gnss(Length{kTruthSigma_m})));
  }
  return session;
}

}  // namespace remount::formats

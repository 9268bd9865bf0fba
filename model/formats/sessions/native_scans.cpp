#include "model/formats/sessions/native_scans.h"

#include <string>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/sessions.h"
#include "model/formats/clouds/scan_list.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/files/declared_table.h"
#include "model/formats/files/input_file.h"
#include "model/formats/sessions/native_choice.h"
#include "model/formats/sessions/native_columns.h"
#include "model/formats/sessions/native_declared.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFromNames = "from-names", kFromPoints = "from-points";

double positive(const DocumentView& node) {
  const double value = node.number();
  if (value <= 0.0) node.fail(say::native_above_zero());
  return value;
}

void read_timing(const DocumentView& node, drive::Session& session) {
  session.scan_timing = choice<drive::ScanTiming>(node.at("timing"), {{"instant", drive::ScanTiming::Instant},
                                                                      {"per-point", drive::ScanTiming::PerPoint},
                                                                      {"sweep", drive::ScanTiming::SweepAzimuth},
                                                                      {"unknown", drive::ScanTiming::Unknown}});
  const auto sweep = node.find("sweep");
  if ((session.scan_timing == drive::ScanTiming::SweepAzimuth) != sweep.has_value()) node.fail(say::native_sweep());
  if (!sweep) return;
  sweep->allow_only({"period_s", "stamp_azimuth_deg", "clockwise", "certain", "direction_certain"});
  session.sweep.period_s = positive(sweep->at("period_s"));
  session.sweep.stamp_azimuth_rad = degrees_to_radians(sweep->at("stamp_azimuth_deg").number());
  session.sweep.clockwise = sweep->at("clockwise").boolean();
  if (const auto certain = sweep->find("certain")) session.sweep.certain = certain->boolean();
  if (const auto certain = sweep->find("direction_certain")) session.sweep.direction_known = certain->boolean();
}

/// Times of a table of somebody's, or in the names of the files.
void list_declared(const DocumentView& node, const fs::path& folder, SessionSource& source, ListedScans& listed,
                   std::vector<drive::Finding>& findings) {
  const std::vector<fs::path> files = source.files(listed.directory);
  if (node.has("names")) {
    node.allow_only({"names", "scale", "offset_s"});
    NameTimes times;
    times.unit_ns = choice<std::int64_t>(
        node.at("names"), {{"s", 1'000'000'000}, {"ms", 1'000'000}, {"us", 1'000}, {"ns", 1}, {"date", 0}});
    if (const auto scale = node.find("scale"))
      times.scale = choice<TimeScale>(*scale, {{"unix", TimeScale::Unix}, {"gps", TimeScale::Gps}});
    times.offset_ns = read_offset_ns(node);
    listed.scans = scans_from_names(files, listed.directory, listed.format, times, findings);
    return;
  }
  node.allow_only({"file", "table", "time", "scan"});
  listed.table = folder / node.at("file").string();
  const TableText text = read_table_text(node);
  const TimeColumns time = read_time_columns(node.at("time"));
  if (time.time_scale == TimeScale::GpsWeek) node.at("time").fail(say::native_scans_week());
  std::optional<ColumnRef> scan;
  if (const auto column = node.find("scan")) scan = read_column(*column);
  listed.scans = scans_from_times(source.table(*listed.table), {*listed.table, text, time, scan}, files,
                                  listed.directory, listed.format, findings);
}

}  // namespace

ListedScans listed_scans(const DocumentView& node, const fs::path& folder, SessionSource& source,
                         std::vector<drive::Finding>& findings, Progress& progress) {
  node.allow_only({"directory", "type", "stamps", "timing", "sweep"});
  ListedScans listed;
  listed.format = choice<CloudFormat>(node.at("type"), {{"pcd", CloudFormat::Pcd},
                                                        {"ply", CloudFormat::Ply},
                                                        {"las", CloudFormat::Las},
                                                        {"laz", CloudFormat::Las},
                                                        {"kitti-bin", CloudFormat::KittiBin},
                                                        {"text", CloudFormat::Text}});
  listed.directory = folder / node.at("directory").string();
  if (!is_folder(listed.directory)) node.at("directory").fail(say::native_no_folder(listed.directory.string()));
  if (node.at("stamps").is_map()) {
    list_declared(node.at("stamps"), folder, source, listed, findings);
    return listed;
  }
  const std::string stamps = node.at("stamps").string();
  if (stamps == kFromNames || stamps == kFromPoints) {
    const std::vector<fs::path> files = source.files(listed.directory);
    listed.scans = stamps == kFromNames ? scans_from_names(files, listed.directory, listed.format, findings)
                                        : scans_from_points(files, listed.directory, listed.format, findings, progress);
    return listed;
  }
  listed.table = folder / stamps;
  const std::string text = source.table(*listed.table);
  if (!text.empty() || !source.only_new())
    listed.scans = scans_from_table(text, *listed.table, listed.directory, findings);
  return listed;
}

bool stamps_are_in_points(const DocumentView& node) {
  const auto stamps = node.find("stamps");
  return stamps && !stamps->is_map() && stamps->string() == kFromPoints;
}

void read_scans(const DocumentView& node, const fs::path& folder, SessionSource& source, drive::Session& session,
                Progress& progress) {
  ListedScans listed = listed_scans(node, folder, source, session.findings, progress);
  if (progress.cancelled()) return;
  std::vector<drive::ScanFile>& scans = listed.scans;
  const fs::path& directory = listed.directory;
  if (listed.table) session.files.push_back(*listed.table);
  if (scans.empty() && source.only_new()) return;
  if (scans.empty()) node.fail(say::native_no_scan(directory.string()));
  drive::keep_ascending(scans, "scan", directory.string(), session.findings);
  for (const drive::ScanFile& scan : scans) session.files.push_back(scan.path);
  read_timing(node, session);
  const bool timed = session.scan_timing == drive::ScanTiming::PerPoint;
  const auto files = std::make_shared<FileScanSource>(std::move(scans), listed.format,
                                                      timed ? TimesOfPoints::Required : TimesOfPoints::Unused);
  session.scans = files;
  if (timed) {
    const FoundPointTimes found = require_point_times(node.at("timing"), *files, session);
    session.times_count = found.count;
    if (found.misfit) return report_no_point_times(*files, session);
  }
  if (timed && !source.only_new()) report_point_clock(*files, session.findings);
  if (session.scan_timing == drive::ScanTiming::Unknown && !source.only_new()) report_no_point_times(*files, session);
}

}  // namespace remount::formats

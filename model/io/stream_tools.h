// What session readers share: streams with clean stamps, bad lines as findings, scans as files.
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/error.h"
#include "model/io/cloud_file.h"
#include "model/session.h"

namespace remount {

inline Finding make_finding(Severity severity, std::string code, std::string where, std::string explanation) {
  return {severity, std::move(code), std::move(where), std::move(explanation)};
}

/// Collects what is wrong with single lines or files of a stream that is usable as a whole: one finding for all.
class BadItems {
 public:
  void add(const Error& error) { add(error.what()); }
  void add(std::string first_message) {
    if (count_++ == 0) first_ = std::move(first_message);
  }
  std::size_t count() const { return count_; }
  const std::string& first() const { return first_; }
  /// Adds nothing where there was nothing wrong.
  void report(std::vector<Finding>& findings, const std::string& code, const std::string& where,
              const std::string& noun) const;

 private:
  std::size_t count_ = 0;
  std::string first_;
};

/// The text of a table without its last line where that was cut: it lacks its end, and has fewer fields than the lines
/// before it, or a last number with fewer digits than theirs, by so many that it is another. Becomes a finding
/// "log-cut".
std::string_view without_cut_line(std::string_view text, const std::string& path, std::vector<Finding>& findings);

/// Makes stamps strictly ascending: stamps that are no time at all and single stamps far in the future are taken out,
/// then every item that is not later than the one before it. What was taken out becomes findings
/// "<code>-duplicate-stamps", "<code>-reversed-stamps" and "<code>-impossible-stamps". Throws Error(Format) where no
/// stamp is possible.
template <class Item>
void keep_ascending(std::vector<Item>& items, const std::string& code, const std::string& where,
                    std::vector<Finding>& findings);

/// Leaves out samples that lie more than 2 degrees from the median: glitches that no drive contains, and that no one
/// grid could hold. What was taken out becomes a finding "ins-far-away".
/// Throws Error(Format) where nothing is left.
void keep_near(std::vector<InsSample>& ins, const std::string& where, std::vector<Finding>& findings);

struct ScanFile {
  std::filesystem::path path;
  std::int64_t stamp_ns = 0;
};

/// A scan that is an item of something else: a message of a bag.
struct IndexedScan {
  std::size_t index = 0;
  std::int64_t stamp_ns = 0;
};

/// Scans that say whether the times of their points are on the clock of their stamps.
class TimedScanSource : public ScanSource {
 public:
  virtual ReadCloud read(std::size_t scan) const = 0;
  PointCloud load(std::size_t scan) const final { return read(scan).cloud; }
};

/// Scans that are files, each with its stamp. load() reads the file every time: what is kept in memory is
/// the pipeline's business (ScanStore).
class FileScanSource final : public TimedScanSource {
 public:
  explicit FileScanSource(std::vector<ScanFile> files, CloudFormat format = CloudFormat::Auto)
      : files_(std::move(files)), format_(format) {}
  std::size_t size() const override { return files_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).stamp_ns; }
  std::string name(std::size_t scan) const override { return at(scan).path.filename().string(); }
  ReadCloud read(std::size_t scan) const override { return read_cloud_file(at(scan).path, at(scan).stamp_ns, format_); }

 private:
  const ScanFile& at(std::size_t scan) const;
  std::vector<ScanFile> files_;
  CloudFormat format_;
};

/// True where the points of the first readable scan (of at most three) carry times that differ.
bool has_point_times(const ScanSource& scans);

/// Adds a finding "point-clock" where the times of the points of that scan are on another clock than its stamp.
void report_point_clock(const TimedScanSource& scans, std::vector<Finding>& findings);

/// Median difference of ascending stamps in seconds; 0 where there are fewer than two.
template <class Item>
double median_period_s(const std::vector<Item>& items) {
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < items.size(); ++i) steps.push_back(items[i].stamp_ns - items[i - 1].stamp_ns);
  if (steps.empty()) return 0.0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  return static_cast<double>(steps[steps.size() / 2]) * 1e-9;
}

/// Rotation from a log that may be slightly off: projects to the nearest rotation. `defect` is how far each entry was
/// off at most. Throws Error(Format) at `where` beyond 0.1: that is no rotation.
Eigen::Matrix3d checked_rotation(const Eigen::Matrix3d& logged, const std::string& where, double& defect);

/// True where latitude and longitude (rad) and height (m) are possible.
bool plausible_geodetic(double latitude_rad, double longitude_rad, double height_m);

}  // namespace remount

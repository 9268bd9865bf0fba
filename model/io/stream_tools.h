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

inline Finding make_finding(Severity severity, std::string code, std::string where, Message explanation) {
  return {severity, std::move(code), std::move(where), std::move(explanation)};
}

/// Where it was and what happened, as one message.
Message message_of(const Error& error);

/// Collects what is wrong with single lines or files of a stream that is usable as a whole: one finding for all.
class BadItems {
 public:
  void add(const Error& error) {
    if (count_++ == 0) first_ = message_of(error);
  }
  void add(Message problem) {
    if (count_++ == 0) first_ = std::move(problem);
  }
  std::size_t count() const { return count_; }
  const Message& first() const { return first_; }
  /// A sentence, followed by the first problem where there is one.
  Message after(Message sentence) const;
  /// Adds nothing where there was nothing wrong. @param left_out says it of so many, and of the first problem
  void report(std::vector<Finding>& findings, const std::string& code, const std::string& where,
              Message (*left_out)(Count count, Message first)) const;

 private:
  std::size_t count_ = 0;
  Message first_;
};

/// The text of a table without its last line where that was cut: it lacks its end, and has fewer fields than the lines
/// before it, or a last number with fewer digits than theirs, by so many that it is another. Becomes a finding
/// "log-cut".
std::string_view without_cut_line(std::string_view text, const std::string& path, std::vector<Finding>& findings);

/// Makes stamps strictly ascending: stamps that are no time at all and single stamps far in the future are taken out,
/// then every item that is not later than the one before it; of fixes and INS samples with one stamp the best by what
/// they say of themselves stays, of others the first. What was taken out becomes findings "<code>-duplicate-stamps",
/// "<code>-reversed-stamps" and "<code>-impossible-stamps". Throws Error(Format) where no stamp is possible.
template <class Item>
void keep_ascending(std::vector<Item>& items, const std::string& code, const std::string& where,
                    std::vector<Finding>& findings);

/// Adds "<code>-duplicate-stamps" where entries repeat the stamp before them.
/// @param best the best of each stamp was used, not the first
void report_one_stamp(std::size_t count, bool best, const std::string& code, const std::string& where,
                      std::vector<Finding>& findings);

/// Leaves out samples that lie more than 2 degrees from the median: glitches that no drive contains, and that no one
/// grid could hold. What was taken out becomes a finding "ins-far-away", of fixes "gnss-far-away".
/// Throws Error(Format) where nothing is left.
void keep_near(std::vector<InsSample>& ins, const std::string& where, std::vector<Finding>& findings);
void keep_near(std::vector<GnssFix>& fixes, const std::string& where, std::vector<Finding>& findings);

struct ScanFile {
  std::filesystem::path path;
  std::int64_t stamp_ns = 0;
};

/// A scan that is an item of something else: a message of a bag.
struct IndexedScan {
  std::size_t index = 0;
  std::int64_t stamp_ns = 0;
};

/// What a session makes of the times of points.
enum class TimesOfPoints {
  Kept,      ///< as far as there are any
  Required,  ///< a scan without is refused: it would be used as if it had been measured at once
  Unused,    ///< no point is left out for its time
};

/// Scans that say whether the times of their points are on the clock of their stamps.
class TimedScanSource : public ScanSource {
 public:
  explicit TimedScanSource(TimesOfPoints times = TimesOfPoints::Kept) : times_(times) {}
  virtual ReadCloud read(std::size_t scan) const = 0;
  /// Throws Error(Format) where times are required and the points have none.
  PointCloud load(std::size_t scan) const final;
  void use_times(TimesOfPoints times) { times_ = times; }

 protected:
  PointTimes times_for_reading() const {
    return times_ == TimesOfPoints::Unused ? PointTimes::Unused : PointTimes::Used;
  }

 private:
  TimesOfPoints times_;
};

/// Scans that are files, each with its stamp. load() reads the file every time: what is kept in memory is
/// the pipeline's business (ScanStore).
class FileScanSource final : public TimedScanSource {
 public:
  explicit FileScanSource(std::vector<ScanFile> files, CloudFormat format = CloudFormat::Auto,
                          TimesOfPoints times = TimesOfPoints::Kept)
      : TimedScanSource(times), files_(std::move(files)), format_(format) {}
  std::size_t size() const override { return files_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).stamp_ns; }
  std::string name(std::size_t scan) const override { return at(scan).path.filename().string(); }
  ReadCloud read(std::size_t scan) const override {
    return read_cloud_file(at(scan).path, at(scan).stamp_ns, format_, times_for_reading());
  }

 private:
  const ScanFile& at(std::size_t scan) const;
  std::vector<ScanFile> files_;
  CloudFormat format_;
};

/// Whether points carry times that differ as those of a sweep do: not all one value, nor a few (seconds of a week that
/// were rounded to 32-bit floats).
bool has_point_times(const PointCloud& cloud);

/// Of the first scans, up to three: whether the points of one of them carry usable times.
struct FoundPointTimes {
  bool usable = false;
  bool misfit = false;                      ///< there are times, but they cannot be of one sweep
  TimesCount count = TimesCount::Forwards;  ///< of those that are usable; or open
  std::string scan;                         ///< the first that could be read; empty where none could
  Message problem;  ///< what is wrong with its times, and its columns: "the points have no times (columns: x y z)"
};
FoundPointTimes find_point_times(const TimedScanSource& scans);

/// "Columns of times are called time, t, ...": a sentence for where none is known.
Message expected_time_columns();

/// Makes the timing of the session unknown, as its scans have no times and may be compensated or not, with the warning
/// "no-point-times"; "point-times-misfit" where there are times that are of no sweep.
void report_no_point_times(TimedScanSource& scans, Session& session);

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

/// True where latitude and longitude (rad) and height (m) are possible. Depths that loggers write for "not known"
/// (-9999) are not.
bool plausible_geodetic(double latitude_rad, double longitude_rad, double height_m);

/// True for what receivers and loggers write in place of any quantity that they do not have: -2e10 ("do not use" of
/// Septentrio, also where a driver turned it into other units), 1e10 and the like.
bool means_not_known(double value);
/// The same for an angle as it was logged, in degrees or radians: nines (-9999), and limits of 16 and 32 bits, too.
bool angle_means_not_known(double logged);

}  // namespace remount

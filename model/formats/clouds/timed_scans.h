// Scans as session readers give them: files or messages whose points may carry times.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "model/drive/session.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/cloud_file.h"

namespace remount::formats {

/// What a session makes of the times of points.
enum class TimesOfPoints {
  Kept,      ///< as far as there are any
  Required,  ///< a scan without is refused: it would be used as if it had been measured at once
  Unused,    ///< no point is left out for its time
};

/// Scans that say whether the times of their points are on the clock of their stamps.
class TimedScanSource : public drive::ScanSource {
 public:
  explicit TimedScanSource(TimesOfPoints times = TimesOfPoints::Kept) : times_(times) {}
  virtual ReadCloud read(std::size_t scan) const = 0;
  /// Throws Error(Format) where times are required and the points have none.
  cloud::PointCloud load(std::size_t scan) const final;
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
  explicit FileScanSource(std::vector<drive::ScanFile> files, CloudFormat format = CloudFormat::Auto,
                          TimesOfPoints times = TimesOfPoints::Kept)
      : TimedScanSource(times), files_(std::move(files)), format_(format) {}
  std::size_t size() const override { return files_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).stamp_ns; }
  std::string name(std::size_t scan) const override { return at(scan).path.filename().string(); }
  ReadCloud read(std::size_t scan) const override {
    return read_cloud_file(at(scan).path, at(scan).stamp_ns, format_, times_for_reading());
  }

 private:
  const drive::ScanFile& at(std::size_t scan) const;
  std::vector<drive::ScanFile> files_;
  CloudFormat format_;
};

/// Whether points carry times that differ as those of a sweep do: not all one value, nor a few (seconds of a week that
/// were rounded to 32-bit floats).
bool has_point_times(const cloud::PointCloud& cloud);

/// Of the first scans, up to three: whether the points of one of them carry usable times.
struct FoundPointTimes {
  bool usable = false;
  bool misfit = false;                                    ///< there are times, but they cannot be of one sweep
  drive::TimesCount count = drive::TimesCount::Forwards;  ///< of those that are usable; or open
  std::string scan;                                       ///< the first that could be read; empty where none could
  Message problem;  ///< what is wrong with its times, and its columns: "the points have no times (columns: x y z)"
};
FoundPointTimes find_point_times(const TimedScanSource& scans);

/// "Columns of times are called time, t, ...": a sentence for where none is known.
Message expected_time_columns();

/// Makes the timing of the session that of its points, where they have usable times, which are required from then on,
/// and unknown where not. Adds what is to be said of either.
void use_point_times(TimedScanSource& scans, drive::Session& session);

/// Makes the timing of the session unknown, as its scans have no times and may be compensated or not, with the warning
/// "no-point-times"; "point-times-misfit" where there are times that are of no sweep.
void report_no_point_times(TimedScanSource& scans, drive::Session& session);

/// Adds a finding "point-clock" where the times of the points of that scan are on another clock than its stamp.
void report_point_clock(const TimedScanSource& scans, std::vector<drive::Finding>& findings);

}  // namespace remount::formats

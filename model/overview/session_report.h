// What `inspect` says about a session: counts, rates, gaps, clocks, and whether it can be calibrated with.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/core/progress.h"
#include "algorithms/core/stamps.h"
#include "algorithms/messages/catalogue.h"
#include "algorithms/messages/message.h"
#include "model/drive/session.h"
#include "model/method_registry/method_needs.h"
#include "model/overview/motion_outlook.h"

namespace remount::overview {

/// One stream of stamps.
struct StreamReport {
  std::size_t count = 0;
  std::int64_t first_ns = 0, last_ns = 0;
  double rate_hz = 0.0;        ///< from the median step; 0 where there are fewer than two
  std::size_t gaps = 0;        ///< steps longer than three median steps
  double longest_gap_s = 0.0;  ///< the longest step
  double span_s() const { return seconds(last_ns - first_ns); }
};
/// Of scans, and of the poses of an odometry.
std::vector<std::int64_t> lidar_stamps_ns(const drive::Session& session);

StreamReport report_stream(const std::vector<std::int64_t>& stamps_ns);

struct SessionReport {
  StreamReport lidar;  ///< scans, or poses of an odometry
  StreamReport ins;
  StreamReport imu, gnss, wheels, barometer;
  std::size_t lidar_covered = 0;                    ///< how many of the lidar's stamps lie within the INS data
  double travelled_m = 0.0;                         ///< of the INS
  double turned_deg = 0.0;                          ///< largest angle between the first attitude and any other
  std::vector<std::size_t> points;                  ///< of the scans that were read as a sample (first, middle, last)
  std::vector<drive::Finding> findings;             ///< those of the session, and what this report adds
  std::vector<method_registry::MethodFit> methods;  ///< which of them the streams serve
  bool usable = false;    ///< enough for a calibration to be tried, by whatever method of a vehicle
  MotionOutlook outlook;  ///< what of X the motion can tell

  bool serves(const method_registry::CalibrationMethod& method) const;
  /// Whether a method takes what is there; one for other machines than vehicles does not count.
  bool serves_a_vehicle() const;
};

/// Reads at most three scans.
SessionReport report_session(const drive::Session& session, Progress& progress);

/// A line of what is said of a session. Deeper ones belong to the one before.
struct ReportLine {
  int depth = 0;
  Message words;
};
std::vector<ReportLine> report_lines(const drive::Session& session, const SessionReport& report);

/// The same as text, indented.
std::string describe(const drive::Session& session, const SessionReport& report, Language language = Language::English);

}  // namespace remount::overview

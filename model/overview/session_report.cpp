#include "model/overview/session_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/geodesy/earth_radius.h"
#include "algorithms/messages/render.h"
#include "messages/checks.h"
#include "messages/drives.h"
#include "messages/stages.h"
#include "model/checks/data_check.h"
#include "model/conventions/clock_hint.h"

namespace remount::overview {
namespace {

std::vector<std::int64_t> ins_stamps(const drive::Session& session) {
  std::vector<std::int64_t> stamps;
  for (const motion::InsSample& sample : session.ins) stamps.push_back(sample.stamp_ns);
  for (const motion::StampedPose& pose : session.world_from_ins) stamps.push_back(pose.stamp_ns);
  return stamps;
}

template <class Sample>
StreamReport report_samples(const std::vector<Sample>& samples) {
  std::vector<std::int64_t> stamps;
  for (const Sample& sample : samples) stamps.push_back(sample.stamp_ns);
  return report_stream(stamps);
}

/// Travelled distance, good to a fraction of a percent: for a person's judgement, not for calibration.
void measure_motion(const drive::Session& session, SessionReport& report) {
  const auto turned = [&](const Eigen::Matrix3d& first, const Eigen::Matrix3d& other) {
    report.turned_deg = std::max(report.turned_deg, radians_to_degrees(so3_log(first.transpose() * other).norm()));
  };
  for (std::size_t i = 1; i < session.ins.size(); ++i) {
    const motion::InsSample &a = session.ins[i - 1], &b = session.ins[i];
    const double north = (b.latitude_rad - a.latitude_rad) * geodesy::kEarthRadius_m;
    const double east =
        wrap_angle_rad(b.longitude_rad - a.longitude_rad) * geodesy::kEarthRadius_m * std::cos(a.latitude_rad);
    report.travelled_m += Eigen::Vector3d(east, north, b.height_m - a.height_m).norm();
    turned(session.ins.front().enu_from_ins.toRotationMatrix(), b.enu_from_ins.toRotationMatrix());
  }
  for (std::size_t i = 1; i < session.world_from_ins.size(); ++i) {
    const RigidTransform &a = session.world_from_ins[i - 1].pose, &b = session.world_from_ins[i].pose;
    report.travelled_m += (b.translation() - a.translation()).norm();
    turned(session.world_from_ins.front().pose.linear(), b.linear());
  }
}

/// What opening the session said already is not said again.
void add_new(SessionReport& report, drive::Finding finding) {
  const bool known = std::any_of(report.findings.begin(), report.findings.end(), [&](const drive::Finding& other) {
    return other.code == finding.code && other.where == finding.where;
  });
  if (!known) report.findings.push_back(std::move(finding));
}

void sample_scans(const drive::Session& session, SessionReport& report, Progress& progress) {
  if (!session.scans || session.scans->size() == 0) return;
  const std::size_t last = session.scans->size() - 1;
  for (const std::size_t scan : std::set<std::size_t>{0, last / 2, last}) {
    if (progress.cancelled()) return;
    progress.report(say::stage_reading_scans, report.points.size(), 3);
    try {
      report.points.push_back(session.scans->load(scan).size());
    } catch (const Error& error) {
      add_new(report, {drive::Severity::Warning, "bad-scan", error.where(), error.what_happened()});
    }
  }
}

void judge(const drive::Session& session, SessionReport& report, const Progress& progress) {
  const auto problem = [&](const char* code, Message words) {
    add_new(report, {drive::Severity::Problem, code, session.name, std::move(words)});
  };
  report.methods = method_registry::method_fits(session);
  const bool served = report.serves_a_vehicle();
  if (report.lidar.count == 0 && served)
    report.findings.push_back({drive::Severity::Note, "no-lidar", session.name, say::no_lidar_needed()});
  else if (report.lidar.count == 0)
    problem("no-lidar", say::no_lidar());
  else if (report.lidar.count < 2)
    problem("too-few-scans", say::too_few_scans());
  if (report.ins.count < 2 && served)
    report.findings.push_back({drive::Severity::Note, "no-ins", session.name, say::no_ins_needed()});
  else if (report.ins.count < 2)
    problem("no-ins", say::no_ins());
  if (session.scans && report.points.empty()) problem("no-readable-scan", say::no_readable_scan());
  if (report.lidar.count >= 2 && report.ins.count >= 2 && report.lidar_covered < 2) {
    const conventions::TimeSpan lidar{report.lidar.first_ns, report.lidar.last_ns},
        ins{report.ins.first_ns, report.ins.last_ns};
    const bool apart = lidar.last_ns < ins.first_ns || lidar.first_ns > ins.last_ns;
    problem("clocks-apart",
            say::clocks_apart(apart ? conventions::time_spans_apart(lidar, ins) : say::scans_in_gaps()));
  } else if (report.lidar_covered < report.lidar.count && report.ins.count >= 2) {
    report.findings.push_back({drive::Severity::Note, "partly-covered", session.name,
                               say::scans_partly_covered(report.lidar.count - report.lidar_covered)});
  }
  const bool problems = std::any_of(report.findings.begin(), report.findings.end(), [](const drive::Finding& finding) {
    return finding.severity == drive::Severity::Problem;
  });
  const bool by_pairs = report.serves(method_registry::calibration_method(calibration::kPairwise));
  report.usable = !problems && served && (!by_pairs || report.lidar_covered >= 2);
  if (!report.usable || !by_pairs) return;
  report.outlook = motion_outlook(session, {}, progress);
  if (report.outlook.judged && report.outlook.determinable.empty() && report.outlook.open.empty()) {
    problem("no-motion", say::no_motion());
    report.usable = false;
  }
}

}  // namespace

bool SessionReport::serves(const method_registry::CalibrationMethod& method) const {
  return std::any_of(methods.begin(), methods.end(),
                     [&](const method_registry::MethodFit& fit) { return fit.method == &method && fit.serves(); });
}

bool SessionReport::serves_a_vehicle() const {
  return std::any_of(methods.begin(), methods.end(),
                     [](const method_registry::MethodFit& fit) { return fit.serves() && fit.proviso.empty(); });
}

std::vector<std::int64_t> lidar_stamps_ns(const drive::Session& session) {
  std::vector<std::int64_t> stamps;
  if (session.scans)
    for (std::size_t i = 0; i < session.scans->size(); ++i) stamps.push_back(session.scans->stamp_ns(i));
  for (const motion::StampedPose& pose : session.odometry_from_lidar) stamps.push_back(pose.stamp_ns);
  return stamps;
}

StreamReport report_stream(const std::vector<std::int64_t>& stamps_ns) {
  StreamReport report;
  report.count = stamps_ns.size();
  if (stamps_ns.empty()) return report;
  report.first_ns = stamps_ns.front();
  report.last_ns = stamps_ns.back();
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) steps.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  if (steps.empty()) return report;
  const std::int64_t median = median_of(steps);
  if (median > 0) report.rate_hz = 1e9 / static_cast<double>(median);
  for (const std::int64_t step : steps) {
    if (median > 0 && static_cast<double>(step) > 3.0 * static_cast<double>(median)) ++report.gaps;
    report.longest_gap_s = std::max(report.longest_gap_s, seconds(step));
  }
  return report;
}

SessionReport report_session(const drive::Session& session, Progress& progress) {
  SessionReport report;
  report.findings = session.findings;
  const std::vector<std::int64_t> lidar = lidar_stamps_ns(session), ins = ins_stamps(session);
  report.lidar = report_stream(lidar);
  report.ins = report_stream(ins);
  report.imu = report_samples(session.imu);
  report.gnss = report_samples(session.gnss);
  report.wheels = report_samples(session.wheels);
  report.barometer = report_samples(session.barometer);
  const double longest_step_s = report.ins.rate_hz > 0.0 ? std::max(0.25, 5.0 / report.ins.rate_hz) : 0.0;
  for (const std::int64_t stamp : lidar) {
    const auto after = std::lower_bound(ins.begin(), ins.end(), stamp);
    if (after == ins.end() || (after == ins.begin() && *after != stamp)) continue;
    const std::int64_t before = *after == stamp ? stamp : *(after - 1);
    if (seconds(*after - before) <= longest_step_s) ++report.lidar_covered;
  }
  measure_motion(session, report);
  sample_scans(session, report, progress);
  for (drive::Finding& finding : checks::drive_findings(session)) add_new(report, std::move(finding));
  judge(session, report, progress);
  return report;
}

}  // namespace remount::overview

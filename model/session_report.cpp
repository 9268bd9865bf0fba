#include "model/session_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/core/error.h"
#include "algorithms/core/median.h"
#include "algorithms/core/stamps.h"
#include "algorithms/geometry/earth_radius.h"
#include "algorithms/messages/render.h"
#include "model/checks/data_check.h"
#include "model/clock_hint.h"
#include "model/count_words.h"
#include "model/printable_text.h"

namespace remount {
namespace {

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

std::vector<std::int64_t> ins_stamps(const Session& session) {
  std::vector<std::int64_t> stamps;
  for (const InsSample& sample : session.ins) stamps.push_back(sample.stamp_ns);
  for (const StampedPose& pose : session.world_from_ins) stamps.push_back(pose.stamp_ns);
  return stamps;
}

template <class Sample>
StreamReport report_samples(const std::vector<Sample>& samples) {
  std::vector<std::int64_t> stamps;
  for (const Sample& sample : samples) stamps.push_back(sample.stamp_ns);
  return report_stream(stamps);
}

/// Whether a method takes what is there; one for other machines than vehicles does not count.
bool serves_a_vehicle(const SessionReport& report) {
  return std::any_of(report.methods.begin(), report.methods.end(),
                     [](const MethodFit& fit) { return fit.serves() && fit.proviso.empty(); });
}

bool serves(const SessionReport& report, MethodChoice method) {
  return report.methods.at(static_cast<std::size_t>(method)).serves();
}

/// Travelled distance, good to a fraction of a percent: for a person's judgement, not for calibration.
void measure_motion(const Session& session, SessionReport& report) {
  const auto turned = [&](const Eigen::Matrix3d& first, const Eigen::Matrix3d& other) {
    report.turned_deg = std::max(report.turned_deg, radians_to_degrees(so3_log(first.transpose() * other).norm()));
  };
  for (std::size_t i = 1; i < session.ins.size(); ++i) {
    const InsSample &a = session.ins[i - 1], &b = session.ins[i];
    const double north = (b.latitude_rad - a.latitude_rad) * kEarthRadius_m;
    const double east = wrap_angle_rad(b.longitude_rad - a.longitude_rad) * kEarthRadius_m * std::cos(a.latitude_rad);
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
void add_new(SessionReport& report, Finding finding) {
  const bool known = std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& other) {
    return other.code == finding.code && other.where == finding.where;
  });
  if (!known) report.findings.push_back(std::move(finding));
}

void sample_scans(const Session& session, SessionReport& report, Progress& progress) {
  if (!session.scans || session.scans->size() == 0) return;
  const std::size_t last = session.scans->size() - 1;
  for (const std::size_t scan : std::set<std::size_t>{0, last / 2, last}) {
    if (progress.cancelled()) return;
    progress.report("reading scans", report.points.size(), 3);
    try {
      report.points.push_back(session.scans->load(scan).size());
    } catch (const Error& error) {
      add_new(report, {Severity::Warning, "bad-scan", error.where(), error.what_happened()});
    }
  }
}

void judge(const Session& session, SessionReport& report, const Progress& progress) {
  const auto problem = [&](const char* code, const std::string& text) {
    add_new(report, {Severity::Problem, code, session.name, text});
  };
  report.methods = method_fits(session);
  const bool served = serves_a_vehicle(report);
  if (report.lidar.count == 0 && served)
    report.findings.push_back({Severity::Note, "no-lidar", session.name,
                               "neither scans nor LiDAR poses: only methods that need none can be run"});
  else if (report.lidar.count == 0)
    problem("no-lidar", "neither scans nor LiDAR poses: calibration compares the motion of the INS with the LiDAR's");
  else if (report.lidar.count < 2)
    problem("too-few-scans", "fewer than two scans: nothing to compare");
  if (report.ins.count < 2 && served)
    report.findings.push_back({Severity::Note, "no-ins", session.name,
                               "no INS motion: only methods that live on the other sensors can be run"});
  else if (report.ins.count < 2)
    problem("no-ins", "no INS motion: calibration needs positions and attitudes over time");
  if (session.scans && report.points.empty())
    problem("no-readable-scan", "none of the scans that were tried can be read");
  if (report.lidar.count >= 2 && report.ins.count >= 2 && report.lidar_covered < 2) {
    const TimeSpan lidar{report.lidar.first_ns, report.lidar.last_ns}, ins{report.ins.first_ns, report.ins.last_ns};
    const bool apart = lidar.last_ns < ins.first_ns || lidar.first_ns > ins.last_ns;
    problem("clocks-apart", "the INS data do not cover the scans' times: " +
                                (apart ? time_spans_apart(lidar, ins) : std::string("the scans lie in gaps of it.")));
  } else if (report.lidar_covered < report.lidar.count && report.ins.count >= 2) {
    report.findings.push_back({Severity::Note, "partly-covered", session.name,
                               number_of(report.lidar.count - report.lidar_covered, "scan lies", "scans lie") +
                                   " outside the INS data or in its gaps: left out"});
  }
  const bool problems = std::any_of(report.findings.begin(), report.findings.end(),
                                    [](const Finding& finding) { return finding.severity == Severity::Problem; });
  const bool by_pairs = serves(report, MethodChoice::Pairwise);
  report.usable = !problems && served && (!by_pairs || report.lidar_covered >= 2);
  if (!report.usable || !by_pairs) return;
  report.outlook = motion_outlook(session, {}, progress);
  if (report.outlook.judged && parameter_names(report.outlook.determinable, true).empty() &&
      parameter_names(report.outlook.open, true).empty()) {
    problem("no-motion", "the vehicle hardly moves while the LiDAR records: nothing can be determined");
    report.usable = false;
  }
}

std::string id_of(const MethodFit& fit) { return std::string(kMethodIds.at(static_cast<std::size_t>(fit.method))); }

/// "trajectory (the antenna's lever arm alone), slew if it is a recording of an excavator".
std::string methods_served(const std::vector<MethodFit>& fits, bool with_provisos) {
  std::string text;
  for (const MethodFit& fit : fits) {
    if (!fit.serves() || (!with_provisos && !fit.proviso.empty())) continue;
    text += (text.empty() ? "" : ", ") + id_of(fit);
    if (!fit.limit.empty()) text += " (" + std::string(fit.limit) + ")";
    if (!fit.proviso.empty()) text += " " + std::string(fit.proviso);
  }
  return text;
}

/// For which methods the streams are there, and what the others lack.
std::string method_lines(const std::vector<MethodFit>& fits) {
  const std::string served = methods_served(fits, true);
  std::string text = "  methods that its streams serve: " + (served.empty() ? "none" : served) + "\n";
  for (const MethodFit& fit : fits)
    if (!fit.serves()) text += "    not " + id_of(fit) + ": it " + fit.lack + "\n";
  return text;
}

/// Where the method that is taken when none is asked for cannot be.
std::string usable_by_others(const SessionReport& report) {
  return "  usable: not by the default method, " + std::string(kPairwise) +
         "; with --method: " + methods_served(report.methods, false) + "\n";
}

/// What the motion can tell, and whether that is worth a calibration.
std::string usable_lines(const SessionReport& report) {
  if (!report.usable) {
    const bool as_machine = !serves_a_vehicle(report) && serves(report, MethodChoice::Slew);
    return std::string("  usable: no") +
           (as_machine ? ", unless it is a recording of an excavator (--method slew)\n" : "\n");
  }
  if (!serves(report, MethodChoice::Pairwise)) return usable_by_others(report);
  if (!report.outlook.judged) return "  usable: yes\n";
  // What may come out either way is neither promised nor denied.
  std::array<bool, 6> sure{}, possible{};
  for (std::size_t i = 0; i < sure.size(); ++i) {
    sure[i] = report.outlook.determinable[i] && !report.outlook.open[i];
    possible[i] = report.outlook.determinable[i] || report.outlook.open[i];
  }
  const std::string told = parameter_names(sure, true), untold = parameter_names(possible, false),
                    open = parameter_names(report.outlook.open, true);
  const std::string perhaps = open.empty() ? "" : "; perhaps " + open;
  const bool lacking = report.outlook.needs_nominal;
  std::string text = std::string("  the motion can tell") + (lacking ? ", with a nominal mounting: " : ": ") +
                     (told.empty() ? "nothing for sure" : told) +
                     (open.empty() ? "" : "; as the scans align, perhaps: " + open) +
                     (untold.empty() ? "" : "; it cannot tell: " + untold) + "\n";
  for (const Message& advice : report.outlook.advice) text += "  advice: " + english(advice) + "\n";
  if (lacking)
    text +=
        "  advice: Give a nominal mounting (some 10 degrees are enough): while yaw is open, nothing is known without "
        "one.\n";
  if (untold.empty() && open.empty()) return text + "  usable: yes\n";
  return text + "  usable: in part" + (lacking ? " and only with a nominal mounting" : "") +
         (told.empty() ? "" : ", for " + told) + perhaps + (untold.empty() ? "" : "; not for " + untold) + "\n";
}

/// A name that must not look like more than one line.
std::string on_one_line(std::string_view name) { return printable(name, LineBreaks::Escaped); }

/// The topics of a bag: count, rate, and what each is used as or could be.
std::string topic_lines(const Session& session) {
  std::string text = session.topics.empty() ? "" : "  topics:\n";
  const auto joined = [](const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
  };
  for (const SessionTopic& topic : session.topics) {
    text += "    " + on_one_line(topic.name) + " (" + on_one_line(topic.type) + "): " + std::to_string(topic.count);
    if (topic.rate_hz > 0.0) text += ", " + number(topic.rate_hz, 1) + " Hz";
    if (!topic.used_as.empty())
      text += ", used as " + joined(topic.used_as);
    else if (!topic.can_be.empty())
      text += ", not used; could be " + joined(topic.can_be);
    text += "\n";
  }
  return text;
}

std::string stream_line(const std::string& name, const StreamReport& stream) {
  if (stream.count == 0) return "  " + name + ": none\n";
  std::string line = "  " + name + ": " + std::to_string(stream.count) + ", " + utc_text(stream.first_ns) + " to " +
                     utc_text(stream.last_ns) + " (" + number(stream.span_s(), 3) + " s)";
  if (stream.rate_hz > 0.0) line += ", " + number(stream.rate_hz, 1) + " Hz";
  line += stream.gaps == 0 ? ", no gaps"
                           : ", " + number_of(stream.gaps, "gap", "gaps") + ", the longest " +
                                 number(stream.longest_gap_s, 3) + " s";
  return line + "\n";
}

}  // namespace

std::string utc_text(std::int64_t stamp_ns) {
  using namespace std::chrono;
  const sys_time<nanoseconds> time{nanoseconds(stamp_ns)};
  const auto day = floor<days>(time);
  const year_month_day date(day);
  const hh_mm_ss clock(floor<milliseconds>(time - day));
  char text[64];
  std::snprintf(text, sizeof(text), "%04d-%02u-%02u %02d:%02d:%02d.%03d UTC", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()),
                static_cast<int>(clock.seconds().count()), static_cast<int>(clock.subseconds().count()));
  return text;
}

std::vector<std::int64_t> lidar_stamps_ns(const Session& session) {
  std::vector<std::int64_t> stamps;
  if (session.scans)
    for (std::size_t i = 0; i < session.scans->size(); ++i) stamps.push_back(session.scans->stamp_ns(i));
  for (const StampedPose& pose : session.odometry_from_lidar) stamps.push_back(pose.stamp_ns);
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

SessionReport report_session(const Session& session, Progress& progress) {
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
  for (Finding& finding : drive_findings(session)) add_new(report, std::move(finding));
  judge(session, report, progress);
  return report;
}

std::string describe(const Session& session, const SessionReport& report) {
  std::string text = on_one_line(session.path.string()) + "\n  format: " + session.format + "\n" + topic_lines(session);
  text += stream_line(session.scans ? "scans" : "LiDAR poses", report.lidar);
  text += stream_line(session.ins.empty() ? "INS poses" : "INS samples", report.ins);
  for (const auto& [name, stream] : {std::pair{"IMU", &report.imu},
                                     {"GNSS", &report.gnss},
                                     {"wheels", &report.wheels},
                                     {"barometer", &report.barometer}})
    if (stream->count > 0) text += stream_line(name, *stream);
  if (report.ins.count > 0)  // without, there is nothing to lie within, and no motion that is known
    text += "  scans within the INS data: " + std::to_string(report.lidar_covered) + " of " +
            std::to_string(report.lidar.count) + "\n  motion: " + number(report.travelled_m, 1) +
            " m travelled, turned by up to " + number(report.turned_deg, 1) + " deg\n";
  if (session.scans) {
    constexpr const char* kTiming[] = {"taken at once, or already compensated", "time of every point is known",
                                       "time of a point follows from its azimuth",
                                       "not known: a calibration tries how the scans were swept"};
    text += std::string("  motion within a scan: ") + kTiming[static_cast<int>(session.scan_timing)] +
            "\n  points in a scan (" + std::to_string(report.points.size()) + " of " +
            std::to_string(report.lidar.count) + " scans were read):";
    for (const std::size_t points : report.points) text += " " + std::to_string(points);
    text += "\n";
  }
  if (session.nominal_ins_from_lidar) text += "  nominal mounting: declared\n";
  constexpr const char* kSeverity[] = {"note", "warning", "problem"};
  for (const Finding& finding : report.findings) {
    text += std::string("  ") + kSeverity[static_cast<int>(finding.severity)] + " [" + finding.code + "] " +
            on_one_line(finding.where) + ": " + english(finding.explanation) + "\n";
    if (const FindingKind* kind = finding_kind(finding.code))
      text += "    " + std::string(kind->meaning) + "\n    do: " + std::string(kind->remedy) + "\n";
  }
  return text + method_lines(report.methods) + usable_lines(report);
}

}  // namespace remount

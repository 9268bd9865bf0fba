#include <array>
#include <utility>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/core/index.h"
#include "algorithms/messages/render.h"
#include "messages/drives.h"
#include "model/checks/data_check.h"
#include "model/formats/files/printable_text.h"
#include "model/formats/files/time_stamp.h"
#include "model/overview/session_report.h"

namespace remount::overview {
namespace {

/// A name that must not look like more than one line.
std::string on_one_line(std::string_view name) { return formats::printable(name, formats::LineBreaks::Escaped); }
/// Words of the catalogue are one line.
Message place_on_one_line(const drive::Place& place) {
  const std::string* name = place.name();
  return name == nullptr ? place.words() : Message::verbatim(on_one_line(*name));
}

class Lines {
 public:
  void add(int depth, Message words) { lines_.push_back({depth, std::move(words)}); }

  void add_topics(const drive::Session& session) {
    if (!session.topics.empty()) add(1, say::session_topics());
    for (const drive::SessionTopic& topic : session.topics) {
      std::vector<Message> facts;
      if (topic.count > 0 || topic.can_be.empty()) facts.push_back(say::session_count(topic.count));
      if (topic.rate_hz > 0.0) facts.push_back(say::session_rate(Frequency{topic.rate_hz}));
      if (!topic.used_as.empty())
        facts.push_back(say::session_used_as(topic.used_as));
      else if (!topic.can_be.empty())
        facts.push_back(say::session_could_be(topic.can_be));
      add(2, say::session_topic(on_one_line(topic.name), on_one_line(topic.type), std::move(facts)));
    }
  }

  void add_stream(Message name, const StreamReport& stream) {
    if (stream.count == 0) return add(1, say::session_stream_none(std::move(name)));
    std::vector<Message> facts{say::session_count(stream.count),
                               say::session_time(formats::utc_text(stream.first_ns), formats::utc_text(stream.last_ns),
                                                 Duration{stream.span_s()})};
    if (stream.rate_hz > 0.0) facts.push_back(say::session_rate(Frequency{stream.rate_hz}));
    facts.push_back(stream.gaps == 0 ? say::session_no_gaps()
                                     : say::session_gaps(stream.gaps, Duration{stream.longest_gap_s}));
    add(1, say::session_stream(std::move(name), std::move(facts)));
  }

  void add_streams(const drive::Session& session, const SessionReport& report) {
    add_stream(session.scans ? say::session_scans() : say::session_lidar_poses(), report.lidar);
    add_stream(session.ins.empty() ? say::session_ins_poses() : say::session_ins_samples(), report.ins);
    const std::pair<Message (*)(), const StreamReport*> others[] = {{say::session_imu, &report.imu},
                                                                    {say::session_gnss, &report.gnss},
                                                                    {say::session_wheels, &report.wheels},
                                                                    {say::session_barometer, &report.barometer}};
    for (const auto& [name, stream] : others)
      if (stream->count > 0) add_stream(name(), *stream);
    if (report.ins.count == 0) return;  // there is nothing to lie within, and no motion that is known
    add(1, say::session_covered(report.lidar_covered, report.lidar.count));
    add(1, say::session_motion(Length{report.travelled_m}, Angle{degrees_to_radians(report.turned_deg)}));
  }

  void add_scans(const drive::Session& session, const SessionReport& report) {
    if (!session.scans) return;
    constexpr std::array<Message (*)(), 4> kTiming{say::session_timing_instant, say::session_timing_per_point,
                                                   say::session_timing_sweep, say::session_timing_unknown};
    add(1, say::session_timing(kTiming.at(index_of(session.scan_timing))()));
    std::vector<std::string> points;
    for (const std::size_t count : report.points) points.push_back(std::to_string(count));
    add(1, points.empty() ? say::session_points_unread(report.lidar.count)
                          : say::session_points(points.size(), report.lidar.count, points));
  }

  void add_finding(const drive::Finding& finding) {
    constexpr std::array<Message (*)(), 3> kSeverities{say::session_note, say::session_warning, say::session_problem};
    add(1, say::session_finding(kSeverities.at(index_of(finding.severity))(), finding.code,
                                place_on_one_line(finding.where), finding.explanation));
    const checks::FindingKind* kind = checks::finding_kind(finding.code);
    if (kind == nullptr) return;
    add(2, kind->meaning());
    add(2, say::session_do(kind->remedy()));
  }

  std::vector<ReportLine> take() { return std::move(lines_); }

 private:
  std::vector<ReportLine> lines_;
};

std::string id_of(const method_registry::MethodFit& fit) { return std::string(fit.method->id); }

/// "trajectory (the antenna's lever arm alone)", "slew if it is a recording of an excavator".
std::vector<Message> methods_served(const std::vector<method_registry::MethodFit>& fits, bool with_provisos) {
  std::vector<Message> served;
  for (const method_registry::MethodFit& fit : fits) {
    if (!fit.serves() || (!with_provisos && !fit.proviso.empty())) continue;
    Message method = Message::verbatim(id_of(fit));
    if (!fit.limit.empty()) method = say::method_limited(std::move(method), fit.limit);
    if (!fit.proviso.empty()) method = say::method_provided(std::move(method), fit.proviso);
    served.push_back(std::move(method));
  }
  return served;
}

/// For which methods the streams are there, and what the others lack.
void add_methods(const std::vector<method_registry::MethodFit>& fits, Lines& lines) {
  std::vector<Message> served = methods_served(fits, true);
  lines.add(1, served.empty() ? say::session_no_method() : say::session_methods(std::move(served)));
  for (const method_registry::MethodFit& fit : fits)
    if (!fit.serves()) lines.add(2, say::session_not_method(id_of(fit), fit.lack));
}

/// Nothing of no parameters.
Message of_parameters(Message (*words)(std::vector<Message>), std::vector<Message> parameters) {
  return parameters.empty() ? Message() : words(std::move(parameters));
}

/// What the motion can tell, and whether that is worth a calibration.
void add_outlook(const MotionOutlook& outlook, Lines& lines) {
  // What may come out either way is neither promised nor denied.
  const std::vector<Message> told = calibration::parameter_words(outlook.determinable & ~outlook.open),
                             untold = calibration::parameter_words(~outlook.determinable & ~outlook.open),
                             open = calibration::parameter_words(outlook.open);
  const bool lacking = outlook.needs_nominal;
  lines.add(1, (lacking ? say::session_motion_tells_with_nominal : say::session_motion_tells)(
                   told.empty() ? say::session_nothing_told() : say::session_told(told),
                   of_parameters(say::session_perhaps_told, open), of_parameters(say::session_untold, untold)));
  for (const Message& advice : outlook.advice) lines.add(1, say::session_advice(advice));
  if (lacking) lines.add(1, say::session_advice(say::session_give_nominal()));
  if (untold.empty() && open.empty()) return lines.add(1, say::session_usable());
  lines.add(1, (lacking ? say::session_usable_in_part_with_nominal : say::session_usable_in_part)(
                   of_parameters(say::session_usable_for, told), of_parameters(say::session_usable_perhaps, open),
                   of_parameters(say::session_usable_not_for, untold)));
}

/// Null: there is none.
const method_registry::CalibrationMethod* other_machine_served(const std::vector<method_registry::MethodFit>& fits) {
  for (const method_registry::MethodFit& fit : fits)
    if (fit.serves() && fit.method->for_other_machine()) return fit.method;
  return nullptr;
}

void add_use(const SessionReport& report, Lines& lines) {
  if (!report.usable) {
    const method_registry::CalibrationMethod* machine =
        report.serves_a_vehicle() ? nullptr : other_machine_served(report.methods);
    lines.add(1, machine ? machine->other_machine.or_else() : say::session_unusable());
  } else if (!report.serves(method_registry::default_method())) {
    lines.add(1, say::session_usable_by_others(std::string(method_registry::default_method().id),
                                               methods_served(report.methods, false)));
  } else if (!report.outlook.judged) {
    lines.add(1, say::session_usable());
  } else {
    add_outlook(report.outlook, lines);
  }
}

}  // namespace

std::vector<ReportLine> report_lines(const drive::Session& session, const SessionReport& report) {
  Lines lines;
  lines.add(0, Message::verbatim(on_one_line(session.path.string())));
  lines.add(1, say::session_format(session.format));
  lines.add_topics(session);
  lines.add_streams(session, report);
  lines.add_scans(session, report);
  if (session.nominal_ins_from_lidar) lines.add(1, say::session_nominal());
  for (const drive::Finding& finding : report.findings) lines.add_finding(finding);
  add_methods(report.methods, lines);
  add_use(report, lines);
  return lines.take();
}

std::string describe(const drive::Session& session, const SessionReport& report, Language language) {
  std::string text;
  for (const ReportLine& line : report_lines(session, report))
    text += std::string(2 * static_cast<std::size_t>(line.depth), ' ') + render(line.words, language) + "\n";
  return text;
}

}  // namespace remount::overview

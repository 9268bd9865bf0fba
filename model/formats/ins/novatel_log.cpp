#include "model/formats/ins/novatel_log.h"

#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/random_access_file.h"
#include "model/formats/files/text_file.h"
#include "model/formats/ins/novatel_csv.h"
#include "model/formats/ins/novatel_survey.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kNovatelHeadBytes = std::size_t{1} << 20;

/// A bag may hold a receiver's bytes as messages, and is a bag all the same.
bool is_container(std::string_view head) {
  return head.starts_with("#ROSBAG") || head.starts_with("\x89MCAP") || head.starts_with("SQLite format 3");
}

/// A binary log is one by its checksum; an ASCII log by that, or by what only a log of an INS has.
bool is_novatel(std::string_view head, bool binary) {
  NovatelScanner scanner(head);
  for (NovatelFrame frame; scanner.next(frame);) {
    const bool whole = frame.problem.empty();
    if (frame.binary && binary && whole) return true;
    if (frame.binary || frame.type == nullptr) continue;
    const NovatelUse use = frame.type->use;
    // One that is mentioned in a text has no header.
    const bool of_ins = (use == NovatelUse::Inspvax || use == NovatelUse::Inspva) && !frame.header.empty();
    if (of_ins || (whole && (use == NovatelUse::Bestpos || use == NovatelUse::RawImu))) return true;
  }
  return false;
}

/// What is to be read of a recording, by its survey.
struct NovatelChoice {
  std::string solution, fixes, imu;
  std::vector<std::string> errors;
};

const char* const kGnssAlone = "BESTGNSSPOS";

std::size_t usable_of(const NovatelSurvey& survey, const std::string& name) {
  const auto found = survey.logs.find(name);
  return found == survey.logs.end() ? 0 : found->second.usable;
}

NovatelChoice choose_novatel(const NovatelSurvey& survey, bool fixes_alone) {
  NovatelChoice choice;
  if (!fixes_alone) choice.imu = survey.most_of({NovatelUse::RawImu});
  if (!fixes_alone) choice.solution = survey.most_of({NovatelUse::Inspvax, NovatelUse::Inspva});
  // BESTPOS may be the INS itself.
  if (choice.solution.empty())
    choice.fixes = usable_of(survey, kGnssAlone) > 0 ? kGnssAlone : survey.most_of({NovatelUse::Bestpos});
  const auto taken = survey.logs.find(choice.solution);
  if (taken == survey.logs.end() || taken->second.use == NovatelUse::Inspvax) return choice;
  for (const auto& [name, count] : survey.logs)
    if ((count.use == NovatelUse::Inspvax || count.use == NovatelUse::Insstdev) && count.usable > 0)
      choice.errors.push_back(name);
  return choice;
}

/// Reads what was chosen; what is broken has been counted by the survey.
class NovatelCollector {
 public:
  NovatelCollector(const NovatelChoice& choice, NovatelLog& log) : choice_(choice), log_(log) {}

  void read(const NovatelRecording& recording) {
    NovatelScanner scanner(recording.bytes());
    for (NovatelFrame frame; scanner.next(frame);) {
      if (!frame.problem.empty() || frame.type == nullptr || frame.type->use == NovatelUse::None) continue;
      try {
        take(frame);
      } catch (const Error&) {
        continue;
      }
    }
    report_misnamed(misnamed_, recording.path().string(), log_.findings);
  }

 private:
  void take(const NovatelFrame& frame) {
    const std::string name = novatel_name(frame);
    if (name == choice_.solution) {
      const auto solution = bodies_.solution(frame, {});
      if (solution) log_.ins.push_back(solution->sample);
      misnamed_ += solution && solution->misnamed;
      log_.without_solution += !solution;
    } else if (name == choice_.fixes) {
      const auto fix = bodies_.fix(frame, {});
      if (fix) log_.fixes.push_back(*fix);
      log_.without_fix += !fix;
    } else if (name == choice_.imu) {
      if (const auto imu = bodies_.raw_imu(frame, {})) log_.imu.push_back(imu->sample);
    } else if (std::ranges::find(choice_.errors, name) != choice_.errors.end()) {
      take_errors(frame);
    }
  }
  void take_errors(const NovatelFrame& frame) {
    if (frame.type->use == NovatelUse::Insstdev) {
      const StampedSigma stated = bodies_.errors(frame, {});
      if (states_any(stated.sigma)) log_.errors.push_back(stated);
      return;
    }
    const auto solution = bodies_.solution(frame, {});
    // Before it has aligned an INS states zeros.
    if (!solution || solution->sample.quality == motion::InsQuality::Invalid) return;
    log_.errors.push_back({solution->sample.stamp_ns, solution->sample.sigma});
  }

  const NovatelChoice& choice_;
  NovatelLog& log_;
  NovatelBodies bodies_;
  std::size_t misnamed_ = 0;
};

/// What of a log was taken and what was not; nothing where there was nothing to choose.
void tell_novatel(const NovatelLog& log, std::size_t without_errors, std::vector<drive::Finding>& findings) {
  constexpr Duration kNear{static_cast<double>(kNearErrors_ns) * 1e-9};
  std::vector<Message> told;
  told.push_back(log.fixes_were_asked ? say::novatel_fixes_taken(log.fixes.size(), log.taken)
                 : log.ins.empty()    ? say::novatel_fixes_alone(log.fixes.size(), log.taken)
                                      : say::novatel_taken(log.taken, log.ins.size()));
  if (!log.ins.empty() && !log.states_errors) {
    const bool none = without_errors == log.ins.size();
    told.push_back(none ? say::novatel_no_errors(kNear) : say::novatel_errors_of(log.error_logs, kNear));
    if (!none && without_errors > 0) told.push_back(say::novatel_errors_missing(without_errors));
  }
  if (!log.imu_told.empty()) told.push_back(log.imu_told);
  if (log.without_solution > 0) told.push_back(say::novatel_without_solution(log.without_solution));
  if (!log.not_used.empty()) told.push_back(say::novatel_not_used(log.not_used));
  if (log.stray_bytes > 0) told.push_back(say::novatel_stray(Bytes{log.stray_bytes}));
  if (told.size() > 1 || log.ins.empty())
    findings.push_back(drive::make_finding(drive::Severity::Note, "ins-log-chosen", log.path.string(),
                                           Message::sequence(std::move(told))));
}

/// Counts become rates and forces, or are passed over with the reason.
void settle_imu(const NovatelSurvey& survey, const std::string& imu, NovatelLog& log) {
  if (log.imu.empty()) return;
  drive::keep_ascending(log.imu, "imu", log.path.string(), log.findings);
  const std::size_t count = log.imu.size();
  log.imu_told = scale_raw_imu(survey.imu_types, imu, log.imu);
  if (!log.imu.empty()) log.imu_told = say::novatel_imu_taken(imu, count, survey.imu_types.names().front());
}

/// Why a recording without a solution and without fixes is of no use.
Message nothing_to_take(const NovatelSurvey& survey) {
  std::vector<std::string> there = survey.others({});
  if (there.empty()) return say::inspvax_none_usable();
  return survey.most_of({NovatelUse::RawImu}).empty() ? say::novatel_others(std::move(there))
                                                      : say::novatel_imu_alone(std::move(there));
}

NovatelLog read_recording(const fs::path& path, bool fixes_alone) {
  const NovatelRecording recording(path);
  const NovatelSurvey survey = survey_novatel(recording);
  const NovatelChoice choice = choose_novatel(survey, fixes_alone);
  NovatelLog log;
  log.path = path;
  log.fixes_were_asked = fixes_alone;
  if (choice.fixes.empty() && fixes_alone)
    throw Error(ErrorCode::Format, path.string(), survey.bad.after(say::novatel_no_fixes()));
  if (choice.fixes.empty() && choice.solution.empty())
    throw Error(ErrorCode::Format, path.string(), survey.bad.after(nothing_to_take(survey)));
  log.taken = choice.solution.empty() ? choice.fixes : choice.solution;
  const auto taken = survey.logs.find(choice.solution);
  log.states_errors = taken != survey.logs.end() && taken->second.use == NovatelUse::Inspvax;
  log.error_logs = choice.errors;
  // As much memory as is needed: a vector that grows has twice that, and the recording is still there.
  log.ins.reserve(usable_of(survey, choice.solution));
  log.fixes.reserve(usable_of(survey, choice.fixes));
  log.imu.reserve(usable_of(survey, choice.imu));
  std::size_t errors = 0;
  for (const std::string& name : choice.errors) errors += usable_of(survey, name);
  log.errors.reserve(errors);
  NovatelCollector(choice, log).read(recording);
  settle_imu(survey, choice.imu, log);
  survey.bad.report(log.findings, "bad-ins", path.string(),
                    recording.is_text() ? say::left_out_lines : say::left_out_logs);
  std::vector<std::string> used = choice.errors;
  used.insert(used.end(), {choice.solution, choice.fixes});
  if (!log.imu.empty()) used.push_back(choice.imu);
  log.not_used = survey.others(used);
  if (!recording.is_text()) log.stray_bytes = survey.stray_bytes;
  return log;
}

}  // namespace

std::optional<NovatelFormat> recognise_novatel(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, kNovatelHeadBytes);
    if (is_container(head)) return std::nullopt;
    if (holds_binary_sync(head) && is_novatel(head, true)) return NovatelFormat::Log;
    const std::string text = utf8_text(head);
    if (is_novatel(text, false)) return NovatelFormat::Log;
    if (is_inspvax_csv(text)) return NovatelFormat::BagCsv;
  } catch (const Error&) {
    // not readable: not recognised
  }
  return std::nullopt;
}

namespace {

/// What a part of a log tells: a motion, or raw measurements of an IMU.
struct NovatelHoldings {
  bool motion = false, raw_imu = false;
};

NovatelHoldings holdings_of(const std::string& part) {
  NovatelHoldings holds;
  const std::string bytes = holds_binary_sync(part) ? part : utf8_text(part);
  NovatelScanner scanner(bytes);
  for (NovatelFrame frame; !holds.motion && scanner.next(frame);) {
    if (!frame.problem.empty() || frame.type == nullptr) continue;
    const NovatelUse use = frame.type->use;
    holds.motion = use == NovatelUse::Inspvax || use == NovatelUse::Inspva || use == NovatelUse::Bestpos;
    holds.raw_imu = holds.raw_imu || use == NovatelUse::RawImu;
  }
  return holds;
}

}  // namespace

bool holds_raw_imu_alone(const fs::path& path) try {
  const NovatelHoldings first = holdings_of(read_file_head(path, kNovatelHeadBytes));
  if (first.motion || !first.raw_imu) return false;
  // A solution begins where the INS is aligned: the end of the log has it.
  const RandomAccessFile file(path);
  const std::uint64_t bytes = std::min<std::uint64_t>(file.size(), kNovatelHeadBytes);
  return !holdings_of(file.read(file.size() - bytes, bytes)).motion;
} catch (const Error&) {
  return false;  // not readable: not known
}

NovatelLog read_novatel_log(const fs::path& path, NovatelFormat format, bool fixes_alone) {
  return format == NovatelFormat::BagCsv ? read_inspvax_csv(path) : read_recording(path, fixes_alone);
}

void settle_novatel(NovatelLog& log, const std::vector<StampedSigma>& more, std::vector<drive::Finding>& findings) {
  const std::string where = log.path.string();
  findings.insert(findings.end(), std::make_move_iterator(log.findings.begin()),
                  std::make_move_iterator(log.findings.end()));
  log.findings.clear();
  if (!log.ins.empty()) {
    drive::keep_near(log.ins, where, findings);
    drive::keep_ascending(log.ins, "ins", where, findings);
  } else {
    if (log.without_fix > 0)
      findings.push_back(
          drive::make_finding(drive::Severity::Note, "no-fix", where, say::novatel_without_fix(log.without_fix)));
    if (!log.fixes.empty()) drive::keep_near(log.fixes, where, findings);
    if (!log.fixes.empty()) drive::keep_ascending(log.fixes, "gnss", where, findings);
  }
  std::size_t without = 0;
  if (!log.states_errors) {
    log.errors.insert(log.errors.end(), more.begin(), more.end());
    std::ranges::stable_sort(log.errors, {}, &StampedSigma::stamp_ns);
    without = give_errors(log.ins, log.errors);
  }
  tell_novatel(log, without, findings);
}

NovatelLog read_novatel(const fs::path& path, NovatelFormat format, std::vector<drive::Finding>& findings) {
  NovatelLog log = read_novatel_log(path, format);
  settle_novatel(log, {}, findings);
  return log;
}

std::vector<motion::GnssFix> read_novatel_fixes(const fs::path& path, std::vector<drive::Finding>& findings) {
  NovatelLog log = read_novatel_log(path, NovatelFormat::Log, true);
  settle_novatel(log, {}, findings);
  return std::move(log.fixes);
}

std::vector<motion::ImuSample> read_novatel_imu(const fs::path& path, std::vector<drive::Finding>& findings) {
  const NovatelRecording recording(path);
  const NovatelSurvey survey = survey_novatel(recording);
  NovatelChoice choice;
  choice.imu = survey.most_of({NovatelUse::RawImu});
  if (choice.imu.empty()) throw Error(ErrorCode::Format, path.string(), survey.bad.after(say::novatel_no_imu()));
  NovatelLog log;
  log.path = path;
  log.imu.reserve(usable_of(survey, choice.imu));
  NovatelCollector(choice, log).read(recording);
  settle_imu(survey, choice.imu, log);
  if (log.imu.empty()) throw Error(ErrorCode::Format, path.string(), log.imu_told);
  survey.bad.report(log.findings, "bad-imu", path.string(),
                    recording.is_text() ? say::left_out_lines : say::left_out_logs);
  findings.insert(findings.end(), std::make_move_iterator(log.findings.begin()),
                  std::make_move_iterator(log.findings.end()));
  findings.push_back(drive::make_finding(drive::Severity::Note, "ins-log-chosen", path.string(), log.imu_told));
  return std::move(log.imu);
}

}  // namespace remount::formats

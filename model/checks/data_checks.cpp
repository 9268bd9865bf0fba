#include <algorithm>

#include "model/checks/builtin.h"
#include "model/checks/data_check.h"

namespace remount::checks {
namespace {

bool matches(std::string_view pattern, std::string_view code) {
  if (pattern.starts_with('*')) return code.ends_with(pattern.substr(1));
  if (pattern.ends_with('*')) return code.starts_with(pattern.substr(0, pattern.size() - 1));
  return pattern == code;
}

}  // namespace

const std::vector<DataCheck>& data_checks() {
  static const std::vector<DataCheck> checks{
      ins_solution_check(),  frozen_part_check(),   held_part_check(),   ins_jump_check(),   rtk_check(),
      drive_variety_check(), attitude_data_check(), unit_check(),        clock_check(),      stamp_check(),
      scan_check(),          handedness_check(),    bag_stream_check(),  capture_check(),    log_reading_check(),
      pose_check(),          reading_check(),       calibration_check(), method_run_check(),
  };
  return checks;
}

const FindingKind* finding_kind(std::string_view code) {
  for (const DataCheck& check : data_checks())
    for (const FindingKind& kind : check.kinds)
      if (matches(kind.code, code)) return &kind;
  return nullptr;
}

std::vector<drive::Finding> drive_findings(const drive::Session& session) {
  std::vector<drive::Finding> findings;
  const CheckedSession checked{session, conventions::MetricPoses(session)};
  for (const DataCheck& check : data_checks())
    if (check.look != nullptr && check.of_the_drive) check.look(checked, findings, Progress());
  return findings;
}

namespace {

/// What was measured of the INS: a jump that is interpolated is none any more.
drive::Session without_interpolated(drive::Session session) {
  const std::vector<std::int64_t>& fixes_ns = session.ins_fix_stamps_ns;
  const auto interpolated = [&](const auto& sample) {
    return !std::binary_search(fixes_ns.begin(), fixes_ns.end(), sample.stamp_ns);
  };
  std::erase_if(session.ins, interpolated);
  std::erase_if(session.world_from_ins, interpolated);
  session.ins_fix_stamps_ns.clear();
  return session;
}

std::vector<drive::Finding> findings_of_measured(const drive::Session& session, LookAt look_at,
                                                 const Progress& progress) {
  std::vector<drive::Finding> findings;
  const CheckedSession checked{session, conventions::MetricPoses(session)};
  for (const DataCheck& check : data_checks()) {
    if (progress.cancelled()) break;
    if (check.look != nullptr && !check.of_the_drive && (look_at == LookAt::StreamsAndScans || !check.reads_scans))
      check.look(checked, findings, progress);
  }
  return findings;
}

}  // namespace

std::vector<drive::Finding> data_findings(const drive::Session& session, LookAt look_at, const Progress& progress) {
  return session.ins_fix_stamps_ns.empty() ? findings_of_measured(session, look_at, progress)
                                           : findings_of_measured(without_interpolated(session), look_at, progress);
}

}  // namespace remount::checks

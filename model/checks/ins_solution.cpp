// What the INS says of itself, and where it says nothing: status, gaps, one solution over and over.
#include <algorithm>

#include "algorithms/core/median.h"
#include "messages/checks.h"
#include "messages/places.h"
#include "model/checks/builtin.h"
#include "model/checks/check_times.h"

namespace remount::checks {
namespace {

constexpr double kShortestGap_s = 0.1;
constexpr double kFrozen_s = 1.0;

double longest_frozen_s(const conventions::MetricPoses& poses) {
  double longest = 0.0;
  std::size_t since = 0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    if (!(poses[i].pose.matrix() == poses[since].pose.matrix())) since = i;
    longest = std::max(longest, seconds_between(poses[since].stamp_ns, poses[i].stamp_ns));
  }
  return longest;
}

/// Stretches of samples that the INS itself does not call good.
struct Doubted {
  std::size_t degraded = 0, invalid = 0, stretches = 0;
  double longest_s = 0.0;
};

Doubted find_doubts(const std::vector<motion::InsSample>& ins) {
  Doubted found;
  std::size_t since = 0;
  bool within = false;
  for (std::size_t i = 0; i < ins.size(); ++i) {
    found.degraded += ins[i].quality == motion::InsQuality::Degraded;
    found.invalid += ins[i].quality == motion::InsQuality::Invalid;
    const bool bad = ins[i].quality == motion::InsQuality::Degraded || ins[i].quality == motion::InsQuality::Invalid;
    if (bad && !within) ++found.stretches, since = i;
    within = bad;
    if (bad) found.longest_s = std::max(found.longest_s, seconds_between(ins[since].stamp_ns, ins[i].stamp_ns));
  }
  return found;
}

void report_status(const std::vector<motion::InsSample>& ins, std::vector<drive::Finding>& findings) {
  const Doubted found = find_doubts(ins);
  if (found.degraded + found.invalid == 0) return;
  findings.push_back(
      {found.invalid > 0 ? drive::Severity::Warning : drive::Severity::Note, "ins-status", say::place_ins(),
       say::ins_status(found.degraded, ins.size(), found.invalid, found.stretches, Duration{found.longest_s})});
}

void report_gaps(const conventions::MetricPoses& poses, std::vector<drive::Finding>& findings) {
  std::vector<double> steps;
  steps.reserve(poses.size());
  for (std::size_t i = 1; i < poses.size(); ++i)
    steps.push_back(seconds_between(poses[i - 1].stamp_ns, poses[i].stamp_ns));
  if (steps.empty()) return;
  const double longest_allowed = std::max(3.0 * median_of(steps), kShortestGap_s);
  const auto gaps = std::count_if(steps.begin(), steps.end(), [&](double step) { return step > longest_allowed; });
  if (gaps == 0) return;
  findings.push_back({drive::Severity::Warning, "ins-gaps", say::place_ins(),
                      say::ins_gaps(gaps, Duration{*std::max_element(steps.begin(), steps.end())})});
}

void look_at_solution(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  report_status(checked.session.ins, findings);
  report_gaps(checked.poses, findings);
  const double frozen_s = longest_frozen_s(checked.poses);
  if (frozen_s > kFrozen_s)
    findings.push_back({drive::Severity::Warning, "ins-frozen", say::place_ins(), say::ins_frozen(Duration{frozen_s})});
}

}  // namespace

DataCheck ins_solution_check() {
  return {.kinds = {{"ins-gaps", say::ins_gaps_meaning, say::ins_gaps_remedy},
                    {"ins-status", say::ins_status_meaning, say::ins_status_remedy},
                    {"ins-frozen", say::ins_frozen_meaning, say::ins_frozen_remedy}},
          .look = look_at_solution};
}

}  // namespace remount::checks

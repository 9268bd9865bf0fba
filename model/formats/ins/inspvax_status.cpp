// What the INS says of its own solution in NovAtel's logs.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "messages/ins_logs.h"
#include "model/drive/bad_items.h"
#include "model/formats/ins/inspvax_log.h"

namespace remount::formats {

namespace {

/// The number of a name that is none of an INS but stands in the table of solution statuses of positions.
std::optional<std::size_t> number_in_wrong_table(std::string_view status) {
  constexpr std::array<std::string_view, 10> kPositionStatuses{
      "SOL_COMPUTED", "INSUFFICIENT_OBS", "NO_CONVERGENCE", "SINGULARITY", "COV_TRACE",
      "TEST_DIST",    "COLD_START",       "V_H_LIMIT",      "VARIANCE",    "RESIDUALS"};
  const auto found = std::find(kPositionStatuses.begin(), kPositionStatuses.end(), status);
  if (found == kPositionStatuses.end()) return std::nullopt;
  return static_cast<std::size_t>(found - kPositionStatuses.begin());
}

}  // namespace

bool is_of_wrong_table(std::string_view status) { return number_in_wrong_table(status).has_value(); }

void report_misnamed(std::size_t count, const std::string& where, std::vector<drive::Finding>& findings) {
  if (count == 0) return;
  findings.push_back(
      drive::make_finding(drive::Severity::Warning, "ins-status-misnamed", where, say::inspvax_misnamed(count)));
}

void give_errors(std::vector<motion::InsSample>& ins, const std::vector<motion::InsSample>& with_errors) {
  constexpr std::int64_t kNearErrors_ns = 2'000'000'000;
  if (with_errors.empty()) return;
  std::size_t next = 0;
  for (motion::InsSample& sample : ins) {
    const auto apart = [&](std::size_t i) { return std::abs(with_errors[i].stamp_ns - sample.stamp_ns); };
    while (next + 1 < with_errors.size() && apart(next + 1) <= apart(next)) ++next;
    if (apart(next) <= kNearErrors_ns) sample.sigma = with_errors[next].sigma;
  }
}

motion::InsQuality inspvax_quality(std::string_view status) {
  if (const auto number = number_in_wrong_table(status)) return inspvax_quality(std::to_string(*number));
  // Numbers in bags and their CSVs, names in ASCII logs (OEM6/OEM7 manuals, "Inertial Solution Status").
  if (status == "3" || status == "INS_SOLUTION_GOOD") return motion::InsQuality::Good;
  if (status == "2" || status == "INS_HIGH_VARIANCE" || status == "6" || status == "INS_SOLUTION_FREE" ||
      status == "7" || status == "INS_ALIGNMENT_COMPLETE")
    return motion::InsQuality::Degraded;
  return motion::InsQuality::Invalid;
}

}  // namespace remount::formats

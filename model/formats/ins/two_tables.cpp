#include "model/formats/ins/two_tables.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "algorithms/core/stamps.h"
#include "messages/ins_logs.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/ins/position_lag_prior.h"

namespace remount::formats {
namespace {

constexpr double kClearlyRarer = 1.5;

struct FromTables {
  std::vector<motion::InsSample> ins;
  std::size_t alone = 0;  ///< left out, for nothing lies beside it
  std::size_t of_one_stamp = 0;
};

FromTables at_positions(std::vector<motion::InsSample> positions, const std::vector<StampedAttitude>& attitudes) {
  const double longest_s = longest_turn_s(attitudes);
  FromTables out;
  for (motion::InsSample& sample : positions) {
    const auto attitude = attitude_at(attitudes, sample.stamp_ns, longest_s);
    if (!attitude) {
      ++out.alone;
      continue;
    }
    out.of_one_stamp += attitude->of_this_stamp;
    sample.enu_from_ins = attitude->enu_from_ins;
    sample.sigma.attitude_rad = attitude->sigma_rad;
    out.ins.push_back(std::move(sample));
  }
  return out;
}

FromTables at_attitudes(const std::vector<motion::InsSample>& positions,
                        const std::vector<StampedAttitude>& attitudes) {
  const double longest_s = longest_way_s(positions);
  FromTables out;
  for (const StampedAttitude& attitude : attitudes) {
    const auto after = std::ranges::lower_bound(positions, attitude.stamp_ns, {}, &motion::InsSample::stamp_ns);
    const bool exact = after != positions.end() && after->stamp_ns == attitude.stamp_ns;
    if (exact) {
      ++out.of_one_stamp;
      out.ins.push_back(*after);
      out.ins.back().enu_from_ins = attitude.enu_from_ins;
      out.ins.back().sigma.attitude_rad = attitude.sigma_rad;
    } else if (after == positions.begin() || after == positions.end() ||
               seconds(after->stamp_ns - (after - 1)->stamp_ns) > longest_s) {
      ++out.alone;
    } else {
      out.ins.push_back(
          sample_between(positions, static_cast<std::size_t>(after - positions.begin()) - 1, attitude, longest_s));
    }
  }
  return out;
}

}  // namespace

JoinedMotion join_tables(std::vector<motion::InsSample> positions, const std::vector<StampedAttitude>& attitudes,
                         const std::string& where, std::vector<drive::Finding>& findings) {
  const std::int64_t first_ns = std::max(positions.front().stamp_ns, attitudes.front().stamp_ns);
  const std::int64_t last_ns = std::min(positions.back().stamp_ns, attitudes.back().stamp_ns);
  if (first_ns > last_ns)
    throw Error(ErrorCode::Format, where, say::ins_tables_apart(Duration{seconds(first_ns - last_ns)}));
  const double position_s = drive::median_period_s(positions), attitude_s = drive::median_period_s(attitudes);
  const bool rare_attitudes = attitude_s > kClearlyRarer * position_s;
  FromTables joined =
      rare_attitudes ? at_attitudes(positions, attitudes) : at_positions(std::move(positions), attitudes);
  if (joined.ins.empty()) throw Error(ErrorCode::Format, where, say::ins_tables_apart(Duration{0.0}));
  if (joined.alone > 0)
    findings.push_back(drive::make_finding(
        drive::Severity::Warning, "ins-incomplete", where,
        rare_attitudes ? say::ins_attitudes_alone(joined.alone) : say::ins_positions_alone(joined.alone)));
  JoinedMotion out;
  out.position_lag_sigma_s = position_lag_sigma_s(joined.ins.size(), joined.of_one_stamp);
  if (rare_attitudes) {
    out.ins = std::move(joined.ins);
    return out;
  }
  SamplesBetweenFixes between = samples_between_fixes(std::move(joined.ins), attitudes);
  out.ins = std::move(between.ins);
  out.fix_stamps_ns = std::move(between.fix_stamps_ns);
  return out;
}

}  // namespace remount::formats

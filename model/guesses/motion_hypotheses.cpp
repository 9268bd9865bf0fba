#include "model/guesses/motion_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <utility>

#include "algorithms/geometry/degree.h"
#include "algorithms/geometry/rotation.h"

namespace remount::guesses {
namespace {

/// What the heading is off, and what makes a reading unlikely in the same measure.
double score_of(const PositionReading& position, const AttitudeReading& attitude, const TravelFit& fit) {
  constexpr double kUpright = 0.8, kNotUpright_rad = 60.0 * kDegree_rad, kUnusual_rad = 0.5 * kDegree_rad,
                   kOfOffset = 0.02, kOfTilt = 0.1, kBuiltIn_rad = 20.0 * kDegree_rad;
  // A box may look any way that it is built in, before a column counts otherwise than a name says that tells how.
  const bool as_named = attitude.telling_name && attitude.usual_for_name && is_set_square(fit);
  const double offset_rad = as_named ? std::min(size_of_offset(fit), kBuiltIn_rad) : size_of_offset(fit);
  double score_rad = fit.residual_rad + kOfOffset * offset_rad;
  // No drive tells roll; a vehicle leans little.
  if (!attitude.by_name) score_rad += kOfTilt * std::acos(std::clamp(fit.upright, -1.0, 1.0));
  if (position.exchanged && position.geodetic) score_rad += 4.0 * kUnusual_rad;  // names say otherwise
  if (fit.upright < kUpright) score_rad += kNotUpright_rad;
  if (!attitude.usual_for_name) score_rad += kUnusual_rad;
  if (position.exchanged && !position.geodetic && fit.slope == SlopeFit::Opposite)
    score_rad += 0.5 * kUnusual_rad;  // it counts down
  if (!attitude.by_name && fit.slope == SlopeFit::Unrelated) score_rad += kUnusual_rad;
  if (!attitude.by_name && fit.slope == SlopeFit::Opposite) score_rad += 0.5 * kUnusual_rad;
  return score_rad;
}

std::vector<std::size_t> attitude_columns(const SampledTable& table, const ColumnNames& names) {
  constexpr Quantity kAll[] = {Quantity::Roll, Quantity::Pitch, Quantity::Heading, Quantity::Yaw,
                               Quantity::Qx,   Quantity::Qy,    Quantity::Qz,      Quantity::Qw};
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].numeric && names[i] && std::ranges::find(kAll, names[i]->quantity) != std::end(kAll))
      columns.push_back(i);
  return columns;
}

/// Some twenty rows a second, which are enough for directions, of those that have a position and a value in all of the
/// columns: a log may give either in every fifth row, and of these none is to be missed.
std::vector<std::size_t> rows_of(const SampledTable& table, const TimeReading& time, const PositionReading& position,
                                 const std::vector<std::size_t>& columns) {
  constexpr double kEnough_hz = 20.0;
  std::vector<std::size_t> filled, rows;
  for (std::size_t row = 0; row < time.times_s.size(); ++row)
    if (position.metres[row].allFinite() &&
        std::ranges::all_of(columns, [&](std::size_t i) { return std::isfinite(table.columns[i].values[row]); }))
      filled.push_back(row);
  const double span_s = time.last_s - time.first_s;
  const double rate_hz = span_s > 0.0 ? static_cast<double>(filled.size()) / span_s : 0.0;
  const std::size_t stride = std::max<std::size_t>(1, static_cast<std::size_t>(rate_hz / kEnough_hz));
  for (std::size_t i = 0; i < filled.size(); i += stride) rows.push_back(filled[i]);
  return rows;
}

/// How far a position gets from where a stretch begins, sideways and along: what stands may tremble.
double reach_m(const std::vector<Eigen::Vector3d>& metres, std::span<const std::size_t> stretch) {
  const Eigen::Vector3d* from = nullptr;
  double reach = 0.0;
  for (const std::size_t row : stretch) {
    if (!metres[row].allFinite()) continue;
    if (from == nullptr) from = &metres[row];
    reach = std::max(reach, (metres[row] - *from).head<2>().norm());
  }
  return reach;
}

/// Stretches from all over the drive in which a position moves, for what is tried by the thousand. Where it moves in
/// few of them, those in which it moves most.
std::vector<std::size_t> some_stretches(const std::vector<std::size_t>& rows,
                                        const std::vector<Eigen::Vector3d>& metres) {
  constexpr std::size_t kStretches = 10, kRows = 200;
  constexpr double kMoves_m = 5.0;
  if (rows.size() <= kStretches * kRows) return rows;
  std::vector<std::pair<double, std::size_t>> stretches;  // how far, and where it begins
  for (std::size_t at = 0; at + kRows <= rows.size(); at += kRows)
    stretches.emplace_back(reach_m(metres, std::span(rows).subspan(at, kRows)), at);
  std::ranges::stable_sort(stretches, std::greater(), &std::pair<double, std::size_t>::first);
  const auto standing = std::ranges::find_if(stretches, [](const auto& one) { return one.first < kMoves_m; });
  const auto moving = std::max(static_cast<std::size_t>(standing - stretches.begin()), kStretches);
  stretches.resize(std::min(moving, stretches.size()));
  std::ranges::sort(stretches, {}, &std::pair<double, std::size_t>::second);
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < kStretches; ++i) {
    const std::size_t at = stretches[i * (stretches.size() - 1) / (kStretches - 1)].second;
    some.insert(some.end(), rows.begin() + static_cast<std::ptrdiff_t>(at),
                rows.begin() + static_cast<std::ptrdiff_t>(at + kRows));
  }
  return some;
}

/// Of thousands those whose columns fit some stretches best, with all ways to read these. Of columns that fit alike the
/// first.
std::vector<Hypothesis> likeliest_of(std::vector<Hypothesis> all) {
  constexpr std::size_t kKept = 16;
  using Columns = std::pair<const PositionReading*, std::vector<std::size_t>>;
  const auto columns_of = [](const Hypothesis& one) { return Columns(one.position, one.attitude.columns()); };
  std::map<Columns, double> scores_rad;
  for (const Hypothesis& one : all) {
    const auto [found, is_new] = scores_rad.try_emplace(columns_of(one), one.score_rad);
    if (!is_new) found->second = std::min(found->second, one.score_rad);
  }
  std::vector<std::pair<double, Columns>> sorted;
  for (const auto& [columns, score_rad] : scores_rad) sorted.emplace_back(score_rad, columns);
  std::ranges::stable_sort(sorted, {}, &std::pair<double, Columns>::first);
  for (std::size_t i = kKept; i < sorted.size(); ++i) scores_rad.erase(sorted[i].second);
  std::erase_if(all, [&](const Hypothesis& one) { return !scores_rad.contains(columns_of(one)); });
  return all;
}

/// Pitch that goes against the road counts the other way.
void settle_pitch(const SampledTable& table, const TimeReading& time, Hypothesis& one) {
  if (one.attitude.quaternion || one.fit.slope != SlopeFit::Opposite) return;
  Hypothesis other = one;
  other.attitude.signs[1] = -other.attitude.signs[1];
  other.fit = travel_fit(poses_of(table, time, *one.position, other.attitude,
                                  rows_of(table, time, *one.position, other.attitude.columns())));
  if (other.fit.slope == SlopeFit::Agrees) one = std::move(other);
}

}  // namespace

bool is_set_square(const TravelFit& fit) {
  constexpr double kSquare_rad = 15.0 * kDegree_rad;
  return std::abs(wrap_angle_rad(4.0 * fit.offset_rad)) < 4.0 * kSquare_rad;
}

double size_of_offset(const TravelFit& fit) { return std::abs(fit.offset_rad); }

bool moves(const Hypothesis& hypothesis) { return hypothesis.fit.steps >= kFewestTravelSteps; }

bool same_columns(const AttitudeReading& a, const AttitudeReading& b) { return a.columns() == b.columns(); }

std::vector<Hypothesis> hypotheses_of(const SampledTable& table, const ColumnNames& names, const TimeReading& time,
                                      const std::vector<PositionReading>& positions, const Progress& progress) {
  std::vector<Hypothesis> out;
  for (const PositionReading& position : positions)
    for (AttitudeReading& attitude : attitude_readings(table, names, time, position))
      out.push_back({&position, std::move(attitude), {}, 0.0});
  const std::vector<std::size_t> attitudes = attitude_columns(table, names);
  const auto rows = [&](const PositionReading& position) { return rows_of(table, time, position, attitudes); };
  const auto fit = [&](const PositionReading& position, const std::vector<std::size_t>& some) {
    for (Hypothesis& one : out) {
      if (one.position != &position || progress.cancelled()) continue;
      one.fit = travel_fit(poses_of(table, time, position, one.attitude, some));
      one.score_rad = score_of(position, one.attitude, one.fit);
    }
  };
  constexpr std::size_t kMany = 200;
  if (out.size() > kMany) {
    bool all_rows = true;
    for (const PositionReading& position : positions) {
      const std::vector<std::size_t> all = rows(position), some = some_stretches(all, position.metres);
      all_rows = all_rows && some.size() == all.size();
      fit(position, some);
    }
    out = likeliest_of(std::move(out));
    if (all_rows) return out;
  }
  for (const PositionReading& position : positions) fit(position, rows(position));
  return out;
}

void settle_pitches(const SampledTable& table, const TimeReading& time, const Hypothesis& best,
                    std::vector<Hypothesis>& all) {
  const std::vector<std::size_t> columns = best.attitude.columns();
  for (Hypothesis& one : all)
    if (one.attitude.columns() == columns) settle_pitch(table, time, one);
}

}  // namespace remount::guesses

#include "model/guesses/error_columns.h"

#include <algorithm>
#include <array>
#include <optional>

namespace remount::guesses {
namespace {

class ErrorColumns {
 public:
  ErrorColumns(const SampledTable& table, const ColumnNames& names) : table_(table), names_(names) {}

  std::optional<std::array<std::size_t, 3>> three(Quantity a, Quantity b, Quantity c) const {
    const auto first = find(a), second = find(b), third = find(c);
    if (!first || !second || !third) return std::nullopt;
    return std::array{*first, *second, *third};
  }
  std::optional<std::size_t> find(Quantity quantity) const { return column_called(names_, quantity); }
  bool all_in(const std::array<std::size_t, 3>& columns, const std::string& unit) const {
    return std::ranges::all_of(columns, [&](std::size_t column) {
      return table_.columns[column].numeric && (names_[column]->unit.empty() || names_[column]->unit == unit);
    });
  }

 private:
  const SampledTable& table_;
  const ColumnNames& names_;
};

Guess error_guess(const SampledTable& table, GuessKind kind, const std::array<std::size_t, 3>& at,
                  const std::string& unit) {
  Guess guess{kind, {}, unit, Sureness::Named, {}, {}};
  for (const std::size_t column : at) guess.columns.push_back(table.label(column));
  return guess;
}

}  // namespace

void put_errors(const SampledTable& table, const ColumnNames& names, ChosenMotion& chosen) {
  formats::InsTableLayout& layout = chosen.layout;
  if (layout.metric_position) return;  // poses have no room for them
  const ErrorColumns errors(table, names);
  if (const auto at = errors.three(Quantity::SigmaEast, Quantity::SigmaNorth, Quantity::SigmaUp);
      at && errors.all_in(*at, "m")) {
    layout.position_sigma_enu = {table.ref((*at)[0]), table.ref((*at)[1]), table.ref((*at)[2])};
    chosen.others.push_back(error_guess(table, GuessKind::PositionSigma, *at, "m"));
  }
  const std::string unit = layout.quaternion || layout.attitude_unit_rad == 1.0 ? "rad" : "deg";
  if (const auto at = errors.three(Quantity::SigmaHeading, Quantity::SigmaPitch, Quantity::SigmaRoll);
      at && errors.all_in(*at, unit)) {
    layout.attitude_sigma_yaw_pitch_roll = {table.ref((*at)[0]), table.ref((*at)[1]), table.ref((*at)[2])};
    chosen.others.push_back(error_guess(table, GuessKind::AttitudeSigma, *at, unit));
  }
  const auto quality = errors.find(Quantity::Quality);
  if (!quality) return;
  const std::vector<std::string>& texts = table.columns[*quality].texts;
  const auto known = [](const std::string& text) {
    return text == "unknown" || text == "good" || text == "degraded" || text == "invalid";
  };
  if (texts.empty() || !std::ranges::all_of(texts, known)) return;
  layout.quality = table.ref(*quality);
  chosen.others.push_back({GuessKind::Quality, {table.label(*quality)}, "", Sureness::Named, {}, {}});
}

}  // namespace remount::guesses

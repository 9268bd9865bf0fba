#include "model/guesses/no_value_number.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace remount::guesses {
namespace {

/// Whether a number lies so far from what a column else holds that it stands for none.
bool is_far_outside(double number, const std::vector<double>& values) {
  constexpr double kRanges = 2.0;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const double value : values)
    if (std::isfinite(value) && value != number) least = std::min(least, value), most = std::max(most, value);
  const double apart = number < least ? least - number : number - most;
  return least <= most && apart > kRanges * std::max(1.0, most - least);
}

}  // namespace

void find_no_value(SampledTable& table) {
  for (const double nines : {-9999.0, -99999.0, -999999.0, -999.0, 99999.0, 999999.0}) {
    for (const SampledColumn& column : table.columns)
      if (column.numeric && std::ranges::find(column.values, nines) != column.values.end() &&
          is_far_outside(nines, column.values))
        table.no_value_in.push_back(table.label(column.index));
    if (table.no_value_in.empty()) continue;
    table.text.no_value = nines;
    for (SampledColumn& column : table.columns) {
      std::ranges::replace(column.values, nines, std::numeric_limits<double>::quiet_NaN());
      column.numeric = column.numeric && std::ranges::any_of(column.values, [](double v) { return std::isfinite(v); });
    }
    return;
  }
}

}  // namespace remount::guesses

#include "model/formats/ins/heading_times.h"

#include <algorithm>

#include "algorithms/core/median.h"

namespace remount::formats {

void HeadingPlaces::add_time(std::int64_t time_ns) {
  if (waiting_) {
    places_.back().after_ns = time_ns;
    places_.back().inside = others_before_ < others_;
  }
  waiting_ = false;
  last_ns_ = time_ns;
  others_ = 0;
}

void HeadingPlaces::add_heading(double heading_rad) {
  if (!waiting_) {
    if (places_.empty()) positions_before_first_ = positions_;
    places_.push_back({last_ns_, kNone_ns, heading_rad, heading_rad, false});
    others_before_ = others_;
  }
  waiting_ = true;
  others_ = 0;
  places_.back().last_rad = heading_rad;
  positions_before_last_ = positions_;
}

HeadingOrder HeadingPlaces::order_by_period() const {
  std::vector<std::int64_t> steps_ns;
  for (std::size_t i = 1; i < places_.size(); ++i)
    if (places_[i - 1].before_ns != kNone_ns && places_[i].before_ns > places_[i - 1].before_ns)
      steps_ns.push_back(places_[i].before_ns - places_[i - 1].before_ns);
  if (steps_ns.empty()) return HeadingOrder::Unknown;
  const std::int64_t period_ns = median_of(std::move(steps_ns));
  const auto on_period = [&](std::int64_t time_ns) {
    constexpr std::int64_t kRounding_ns = 1'000'000;
    const std::int64_t rest = time_ns % period_ns;
    return rest <= kRounding_ns || rest >= period_ns - kRounding_ns;
  };
  std::size_t before = 0, after = 0;
  for (const Place& place : places_) {
    if (!place.between_epochs()) continue;
    before += on_period(place.before_ns);
    after += on_period(place.after_ns);
  }
  if (before > 2 * after) return HeadingOrder::Follows;
  return after > 2 * before ? HeadingOrder::Leads : HeadingOrder::Unknown;
}

HeadingOrder HeadingPlaces::order() const {
  std::size_t between = 0, open = 0, inside = 0;
  for (const Place& place : places_) {
    open += place.before_ns != place.after_ns;
    between += place.between_epochs();
    inside += place.between_epochs() && place.inside;
  }
  if (open == 0) return HeadingOrder::Follows;
  if (const HeadingOrder order = order_by_period(); order != HeadingOrder::Unknown) return order;
  const bool begins = positions_before_first_ == 0, ends = positions_before_last_ == positions_;
  if (begins != ends) return begins ? HeadingOrder::Leads : HeadingOrder::Follows;
  return 2 * inside > between ? HeadingOrder::Follows : HeadingOrder::Unknown;
}

HeadingTimes HeadingPlaces::times() const {
  HeadingTimes times;
  if (places_.empty()) return times;
  times.order = order();
  const bool leads = times.order == HeadingOrder::Leads;
  std::vector<TimedHeading>& headings = times.headings;
  headings.reserve(places_.size());
  for (const Place& place : places_) {
    // Of several in a row the one that stands closest to its epoch.
    const std::int64_t time_ns = leads ? place.after_ns : place.before_ns;
    if (time_ns != kNone_ns) headings.push_back({time_ns, leads ? place.last_rad : place.first_rad});
  }
  // Once for each time: an epoch may have headings between its sentences and behind them.
  std::stable_sort(headings.begin(), headings.end(),
                   [](const TimedHeading& a, const TimedHeading& b) { return a.time_ns < b.time_ns; });
  headings.erase(std::unique(headings.begin(), headings.end(),
                             [](const TimedHeading& a, const TimedHeading& b) { return a.time_ns == b.time_ns; }),
                 headings.end());
  return times;
}

}  // namespace remount::formats

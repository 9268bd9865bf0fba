// Times of headings (HDT), which have none of their own, from where they stand in an NMEA log.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace remount::formats {

/// Where receivers write the heading of an epoch.
enum class HeadingOrder { Follows, Leads, Unknown };

struct TimedHeading {
  std::int64_t time_ns = 0;
  double heading_rad = 0.0;
};

struct HeadingTimes {
  std::vector<TimedHeading> headings;  ///< ascending, one for each time
  HeadingOrder order = HeadingOrder::Follows;
};

/// Takes the sentences of a log in their order. A heading between two sentences of one time is of that time. Between
/// two epochs the sequence is the same again and again wherever it begins, and what tells is: times that are multiples
/// of the headings' period, where they are slower than the epochs; then the ends of the log: a heading before its first
/// position and none after the last leads, the other way about it follows; then other sentences of the epoch behind it.
/// What shows nothing is Unknown, and taken to follow.
class HeadingPlaces {
 public:
  void add_time(std::int64_t time_ns);
  /// Before its add_time.
  void add_position() { ++positions_; }
  void add_other() { ++others_; }
  void add_heading(double heading_rad);
  HeadingTimes times() const;
  std::size_t count() const { return places_.size(); }
  void reserve(std::size_t headings) { places_.reserve(headings); }

 private:
  static constexpr std::int64_t kNone_ns = std::numeric_limits<std::int64_t>::min();

  /// Headings in a row, between two sentences with a time.
  struct Place {
    std::int64_t before_ns = kNone_ns, after_ns = kNone_ns;
    double first_rad = 0.0, last_rad = 0.0;
    bool inside = false;  ///< closer to what stands before it
    bool between_epochs() const { return before_ns != kNone_ns && after_ns != kNone_ns && before_ns != after_ns; }
  };
  HeadingOrder order() const;
  HeadingOrder order_by_period() const;

  std::vector<Place> places_;
  bool waiting_ = false;  ///< no sentence with a time follows the last place yet
  std::int64_t last_ns_ = kNone_ns;
  std::size_t others_before_ = 0, others_ = 0;  ///< sentences before the last place and since, without a time
  std::size_t positions_ = 0, positions_before_first_ = 0, positions_before_last_ = 0;
};

}  // namespace remount::formats

#include "model/formats/ins/heading_times.h"

#include <gtest/gtest.h>

#include <string>

namespace remount::formats {
namespace {

constexpr std::int64_t kStep_ns = 100'000'000;

/// P: a position, the next epoch begins; t: another sentence of its time; o: one without time; H: a heading, numbered.
HeadingTimes times_of(const std::string& log) {
  HeadingPlaces places;
  std::int64_t time_ns = 0;
  double heading = 0.0;
  for (const char sentence : log) {
    if (sentence == 'P') places.add_position(), places.add_time(time_ns += kStep_ns);
    if (sentence == 't') places.add_time(time_ns);
    if (sentence == 'o') places.add_other();
    if (sentence == 'H') places.add_heading(++heading);
  }
  return places.times();
}

TEST(heading_times, follow_or_lead_as_the_log_shows) {
  using enum HeadingOrder;
  const std::pair<const char*, HeadingOrder> logs[] = {
      {"PHPHPHPH", Follows},   {"HPHPHPHP", Leads},       {"PtHPtHPtH", Follows},
      {"HPtHPtHPt", Leads},    {"PotHPotHPotH", Follows}, {"oHPootHPootHPoot", Leads},
      {"PHtPHtPHt", Follows},  {"PHPHPHP", Unknown},      {"HPHPHPH", Unknown},
      {"HPHoPHoPHo", Follows}, {"PPHPPHPPHP", Follows},   {"PHPPHPPHPP", Leads},
      {"oo", Follows},         {"PPP", Follows},
  };
  for (const auto& [log, order] : logs) EXPECT_EQ(times_of(log).order, order) << log;
}

TEST(heading_times, are_those_of_the_nearest_heading_once_for_each_time) {
  const HeadingTimes follows = times_of("PHHPHHPHH");
  ASSERT_EQ(follows.headings.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(follows.headings[i].time_ns, static_cast<std::int64_t>(i + 1) * kStep_ns);
    EXPECT_EQ(follows.headings[i].heading_rad, static_cast<double>(2 * i + 1)) << "right behind the position";
  }
  const HeadingTimes leads = times_of("HHPHHPHHP");
  ASSERT_EQ(leads.headings.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(leads.headings[i].time_ns, static_cast<std::int64_t>(i + 1) * kStep_ns);
    EXPECT_EQ(leads.headings[i].heading_rad, static_cast<double>(2 * i + 2)) << "right before the position";
  }
  EXPECT_TRUE(times_of("").headings.empty());
  EXPECT_TRUE(times_of("HHH").headings.empty());
}

}  // namespace
}  // namespace remount::formats

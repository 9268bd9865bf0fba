// Times of tables and scans as makers and people write them: which are read, on which clock, and what is said of
// others.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "algorithms/core/stamps.h"
#include "model/formats/files/running_period.h"
#include "model/guesses/table_import.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

using TimeText = std::function<std::string(std::int64_t stamp_ns)>;

class times_of_tables : public DescribedRows {
 protected:
  static constexpr std::size_t kFewScans = 12;

  /// Some of the scans under other names.
  static void name_scans(const fs::path& folder, const TimeText& name) {
    fs::create_directories(folder / "scans");
    for (std::size_t i = 0; i < kFewScans; ++i)
      fs::copy_file(native_drive() / "scans" / session_->scans->name(i),
                    folder / "scans" / (name(session_->scans->stamp_ns(i)) + ".pcd"));
  }
  static void write_table(const fs::path& file, const std::string& head, const TimeText& time) {
    write_rows(file, head + kGeodeticHead, [&](std::size_t, const WrittenSample& sample) {
      return joined({time(sample.ins.stamp_ns)}, geodetic(sample));
    });
  }
  static Description of_texts(const std::string& head, const TimeText& time) {
    const formats::TemporaryFolder folder;
    name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
    write_table(folder.path() / "ins.csv", head, time);
    return described({folder.path()});
  }
  static std::int64_t week_ns(std::int64_t stamp_ns) {
    return formats::gps_ns_from_unix_ns(stamp_ns) % formats::kGpsWeek_ns;
  }
  /// Hours, minutes and seconds behind a date as KITTI writes it.
  static std::string clock_text(std::int64_t stamp_ns) { return formats::format_date_ns(stamp_ns).substr(11, 12); }
  static bool says_code(const std::vector<NotUsed>& all, std::string_view code) {
    return std::ranges::any_of(all, [&](const NotUsed& one) { return one.why.code() == code; });
  }
  /// Whether a file is said to lack something, and what.
  static bool lacks(const Description& found, std::string_view words) { return says_why(found, words); }
};

/// A clock for the scans, and one for the table.
struct NamedClock {
  const char* what;
  TimeText scan;
  const char* head;
  TimeText row;
  Sureness sureness;
};

TEST_F(times_of_tables, numbers_in_names_are_times_of_the_clock_of_the_table) {
  const std::int64_t first_ns = samples_->front().ins.stamp_ns, boot_ns = first_ns - 1'234'000'000'000;
  const auto us = [](std::int64_t time_ns) { return std::to_string(time_ns / 1000); };
  const NamedClock clocks[] = {
      {"week, s", [](auto t) { return seconds_text(week_ns(t)); }, "tow",
       [](auto t) { return seconds_text(week_ns(t)); }, Sureness::Checked},
      {"week, us", [&](auto t) { return us(week_ns(t)); }, "tow", [](auto t) { return seconds_text(week_ns(t)); },
       Sureness::Checked},
      {"week beside dates", [](auto t) { return seconds_text(week_ns(t)); }, "time_ns",
       [](auto t) { return std::to_string(t); }, Sureness::Checked},
      {"since power-on, us", [&](auto t) { return us(t - boot_ns); }, "timestamp",
       [&](auto t) { return us(t - boot_ns); }, Sureness::Checked},
      {"from zero, s", [&](auto t) { return seconds_text(t - first_ns); }, "time",
       [&](auto t) { return seconds_text(t - first_ns); }, Sureness::Open},
  };
  for (const NamedClock& clock : clocks) {
    const formats::TemporaryFolder folder;
    name_scans(folder.path(), clock.scan);
    write_table(folder.path() / "ins.csv", clock.head, clock.row);
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.complete()) << clock.what;
    const Guess* stamps = find_guess(found.lidars.front().guesses, GuessKind::Stamps);
    ASSERT_TRUE(stamps) << clock.what;
    EXPECT_EQ(stamps->sureness, clock.sureness) << clock.what;
    EXPECT_EQ(stamps->alternatives.empty(), clock.sureness == Sureness::Checked) << clock.what;
    EXPECT_NE(found.clock->sureness, Sureness::Open) << clock.what;
    const drive::Session session = opened(found, folder.path());
    const std::int64_t apart_ns = session.scans->stamp_ns(3) - session.ins.front().stamp_ns,
                       truth_ns = session_->scans->stamp_ns(3) - first_ns;
    std::printf("%s: %lld ns off\n", clock.what, static_cast<long long>(apart_ns - truth_ns));
    EXPECT_LE(std::abs(apart_ns - truth_ns), 1000) << clock.what;
  }
}

TEST_F(times_of_tables, names_that_count_the_scans_are_no_times) {
  const std::int64_t first_ns = samples_->front().ins.stamp_ns;
  for (const char* before : {"", "20231114_0000"}) {
    const formats::TemporaryFolder folder;
    int count = 10;
    name_scans(folder.path(), [&](std::int64_t) { return before + std::to_string(count++); });
    write_table(folder.path() / "ins.csv", "time", [&](std::int64_t t) { return seconds_text(t - first_ns); });
    const Description found = described({folder.path()});
    EXPECT_TRUE(found.ins) << before;
    const Guess* stamps = find_guess(found.lidars.front().guesses, GuessKind::Stamps);
    EXPECT_TRUE(stamps ? says(stamps->alternatives, "guess-stamps-may-be-numbers")
                       : says(found.missing, "guess-needs-stamps"))
        << before;
    EXPECT_TRUE(!stamps || stamps->sureness == Sureness::Open) << before;
  }
}

TEST_F(times_of_tables, dates_are_read_as_they_are_written) {
  const auto iso = [](std::int64_t t) { return formats::format_date_ns(t).substr(0, 23); };
  const std::pair<const char*, TimeText> texts[] = {
      {"a zone", [&](auto t) { return iso(t + 8 * 3600'000'000'000).replace(10, 1, "T") + "+08:00"; }},
      {"halves of a day", [&](auto t) { return "11/14/2023 10" + iso(t).substr(13) + " PM"; }},
      {"a short year", [&](auto t) { return "14.11.23 " + iso(t).substr(11); }},
      {"colons", [&](auto t) { return iso(t).replace(19, 1, ":"); }}};
  ASSERT_EQ(iso(samples_->front().ins.stamp_ns).substr(0, 13), "2023-11-14 22");
  for (const auto& [what, text] : texts) {
    const Description found = of_texts("UTC Time", text);
    ASSERT_TRUE(found.ins) << what << (found.not_used.empty() ? "" : english(found.not_used.front().why));
    EXPECT_EQ(found.ins->samples, samples_->size()) << what;
    EXPECT_EQ(found.ins->span.first_ns, samples_->front().ins.stamp_ns) << what;
    EXPECT_NE(guess_of(found, GuessKind::Time)->sureness, Sureness::Open) << what;
  }
}

TEST_F(times_of_tables, dates_in_columns_and_rests_of_seconds) {
  const formats::TemporaryFolder parts, rest;
  for (const auto* folder : {&parts, &rest})
    name_scans(folder->path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
  write_rows(parts.path() / "mt.csv",
             "count,UTC_Nano,UTC_Year,UTC_Month,UTC_Day,UTC_Hour,UTC_Minute,UTC_Second" + std::string(kGeodeticHead),
             [](std::size_t i, const WrittenSample& sample) {
               const std::string text = formats::format_date_ns(sample.ins.stamp_ns);
               return joined({std::to_string(1000 + i), text.substr(20), text.substr(0, 4), text.substr(5, 2),
                              text.substr(8, 2), text.substr(11, 2), text.substr(14, 2), text.substr(17, 2)},
                             geodetic(sample));
             });
  write_rows(rest.path() / "state.csv", "Unix Time,Microseconds" + std::string(kGeodeticHead),
             [](std::size_t, const WrittenSample& sample) {
               return joined({std::to_string(sample.ins.stamp_ns / 1'000'000'000),
                              std::to_string(sample.ins.stamp_ns % 1'000'000'000 / 1000)},
                             geodetic(sample));
             });
  for (const auto* folder : {&parts, &rest}) {
    const Description found = described({folder->path()});
    ASSERT_TRUE(found.complete());
    const formats::InsTableLayout& ours = found.ins->layout;
    for (const formats::InsTableLayout& other : guess_of(found, GuessKind::Time)->other_layouts)
      EXPECT_TRUE(other.nanoseconds && other.calendar.has_value() == ours.calendar.has_value());
    Progress progress;
    const ImportData data = look_for_import({folder->path()}, progress);
    ASSERT_TRUE(data.table);
    const ImportChecks checks = check_choice(data.description, {data.table, data.table->preset, {}}, progress);
    EXPECT_EQ(checks.samples, samples_->size()) << "the import presets all of the columns";
    TableChoices other = data.table->preset;
    give_role(data.table->table, other, 0, ColumnRole::Minute);
    std::vector<Message> lacks;
    EXPECT_FALSE(layout_of(data.table->table, other, lacks) && !ours.calendar) << "a minute needs an hour beside it";
    EXPECT_LT(motions_apart(opened(found, folder->path()), *session_), kTextPrecision);
  }
}

TEST_F(times_of_tables, a_title_whose_unit_no_log_can_have_is_contradicted) {
  const Description found = of_texts("time_ms", seconds_text);
  ASSERT_TRUE(found.ins);
  EXPECT_EQ(found.ins->layout.time_unit_ns, 1'000'000'000);
  EXPECT_TRUE(says(guess_of(found, GuessKind::Time)->evidence, "guess-unit-against-title"));
}

TEST_F(times_of_tables, what_is_no_date_is_said_to_be_so_with_the_column) {
  EXPECT_TRUE(lacks(of_texts("UTC Time", clock_text), "\"UTC Time\" holds times of day"));
  int row = 0;
  EXPECT_TRUE(lacks(of_texts("packet,UTC Time", [&](auto t) { return std::to_string(++row) + "," + clock_text(t); }),
                    "\"UTC Time\" holds times of day"))
      << "what counts the rows is no time beside one";
  EXPECT_TRUE(lacks(of_texts("timestamp", [](auto t) { return "2023-318 " + clock_text(t); }),
                    "\"timestamp\" is called a time"));
  EXPECT_TRUE(lacks(of_texts("Date", [](auto t) { return number(static_cast<double>(t) / 86'400e9 + 25'569.0); }),
                    "in no unit that is read"));
  EXPECT_TRUE(lacks(of_texts("time", [](auto t) { return number(-1e-9 * static_cast<double>(t)); }), "does not go up"));
}

TEST_F(times_of_tables, clocks_without_a_date_are_told_by_that_of_the_scans) {
  const std::int64_t day_ns = formats::kUtcDay_ns, first_ns = samples_->front().ins.stamp_ns;
  const Description of_day = of_texts("seconds", [&](auto t) { return seconds_text(t % day_ns); });
  ASSERT_TRUE(of_day.clock);
  EXPECT_EQ(of_day.clock->sureness, Sureness::Open);
  EXPECT_EQ(of_day.clock->added_ns, first_ns - first_ns % day_ns);
  const Description digits = of_texts("time", [](auto t) {
    std::string text = clock_text(t);
    std::erase(text, ':');
    return text;
  });
  ASSERT_TRUE(digits.clock);
  EXPECT_TRUE(says(digits.clock->evidence, "guess-clock-digits"));
  const Description from_zero = of_texts("time", [&](auto t) { return seconds_text(t - first_ns); });
  ASSERT_TRUE(from_zero.clock);
  EXPECT_TRUE(says(from_zero.clock->evidence, "guess-clock-from-start"));
}

TEST_F(times_of_tables, scans_in_a_gap_are_not_within_the_motion) {
  const formats::TemporaryFolder folder;
  name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
  std::vector<WrittenSample> some = *samples_;
  const std::int64_t from_ns = session_->scans->stamp_ns(2), to_ns = session_->scans->stamp_ns(kFewScans - 3);
  std::erase_if(some, [&](const WrittenSample& one) { return one.ins.stamp_ns > from_ns && one.ins.stamp_ns < to_ns; });
  write_rows(
      folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
      [](std::size_t, const WrittenSample& sample) {
        return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
      },
      some);
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.clock);
  for (const Message& evidence : found.clock->evidence) std::printf("%s\n", english(evidence).c_str());
  EXPECT_TRUE(says(found.clock->evidence, "guess-clock-in-gaps"));
  EXPECT_EQ(found.clock->sureness, Sureness::Likely);
}

TEST_F(times_of_tables, utc_is_not_checked_where_gps_time_would_hold_the_scans_too) {
  const std::int64_t first_ns = session_->scans->stamp_ns(0);
  for (const double long_s : {120.0, 8.0}) {
    const formats::TemporaryFolder folder;
    name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
    write_rows(
        folder.path() / "ins.csv", "time_unix" + std::string(kGeodeticHead),
        [](std::size_t, const WrittenSample& sample) {
          return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
        },
        circles(first_ns - static_cast<std::int64_t>(long_s * 0.4e9), long_s));
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_TRUE(time && found.clock);
    const bool told = long_s < 36.0;
    EXPECT_EQ(time->sureness == Sureness::Checked, told) << long_s;
    EXPECT_EQ(says(found.clock->evidence, "guess-clock-not-to-seconds"), !told) << long_s;
  }
}

TEST_F(times_of_tables, rows_without_a_value_are_left_out_and_counted) {
  for (const char* mark : {"", "N/A", "-", "nan", "-9999"}) {
    const std::size_t every = mark == std::string_view("-") ? 2 : 7;
    const formats::TemporaryFolder folder;
    std::size_t without = 0;
    name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
    write_rows(folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
               [&](std::size_t i, const WrittenSample& sample) {
                 Fields fields = joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
                 if (i % every == every - 1) fields[4] = fields[5] = fields[6] = mark, ++without;
                 return fields;
               });
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.ins) << "'" << mark << "' "
                           << (found.not_used.empty() ? "" : english(found.not_used.front().why));
    EXPECT_EQ(found.ins->samples, samples_->size() - without) << mark;
    EXPECT_GE(guess_of(found, GuessKind::Rows)->evidence.size(), 2U) << mark;
    EXPECT_EQ(found.ins->layout.text.no_value.has_value(), mark == std::string_view("-9999")) << mark;
    EXPECT_EQ(opened(found, folder.path()).ins.size(), samples_->size() - without) << mark;
  }
}

TEST_F(times_of_tables, rows_that_are_written_twice_count_once) {
  std::vector<WrittenSample> twice;
  for (const WrittenSample& sample : *samples_) twice.insert(twice.end(), {sample, sample});
  const formats::TemporaryFolder folder;
  name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
  write_rows(
      folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
      [](std::size_t, const WrittenSample& sample) {
        return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
      },
      twice);
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  EXPECT_EQ(found.ins->samples, samples_->size());
}

TEST_F(times_of_tables, files_that_are_no_table_are_told_with_the_reason) {
  const formats::TemporaryFolder folder;
  name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
  const std::string head = "time" + std::string(kGeodeticHead), row = "1.5,48,9,250,1,2,3\n";
  for (const auto& [text, code] : {std::pair(std::string(), "guess-file-empty"),
                                   {head, "guess-too-few-rows"},
                                   {head + row + row, "guess-too-few-rows"},
                                   {head + std::string("1\0", 2) + row, "guess-file-not-text"}}) {
    folder.write("ins.csv", text);
    EXPECT_TRUE(says_code(described({folder.path()}).not_used, code)) << code;
  }
  folder.write("ins.txt", "Notes of the drive: nothing happened, 3 times.\n");
  fs::remove(folder.path() / "ins.csv");
  EXPECT_TRUE(described({folder.path()}).not_used.empty()) << "prose is no table that anybody would look for";
}

TEST_F(times_of_tables, what_merely_goes_up_is_no_other_reading) {
  const formats::TemporaryFolder folder;
  name_scans(folder.path(), [](std::int64_t stamp_ns) { return std::to_string(stamp_ns); });
  double way = 0.0;
  write_rows(folder.path() / "ins.csv", "time,a,b" + std::string(kGeodeticHead),
             [&](std::size_t i, const WrittenSample& sample) {
               way += 0.1 + 0.05 * std::sin(0.1 * static_cast<double>(i));
               return joined({seconds_text(week_ns(sample.ins.stamp_ns)), number(way), number(5e6 + 2.0 * way)},
                             geodetic(sample));
             });
  const Description found = described({folder.path()});
  const Guess* time = guess_of(found, GuessKind::Time);
  ASSERT_TRUE(time);
  EXPECT_EQ(time->columns, std::vector<std::string>{"time"});
  for (const formats::InsTableLayout& other : time->other_layouts) EXPECT_EQ(other.time.name, "time");
}

}  // namespace
}  // namespace remount::guesses

// Dates whose year comes last: which number is the day.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <set>

#include "algorithms/messages/render.h"
#include "model/formats/files/declared_table.h"
#include "model/guesses/table_import.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;
using formats::DateOrder;
using formats::parse_calendar_ns;

class written_dates : public DescribedRows {
 protected:
  /// "14.11.2023 22:13:20.500000000". @param order of the first two, parted by `apart`
  static std::string date(std::int64_t stamp_ns, DateOrder order, char apart, char before_clock = ' ') {
    const std::string iso = formats::format_date_ns(stamp_ns);
    const std::string day = iso.substr(8, 2), month = iso.substr(5, 2);
    std::string text = order == DateOrder::DayFirst ? day + apart + month : month + apart + day;
    return text + apart + iso.substr(0, 4) + before_clock + iso.substr(11);
  }
  /// Twenty seconds in circles, and scans named by their nanoseconds where there are to be some.
  static Description described_circles(const fs::path& folder, std::int64_t first_ns, DateOrder order, char apart,
                                       bool with_scans) {
    if (with_scans) {
      fs::create_directories(folder / "scans");
      std::int64_t scan = 0;
      for (const fs::directory_entry& file : fs::directory_iterator(native_drive() / "scans"))
        if (scan < 20)
          fs::copy_file(file, folder / "scans" / (std::to_string(first_ns + ++scan * 500'000'000) + ".pcd"));
    }
    write_rows(
        folder / "ins.csv", "time" + std::string(kGeodeticHead),
        [&](std::size_t, const WrittenSample& sample) {
          return joined({date(sample.ins.stamp_ns, order, apart)}, geodetic(sample));
        },
        circles(first_ns, 20.0));
    return described({folder});
  }
  /// What the import makes of it where nobody touches anything; and how many of the rows it reads.
  static std::size_t rows_of_import(const fs::path& folder, std::string& manifest_text) {
    Progress progress;
    const ImportData data = look_for_import({folder}, progress);
    const ImportChoice choice{data.table, data.table->preset, {}};
    const ImportChecks checks = check_choice(data.description, choice, progress);
    Description again = data.description;
    std::vector<Message> lacks;
    again.ins->layout = *layout_of(data.table->table, choice.choices, lacks);
    manifest_text = manifest(again, folder);
    return checks.samples;
  }
  static std::string manifest(const Description& found, const fs::path& folder) {
    return formats::to_yaml(manifest_of(found, folder, Language::English));
  }
};

TEST_F(written_dates, are_read_in_the_order_that_is_asked_for_alone) {
  constexpr std::int64_t kDate_ns = 1'700'000'000'500'000'000;
  EXPECT_EQ(parse_calendar_ns("14.11.2023 22:13:20.5", DateOrder::DayFirst), kDate_ns);
  EXPECT_EQ(parse_calendar_ns("14/11/2023T22:13:20.5Z", DateOrder::DayFirst), kDate_ns);
  EXPECT_EQ(parse_calendar_ns("11-14-2023 22:13:20,5", DateOrder::MonthFirst), kDate_ns);
  EXPECT_EQ(parse_calendar_ns("4.1.2023 0:0:0", DateOrder::DayFirst), parse_calendar_ns("2023-01-04 00:00:00"));
  for (const char* text : {"14.11.2023 22:13:20", "2023-11-14 22:13:20", "14.11/2023 22:13:20", "14.11.23 22:13:20",
                           "14.11.20234 22:13:20", "14.11.", "14", "", "14.11.2023"})
    EXPECT_FALSE(parse_calendar_ns(text, DateOrder::MonthFirst)) << text;
  EXPECT_FALSE(parse_calendar_ns("31.02.2023 22:13:20", DateOrder::DayFirst));
  EXPECT_FALSE(parse_calendar_ns("14.11.2023 22:13:20")) << "the year comes first unless it is declared";
}

TEST_F(written_dates, with_points_or_a_number_above_twelve_leave_no_doubt) {
  for (const auto& [order, apart] : {std::pair{DateOrder::DayFirst, '.'},
                                     {DateOrder::DayFirst, '/'},
                                     {DateOrder::MonthFirst, '/'},
                                     {DateOrder::MonthFirst, '-'}}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "ins.csv", "time" + std::string(kGeodeticHead),
               [written = order, parting = apart](std::size_t, const WrittenSample& sample) {
                 return joined({date(sample.ins.stamp_ns, written, parting)}, geodetic(sample));
               });
    const Description found = described({folder.path()});
    const Guess* time = guess_of(found, GuessKind::Time);
    ASSERT_TRUE(time) << apart;
    EXPECT_NE(time->sureness, Sureness::Open) << apart;
    const std::string name(date_order_name(order));
    EXPECT_NE(manifest(found, folder.path()).find("order: " + name), std::string::npos)
        << manifest(found, folder.path());
    EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision);
    std::string imported;
    EXPECT_EQ(rows_of_import(folder.path(), imported), samples_->size()) << apart;
    EXPECT_EQ(imported, manifest(found, folder.path()));
  }
}

TEST_F(written_dates, an_open_order_is_a_choice_of_the_import) {
  const std::int64_t first_ns = *parse_calendar_ns("2023-12-11 10:00:00");
  const formats::TemporaryFolder folder;
  described_circles(folder.path(), first_ns, DateOrder::DayFirst, '/', false);
  Progress progress;
  const ImportData data = look_for_import({folder.path()}, progress);
  ASSERT_TRUE(data.table && data.table->guess);
  const Guess* time = find_guess(data.table->guess->guesses, GuessKind::Time);
  ASSERT_TRUE(time);
  std::set<DateOrder> orders{data.table->preset.date_order};
  ASSERT_EQ(time->alternatives.size(), time->other_layouts.size());
  for (std::size_t i = 0; i < time->other_layouts.size(); ++i) {
    ImportChoice choice{data.table, data.table->preset, {}};
    take_time(data.table->table, time->other_layouts[i], choice.choices);
    EXPECT_FALSE(choice.choices == data.table->preset) << english(time->alternatives[i]);
    const ImportChecks checks = check_choice(data.description, choice, progress);
    EXPECT_EQ(checks.samples, 400U);
    std::printf("%s\n", english(time->alternatives[i]).c_str());
    const bool other_order = choice.choices.date_order != data.table->preset.date_order,
               gps = choice.choices.time_scale == formats::TimeScale::Gps;
    EXPECT_EQ(formats::contains(english(time->alternatives[i]), "order"), other_order);
    EXPECT_EQ(formats::contains(english(time->alternatives[i]), "GPS time"), gps);
    if (!orders.insert(choice.choices.date_order).second || gps) continue;
    const Description made = description_of(data.description, choice, checks);
    EXPECT_FALSE(find_guess(made.ins->guesses, GuessKind::Time)->sureness == Sureness::Open) << "somebody said so";
    EXPECT_NE(manifest(made, folder.path()).find("order: " + std::string(date_order_name(choice.choices.date_order))),
              std::string::npos);
    EXPECT_EQ(std::abs(checks.span.first_ns - first_ns),
              std::abs(*parse_calendar_ns("2023-11-12 10:00:00") - first_ns) *
                  (choice.choices.date_order == DateOrder::MonthFirst ? 1 : 0));
  }
  EXPECT_EQ(orders.size(), 2U);
}

TEST_F(written_dates, a_day_beside_its_time_has_an_order_too) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "ins.csv", "date,clock" + std::string(kGeodeticHead),
             [](std::size_t, const WrittenSample& sample) {
               const std::string text = date(sample.ins.stamp_ns, DateOrder::DayFirst, '.');
               return joined({text.substr(0, 10), text.substr(11)}, geodetic(sample));
             });
  const Description found = described({folder.path()});
  EXPECT_NE(manifest(found, folder.path()).find("day: date"), std::string::npos) << manifest(found, folder.path());
  EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision);
}

// The eleventh of December, which may as well be the twelfth of November.
TEST_F(written_dates, of_two_orders_the_scans_decide_and_without_them_none) {
  const std::int64_t first_ns = *parse_calendar_ns("2023-12-11 10:00:00");
  for (const DateOrder order : {DateOrder::DayFirst, DateOrder::MonthFirst}) {
    const formats::TemporaryFolder with, without;
    const Description told = described_circles(with.path(), first_ns, order, '/', true),
                      open = described_circles(without.path(), first_ns, order, '/', false);
    const Guess *time = guess_of(told, GuessKind::Time), *undecided = guess_of(open, GuessKind::Time);
    ASSERT_TRUE(time && undecided);
    const std::string name(date_order_name(order));
    std::printf("%s: %s\n", name.c_str(), english(time->evidence.back()).c_str());
    EXPECT_EQ(time->columns, std::vector<std::string>{"time"});
    EXPECT_NE(time->sureness, Sureness::Open) << name;
    EXPECT_NE(manifest(told, with.path()).find("order: " + name), std::string::npos) << name;
    EXPECT_EQ(undecided->sureness, Sureness::Open) << name;
    EXPECT_TRUE(says(undecided->alternatives, "guess-date-alternative")) << name;
    EXPECT_TRUE(says(undecided->evidence, "guess-date-order")) << name;
  }
}

TEST_F(written_dates, one_date_of_two_orders_is_no_question) {
  const formats::TemporaryFolder folder;
  const Description found =
      described_circles(folder.path(), *parse_calendar_ns("2023-05-05 10:00:00"), DateOrder::DayFirst, '/', false);
  const Guess* time = guess_of(found, GuessKind::Time);
  ASSERT_TRUE(time);
  EXPECT_FALSE(says(time->alternatives, "guess-date-alternative"));
}

}  // namespace
}  // namespace remount::guesses

// More tables and columns than somebody would look at.
#include <gtest/gtest.h>

#include <stop_token>

#include "model/formats/files/text_file.h"
#include "model/guesses/motion_guess.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

class much_data : public DescribedRows {
 protected:
  /// A table without names: the motion among so many other columns, that swing like some motion.
  static void write_among_others(const std::filesystem::path& file, const std::vector<WrittenSample>& samples,
                                 int others) {
    write_rows(
        file, "",
        [&](std::size_t i, const WrittenSample& sample) {
          Fields fields = joined({seconds_text(sample.ins.stamp_ns)}, place_deg(sample));
          for (int k = 1; k <= others; ++k)
            fields.push_back(number(3.0 * k * std::sin(0.002 * static_cast<double>(i) * k + k)));
          return joined(fields, angles(heading_angles(sample)));
        },
        samples);
  }
};

TEST_F(much_data, hundreds_of_small_tables_do_not_hide_the_motion) {
  constexpr int kLabels = 300;
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  for (int i = 0; i < kLabels; ++i)
    folder.write("annotations/" + std::to_string(1000 + i) + ".txt", "1 0\n2 0\n0 1\n1 1\n2 2\n3 1\n");
  fs::create_directories(folder.path() / "ins");
  write_rows(folder.path() / "ins" / "motion.csv", "time" + std::string(kGeodeticHead),
             [](std::size_t, const WrittenSample& sample) {
               return joined({seconds_text(sample.ins.stamp_ns)}, geodetic(sample));
             });
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  EXPECT_EQ(found.ins->file.filename(), "motion.csv");
  EXPECT_EQ(found.not_used.size(), 1U) << "all of them at once";
  EXPECT_TRUE(says_why(found, "300 tables"));
}

TEST_F(much_data, of_many_columns_without_names_the_motion_is_found_and_can_be_cancelled) {
  constexpr int kMore = 40;
  const std::vector<WrittenSample> samples = circles(1'700'000'000'000'000'000, 200.0);
  const formats::TemporaryFolder folder;
  write_among_others(folder.path() / "ins.csv", samples, kMore);
  const Description found = described({folder.path()});
  const Guess* attitude = guess_of(found, GuessKind::Attitude);
  ASSERT_TRUE(attitude);
  EXPECT_EQ(attitude->columns.front(), std::to_string(4 + kMore + 2));
  EXPECT_EQ(found.ins->layout.attitude, drive::AttitudeConvention::Heading);
  const auto table = sample_table("ins.csv", formats::read_text_file(folder.path() / "ins.csv"));
  ASSERT_TRUE(table);
  const ColumnNames names = names_of(*table);
  const auto time = choose_time(*table, names, {});
  ASSERT_TRUE(time);
  std::stop_source stop;
  stop.request_stop();
  std::vector<Message> missing;
  EXPECT_FALSE(choose_motion(*table, names, time->reading, Progress(stop.get_token()), missing));
  EXPECT_TRUE(missing.empty()) << missing.front();
}

/// Stands, drives in circles for some seconds, and stands again.
std::vector<WrittenSample> mostly_parked() {
  constexpr std::size_t kBefore = 1600, kAfter = 1600;
  const std::int64_t first_ns = 1'700'000'000'000'000'000;
  std::vector<WrittenSample> samples = circles(first_ns, 12.0);
  samples.insert(samples.begin(), kBefore, samples.front());
  samples.insert(samples.end(), kAfter, samples.back());
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].ins.stamp_ns = first_ns + static_cast<std::int64_t>(i) * 50'000'000;
  return samples;
}

TEST_F(much_data, of_many_columns_without_names_a_parked_vehicle_hides_nothing) {
  constexpr int kMore = 24;
  const std::vector<WrittenSample> samples = mostly_parked();
  const formats::TemporaryFolder folder;
  write_among_others(folder.path() / "ins.csv", samples, kMore);
  const Description found = described({folder.path()});
  const Guess *position = guess_of(found, GuessKind::Position), *attitude = guess_of(found, GuessKind::Attitude);
  ASSERT_TRUE(position && attitude);
  EXPECT_EQ(position->columns, (Fields{"1", "2", "3"}));
  EXPECT_EQ(attitude->columns.front(), std::to_string(4 + kMore + 2));
  EXPECT_EQ(found.ins->layout.attitude, drive::AttitudeConvention::Heading);
}

TEST_F(much_data, tables_beyond_a_number_are_said_to_be_left) {
  const formats::TemporaryFolder folder;
  for (int i = 0; i < 230; ++i)
    folder.write(std::to_string(1000 + i) + ".tab",
                 "1,0,1,1,1,1\n2,0,1,1,1,1\n0,1,1,1,1,1\n1,1,1,1,1,1\n2,2,1,1,1,1\n");
  for (int i = 0; i < 300; ++i) folder.write(std::to_string(i) + ".png", std::string("\x89PNG\0\0", 6));
  EXPECT_TRUE(says_why(described({folder.path()}), "this and 30 in all were not looked at"));
}

}  // namespace
}  // namespace remount::guesses

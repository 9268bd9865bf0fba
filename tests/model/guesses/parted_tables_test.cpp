// An INS whose positions stand in one table and whose attitudes in another, at other rates.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

class parted_tables : public DescribedRows {
 protected:
  void SetUp() override { write_scans(native_drive(), folder_.path(), ScanNames::Nanoseconds); }

  static std::vector<WrittenSample> every(std::size_t stride) {
    std::vector<WrittenSample> some;
    for (std::size_t i = 0; i < samples_->size(); i += stride) some.push_back((*samples_)[i]);
    return some;
  }

  /// Positions in degrees with errors, attitudes as a heading.
  void write_parts(std::size_t position_stride, std::size_t attitude_stride, std::int64_t attitudes_later_ns = 0) {
    write_rows(
        folder_.path() / "position.csv", "utc_ns,latitude,longitude,height,std_e,std_n,std_u\n",
        [](std::size_t, const WrittenSample& s) {
          return joined(joined({std::to_string(s.ins.stamp_ns)}, place_deg(s)), {"0.02", "0.02", "0.04"});
        },
        every(position_stride));
    write_rows(
        folder_.path() / "attitude.csv", "time (s),roll,pitch,heading\n",
        [&](std::size_t, const WrittenSample& s) {
          return joined({seconds_text(s.ins.stamp_ns + attitudes_later_ns)}, angles(heading_angles(s)));
        },
        every(attitude_stride));
  }

  /// Largest errors of position (m) and attitude (rad) beside the samples that were written.
  static std::pair<double, double> errors_of(const drive::Session& session) {
    constexpr double kEarthLike_m = 6'371'000.0;
    double worst_m = 0.0, worst_rad = 0.0;
    for (const motion::InsSample& sample : session.ins) {
      const auto truth = std::ranges::lower_bound(*samples_, sample.stamp_ns, {},
                                                  [](const WrittenSample& one) { return one.ins.stamp_ns; });
      if (truth == samples_->end() || truth->ins.stamp_ns != sample.stamp_ns) {
        ADD_FAILURE() << "no sample of the drive is at " << sample.stamp_ns;
        return {1.0, 1.0};
      }
      worst_m = std::max({worst_m, kEarthLike_m * std::abs(sample.latitude_rad - truth->ins.latitude_rad),
                          kEarthLike_m * std::abs(sample.longitude_rad - truth->ins.longitude_rad),
                          std::abs(sample.height_m - truth->ins.height_m)});
      worst_rad = std::max(worst_rad, sample.enu_from_ins.angularDistance(truth->ins.enu_from_ins));
    }
    return {worst_m, worst_rad};
  }

  formats::TemporaryFolder folder_;
};

TEST_F(parted_tables, are_joined_and_checked_against_the_travel) {
  for (const auto& [position_stride, attitude_stride] : {std::pair<std::size_t, std::size_t>{1, 1}, {5, 1}, {1, 4}}) {
    write_parts(position_stride, attitude_stride);
    const Description found = described({folder_.path()});
    ASSERT_TRUE(found.complete()) << (found.missing.empty() ? "" : english(found.missing.front()));
    ASSERT_TRUE(found.ins->attitude);
    EXPECT_EQ(found.ins->file.filename(), "position.csv");
    EXPECT_EQ(found.ins->attitude->file.filename(), "attitude.csv");
    EXPECT_EQ(find_guess(found.ins->guesses, GuessKind::Position)->sureness, Sureness::Named);
    EXPECT_NE(find_guess(found.ins->guesses, GuessKind::PositionSigma), nullptr);
    const Guess* attitude = find_guess(found.ins->attitude->guesses, GuessKind::Attitude);
    ASSERT_NE(attitude, nullptr);
    EXPECT_EQ(attitude->sureness, Sureness::Checked);
    EXPECT_TRUE(says(find_guess(found.ins->attitude->guesses, GuessKind::Rows)->evidence, "guess-joined"));
    for (const NotUsed& one : found.not_used) EXPECT_NE(one.path.extension(), ".csv") << english(one.why);
    const drive::Session session = opened(found, folder_.path());
    const auto [off_m, off_rad] = errors_of(session);
    std::cout << "every " << position_stride << ". position, every " << attitude_stride
              << ". attitude: " << session.ins.size() << " samples, off by " << off_m << " m and " << off_rad
              << " rad\n";
    EXPECT_GT(session.ins.size(), samples_->size() / 6);
    EXPECT_EQ(session.ins.size(), found.ins->samples);
    EXPECT_LT(off_m, 1e-5);
    EXPECT_LT(off_rad, 1e-7);
    EXPECT_NEAR(session.ins.front().sigma.position_enu_m.z(), 0.04, 1e-12);
    EXPECT_TRUE(std::ranges::count(session.files, folder_.path() / "attitude.csv"));
    fs::remove(folder_.path() / "session.yaml");
  }
}

TEST_F(parted_tables, without_a_time_in_common_are_told_apart) {
  write_parts(1, 1, 3'600'000'000'000);
  const Description found = described({folder_.path()});
  EXPECT_FALSE(found.complete());
  EXPECT_TRUE(says_why(found, "position.csv and attitudes in attitude.csv have no time in common"));
}

/// GPS time beside UTC, or the computer's clock: as they stand, latitude and longitude exchanged would fit better.
TEST_F(parted_tables, of_two_clocks_are_brought_together_and_open) {
  for (const double later_s : {3.0, -18.0}) {
    write_parts(2, 1, static_cast<std::int64_t>(1e9 * later_s));
    const Description found = described({folder_.path()});
    ASSERT_TRUE(found.ins && found.ins->attitude) << (found.missing.empty() ? "" : english(found.missing.front()));
    const Guess* time = find_guess(found.ins->attitude->guesses, GuessKind::Time);
    ASSERT_NE(time, nullptr);
    EXPECT_EQ(time->sureness, Sureness::Open);
    EXPECT_TRUE(says(time->evidence, "guess-two-clocks"));
    EXPECT_EQ(guess_of(found, GuessKind::Position)->sureness, Sureness::Named);
    const double added_s = 1e-9 * static_cast<double>(found.ins->attitude->layout.offset_ns);
    std::cout << "later by " << later_s << " s: " << added_s << " s are added\n";
    EXPECT_NEAR(added_s, -later_s, 0.15);
    const auto [off_m, off_rad] = errors_of(opened(found, folder_.path()));
    EXPECT_LT(off_m, 1e-5);
    EXPECT_LT(off_rad, 0.05);
    fs::remove(folder_.path() / "session.yaml");
  }
}

/// As of an INS that solves for attitudes less often than it writes; where every fifth row is looked at these are
/// missed.
TEST_F(parted_tables, in_one_whose_attitudes_stand_in_every_fifth_row_are_read_there) {
  write_rows(folder_.path() / "motion.csv", "time_ns" + std::string(kGeodeticHead),
             [](std::size_t i, const WrittenSample& sample) {
               const Fields turned = i % 5 == 3 ? angles(heading_angles(sample)) : Fields{"", "", ""};
               return joined({std::to_string(sample.ins.stamp_ns)}, joined(place_deg(sample), turned));
             });
  const Description found = described({folder_.path()});
  ASSERT_TRUE(found.ins) << (found.missing.empty() ? "" : english(found.missing.front()));
  EXPECT_EQ(guess_of(found, GuessKind::Attitude)->sureness, Sureness::Checked);
  const drive::Session session = opened(found, folder_.path());
  EXPECT_NEAR(static_cast<double>(session.ins.size()), static_cast<double>(samples_->size()) / 5.0, 1.0);
  const auto [off_m, off_rad] = errors_of(session);
  std::cout << session.ins.size() << " of " << samples_->size() << " rows, off by " << off_m << " m and " << off_rad
            << " rad\n";
  EXPECT_LT(off_m, 1e-5);
  EXPECT_LT(off_rad, 1e-7);
}

/// Likewise of a receiver that solves for positions less often.
TEST_F(parted_tables, in_one_whose_positions_stand_in_every_fifth_row_are_read_there) {
  write_rows(folder_.path() / "motion.csv", "time_ns" + std::string(kGeodeticHead),
             [](std::size_t i, const WrittenSample& sample) {
               const Fields place = i % 5 == 3 ? place_deg(sample) : Fields{"", "", ""};
               return joined({std::to_string(sample.ins.stamp_ns)}, joined(place, angles(heading_angles(sample))));
             });
  const Description found = described({folder_.path()});
  ASSERT_TRUE(found.ins) << (found.missing.empty() ? "" : english(found.missing.front()));
  EXPECT_EQ(guess_of(found, GuessKind::Attitude)->sureness, Sureness::Checked);
  const auto [off_m, off_rad] = errors_of(opened(found, folder_.path()));
  EXPECT_LT(off_m, 1e-5);
  EXPECT_LT(off_rad, 1e-7);
}

TEST_F(parted_tables, give_way_to_a_table_that_has_all) {
  write_parts(2, 1);
  folder_.write("motion.txt", table_text(layouts().front(), *samples_));
  const Description found = described({folder_.path()});
  ASSERT_TRUE(found.complete());
  EXPECT_EQ(found.ins->file.filename(), "motion.txt");
  EXPECT_FALSE(found.ins->attitude);
}

TEST_F(parted_tables, of_which_one_is_broken_are_refused_with_its_name) {
  write_parts(1, 1);
  const Description found = described({folder_.path()});
  opened(found, folder_.path());
  folder_.write("attitude.csv", "time (s),roll,pitch\n1,2,3\n");
  Progress progress;
  try {
    formats::open_session(folder_.path() / "session.yaml", progress);
    ADD_FAILURE() << "opened";
  } catch (const Error& error) {
    EXPECT_NE(error.where().find("attitude.csv"), std::string::npos) << error.what();
    EXPECT_NE(english(error.message()).find("heading"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace remount::guesses

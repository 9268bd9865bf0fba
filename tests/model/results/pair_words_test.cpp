#include "model/results/pair_words.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "messages/pairs.h"

namespace remount::results {
namespace {

/// A LiDAR that is turned to the left by 16 degrees: the street lies along [0.96, -0.28, 0] of it.
ResultFile turned_lidar() {
  ResultFile file;
  file.result.status = calibration::Status::Ok;
  file.result.set_observed(calibration::ParameterSet::all(), {});
  file.result.mounting.reference_from_sensor = rigid_from_six({1.0, 0.0, 1.5, degrees_to_radians(16.0), 0.0, 0.0});
  file.ins_axes = drive::InsAxes::ForwardLeftUp;
  return file;
}

void add(ResultFile& file, int count, motion::PairState state, const Message& reason, double residual_m = 0.0) {
  PairRecord pair;
  pair.state = state;
  pair.decided_by = motion::DecidedBy::Program;
  pair.reason = reason;
  pair.residual_translation_m = residual_m;
  file.pairs.insert(file.pairs.end(), static_cast<std::size_t>(count), pair);
}

Message leaves_open(std::vector<Message> directions) {
  return say::pair_leaves_open(say::open_of_lidar(std::move(directions)));
}

TEST(pair_words, open_directions_are_told_in_axes_of_the_vehicle) {
  const ResultFile file = turned_lidar();
  const auto told = [&](std::vector<Message> open) {
    return english(not_shown_by(leaves_open(std::move(open)), file));
  };
  EXPECT_EQ(told({say::open_shift_along(0.96, -0.28, -0.01)}), "the shift along the street");
  EXPECT_EQ(told({say::open_shift_along(0.28, 0.96, 0.02)}), "the shift across the street");
  EXPECT_EQ(told({say::open_shift_z()}), "the height");
  EXPECT_EQ(told({say::open_shift_along(0.87, 0.48, 0.02)}), "the shift in one direction");
  EXPECT_EQ(told({say::open_shift_x(), say::open_shift_y()}), "any shift over the ground");
  EXPECT_EQ(
      told({say::open_shift_along(0.70, 0.70, 0.10), say::open_shift_along(-0.70, 0.70, 0.00), say::open_turn_z()}),
      "any shift over the ground and yaw");
  EXPECT_EQ(told({say::open_turn_x()}), "roll");
  EXPECT_EQ(told({say::open_turn_about(0.0, 0.69, 0.72)}), "the turn about one axis");
  EXPECT_EQ(told({say::open_shift_x(), say::open_shift_y(), say::open_shift_z(), say::open_turn_x(), say::open_turn_y(),
                  say::open_turn_z()}),
            "any motion at all");
  EXPECT_EQ(told({say::open_turn_beside()}), "every direction of motion");
  EXPECT_EQ(not_shown_by(say::registration_small_overlap(0.21, 0.30), file), Message());
  EXPECT_EQ(not_shown_by({}, file), Message());
}

TEST(pair_words, mere_words_of_older_files_say_nothing_of_directions) {
  const Message words =
      Message::verbatim("does not determine the shift along [0.96, -0.28, -0.01] (axes of the lidar)");
  EXPECT_EQ(english(not_shown_by(words, turned_lidar())), "every direction of motion");
}

TEST(pair_words, other_axes_of_the_ins_are_heeded_and_without_any_no_street_is_claimed) {
  ResultFile file = turned_lidar();
  const Message reason = leaves_open({say::open_shift_along(0.96, -0.28, -0.01)});
  file.ins_axes = drive::InsAxes::RightForwardUp;
  EXPECT_EQ(english(not_shown_by(reason, file)), "the shift across the street");
  file.ins_axes = drive::InsAxes::LeftBackwardUp;
  EXPECT_EQ(english(not_shown_by(reason, file)), "the shift across the street");
  file.ins_axes.reset();
  EXPECT_EQ(english(not_shown_by(reason, file)), "every direction of motion");
  file = turned_lidar();
  file.result.status = calibration::Status::NotConverged;
  EXPECT_EQ(english(not_shown_by(reason, file)), "every direction of motion");
}

TEST(pair_words, kinds_are_counted_and_told_without_numbers_of_a_single_pair) {
  ResultFile file = turned_lidar();
  add(file, 8, motion::PairState::Accepted, leaves_open({say::open_shift_along(0.96, -0.28, -0.01)}));
  add(file, 4, motion::PairState::Accepted, leaves_open({say::open_shift_along(0.95, -0.31, 0.00)}));
  add(file, 5, motion::PairState::Accepted, {});
  add(file, 2, motion::PairState::Rejected, say::pair_contradicts_ins({0.3}, {0.002}, 5.1), 0.3);
  add(file, 1, motion::PairState::Rejected, say::pair_contradicts_ins_screw({0.5}, {0.002}, 9.1), 0.5);
  add(file, 5, motion::PairState::Rejected, say::registration_few_points(2));
  add(file, 1, motion::PairState::Rejected, say::registration_few_points(1));
  EXPECT_EQ(english(pair_lines(file)),
            (std::vector<std::string>{
                "12 of the accepted: the scans do not show the shift along the street",
                "6 of the rejected, for instance: too few points with a surface: 2",
                "3 of the rejected: scans and INS tell different motions, half of them by more than 0.3 m"}));
}

TEST(pair_words, many_kinds_fit_on_a_screen) {
  ResultFile file = turned_lidar();
  for (int kind = 0; kind < 26; ++kind)
    add(file, 30 - kind, motion::PairState::Rejected,
        Message::verbatim(std::string("reason ") + static_cast<char>('a' + kind)));
  for (PairRecord& pair : file.pairs) pair.decided_by = motion::DecidedBy::User;
  const std::vector<std::string> lines = english(pair_lines(file));
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines.front(), "30 of the rejected: reason a");
  EXPECT_EQ(lines.back(), "341 of the rejected: other reasons (see the result file)");
}

}  // namespace
}  // namespace remount::results

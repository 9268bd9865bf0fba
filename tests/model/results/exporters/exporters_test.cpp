#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/drive/session_frames.h"
#include "model/results/exporters/exporter.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::results {
namespace {

ResultFile result_with(const RigidTransform& ins_from_lidar) {
  ResultFile file;
  file.result.status = calibration::Status::Ok;
  file.result.set_observed(calibration::ParameterSet::all(), {});
  file.result.covariance = Matrix6d::Identity() * 1e-6;
  file.result.mounting.reference_from_sensor = ins_from_lidar;
  file.ins_axes = drive::InsAxes::ForwardLeftUp;
  return file;
}

/// Random mountings, and those where Euler angles and quaternions are delicate.
std::vector<RigidTransform> mountings() {
  std::vector<RigidTransform> list{RigidTransform::Identity()};
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    list.push_back(
        make_rigid(q.normalized().toRotationMatrix(), {normal(random), normal(random), 10 * normal(random)}));
  }
  for (const double yaw : {kPi, -kPi, kPi / 2, -kPi / 2, 3.0})
    for (const double off : {0.0, 1e-15, 1e-12, 1e-10, 1e-9, 1e-8, 1e-5, 1e-2})
      for (const double sign : {-1.0, 1.0})
        for (const double roll : {0.0, kPi, 0.7})
          list.push_back(rigid_from_six({1, -2, 3, yaw, sign * (kPi / 2 - off), roll}));
  for (const double yaw : {kPi, -kPi, kPi / 2, kPi - 1e-9})
    for (const double roll : {0.0, kPi, -kPi + 1e-12}) list.push_back(rigid_from_six({0.1, 0.2, 0.3, yaw, 0.0, roll}));
  return list;
}

TEST(exporters, every_format_reads_back_what_it_wrote) {
  for (const auto& format : exporters()) {
    if (!format->holds_mounting()) continue;
    double worst = 0.0;
    for (const RigidTransform& x : mountings()) {
      const std::string text = format->write(result_with(x), {});
      const RigidTransform back = format->read(text, "export");
      worst = std::max(worst, (back.matrix() - x.matrix()).cwiseAbs().maxCoeff());
      ASSERT_LE((back.matrix() - x.matrix()).cwiseAbs().maxCoeff(), 1e-12) << format->id() << "\n"
                                                                           << text << x.matrix();
    }
    std::cout << format->id() << ": worst " << worst << "\n";
  }
}

TEST(exporters, every_format_says_its_direction) {
  ASSERT_GE(exporters().size(), 10U);
  const RigidTransform x = rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3});
  for (const auto& format : exporters()) {
    if (!format->holds_mounting()) continue;
    EXPECT_FALSE(format->description().empty());
    EXPECT_FALSE(format->file_name().empty());
    EXPECT_EQ(&exporter(format->id()), format.get());
    const bool inverse = english(format->direction()).find("ins to lidar") != std::string_view::npos;
    EXPECT_EQ(inverse, format->id() == "kitti" || format->id() == "opencalib") << format->id();
    const bool has_comments = format->id() != "opencalib" && format->id() != "json";
    const std::string text = format->write(result_with(x), {});
    EXPECT_EQ(text.find(english(format->direction())) != std::string::npos, has_comments) << text;
  }
  EXPECT_THROW(exporter("nothing"), Error);
}

// A place in the vehicle's frame must not come back as one in the INS's.
TEST(exporters, every_format_says_that_frames_are_others_or_refuses_them) {
  ResultFile file = result_with(rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3}));
  file.result.mounting.reference = calibration::BodyFrame::Vehicle;
  int told = 0, refused = 0;
  const formats::TemporaryFolder folder;
  for (const auto& format : exporters()) {
    if (!format->holds_mounting()) continue;
    std::string text;
    try {
      text = format->write(file, {});
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Contract) << format->id();
      ++refused;
      continue;
    }
    const std::filesystem::path path = folder.write("other_frames", text);
    EXPECT_EQ(read_any_mounting(path).frames.reference, calibration::BodyFrame::Vehicle) << format->id() << "\n"
                                                                                         << text;
    ++told;
  }
  std::printf("  %d formats say it, %d refuse\n", told, refused);
  EXPECT_GE(told, 8);
  EXPECT_THROW((void)exporter("opencalib").write(file, {}), Error);
}

TEST(exporters, what_is_not_observed_is_said_in_the_file) {
  ResultFile file = result_with(RigidTransform::Identity());
  file.result.status = calibration::Status::Degenerate;
  file.result.withdraw(calibration::Parameter::Z, Message::verbatim("not shown by this drive"));
  file.result.covariance.row(2).setConstant(std::nan(""));
  ASSERT_EQ(export_warnings(file.result).size(), 1U);
  EXPECT_NE(english(export_warnings(file.result)[0]).find("z"), std::string::npos);
  for (const char* id : {"kitti", "yaml", "matrix", "ros1", "ros2", "autoware", "apollo", "apollo-rfu", "urdf"})
    EXPECT_NE(exporter(id).write(file, {}).find("WARNING: not observed"), std::string::npos) << id;
  file.result.status = calibration::Status::Inconsistent;
  EXPECT_EQ(export_warnings(file.result).size(), 2U);
  EXPECT_TRUE(export_warnings(result_with(RigidTransform::Identity()).result).empty());
}

TEST(exporters, an_antenna_that_is_exported_as_a_lidar_is_said_in_the_file) {
  ResultFile file = result_with(RigidTransform::Identity());
  file.result.mounting.sensor = calibration::BodyFrame::Antenna;
  const std::vector<Message> warnings = export_warnings(file.result);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(english(warnings[0]).find("the sensor is the antenna"), std::string::npos) << english(warnings[0]);
}

TEST(exporters, kitti_and_opencalib_hold_the_inverse) {
  const ResultFile file = result_with(rigid_from_six({1, 2, 3, 0, 0, 0}));
  EXPECT_NE(exporter("kitti").write(file, {}).find("T: -1 -2 -3"), std::string::npos)
      << exporter("kitti").write(file, {});
  EXPECT_NE(exporter("opencalib").write(file, {}).find("[1, 0, 0, -1]"), std::string::npos);
  EXPECT_NE(exporter("apollo").write(file, {}).find("x: 1\n"), std::string::npos) << exporter("apollo").write(file, {});
}

TEST(exporters, kitti_has_the_time_of_the_last_scan_that_took_part) {
  ResultFile file = result_with(RigidTransform::Identity());
  EXPECT_TRUE(exporter("kitti").write(file, {}).starts_with("calib_time: unknown\nnote: "));
  file.pairs.resize(3);
  file.pairs[0].stamp_b_ns = 753000000000;  // counts from the beginning of the recording
  file.pairs[0].state = file.pairs[1].state = motion::PairState::Accepted;
  EXPECT_TRUE(exporter("kitti").write(file, {}).starts_with("calib_time: unknown\nnote: "));
  file.pairs[0].stamp_b_ns = 1317042152964000000;  // 2011-09-26 13:02:32.964 UTC
  file.pairs[1].stamp_b_ns = file.pairs[0].stamp_b_ns - 1000000000;
  file.pairs[2].stamp_b_ns = file.pairs[0].stamp_b_ns + 1000000000;
  file.pairs[2].state = motion::PairState::Rejected;
  const std::string text = exporter("kitti").write(file, {});
  EXPECT_TRUE(text.starts_with("calib_time: 26-Sep-2011 13:02:32\nnote: ")) << text;
}

TEST(exporters, apollo_rfu_turns_forward_into_its_y) {
  // A LiDAR 1 m ahead of the INS, looking ahead: in x right, y forward it is at y = 1, turned by +90 degrees.
  const std::string text = exporter("apollo-rfu").write(result_with(rigid_from_six({1, 0, 0.5, 0, 0, 0})), {});
  EXPECT_NE(text.find("    y: 1\n    z: 0.5"), std::string::npos) << text;
  EXPECT_NE(text.find("    z: 0.7071067811865"), std::string::npos) << text;
}

TEST(exporters, apollo_rfu_refuses_axes_that_are_apollos_already) {
  ResultFile file = result_with(rigid_from_six({0, 1, 0.5, 0, 0, 0}));
  file.ins_axes = drive::InsAxes::RightForwardUp;
  try {
    exporter("apollo-rfu").write(file, {});
    ADD_FAILURE() << "the axes were turned twice";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("export it as apollo"), std::string::npos) << error.what();
  }
  EXPECT_NE(exporter("apollo").write(file, {}).find("    y: 1\n"), std::string::npos);
  file.ins_axes = drive::InsAxes::ForwardLeftUp;
  EXPECT_FALSE(exporter("apollo-rfu").write(file, {}).empty());
  file.ins_axes.reset();
  EXPECT_THROW(exporter("apollo-rfu").write(file, {}), Error) << "nobody knows how they would have to be turned";
}

TEST(exporters, replace_an_export_of_their_format_and_nothing_else) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("export" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const ResultFile result = result_with(rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3}));
  save_result(result, folder / "result.yaml");
  std::ofstream(folder / "ins.csv") << "time_ns,latitude_deg\n1,2\n";
  for (const auto& format : exporters()) {
    if (!format->holds_mounting()) continue;
    const std::filesystem::path own = folder / std::string(format->id());
    EXPECT_NO_THROW(check_replaces_export(own, *format)) << "there is no such file yet";
    std::ofstream(own) << format->write(result, {});
    if (format->id() == "json")
      EXPECT_THROW(check_replaces_export(own, *format), Error) << "nothing tells it from a calibration's result";
    else
      EXPECT_NO_THROW(check_replaces_export(own, *format)) << format->id();
    for (const char* other : {"result.yaml", "ins.csv"})
      EXPECT_THROW(check_replaces_export(folder / other, *format), Error) << format->id() << " over " << other;
  }
  std::filesystem::remove_all(folder);
}

// Some readers accept what others mean differently: another order would read files otherwise.
TEST(exporters, are_tried_in_the_order_of_their_strictness) {
  const formats::TemporaryFolder folder;
  const std::filesystem::path path = folder.write("of_no_format", "nothing that anybody wrote");
  std::string said;
  try {
    (void)read_any_mounting(path);
  } catch (const Error& error) {
    said = error.what();
  }
  std::size_t at = 0;
  for (const char* id : {"opencalib", "ros2", "ros1", "urdf", "apollo", "kitti", "matrix", "autoware"}) {
    const std::size_t found = said.find("  " + std::string(id), at);
    ASSERT_NE(found, std::string::npos) << id << " is not tried, or too early: " << said;
    at = found + 1;
  }
  for (const char* id : {"yaml", "json", "apollo-rfu"}) EXPECT_EQ(exporter(id).strictness(), 0) << id;
}

TEST(exporters, published_calibrations_are_read) {
  const std::filesystem::path file =
      std::filesystem::path(REMOUNT_SOURCE_DIR) / "../shared/data/opencalib/gnss-to-top_center_lidar-extrinsic.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not there";
  const RigidTransform x = read_any_mounting(file).ins_from_lidar;
  EXPECT_NEAR((x.inverse().translation() - Eigen::Vector3d(-1, 0, -1.3)).norm(), 0.0, 1e-12);
}

TEST(exporters, names_are_used_and_escaped) {
  const ResultFile file = result_with(RigidTransform::Identity());
  EXPECT_NE(exporter("ros2").write(file, {"imu", "top"}).find("--frame-id imu --child-frame-id top"),
            std::string::npos);
  EXPECT_NE(exporter("apollo").write(file, {"novatel", "velodyne128"}).find("child_frame_id: velodyne128"),
            std::string::npos);
  EXPECT_EQ(exporter("urdf").write(file, {"a<b\"&", "c"}).find("a<b"), std::string::npos);
}

class exported_nominals : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("remount_export_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  /// As --nominal reads it.
  RigidTransform read(const std::string& name, const std::string& text) {
    doubts_.clear();
    return read_any_mounting(write(name, text), &doubts_).ins_from_lidar;
  }

  std::filesystem::path folder_;
  std::vector<Message> doubts_;
};

TEST_F(exported_nominals, are_recognised_in_every_format_whatever_the_frames_are_called) {
  const RigidTransform x = rigid_from_six({0.9, -0.25, 0.75, 2.0, -0.02, 0.015});
  for (const auto& format : exporters())
    for (const ExportNames& names : {ExportNames{}, ExportNames{"imu", "top_lidar"}, ExportNames{"base", "front"}}) {
      if (!format->holds_mounting()) continue;
      const RigidTransform back = read(std::string(format->id()) + "_" + std::string(format->file_name()),
                                       format->write(result_with(x), names));
      EXPECT_LE((back.matrix() - x.matrix()).cwiseAbs().maxCoeff(), 1e-12) << format->id();
      EXPECT_TRUE(doubts_.empty()) << format->id() << ": " << doubts_[0];
    }
}

TEST_F(exported_nominals, of_apollo_keep_their_axes_when_a_program_rewrites_them_without_comments) {
  const RigidTransform x = rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3});
  for (const char* id : {"apollo", "apollo-rfu"}) {
    std::istringstream lines(exporter(id).write(result_with(x), {}));
    std::string kept;
    for (std::string line; std::getline(lines, line);)
      if (!line.starts_with("#")) kept += line + "\n";
    EXPECT_LE((read("a.yaml", kept).matrix() - x.matrix()).cwiseAbs().maxCoeff(), 1e-12) << id;
    // Each reader knows the other's file too.
    for (const char* other : {"apollo", "apollo-rfu"})
      EXPECT_LE((exporter(other).read(kept, "a").matrix() - x.matrix()).cwiseAbs().maxCoeff(), 1e-12) << id << other;
  }
}

TEST_F(exported_nominals, of_apollo_itself_are_read_as_documented_and_the_doubt_is_said) {
  const std::string foreign =
      "header:\n  frame_id: novatel\nchild_frame_id: velodyne128\ntransform:\n"
      "  rotation: {x: 0, y: 0, z: 0.70710678118654757, w: 0.70710678118654757}\n  translation: {x: 0, y: 1, z: 0.5}\n";
  EXPECT_NEAR(read("novatel.yaml", foreign).translation().y(), 1.0, 1e-12) << "axes as in the log";
  ASSERT_EQ(doubts_.size(), 1U);
  EXPECT_NE(english(doubts_[0]).find("apollo-rfu:FILE"), std::string::npos) << doubts_[0];
  EXPECT_NEAR(exporter("apollo-rfu").read(foreign, "f").translation().x(), 1.0, 1e-12);
}

TEST_F(exported_nominals, are_turned_to_the_axes_of_the_log_where_both_are_known) {
  const RigidTransform flu = rigid_from_six({1, 0, 0.5, 0, 0, 0});
  ResultFile novatel = result_with(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).inverse() * flu);
  novatel.ins_axes = drive::InsAxes::RightForwardUp;
  std::vector<Message> doubts;
  const auto read_in = [&](const std::string& text, const std::optional<drive::InsAxes>& axes) {
    doubts.clear();
    return in_axes_of(read_any_mounting(write("n.yaml", text)), axes, doubts);
  };
  const std::string result = exporter("yaml").write(novatel, {});
  EXPECT_LT((read_in(result, drive::InsAxes::ForwardLeftUp).matrix() - flu.matrix()).norm(), 1e-12);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_NE(english(doubts[0]).find("turned to those of the log"), std::string::npos) << doubts[0];
  EXPECT_LT((read_in(result, drive::InsAxes::RightForwardUp).matrix() -
             novatel.result.mounting.reference_from_sensor.matrix())
                .norm(),
            1e-12);
  EXPECT_TRUE(doubts.empty());
  EXPECT_LT((read_in(result, {}).matrix() - novatel.result.mounting.reference_from_sensor.matrix()).norm(), 1e-12);
  const std::string same = exporter("apollo").write(novatel, {});
  EXPECT_LT(
      (read_in(same, drive::InsAxes::RightForwardUp).matrix() - novatel.result.mounting.reference_from_sensor.matrix())
          .norm(),
      1e-12);
  EXPECT_LT((read_in(same, drive::InsAxes::ForwardLeftUp).matrix() - flu.matrix()).norm(), 1e-12);
  const std::string apollo = exporter("apollo-rfu").write(result_with(flu), {});
  EXPECT_LT((read_in(apollo, drive::InsAxes::RightForwardUp).matrix() -
             novatel.result.mounting.reference_from_sensor.matrix())
                .norm(),
            1e-12);
  EXPECT_LT((read_in(apollo, drive::InsAxes::ForwardLeftUp).matrix() - flu.matrix()).norm(), 1e-12);
}

TEST_F(exported_nominals, of_other_pairs_of_sensors_are_refused) {
  EXPECT_THROW(read("calib_velo_to_cam.txt", "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\ndelta_f: 0 0\ndelta_c: 0 0\n"), Error);
  std::string inverse = exporter("opencalib").write(result_with(RigidTransform::Identity()), {"top_lidar", "gnss"});
  EXPECT_THROW(exporter("opencalib").read(inverse, "x"), Error);
}

TEST_F(exported_nominals, may_be_six_numbers_within_a_turn) {
  EXPECT_NEAR(six_from_rigid(read("six.txt", "# x y z yaw pitch roll\n0.9, -0.25, 0.75, 90, 0, 0\n")).yaw_rad, kPi / 2,
              1e-12);
  EXPECT_THROW(read("turns.txt", "0.9, -0.25, 0.75, 720, 0, 0\n"), Error);
  EXPECT_THROW(read("odd.txt", "1 2 3\n"), Error);
}

TEST(exporters, damaged_texts_are_errors) {
  std::mt19937 random(2);
  const ResultFile file = result_with(rigid_from_six({0.9, -0.25, 0.75, 2.0, -0.02, 0.015}));
  for (const auto& format : exporters()) {
    if (!format->holds_mounting()) continue;
    const std::string good = format->write(file, {});
    EXPECT_THROW(format->read("", "x"), Error) << format->id();
    int refused = 0;
    for (int i = 0; i < 60; ++i) {
      std::string text = good.substr(0, random() % good.size());
      try {
        format->read(text, "x");
      } catch (const Error&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, 30) << format->id();
  }
}

}  // namespace
}  // namespace remount::results

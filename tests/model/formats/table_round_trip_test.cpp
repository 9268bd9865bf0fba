// Tables of poses, speeds and pairs read back what was written into them, with as many digits as peers print.
#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <functional>
#include <numeric>

#include "model/formats/files/number_text.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/poses/motion_pairs_file.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/sessions/opencalib_reader.h"
#include "model/formats/sessions/smartloc_reader.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/model/formats/written_logs.h"

namespace remount::formats {
namespace {

constexpr double kEarth_m = 6'378'137.0;

std::vector<motion::StampedPose> poses(RandomValues& random, std::int64_t unit_ns) {
  std::vector<motion::StampedPose> list;
  const Eigen::Vector3d origin = random.flip()
                                     ? Eigen::Vector3d(random.between(1e5, 9e5), random.between(0.0, 1e7), 0.0)
                                     : Eigen::Vector3d::Zero();
  for (const std::int64_t stamp_ns : stamps(random, moment(random), unit_ns, 1000.0)) {
    list.push_back({stamp_ns, random.rigid()});
    list.back().pose.translation() += origin;
  }
  return list;
}

std::string pose_text(const motion::StampedPose& pose, PoseFormat format,
                      const std::function<std::string(double)>& number) {
  const Eigen::Quaterniond q(pose.pose.linear());
  const Eigen::Vector3d t = pose.pose.translation();
  const std::string stamp = seconds_text(pose.stamp_ns, 9);
  std::string line;
  const auto add = [&](std::initializer_list<double> values, char between) {
    for (const double value : values) line += between + number(value);
  };
  switch (format) {
    case PoseFormat::Tum:
    case PoseFormat::EthCsv:
      line = stamp;
      add({t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}, format == PoseFormat::Tum ? ' ' : ',');
      break;
    case PoseFormat::AloamCsv:
      line = "1,0," + std::to_string(pose.stamp_ns / kSecond_ns) + "," + std::to_string(pose.stamp_ns % kSecond_ns);
      add({t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()}, ',');
      break;
    case PoseFormat::ApolloCsv:
      line = stamp + ",56";
      add({q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z()}, ',');
      break;
    case PoseFormat::PoseLines:
      line = format_date_ns(pose.stamp_ns).substr(0, 23);
      std::replace_if(
          line.begin(), line.end(), [](char c) { return c == ' ' || c == ':' || c == '.'; }, '-');
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) line += " " + number(pose.pose(row, column));
  }
  return line + "\n";
}

TEST(table_round_trip, poses_of_every_format) {
  RandomValues random(35);
  const TemporaryFolder folder;
  const std::string head[] = {"", "",
                              "time,header.seq,header.stamp.secs,header.stamp.nsecs,pose.pose.position.x,"
                              "pose.pose.position.y,pose.pose.position.z,pose.pose.orientation.x,"
                              "pose.pose.orientation.y,pose.pose.orientation.z,pose.pose.orientation.w\n",
                              "", "timestamp,position_type,qw,qx,qy,qz,x,y,z\n"};
  for (int kind = 0; kind < 5; ++kind) {
    const auto format = static_cast<PoseFormat>(kind);
    const std::string name(to_string(format));
    Worst position(name + " position, m"), turn(name + " turn, rad");
    for (int draw = 0; draw < 60; ++draw) {
      SCOPED_TRACE(name + ", draw " + std::to_string(draw));
      const int decimals = 6 + static_cast<int>(random.below(10));
      const std::vector<motion::StampedPose> written = poses(random, format == PoseFormat::PoseLines ? 1'000'000 : 1);
      std::string text = format == PoseFormat::ApolloCsv && random.flip() ? "" : head[kind];
      for (const motion::StampedPose& pose : written)
        text += pose_text(pose, format, [&](double value) { return fixed(value, decimals); });
      std::vector<drive::Finding> findings;
      const std::filesystem::path file = folder.write("poses.txt", text);
      ASSERT_EQ(recognise_pose_file(file), format);
      const std::vector<motion::StampedPose> read = read_pose_file(file, format, findings);
      ASSERT_EQ(read.size(), written.size());
      for (std::size_t i = 0; i < read.size(); ++i) {
        ASSERT_EQ(read[i].stamp_ns, written[i].stamp_ns) << i;
        position.add((read[i].pose.translation() - written[i].pose.translation()).cwiseAbs().maxCoeff(),
                     lost(decimals) + 4e-9);
        turn.add(so3_log(read[i].pose.linear().transpose() * written[i].pose.linear()).norm(),
                 4.0 * lost(decimals) + 1e-12);
      }
    }
  }
}

TEST(table_round_trip, opencalib_folders) {
  RandomValues random(36);
  Worst position("position, m");
  Progress progress;
  for (int draw = 0; draw < 20; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const TemporaryFolder folder;
    const std::vector<motion::StampedPose> written = poses(random, 1'000'000);
    std::string text;
    std::filesystem::create_directories(folder.path() / "top_lidar");
    for (const motion::StampedPose& pose : written) {
      const std::string line = pose_text(pose, PoseFormat::PoseLines, exact_text);
      text += line;
      folder.write("top_lidar/" + line.substr(0, 23) + ".pcd",
                   "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
                   "DATA ascii\n1 2 " +
                       std::to_string(pose.stamp_ns % kSecond_ns / 1'000'000) + "\n");
    }
    folder.write("novatel-pose.txt", text);
    ASSERT_EQ(OpenCalibReader().probe(folder.path()), 80);
    const drive::Session read = OpenCalibReader().open(folder.path(), progress);
    ASSERT_EQ(read.world_from_ins.size(), written.size());
    ASSERT_EQ(read.scans->size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
      ASSERT_EQ(read.world_from_ins[i].stamp_ns, written[i].stamp_ns);
      ASSERT_EQ(read.scans->stamp_ns(i), written[i].stamp_ns);
      const auto milliseconds = static_cast<float>(written[i].stamp_ns % kSecond_ns / 1'000'000);
      EXPECT_EQ(read.scans->load(i).points.at(0).z(), milliseconds) << "the scan of this stamp";
      position.add((read.world_from_ins[i].pose.matrix() - written[i].pose.matrix()).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(table_round_trip, smartloc_drives) {
  RandomValues random(37);
  Worst worst_place("place, m"), worst_speed("speed, m/s and rad/s");
  const GeographicLib::Geocentric earth = GeographicLib::Geocentric::WGS84();
  Progress progress;
  for (int draw = 0; draw < 60; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const TemporaryFolder folder;
    const std::vector<InsLine> written = ins_lines(random, stamps(random, 100 * kSecond_ns, 1, 200.0));
    std::vector<motion::ImuSample> rates;
    std::string input, truth;
    for (const InsLine& line : written) {
      rates.push_back({line.stamp_ns,
                       {random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)},
                       Eigen::Vector3d::Zero()});
      const Eigen::Vector3d& rate = rates.back().angular_rate_radps;
      double x = 0.0, y = 0.0, z = 0.0;
      earth.Forward(line.at.latitude_deg, line.at.longitude_deg, line.height_m, x, y, z);
      const std::string time = seconds_text(line.stamp_ns, 9);
      input += "odom3 " + time + " " + exact_text(line.roll_deg) + " 0 0 " + exact_text(rate.x()) + " " +
               exact_text(rate.y()) + " " + exact_text(rate.z()) + " 1 1 1 1 1 1\n";
      if (random.flip()) input += "pseudorange3 " + time + " 2.1e7 1 2 3 4 5\n";
      truth += "point3 " + time + " " + fixed(x, 5) + " " + fixed(y, 5) + " " + fixed(z, 5) + " 0 0 0 0 0 0 0 0 0\n";
    }
    folder.write("Berlin_Input.txt", input);
    folder.write("Berlin_GT.txt", truth);
    const drive::Session read = SmartlocReader().open(folder.path(), progress);
    ASSERT_EQ(read.wheels.size(), written.size());
    ASSERT_EQ(read.imu.size(), written.size());
    ASSERT_EQ(read.gnss.size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
      ASSERT_EQ(read.wheels[i].stamp_ns, written[i].stamp_ns);
      ASSERT_EQ(read.gnss[i].stamp_ns, written[i].stamp_ns);
      worst_speed.add(std::abs(read.wheels[i].rear_left_mps - written[i].roll_deg) +
                          (read.imu[i].angular_rate_radps - rates[i].angular_rate_radps).norm(),
                      1e-14);
      const double cosine = std::cos(degrees_to_radians(written[i].at.latitude_deg));
      const double off_m = std::hypot(
          degrees_to_radians(apart_deg(read.gnss[i].latitude_rad, written[i].at.latitude_deg)) * kEarth_m,
          degrees_to_radians(apart_deg(read.gnss[i].longitude_rad, written[i].at.longitude_deg)) * kEarth_m * cosine,
          read.gnss[i].height_m - written[i].height_m);
      worst_place.add(off_m, std::sqrt(3.0) * lost(5) * 1.02 + 1e-8);
    }
  }
}

// ---- Pairs

TEST(table_round_trip, motion_pairs_with_their_columns_in_any_order) {
  RandomValues random(38);
  const TemporaryFolder folder;
  Worst worst("entry of P and Q");
  for (int draw = 0; draw < 100; ++draw) {
    SCOPED_TRACE("draw " + std::to_string(draw));
    const bool numbered = random.flip(), sets = random.flip();
    const int decimals = 6 + static_cast<int>(random.below(11));
    std::vector<std::string> names;
    for (const char letter : {'P', 'Q'})
      for (int i = 0; i < 12; ++i) names.push_back(letter + std::to_string(i / 4) + std::to_string(i % 4));
    if (numbered) names.insert(names.end(), {"i", "j"});
    if (sets) names.push_back("set");
    names.push_back("note");
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t k = order.size() - 1; k > 0; --k) std::swap(order[k], order[random.below(k + 1)]);
    const auto line_of = [&](const std::vector<std::string>& cells) {
      std::string line;
      for (const std::size_t k : order) line += (line.empty() ? "" : ",") + cells[k];
      return line + "\n";
    };
    struct Written {
      RigidTransform p, q;
      int i = 0, j = 0, set = 0;
    };
    std::vector<Written> written(1 + random.below(20));
    std::string text = "# pairs\n" + line_of(names);
    for (Written& pair : written) {
      pair = {random.rigid(), random.rigid(), static_cast<int>(random.below(50)),
              50 + static_cast<int>(random.below(50)), static_cast<int>(random.below(3))};
      std::vector<std::string> cells;
      for (const RigidTransform& matrix : {pair.p, pair.q})
        for (int i = 0; i < 12; ++i) cells.push_back(fixed(matrix(i / 4, i % 4), decimals));
      if (numbered) cells.insert(cells.end(), {std::to_string(pair.i), std::to_string(pair.j)});
      if (sets) cells.push_back("\"set " + std::to_string(pair.set) + "\"");
      cells.push_back("\"a, b\"");
      text += line_of(cells);
    }
    const MotionPairs read = read_motion_pairs(folder.write("pairs.csv", text));
    ASSERT_EQ(read.pairs.size(), written.size());
    for (std::size_t k = 0; k < written.size(); ++k) {
      const motion::Pair& pair = read.pairs[k];
      const double off = std::max((pair.ins_b_from_ins_a.matrix() - written[k].p.matrix()).cwiseAbs().maxCoeff(),
                                  (pair.lidar_b_from_lidar_a.matrix() - written[k].q.matrix()).cwiseAbs().maxCoeff());
      worst.add(off, 2.0 * lost(decimals));
      const motion::Keyframe& a = read.keyframes.at(pair.keyframe_a);
      const motion::Keyframe& b = read.keyframes.at(pair.keyframe_b);
      EXPECT_EQ(signed_of(a.scan), numbered ? written[k].j : 2 * static_cast<int>(k) + 1);
      EXPECT_EQ(signed_of(b.scan), numbered ? written[k].i : 2 * static_cast<int>(k));
      if (sets) {
        EXPECT_EQ(read.sets.at(a.session), "set " + std::to_string(written[k].set));
      }
    }
  }
}

}  // namespace
}  // namespace remount::formats

#include "model/results/exporters/several_exporter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "algorithms/core/error.h"
#include "model/results/exporters/export_text.h"
#include "model/results/lidar_names.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::results {
namespace {

LidarResult lidar_at(const std::string& name, const RigidTransform& ins_from_lidar) {
  LidarResult lidar{name, true, {}};
  lidar.file.result.status = calibration::Status::Ok;
  lidar.file.result.set_observed(calibration::ParameterSet::all(), {});
  lidar.file.result.covariance = Matrix6d::Identity() * 1e-6;
  lidar.file.result.mounting.reference_from_sensor = ins_from_lidar;
  lidar.file.ins_axes = drive::InsAxes::ForwardLeftUp;
  return lidar;
}

VehicleFile three_lidars() {
  VehicleFile vehicle;
  vehicle.lidars = {lidar_at("front", rigid_from_six({1.2, 0, 1.6, 0.01, 0, -0.04})),
                    lidar_at("rear", rigid_from_six({-1.5, 0.1, 0.9, 3.1, 0.02, 0})),
                    lidar_at("/roof/points", rigid_from_six({0, 0, 2.1, 1.5, -0.1, 0.2}))};
  vehicle.version = "0.0.1-before";
  return vehicle;
}

double worst_difference(const RigidTransform& a, const RigidTransform& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::string refusal(const std::function<void()>& what) {
  try {
    what();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST(several_exporter, every_format_of_several_reads_back_all_by_their_names) {
  const formats::TemporaryFolder folder;
  const VehicleFile vehicle = three_lidars();
  int several = 0;
  for (const auto& format : exporters()) {
    if (!format->holds_several()) continue;
    const std::string text = format->write_all(vehicle, {});
    const std::vector<NamedTransform> back = format->read_all(text, "export");
    ASSERT_EQ(back.size(), 3U) << format->id();
    const std::vector<NamedMounting> any =
        read_any_mountings(folder.write("any_" + std::string(format->id()), text), nullptr);
    ASSERT_EQ(any.size(), 3U) << format->id();
    double worst = 0.0;
    for (std::size_t l = 0; l < 3; ++l) {
      const RigidTransform& x = vehicle.lidars[l].file.result.mounting.reference_from_sensor;
      EXPECT_TRUE(is_frame_of(back[l].name, vehicle.lidars[l].name)) << format->id() << ": " << back[l].name;
      EXPECT_TRUE(is_frame_of(any[l].name, vehicle.lidars[l].name)) << format->id() << ": " << any[l].name;
      worst = std::max(
          {worst, worst_difference(back[l].ins_from_lidar, x), worst_difference(any[l].mounting.ins_from_lidar, x)});
    }
    std::printf("  %s: worst %.2g\n", std::string(format->id()).c_str(), worst);
    EXPECT_LE(worst, 1e-12) << format->id() << "\n" << text;
    ++several;
  }
  EXPECT_EQ(several, 6) << "yaml, json, ros1, ros2, autoware, urdf";
}

TEST(several_exporter, a_format_of_one_refuses_several) {
  for (const auto& format : exporters()) {
    if (format->holds_several()) continue;
    const std::string said = refusal([&] { (void)format->write_all(three_lidars(), {}); });
    EXPECT_NE(said.find("holds one LiDAR"), std::string::npos) << format->id();
  }
}

TEST(several_exporter, a_vehicle_with_one_unnamed_lidar_is_a_result_of_one) {
  VehicleFile vehicle = three_lidars();
  vehicle.lidars.resize(1);
  vehicle.lidars[0].name.clear();
  for (const auto& format : exporters()) {
    if (!format->holds_several()) continue;
    EXPECT_EQ(format->write_all(vehicle, {"imu", "top"}), format->write(vehicle.lidars[0].file, {"imu", "top"}));
  }
}

TEST(several_exporter, frames_are_called_as_asked_or_after_the_lidars) {
  ExportNames names{"imu", ""};
  names.lidar_frames = {{"rear", "rear \"2\""}};
  for (const char* id : {"ros1", "ros2", "urdf"}) {
    const std::string text = exporter(id).write_all(three_lidars(), names);
    EXPECT_NE(text.find("rear &quot;2&quot;"), std::string::npos) << text;
    EXPECT_NE(text.find("ins_from_front"), std::string::npos) << text;
    EXPECT_NE(text.find("roof_points"), std::string::npos) << text;
  }
  EXPECT_EQ(exporter("urdf").read_all(exporter("urdf").write_all(three_lidars(), names), "u")[1].name, "rear \"2\"");
  EXPECT_NE(exporter("autoware").write_all(three_lidars(), {}).find("  front_base_link:"), std::string::npos);
  names.lidar_frames = {{"rear", "front"}};
  EXPECT_NE(refusal([&] { (void)exporter("urdf").write_all(three_lidars(), names); }).find("called front"),
            std::string::npos);
}

TEST(several_exporter, what_is_not_observed_is_said_with_the_lidar) {
  VehicleFile vehicle = three_lidars();
  vehicle.lidars[1].file.result.withdraw(calibration::Parameter::Z, Message::verbatim("flat"));
  for (const char* id : {"ros1", "ros2", "urdf", "autoware", "yaml"}) {
    const std::string text = exporter(id).write_all(vehicle, {});
    EXPECT_NE(text.find("WARNING: rear: not observed"), std::string::npos) << text;
    EXPECT_EQ(text.find("WARNING: front"), std::string::npos) << text;
    EXPECT_NE(text.find("Direction: lidar to ins"), std::string::npos) << text;
  }
}

TEST(several_exporter, others_are_placed_in_the_frame_of_one_and_do_not_pass_for_mountings) {
  const VehicleFile vehicle = three_lidars(), others = relative_to(vehicle, "rear", "v");
  ASSERT_EQ(lidar_names(others), (std::vector<std::string>{"front", "/roof/points"}));
  ExportNames names{"imu", ""};  // poses in the frame of a LiDAR must not name that of the INS
  names.relative_to = "rear";
  const formats::TemporaryFolder folder;
  for (const auto& format : exporters()) {
    if (!format->names_frames()) continue;
    const std::string text = format->write_all(others, names);
    const RigidTransform rear_from_front = format->read_all(text, "x").front().ins_from_lidar;
    EXPECT_LE(worst_difference(vehicle.lidars[1].file.result.mounting.reference_from_sensor * rear_from_front,
                               vehicle.lidars[0].file.result.mounting.reference_from_sensor),
              1e-12)
        << text;
    EXPECT_NE(text.find("Direction: each lidar to the lidar rear"), std::string::npos) << text;
    EXPECT_EQ(text.find("ins_link"), std::string::npos) << text;
    EXPECT_EQ(text.find("imu"), std::string::npos) << text;
    EXPECT_EQ(text.find("called ins"), std::string::npos) << "nothing in it is\n" << text;
    const std::string why = refusal([&] { (void)read_any_mountings(folder.write("relative", text)); });
    EXPECT_NE(why.find("is relative to the LiDAR rear, not to the INS. Export the result without relative-to"),
              std::string::npos)
        << format->id() << ": " << why;
    EXPECT_EQ(why.find("opencalib"), std::string::npos) << "said once: " << why;
  }
  EXPECT_THROW((void)relative_to(vehicle, "left", "v"), Error);
}

TEST(several_exporter, what_is_observed_between_two_is_taken_as_it_is_known) {
  VehicleFile vehicle = three_lidars();
  for (LidarResult& lidar : vehicle.lidars) lidar.file.result.withdraw(calibration::Parameter::Z, {});
  RelativeRecord two;
  two.lidar_a = "front", two.lidar_b = "rear";
  two.lidar_a_from_lidar_b = rigid_from_six({-2.7, 0, -0.7, 3, 0, 0});
  for (const calibration::Parameter parameter : calibration::kParameters) two.sigma[parameter] = 0.001;
  vehicle.relatives = {two};
  const VehicleFile of_front = relative_to(vehicle, "front", "v"), of_rear = relative_to(vehicle, "rear", "v");
  EXPECT_TRUE(of_front.lidars[0].file.result.observed().is_all()) << "heights are known against each other";
  EXPECT_LE(worst_difference(of_front.lidars[0].file.result.mounting.reference_from_sensor, two.lidar_a_from_lidar_b),
            1e-15);
  EXPECT_TRUE(of_rear.lidars[0].file.result.observed().is_all());
  EXPECT_EQ(of_front.lidars[1].file.result.observed(), calibration::kAttitudeParameters)
      << "no pair joins the roof with them";
}

TEST(several_exporter, frames_that_others_carry_are_taken_to_the_root) {
  const std::string urdf =
      "<robot name=\"car\"><link name=\"base_link\"/>"
      "<joint name=\"wheel\" type=\"continuous\"><parent link=\"base_link\"/><child link=\"wheel\"/></joint>"
      "<joint name=\"b\" type=\"fixed\"><parent link=\"kit\"/><child link=\"front_link\"/>"
      "<origin xyz=\"1 0 0\" rpy=\"0 0 0\"/></joint>"
      "<joint name=\"a\" type=\"fixed\"><parent link=\"base_link\"/><child link=\"kit\"/>"
      "<origin xyz=\"0 0 2\" rpy=\"0 0 1.5707963267948966\"/></joint></robot>";
  const std::vector<NamedTransform> all = exporter("urdf").read_all(urdf, "u");
  ASSERT_EQ(all.size(), 2U) << "wheels are no LiDARs";
  EXPECT_EQ(all[0].name, "front_link");
  EXPECT_NEAR((all[0].ins_from_lidar.translation() - Eigen::Vector3d(0, 1, 2)).norm(), 0.0, 1e-12);
}

std::string launch_of(std::initializer_list<const char*> frames) {
  std::string launch = "<launch>";
  for (const char* two : frames)
    launch += std::string("<node type=\"static_transform_publisher\" args=\"1 0 0 0 0 0 1 ") + two + "\"/>";
  return launch + "</launch>";
}

std::string in_single_quotes(std::string text) {
  std::ranges::replace(text, '"', '\'');
  return text;
}

TEST(several_exporter, attributes_stand_in_either_quotes) {
  const VehicleFile vehicle = three_lidars();
  for (const char* id : {"ros1", "ros2", "urdf"}) {
    const std::string text = exporter(id).write_all(vehicle, {});
    const auto in_double = exporter(id).read_all(text, id),
               in_single = exporter(id).read_all(in_single_quotes(text), id);
    ASSERT_EQ(in_single.size(), vehicle.lidars.size()) << id;
    for (std::size_t l = 0; l < in_single.size(); ++l) {
      EXPECT_EQ(in_single[l].name, in_double[l].name) << id;
      EXPECT_EQ(worst_difference(in_single[l].ins_from_lidar, in_double[l].ins_from_lidar), 0.0) << id;
    }
    const RigidTransform first = exporter(id).read(in_single_quotes(text), id);
    EXPECT_EQ(worst_difference(first, in_double.front().ins_from_lidar), 0.0) << id;
  }
}

TEST(several_exporter, attributes_are_those_of_their_tag) {
  const std::string urdf =
      "<robot><transmission><joint name='j'/></transmission>\n"
      "<joint\n\tname = \"a='b'\"\n\ttype\n=\n'fixed'>"
      "<parent link='it&apos;s &gt; that'/><child link='a > \"b\"'/><origin rpy='0 0 0' xyz = '1 2 "
      "3'/></joint></robot>";
  const std::vector<NamedTransform> all = exporter("urdf").read_all(urdf, "u");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].name, "a > \"b\"");
  EXPECT_EQ((all[0].ins_from_lidar.translation() - Eigen::Vector3d(1, 2, 3)).norm(), 0.0);
  EXPECT_EQ(xml_unescaped("it&apos;s &gt; that &amp;gt;"), "it's > that &gt;");
  // xyz is that of the axis.
  const std::string of_axis =
      "<robot><joint name='a' type='fixed'><parent link='p'/><child link='c'/><origin rpy='0 0 0'/><axis xyz='0 0 1'/>"
      "</joint></robot>";
  EXPECT_NE(refusal([&] { (void)exporter("urdf").read_all(of_axis, "u"); }).find("xyz"), std::string::npos);
}

TEST(several_exporter, frames_without_an_outermost_are_refused) {
  for (const std::string& circle : {launch_of({"a b", "b a"}), launch_of({"a a"}), launch_of({"r x", "c b", "b c"})})
    EXPECT_NE(refusal([&] { (void)exporter("ros1").read_all(circle, "l"); }).find("in itself"), std::string::npos)
        << circle;
  const std::vector<NamedTransform> chain = exporter("ros1").read_all(launch_of({"c d", "a b", "b c"}), "l");
  ASSERT_EQ(chain.size(), 3U);
  EXPECT_NEAR(chain[0].ins_from_lidar.translation().x(), 3.0, 1e-12) << "a chain of all of them is none";
  const std::string nameless =
      "<launch><node exec=\"static_transform_publisher\" args=\"--x 1 --y 0 --z 0 --qx 0 --qy 0 --qz 0 --qw 1\"/>"
      "</launch>";
  EXPECT_NEAR(exporter("ros2").read_all(nameless, "l").front().ins_from_lidar.translation().x(), 1.0, 1e-12);
}

TEST(several_exporter, long_files_are_refused_or_read_in_time) {
  std::string many = "<launch>", open = "<robot>";
  for (int i = 0; i < 4097; ++i)
    many += "<node type=\"static_transform_publisher\" args=\"1 0 0 0 0 0 1 a b" + std::to_string(i) + "\"/>";
  EXPECT_NE(refusal([&] { (void)exporter("ros1").read_all(many, "l"); }).find("4097 transforms"), std::string::npos);
  for (int i = 0; i < 200000; ++i) open += "<joint type=\"continuous\">";  // half a minute, were each read to the end
  EXPECT_THROW((void)exporter("urdf").read_all(open, "u"), Error);
  std::string attributes = "<robot><joint";  // blanks behind all of them, looked through for each
  for (int i = 0; i < 300'000; ++i) attributes += " a=''";
  attributes += std::string(1'000'000, ' ') + "/></robot>";
  EXPECT_THROW((void)exporter("urdf").read_all(attributes, "u"), Error);
}

TEST(several_exporter, a_file_of_the_users_with_several_mountings_is_not_replaced) {
  const formats::TemporaryFolder folder;
  const std::string sensor = ": {x: 1, y: 0, z: 0, roll: 0, pitch: 0, yaw: 0}\n";
  const auto over = [&](const char* id, const std::string& text) {
    return refusal([&] { check_replaces_export(folder.write("there", text), exporter(id)); });
  };
  EXPECT_NE(over("autoware", "kit:\n  camera" + sensor + "  top" + sensor).find("is no export"), std::string::npos);
  EXPECT_EQ(over("autoware", "kit:\n  top" + sensor), "") << "of one it cannot be told";
  EXPECT_NE(over("ros1", launch_of({"base camera", "base top"})).find("is no export"), std::string::npos);
  for (const char* id : {"ros1", "ros2", "urdf", "autoware", "yaml"})
    EXPECT_EQ(over(id, exporter(id).write_all(three_lidars(), {})), "") << id;
}

TEST(several_exporter, names_that_would_be_alike_are_refused_with_both_lidars) {
  VehicleFile vehicle = three_lidars();
  vehicle.lidars[0].name = "/front/points", vehicle.lidars[1].name = "/front_points";
  for (const char* id : {"ros1", "ros2", "urdf", "autoware"}) {
    ExportNames names;
    const std::string frames = refusal([&] { (void)exporter(id).write_all(vehicle, names); });
    EXPECT_NE(frames.find("/front_points: this LiDAR and /front/points"), std::string::npos) << id << frames;
    names.lidar_frames = {{"/front_points", "other"}};
    EXPECT_EQ(refusal([&] { (void)exporter(id).write_all(vehicle, names); }), "") << id;
    names.lidar_frames = {{"/front_points", "a b"}, {"/front/points", "a/b"}};
    const std::string transforms = refusal([&] { (void)exporter(id).write_all(vehicle, names); });
    if (id != std::string("autoware")) {
      EXPECT_NE(transforms.find("ins_from_a_b"), std::string::npos) << id << transforms;
    }
  }
}

TEST(several_exporter, of_several_mountings_the_first_is_taken_with_a_doubt_where_one_is_wanted) {
  const formats::TemporaryFolder folder;
  std::vector<Message> doubts;
  const VehicleFile vehicle = three_lidars();
  const std::filesystem::path launch = folder.write("l", exporter("ros2").write_all(vehicle, {}));
  EXPECT_LE(worst_difference(read_any_mounting(launch, &doubts).ins_from_lidar,
                             vehicle.lidars[0].file.result.mounting.reference_from_sensor),
            1e-12);
  ASSERT_EQ(doubts.size(), 1U);
  EXPECT_NE(refusal([&] {
              (void)read_any_mounting(folder.write("v", exporter("yaml").write_all(vehicle, {})));
            }).find("several LiDARs"),
            std::string::npos);
}

TEST(several_exporter, damaged_texts_of_several_are_errors) {
  for (const auto& format : exporters()) {
    if (!format->holds_several()) continue;
    const std::string good = format->write_all(three_lidars(), {});
    EXPECT_THROW((void)format->read_all("", "x"), Error) << format->id();
    for (std::size_t cut = 0; cut < good.size(); cut += 1 + good.size() / 200)
      (void)refusal([&] { (void)format->read_all(good.substr(0, cut), "x"); });  // an error or fewer, no crash
  }
}

}  // namespace
}  // namespace remount::results

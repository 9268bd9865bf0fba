// What comes out of a calibration of several LiDARs, through the command line.
#include <gtest/gtest.h>

#include <fstream>
#include <optional>

#include "model/results/vehicle_file.h"
#include "tests/app/cli/program_fixture.h"
#include "tests/support/draws.h"

namespace remount::cli {
namespace {

/// Two drives of one vehicle: before the second its rear LiDAR was moved by 5 cm and a degree.
class cli_vehicle_results : public ProgramFixture<cli_vehicle_results> {
 protected:
  static constexpr const char* kDrive = " --duration-s 5 --beams 16 --azimuth-steps 250 ";

  static void SetUpTestSuite() {
    make_folder_with_drive(std::string(kDrive) +
                           "--mount front=at:1.2/0/1.6/0/0/-2.5 --mount rear=at:-1.5/0/0.9/180/0/0");
    const Outcome moved = run("simulate street " + path("moved") + kDrive +
                              "--mount front=at:1.2/0/1.6/0/0/-2.5 --mount rear=at:-1.5/0.05/0.9/179/0/0");
    ASSERT_EQ(moved.code, 0) << moved.err;
    first_ = run("calibrate " + path("drive") + " --lidars all -o " + path("vehicle.yaml"));
    const Outcome second = run("calibrate " + path("moved") + " --lidars rear,front -o " + path("moved.json"));
    ASSERT_EQ(first_.code, 0) << first_.err;
    ASSERT_EQ(second.code, 0) << second.err;
  }

  static void expect_refused(const std::string& arguments, const std::string& part) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 1) << arguments;
    EXPECT_NE(outcome.err.find(part), std::string::npos) << part << " in\n" << outcome.err;
  }
  static std::string vehicle() { return path("vehicle.yaml"); }

  inline static Outcome first_;
};

TEST_F(cli_vehicle_results, a_height_that_is_measured_of_one_serves_the_other) {
  const Outcome outcome =
      run("calibrate " + path("drive") + " --lidars all --measured rear:z=0.9,0.001 -o " + path("measured.yaml"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const results::VehicleFile measured = results::load_vehicle(path("measured.yaml")),
                             before = results::load_vehicle(vehicle());
  const auto z_of = [](const results::VehicleFile& of, const char* name) {
    return results::lidar_of(of, name, "here").file.result.estimate(calibration::Parameter::Z);
  };
  const calibration::Estimate rear = z_of(measured, "rear"), front = z_of(measured, "front");
  ASSERT_TRUE(rear.sigma && front.sigma);
  EXPECT_NEAR(rear.value, 0.9, 0.004);
  EXPECT_LT(*rear.sigma, 0.0011);
  EXPECT_NEAR(front.value, 1.6, 4.0 * *front.sigma);
  const std::optional<double> without = z_of(before, "front").sigma;
  ASSERT_TRUE(without) << "the ground is seen without it, too";
  std::printf("  sigma of z of front: %.4f m with the height of rear, %.4f m without it\n", *front.sigma, *without);
  EXPECT_LT(*front.sigma, 0.8 * *without);
}

TEST_F(cli_vehicle_results, what_was_measured_of_the_vehicle_or_twice_of_one_lidar_is_refused) {
  expect_refused("calibrate " + path("drive") + " --lidars all --measured z=0.9,0.001", "(front:z=1.73,0.01)");
  expect_refused("calibrate " + path("drive") + " --lidars all --measured left:z=0.9,0.001", "front, rear");
  const std::string twice = "calibrate " + path("drive") + " --lidars all --measured rear:z=1,1 --measured ";
  expect_refused(twice + "rear:z=2,1", "rear:z is given twice");
  expect_refused(twice + "'rear : z =2,1'", "rear:z is given twice");
  for (const char* lidars : {"all", "rear"})
    expect_refused("calibrate " + path("drive") + " --lidars " + lidars + " --measured rear:ins-height=0.6,0.02",
                   "the height of the INS is of the vehicle");
}

TEST_F(cli_vehicle_results, what_was_measured_of_the_only_lidar_may_have_its_name) {
  const std::string one = "calibrate " + path("drive") + " --lidars front --measured ";
  const Outcome named = run(one + "front:z=1.6,0.001 -o " + path("named.yaml"));
  ASSERT_EQ(named.code, 0) << named.err;
  const calibration::Estimate z = results::load_result(path("named.yaml")).result.estimate(calibration::Parameter::Z);
  ASSERT_TRUE(z.sigma);
  std::printf("  z of front is %.5f m, sigma %.5f m\n", z.value, *z.sigma);
  EXPECT_NEAR(z.value, 1.6, 0.004);
  EXPECT_LT(*z.sigma, 0.0011);
  expect_refused(one + "rear:z=0.9,0.001", "rear is not among the LiDARs that are calibrated. They are: front");
  expect_refused(one + "z=1.6,0.01 --measured front:z=1.7,0.01", "z is given twice");
}

void expect_parts(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
}

TEST_F(cli_vehicle_results, are_said_of_each_lidar_and_of_where_they_sit_against_each_other) {
  expect_parts(first_.out, {"== front ==\nstatus: ok", "== rear ==\nstatus: ok", "ins_from_lidar (pose of the lidar",
                            "== against each other ==\nrear in the frame of front\n  x         -2."});
  const results::VehicleFile file = results::load_vehicle(vehicle());
  EXPECT_EQ(results::lidar_names(file), (std::vector<std::string>{"front", "rear"}));
  const RigidTransform truth = rigid_from_six({-1.5, 0, 0.9, kPi, 0, 0});
  const Vector6d off = difference(truth, file.lidars[1].file.result.mounting.reference_from_sensor);
  std::printf("  rear is off by %.4f m, %.4f rad\n", off.head<3>().norm(), off.tail<3>().norm());
  EXPECT_LT(off.head<2>().norm(), 0.02);
  EXPECT_LT(off.tail<3>().norm(), 0.002);
  ASSERT_EQ(file.relatives.size(), 1U);
  EXPECT_NEAR(file.relatives[0].height_m, -0.7, 0.02);
  EXPECT_NEAR(file.relatives[0].lidar_a_from_lidar_b.translation().x(), -2.7, 0.005);
  EXPECT_FALSE(file.lidars[0].file.inputs.empty());
  EXPECT_EQ(results::lidar_names(results::load_vehicle(path("moved.json"))),
            (std::vector<std::string>{"rear", "front"}))
      << "as they were named";
}

TEST_F(cli_vehicle_results, of_one_lidar_are_those_of_one) {
  const Outcome named = run("calibrate " + path("drive") + " --lidars rear -o " + path("rear.yaml"));
  ASSERT_EQ(named.code, 0) << named.err;
  EXPECT_FALSE(results::is_vehicle_file(path("rear.yaml")));
  EXPECT_EQ(named.out.find("--lidars all"), std::string::npos) << named.out;
  EXPECT_EQ(run("compare " + vehicle() + " " + path("rear.yaml") + " --lidar rear").code, 0);
  expect_refused("calibrate " + path("drive") + " -o " + vehicle(), "holds the results of several LiDARs");
  expect_refused("calibrate " + path("drive") + " --lidars all -o " + path("rear.yaml"), "remount-vehicle/");
}

TEST_F(cli_vehicle_results, options_that_go_with_one_lidar_and_names_that_are_none_are_refused) {
  const std::string all = "calibrate " + path("drive") + " --lidars all ";
  expect_refused("calibrate " + path("drive") + " --lidars front,left",
                 "left: is no LiDAR of these recordings. They have: front, rear");
  expect_refused("calibrate " + path("drive") + " --lidars front,front", "names a LiDAR twice");
  expect_refused(all + "--follow --method trajectory", "--follow: goes with one LiDAR");
  expect_refused(all + "--save-project " + path("p.remount"), "--save-project: goes with one LiDAR");
  for (const char* names : {"all", "rear"})
    expect_refused("calibrate --project " + path("p.remount") + " --lidars " + names,
                   "--project: goes with one LiDAR, that of its sessions, and not with --lidars");
  expect_refused(all + "--method trajectory", "--method: goes with one LiDAR");
  expect_refused(all + "--measured z=1.6,0.01",
                 "angles are of one LiDAR, whose name is expected before them (front:z=");
  expect_refused(all + "--topic lidar=front", "expected one of them");
  expect_refused(all + "--nominal 1.2,0,1.6,0,0,0", "expected NAME=SIX or NAME=FILE");
  expect_refused(all + "--nominal front=1,2,3,0,0,0 --nominal front=1,2,3,0,0,0", "front is given twice");
}

TEST_F(cli_vehicle_results, are_exported_into_one_file_or_one_for_each) {
  const Outcome launch = run("export " + vehicle() + " --to ros2 --lidar-frame front=front_link --ins-frame imu");
  EXPECT_EQ(launch.code, 0) << launch.err;
  expect_parts(launch.out, {"--frame-id imu --child-frame-id front_link", "--frame-id imu --child-frame-id rear"});
  const Outcome relative = run("export " + vehicle() + " --to urdf --relative-to front");
  expect_parts(relative.out, {"each lidar to the lidar front", "<parent link=\"front\"/>", "<child link=\"rear\"/>"});
  const Outcome apollo = run("export " + vehicle() + " --to apollo -o " + path("apollo"));
  EXPECT_EQ(apollo.code, 0) << apollo.err;
  expect_parts(text_of(path("apollo/rear_novatel_extrinsics.yaml")),
               {"child_frame_id: rear", "# Direction: lidar to ins"});
  EXPECT_TRUE(std::filesystem::exists(path("apollo/front_novatel_extrinsics.yaml")));
  EXPECT_EQ(run("export " + vehicle() + " --to matrix --lidar rear").code, 0);
  for (const char* frame : {"tail", "rear=tail"}) {
    const Outcome one = run("export " + vehicle() + " --to ros2 --lidar rear --lidar-frame " + frame);
    EXPECT_EQ(one.code, 0) << one.err;
    expect_parts(one.out, {"--child-frame-id tail"});
  }
  expect_refused("export " + vehicle() + " --to ros2 --lidar rear --lidar-frame a --lidar-frame rear=b", "twice");
  expect_refused("export " + vehicle() + " --to kitti", "-o FOLDER");
  expect_refused("export " + vehicle() + " --to json --relative-to front", "ros1, ros2, autoware, urdf");
  expect_refused("export " + vehicle() + " --to urdf --lidar-frame top", "expected NAME=FRAME");
  expect_refused("export " + vehicle() + " --to urdf --lidar left", "It has: front, rear");
  expect_refused("export " + vehicle() + " --to yaml -o " + vehicle(), "result");
}

TEST_F(cli_vehicle_results, exports_lose_no_lidar_and_no_file) {
  expect_refused("export " + vehicle() + " --to urdf --relative-to front --ins-frame imu", "excludes");
  expect_refused("export " + vehicle() + " --to apollo --lidar-frame front=a --lidar-frame rear=A -o " + path("alike"),
                 "rear: this LiDAR and front would both be called a_novatel_extrinsics.yaml");
  EXPECT_FALSE(std::filesystem::exists(path("alike")));
  results::VehicleFile file = results::load_vehicle(vehicle());
  file.lidars[1].file.result.status = calibration::Status::TooFewPairs;
  results::save_vehicle(file, path("rear_unusable.yaml"));
  ASSERT_EQ(run("export " + vehicle() + " --to urdf --relative-to front -o " + path("good.urdf")).code, 0);
  const std::string good = text_of(path("good.urdf"));
  for (const char* reference : {"front", "rear"}) {
    const Outcome outcome = run("export " + path("rear_unusable.yaml") + " --to urdf --relative-to " + reference +
                                " -o " + path("good.urdf"));
    EXPECT_EQ(outcome.code, 3) << outcome.err;
    expect_parts(outcome.err, {"rear is left out", "no other LiDAR can be placed"});
    EXPECT_EQ(text_of(path("good.urdf")), good) << reference;
  }
}

TEST_F(cli_vehicle_results, of_a_file_whose_format_is_named_the_lidar_has_its_own_mounting) {
  ONLY_IN_LONG_TESTS();
  ASSERT_EQ(run("export " + vehicle() + " --to ros2 -o " + path("tf.launch.xml")).code, 0);
  const std::string from = "calibrate " + path("drive") + " --lidars rear --nominal ";
  for (const std::string& nominal : {"rear=ros2:" + path("tf.launch.xml"), "ros2:" + path("tf.launch.xml")}) {
    const Outcome outcome = run(from + nominal + " -o " + path("own.json"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(results::load_result(path("own.json"))
                    .nominal_ins_from_lidar->isApprox(results::find_lidar(results::load_vehicle(vehicle()), "rear")
                                                          ->file.result.mounting.reference_from_sensor,
                                                      1e-9))
        << nominal;
  }
  ASSERT_EQ(run("export " + vehicle() + " --to ros2 --lidar-frame rear=x --lidar-frame front=y -o " + path("xy")).code,
            0);
  const Outcome first = run(from + "ros2:" + path("xy") + " -o " + path("first.json"));
  expect_parts(first.err, {"the first of them is taken: y, x"});
}

TEST_F(cli_vehicle_results, exports_are_nominals_of_all_lidars_by_their_names) {
  ONLY_IN_LONG_TESTS();
  ASSERT_EQ(run("export " + vehicle() + " --to autoware --lidar-frame rear=camera -o " + path("kit.yaml")).code, 0);
  const Outcome outcome = run("calibrate " + path("drive") + " --lidars all --nominal " + path("kit.yaml") +
                              " --nominal rear=-1.5,0,0.9,180,0,0 -o " + path("with_nominal.yaml"));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  expect_parts(outcome.out, {"holds mountings of other names, which are not used: camera"});
  const results::VehicleFile file = results::load_vehicle(path("with_nominal.yaml")),
                             from = results::load_vehicle(vehicle());
  for (const results::LidarResult& lidar : file.lidars) ASSERT_TRUE(lidar.file.nominal_ins_from_lidar) << lidar.name;
  EXPECT_TRUE(file.lidars[0].file.nominal_ins_from_lidar->isApprox(
      from.lidars[0].file.result.mounting.reference_from_sensor, 1e-9));
  const Outcome rear =
      run("calibrate " + path("drive") + " --lidars rear --nominal " + vehicle() + " -o " + path("r.json"));
  EXPECT_EQ(rear.code, 0) << rear.err;
  EXPECT_TRUE(results::load_result(path("r.json"))
                  .nominal_ins_from_lidar->isApprox(from.lidars[1].file.result.mounting.reference_from_sensor, 1e-9));
  const Outcome of_one = run("calibrate " + path("drive") + " --lidars all --nominal front=1.2,0,1.6,0,0,-2.5");
  expect_parts(of_one.out, {"no nominal mounting is given of rear"});
  std::ofstream(path("twice.urdf"))
      << R"(<robot name="v"><joint name="a" type="fixed"><parent link="ins"/><child link="front"/>
    <origin xyz="1 0 1" rpy="0 0 0"/></joint><joint name="b" type="fixed"><parent link="ins"/><child link="front"/>
    <origin xyz="2 0 1" rpy="0 0 0"/></joint></robot>)";
  expect_refused("calibrate " + path("drive") + " --lidars all --nominal " + path("twice.urdf"),
                 "two mountings that are called front");
  expect_refused("calibrate " + path("drive") + " --lidars all --nominal " + path("apollo_of_none.yaml"),
                 "expected NAME=SIX");
}

TEST_F(cli_vehicle_results, of_a_bag_go_with_names_that_are_parts_of_its_topics) {
  const Outcome bag = run("simulate street " + path("bag") + kDrive + "--format mcap " +
                          "--mount front=at:1.2/0/1.6/0/0/-2.5 --mount rear=at:-1.5/0/0.9/180/0/0");
  ASSERT_EQ(bag.code, 0) << bag.err;
  const Outcome made =
      run("calibrate " + path("bag") +
          " --lidars rear,front --measured rear:z=0.9,0.001 --nominal rear=-1.5,0,0.9,180,0,0 -o " + path("bag.yaml"));
  ASSERT_EQ(made.code, 0) << made.err;
  expect_refused("calibrate " + path("bag") + " --lidars rear,lidar_rear", "names a LiDAR twice");
  const results::VehicleFile file = results::load_vehicle(path("bag.yaml"));
  EXPECT_EQ(results::lidar_names(file), (std::vector<std::string>{"/lidar_rear/points", "/lidar_front/points"}));
  EXPECT_LT(results::lidar_of(file, "rear", "bag").file.result.estimate(calibration::Parameter::Z).sigma.value_or(1.0),
            0.0011)
      << "its height was measured";
  EXPECT_TRUE(results::lidar_of(file, "/lidar_rear/points", "bag").file.nominal_ins_from_lidar.has_value());
  const Outcome same = run("compare " + vehicle() + " " + path("bag.yaml"));
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  expect_parts(same.out, {"/lidar_rear/points of bag and rear of vehicle are taken for the same LiDAR"});
  EXPECT_EQ(run("compare " + vehicle() + " " + path("bag.yaml") + " --lidar rear").code, 0);
  const std::string xacro = "export " + path("bag.yaml") + " --to urdf --relative-to front --lidar-frame rear=velo -o ";
  const Outcome exported = run(xacro + path("bag.urdf"));
  EXPECT_EQ(exported.code, 0) << exported.err;
  expect_parts(text_of(path("bag.urdf")), {"\"velo\""});
  EXPECT_EQ(run("export " + path("bag.yaml") + " --to yaml --lidar rear").code, 0);
  EXPECT_EQ(run("report " + path("bag.yaml") + " " + path("bag") + " --lidar rear -o " + path("bag.html")).code, 0);
  expect_parts(text_of(path("bag.html")), {"/lidar_rear/points"});
  const Outcome obstacles = run("obstacles " + path("bag") + " --scan 3 --result " + path("bag.yaml") +
                                " --lidar rear --nominal " + path("bag.yaml"));
  EXPECT_EQ(obstacles.code, 0) << obstacles.err;
}

TEST_F(cli_vehicle_results, that_differ_say_which_lidar_moved) {
  const Outcome same = run("compare " + vehicle() + " " + vehicle());
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  const Outcome moved = run("compare " + vehicle() + " " + path("moved.json"));
  EXPECT_EQ(moved.code, 3) << moved.out << moved.err;
  expect_parts(moved.out, {"moved less vehicle", "\nfront ", "\nrear "});
  expect_parts(moved.err, {"Moved, or claiming too much: rear."});
  EXPECT_EQ(run("compare " + vehicle() + " " + path("moved.json") + " --lidar front").code, 0);
  const Outcome rear = run("compare " + vehicle() + " " + path("moved.json") + " --lidar rear");
  EXPECT_EQ(rear.code, 3);
  expect_parts(rear.err, {"vehicle rear and moved rear contradict each other"});
}

TEST_F(cli_vehicle_results, are_reported_together_or_one_of_them) {
  EXPECT_EQ(run("report " + vehicle() + " -o " + path("all.html")).code, 0);
  expect_parts(text_of(path("all.html")), {": front</h1>", ": rear</h1>", "rear in the frame of front"});
  const std::string of_rear = "report " + vehicle() + " " + path("drive") + " --lidar rear -o " + path("one.html");
  const Outcome rear = run(of_rear);
  EXPECT_EQ(rear.code, 0) << "the session is opened with the LiDAR of the result\n" << rear.err;
  EXPECT_EQ(text_of(path("one.html")).find(": front</h1>"), std::string::npos);
  EXPECT_EQ(run(of_rear + " --topic lidar=rear").code, 0);
  expect_refused(of_rear + " --topic lidar=front", "front");
  expect_refused("report " + vehicle() + " " + path("drive") + " -o " + path("all.html"), "expected --lidar NAME");
}

TEST_F(cli_vehicle_results, tell_obstacles_of_the_lidar_that_is_named) {
  const std::string scan = "obstacles " + path("drive") + " --scan 3 --result ";
  const Outcome rear = run(scan + vehicle() + " --lidar rear --nominal " + vehicle());
  EXPECT_EQ(rear.code, 0) << rear.err;
  ASSERT_EQ(run("export " + vehicle() + " --to yaml --lidar rear -o " + path("rear_alone.yaml")).code, 0);
  const Outcome alone =
      run(scan + path("rear_alone.yaml") + " --topic lidar=rear --nominal " + path("rear_alone.yaml"));
  EXPECT_EQ(alone.code, 0) << alone.err;
  EXPECT_EQ(rear.out, alone.out) << "the session is opened with the LiDAR of the result";
  const Outcome front = run(scan + vehicle() + " --lidar front --nominal 1.2,0,1.6,0,0,0");
  EXPECT_EQ(front.code, 0) << front.err;
  EXPECT_NE(front.out, rear.out);
  expect_refused(scan + vehicle(), "expected --lidar NAME with one of front, rear");
  expect_refused(scan + vehicle() + " --lidar left", "It has: front, rear");
  expect_refused(scan + path("rear_alone.yaml") + " --lidar rear", "goes with a result of several LiDARs");
}

TEST_F(cli_vehicle_results, are_refused_with_a_way_out_where_the_result_of_one_is_expected) {
  for (const std::string& arguments :
       {"calibrate " + path("drive") + " --nominal " + vehicle(),
        "odometry " + path("drive") + " --nominal " + vehicle() + " -o " + path("poses.txt"),
        "beams " + vehicle() + " --into " + path("none.xml") + " -o " + path("x.xml"),
        "calibrate " + path("drive") + " --method trajectory --set beams.file=" + vehicle() + " --topic lidar=rear"}) {
    const Outcome outcome = run(arguments);
    EXPECT_NE(outcome.code, 0) << arguments;
    const bool says = outcome.err.find("remount-cli export") != std::string::npos ||
                      outcome.err.find("expected --lidar NAME") != std::string::npos ||
                      outcome.err.find("The method pairwise finds them") != std::string::npos;
    EXPECT_TRUE(says) << arguments << "\n" << outcome.err;
  }
}

TEST_F(cli_vehicle_results, are_offered_where_one_of_several_is_calibrated) {
  const Outcome one = run("calibrate " + path("drive"));
  EXPECT_EQ(one.code, 0);
  expect_parts(one.out, {"note: 2 LiDARs are in this recording: --lidars all calibrates them together"});
}

}  // namespace
}  // namespace remount::cli

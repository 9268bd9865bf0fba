#include "model/guesses/description.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>

#include "algorithms/messages/render.h"
#include "model/formats/documents/document.h"
#include "model/formats/sessions/native_session_reader.h"
#include "model/guesses/manifest.h"
#include "tests/model/guesses/written_tables.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> angles(const drive::AttitudeAngles& a, double yaw_sign = 1.0) {
  return {degrees_text(a.roll_rad), degrees_text(a.pitch_rad), degrees_text(yaw_sign * a.yaw_rad)};
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string>& then) {
  first.insert(first.end(), then.begin(), then.end());
  return first;
}

std::vector<std::string> place_deg(const WrittenSample& s) {
  return {degrees_text(s.ins.latitude_rad), degrees_text(s.ins.longitude_rad), number(s.ins.height_m)};
}

std::vector<std::string> place_m(const WrittenSample& s) {
  const Eigen::Vector3d p = s.world_from_ins.translation();
  return {number(p.x()), number(p.y()), number(p.z())};
}

std::vector<std::string> wxyz(const Eigen::Quaterniond& q) {
  return {number(q.w()), number(q.x()), number(q.y()), number(q.z())};
}

/// North, east, down from forward, right, down.
Eigen::Quaterniond ned_from_frd(const Eigen::Quaterniond& enu_from_flu) {
  Eigen::Matrix3d ned_from_enu;
  ned_from_enu << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  const Eigen::Matrix3d flu_from_frd = Eigen::Vector3d(1, -1, -1).asDiagonal();
  return Eigen::Quaterniond(ned_from_enu * enu_from_flu.toRotationMatrix() * flu_from_frd);
}

/// Layouts that differ in names, order, units, conventions, separators and clocks.
std::vector<WrittenLayout> layouts() {
  std::vector<WrittenLayout> all;
  all.push_back(
      {"a maker's CSV with GPS week",
       "GPS Week,TOW(s),Latitude(deg),Longitude(deg),Height(m),Roll(deg),Pitch(deg),Heading(deg),Course(deg)\n", ",",
       false, [](const WrittenSample& s) {
         const std::int64_t gps_ns = formats::gps_ns_from_unix_ns(s.ins.stamp_ns);
         constexpr std::int64_t kWeek_ns = 604'800'000'000'000;
         return joined(joined({std::to_string(gps_ns / kWeek_ns), seconds_text(gps_ns % kWeek_ns)}, place_deg(s)),
                       joined(angles(heading_angles(s)), {"12.5"}));
       }});
  all.push_back({"Chinese names, commas of decimals",
                 "项目：测试\n时间(毫秒);航向角(度);俯仰角(度);横滚角(度);纬度(度);经度(度);高程(米)\n", ";", true,
                 [](const WrittenSample& s) {
                   const drive::AttitudeAngles a = heading_angles(s);
                   return joined({std::to_string(s.ins.stamp_ns / 1'000'000), degrees_text(a.yaw_rad),
                                  degrees_text(a.pitch_rad), degrees_text(a.roll_rad)},
                                 place_deg(s));
                 }});
  all.push_back({"tabs, radians, yaw from east", "lon_rad\tlat_rad\talt\troll\tpitch\tyaw\tstamp_us\tvel_x\n", "\t",
                 false, [](const WrittenSample& s) {
                   const drive::AttitudeAngles a = yaw_angles(s);
                   return std::vector<std::string>{number(s.ins.longitude_rad),
                                                   number(s.ins.latitude_rad),
                                                   number(s.ins.height_m),
                                                   number(a.roll_rad),
                                                   number(a.pitch_rad),
                                                   number(a.yaw_rad),
                                                   std::to_string(s.ins.stamp_ns / 1000),
                                                   "1.5"};
                 }});
  all.push_back({"poses between blanks, w first", "# trajectory of the INS\n# t x y z qw qx qy qz\n", " ", false,
                 [](const WrittenSample& s) {
                   return joined(joined({seconds_text(s.ins.stamp_ns)}, place_m(s)),
                                 wxyz(Eigen::Quaterniond(s.world_from_ins.linear())));
                 }});
  all.push_back({"numbers alone", "", " ", false, [](const WrittenSample& s) {
                   return joined(joined({seconds_text(s.ins.stamp_ns)}, place_deg(s)), angles(heading_angles(s)));
                 }});
  all.push_back({"dates, quaternion of north-east-down", "utc time,lat,lon,alt,q.x,q.y,q.z,q.w\n", ",", false,
                 [](const WrittenSample& s) {
                   const std::vector<std::string> q = wxyz(ned_from_frd(s.ins.enu_from_ins));
                   std::string date = formats::format_date_ns(s.ins.stamp_ns) + "Z";
                   date[10] = 'T';
                   return joined(joined({date}, place_deg(s)), {q[1], q[2], q[3], q[0]});
                 }});
  all.push_back(
      {"yaw from north to the left, nose up", "time[s]|latitude|longitude|altitude|yaw[deg]|pitch[deg]|roll[deg]\n",
       "|", false, [](const WrittenSample& s) {
         const drive::AttitudeAngles a = heading_angles(s);
         return joined(joined({seconds_text(s.ins.stamp_ns)}, place_deg(s)),
                       {degrees_text(wrap_angle_rad(-a.yaw_rad)), degrees_text(a.pitch_rad), degrees_text(a.roll_rad)});
       }});
  all.push_back({"a message as columns",
                 "field.header.seq,field.header.stamp.secs,field.header.stamp.nsecs,field.pose.pose.position.x,field."
                 "pose.pose.position.y,field.pose.pose.position.z,field.pose.pose.orientation.x,field.pose.pose."
                 "orientation.y,field.pose.pose.orientation.z,field.pose.pose.orientation.w\n",
                 ",", false, [](const WrittenSample& s) {
                   const std::vector<std::string> q = wxyz(Eigen::Quaterniond(s.world_from_ins.linear()));
                   return joined(joined({"7", std::to_string(s.ins.stamp_ns / 1'000'000'000),
                                         std::to_string(s.ins.stamp_ns % 1'000'000'000)},
                                        place_m(s)),
                                 {q[1], q[2], q[3], q[0]});
                 }});
  all.push_back({"north, east, down", "Time(ns),North(m),East(m),Down(m),Heading(deg),Pitch(deg),Roll(deg)\n", ",",
                 false, [](const WrittenSample& s) {
                   const std::vector<std::string> p = place_m(s);
                   WrittenSample turned = s;
                   turned.ins.enu_from_ins = Eigen::Quaterniond(s.world_from_ins.linear());
                   const drive::AttitudeAngles a = heading_angles(turned);
                   return std::vector<std::string>{std::to_string(s.ins.stamp_ns),
                                                   p[1],
                                                   p[0],
                                                   number(-s.world_from_ins.translation().z()),
                                                   degrees_text(a.yaw_rad),
                                                   degrees_text(a.pitch_rad),
                                                   degrees_text(a.roll_rad)};
                 }});
  all.push_back({"yaw from east, nose up, two times", "host_time,timestamp (s),lat,lng,height,yaw,pitch,roll\n", ",",
                 false, [](const WrittenSample& s) {
                   const drive::AttitudeAngles a = yaw_angles(s);
                   return joined(
                       joined({seconds_text(s.ins.stamp_ns + 37'000'000), seconds_text(s.ins.stamp_ns)}, place_deg(s)),
                       {degrees_text(a.yaw_rad), degrees_text(-a.pitch_rad), degrees_text(a.roll_rad)});
                 }});
  return all;
}

/// Degrees and radians are turned into each other for the text and back: the last digit of a longitude is a nanometre.
constexpr double kTextPrecision = 3e-9;

/// A drive on a ramp, as a native session and as tables.
class description : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    native_ = new formats::TemporaryFolder;
    simulator::SimulationOptions options = simulator::parking_ramp();
    options.duration_s = 25.0;
    Progress progress;
    simulator::write_drive(simulator::simulate_drive(options), native_->path() / "drive", "native", 1, progress);
    session_ = new drive::Session(formats::open_session(native_->path() / "drive", progress));
    samples_ = new std::vector<WrittenSample>(written_samples(*session_));
  }
  static void TearDownTestSuite() {
    delete samples_;
    delete session_;
    delete native_;
  }

  static fs::path native_drive() { return native_->path() / "drive"; }

  /// Writes the manifest and opens it.
  static drive::Session opened(const Description& described, const fs::path& folder) {
    std::ofstream(folder / "session.yaml") << formats::to_yaml(manifest_of(described, folder, Language::English));
    Progress progress;
    return formats::open_session(folder / "session.yaml", progress);
  }

  static Description described(const std::vector<fs::path>& paths) {
    Progress progress;
    return describe_data(paths, progress);
  }

  static formats::TemporaryFolder* native_;
  static drive::Session* session_;
  static std::vector<WrittenSample>* samples_;
};
formats::TemporaryFolder* description::native_ = nullptr;
drive::Session* description::session_ = nullptr;
std::vector<WrittenSample>* description::samples_ = nullptr;

/// Largest difference of motions over ten samples, m + rad.
double motions_apart(const drive::Session& a, const drive::Session& b) {
  const std::vector<motion::StampedPose> poses_a = drive::metric_poses(a), poses_b = drive::metric_poses(b);
  EXPECT_EQ(poses_a.size(), poses_b.size());
  double worst = poses_a.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i + 10 < std::min(poses_a.size(), poses_b.size()); ++i) {
    EXPECT_EQ(poses_a[i].stamp_ns, poses_b[i].stamp_ns) << i;
    if (poses_a[i].stamp_ns != poses_b[i].stamp_ns) return 1.0;
    const RigidTransform motion_a = poses_a[i].pose.inverse() * poses_a[i + 10].pose,
                         motion_b = poses_b[i].pose.inverse() * poses_b[i + 10].pose;
    worst = simulator::worse_of(worst, (motion_a.matrix() - motion_b.matrix()).norm());
  }
  return worst;
}

bool says(const std::vector<Message>& messages, std::string_view code) {
  return std::ranges::any_of(messages, [&](const Message& one) { return one.code() == code; });
}

const Guess* find_guess(const std::vector<Guess>& guesses, GuessKind kind) {
  const auto found = std::ranges::find(guesses, kind, &Guess::kind);
  return found == guesses.end() ? nullptr : &*found;
}

TEST_F(description, tables_of_every_layout_give_the_motions_of_the_native_session) {
  const ScanNames names[] = {ScanNames::Table, ScanNames::Nanoseconds, ScanNames::RowsOfTimes, ScanNames::RowsWithNames,
                             ScanNames::Microseconds};
  std::size_t i = 0;
  for (const WrittenLayout& layout : layouts()) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), names[i++ % 5]);
    folder.write("motion.txt", table_text(layout, *samples_));
    const Description found = described({folder.path()});
    ASSERT_FALSE(found.known) << layout.name << ": " << found.known->format;
    EXPECT_TRUE(found.complete()) << layout.name << ": "
                                  << (found.missing.empty() ? "" : english(found.missing.front()));
    const std::string manifest = formats::to_yaml(manifest_of(found, folder.path(), Language::English));
    SCOPED_TRACE(layout.name + "\n" + manifest);
    if (!found.complete()) continue;
    const drive::Session session = opened(found, folder.path());
    const double apart = motions_apart(session, *session_);
    const Guess* attitude = find_guess(found.ins->guesses, GuessKind::Attitude);
    std::cout << layout.name << ": motions " << apart << " apart; attitude " << english(words(attitude->sureness))
              << "\n";
    EXPECT_LT(apart, kTextPrecision);
    ASSERT_TRUE(session.scans);
    EXPECT_EQ(session.scans->size(), session_->scans->size());
    EXPECT_LT(std::abs(session.scans->stamp_ns(3) - session_->scans->stamp_ns(3)), 1000)
        << "some names hold microseconds";
    EXPECT_EQ(session.scan_timing, drive::ScanTiming::PerPoint);
    EXPECT_LE(attitude->sureness, layout.head.empty() ? Sureness::Likely : Sureness::Checked);
    EXPECT_TRUE(says(found.clock->evidence, "guess-clock-within"));
    EXPECT_EQ(found.clock->sureness, Sureness::Checked);
  }
}

TEST_F(description, calibrations_of_described_tables_find_the_same_mounting) {
  const formats::TemporaryFolder native;
  simulator::SimulationOptions options = simulator::parking_ramp();
  options.beams = 16, options.azimuth_steps = 300;
  options.duration_s = 12.0;
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(options), native.path() / "drive", "native", 1, progress);
  const drive::Session original = formats::open_session(native.path() / "drive", progress);
  const std::vector<WrittenSample> samples = written_samples(original);
  const auto calibrate = [](const drive::Session& session) {
    pipeline::PipelineInput input;
    input.sessions = {std::make_shared<drive::Session>(session)};
    input.nominal_ins_from_lidar = simulator::parking_ramp().ins_from_lidar;
    input.settings.run.map_check = false;
    Progress progress;
    const calibration::CalibrationResult result = simulator::by_pairs(input, progress);
    EXPECT_TRUE(calibration::is_usable(result)) << english(result.message);
    (void)testing::error_of(result, simulator::parking_ramp().ins_from_lidar);
    return result.mounting.ins_from_lidar();
  };
  // A manifest by hand, which says no more than the tables do.
  std::ofstream(native.path() / "drive" / "plain.yaml")
      << "format: remount-session/1\nname: plain\n"
         "scans: {directory: scans, type: pcd, stamps: scan_stamps.csv, timing: per-point}\n"
         "ins:\n  file: ins.csv\n  columns:\n    time: {name: time_ns, unit: ns, scale: unix}\n"
         "    latitude: {name: latitude_deg, unit: deg}\n    longitude: {name: longitude_deg, unit: deg}\n"
         "    height: {name: height_m, unit: m}\n"
         "    attitude: {convention: enu-yaw, unit: deg, yaw: yaw_deg, pitch: pitch_deg, roll: roll_deg}\n";
  const RigidTransform expected = calibrate(formats::open_session(native.path() / "drive" / "plain.yaml", progress));
  const std::vector<WrittenLayout> all = layouts();
  for (const auto& [i, limit] : {std::pair(std::size_t{2}, 1e-9), {std::size_t{1}, 2e-4}}) {
    const formats::TemporaryFolder folder;
    write_scans(native.path() / "drive", folder.path(), ScanNames::Nanoseconds);
    folder.write("motion.csv", table_text(all[i], samples));
    const RigidTransform found = calibrate(opened(described({folder.path()}), folder.path()));
    const double apart = (found.matrix() - expected.matrix()).norm();
    std::cout << all[i].name << ": mountings " << apart << " apart\n";
    EXPECT_LT(apart, limit)
        << "a nanometre of the text may change which points are matched, and X by a tenth of its sigma";
  }
}

TEST_F(description, what_a_format_is_known_of_needs_no_manifest) {
  const Description native = described({native_drive()});
  ASSERT_TRUE(native.known);
  EXPECT_EQ(native.known->format, "native");
  simulator::SimulationOptions options = simulator::with_few_rays();
  options.clockwise = false;
  const formats::TemporaryFolder folder;
  Progress progress;
  simulator::write_drive(simulator::simulate_drive(options), folder.path() / "k", "kitti-raw", 1, progress);
  const Description kitti = described({folder.path() / "k"});
  ASSERT_TRUE(kitti.known);
  EXPECT_EQ(kitti.known->format, "kitti-raw");
}

TEST_F(description, a_vehicle_that_stands_does_not_tell_how_its_heading_counts) {
  std::vector<WrittenSample> standing = *samples_;
  for (WrittenSample& sample : standing) {
    const std::int64_t stamp_ns = sample.ins.stamp_ns;
    sample = samples_->front();
    sample.ins.stamp_ns = stamp_ns;
  }
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[9], standing));  // "yaw", which may be either
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* attitude = find_guess(found.ins->guesses, GuessKind::Attitude);
  ASSERT_NE(attitude, nullptr);
  EXPECT_EQ(attitude->sureness, Sureness::Open);
  EXPECT_TRUE(says(attitude->evidence, "guess-hardly-moves"));
  EXPECT_GE(attitude->alternatives.size(), 3U) << "the other ways to count it";
  EXPECT_TRUE(found.open());
  const formats::TemporaryFolder unnamed;
  write_scans(native_drive(), unnamed.path(), ScanNames::Nanoseconds);
  unnamed.write("motion.txt", table_text(layouts()[4], standing));
  const Description nothing = described({unnamed.path()});
  EXPECT_FALSE(nothing.ins) << "numbers that nobody names and nothing moves";
  EXPECT_FALSE(nothing.complete());
}

TEST_F(description, garbage_is_no_motion_and_no_scan) {
  const formats::TemporaryFolder folder;
  std::string noise;
  for (unsigned i = 0; i < 5000; ++i) noise += static_cast<char>((i * 2654435761U) >> 13);
  folder.write("a.txt", noise);
  folder.write("b.csv", "once,upon,a,time\nthere,was,a,table\nthat,held,no,numbers\n,,,\n\n");
  folder.write("c.pcd", "no cloud at all");
  folder.write("d.csv", "");
  const Description found = described({folder.path()});
  EXPECT_FALSE(found.ins);
  EXPECT_TRUE(found.lidars.empty());
  EXPECT_TRUE(says(found.missing, "guess-needs-ins"));
  EXPECT_TRUE(says(found.missing, "guess-needs-lidar"));
  EXPECT_FALSE(found.complete());
}

TEST_F(description, numbers_that_move_and_have_no_attitude_are_said_to_lack_it) {
  std::string text = "time,latitude,longitude,height,speed,satellites\n";
  for (const WrittenSample& sample : *samples_)
    text += seconds_text(sample.ins.stamp_ns) + "," + degrees_text(sample.ins.latitude_rad) + "," +
            degrees_text(sample.ins.longitude_rad) + "," + number(sample.ins.height_m) + ",3.5,12\n";
  const formats::TemporaryFolder folder;
  folder.write("fixes.csv", text);
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  const Description found = described({folder.path()});
  EXPECT_FALSE(found.ins);
  ASSERT_EQ(found.not_used.size(), 1U);
  EXPECT_TRUE(formats::contains(english(found.not_used.front().why), "attitude")) << found.not_used.front().why;
}

TEST_F(description, of_two_times_the_other_is_named_with_the_difference) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.txt", table_text(layouts()[9], *samples_));
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.ins);
  const Guess* time = find_guess(found.ins->guesses, GuessKind::Time);
  EXPECT_EQ(time->columns, std::vector<std::string>{"timestamp (s)"});
  ASSERT_EQ(time->alternatives.size(), 1U);
  EXPECT_TRUE(formats::contains(english(time->alternatives.front()), "0.037 s")) << time->alternatives.front();
}

TEST_F(description, clocks_that_do_not_meet_are_told_with_what_would_bring_them_together) {
  for (const auto& [shift_s, code] :
       {std::pair(315'964'782LL, "guess-offset-epoch"), {8LL * 3600, "guess-offset-zone"}}) {
    std::vector<WrittenSample> shifted = *samples_;
    for (WrittenSample& sample : shifted) sample.ins.stamp_ns -= shift_s * 1'000'000'000;
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    folder.write("motion.txt", table_text(layouts()[5], shifted));  // dates: no other epoch is meant
    const Description found = described({folder.path()});
    ASSERT_TRUE(found.ins && found.clock);
    EXPECT_EQ(found.clock->sureness, Sureness::Open);
    ASSERT_EQ(found.clock->alternatives.size(), 1U) << shift_s;
    const Argument* cause = found.clock->alternatives.front().argument("cause");
    ASSERT_NE(cause, nullptr);
    EXPECT_EQ(std::get<Message>(cause->value).code(), code) << found.clock->alternatives.front();
  }
}

TEST_F(description, seconds_of_a_week_that_nothing_names_take_the_week_of_the_scans) {
  WrittenLayout layout = layouts()[0];
  layout.head = "TOW(s),Latitude(deg),Longitude(deg),Height(m),Roll(deg),Pitch(deg),Heading(deg),Course(deg)\n";
  const auto with_week = layout.row;
  layout.row = [&](const WrittenSample& sample) {
    std::vector<std::string> fields = with_week(sample);
    fields.erase(fields.begin());
    return fields;
  };
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  folder.write("motion.csv", table_text(layout, *samples_));
  const Description found = described({folder.path()});
  ASSERT_TRUE(found.complete());
  const double apart = motions_apart(opened(found, folder.path()), *session_);
  std::cout << "motions " << apart << " apart\n";
  EXPECT_LT(apart, kTextPrecision);
}

}  // namespace
}  // namespace remount::guesses

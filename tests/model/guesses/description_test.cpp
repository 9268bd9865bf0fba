#include "model/guesses/description.h"

#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/messages/render.h"
#include "tests/model/guesses/described_drive.h"

namespace remount::guesses {
namespace {

namespace fs = std::filesystem;

class description : public DescribedDrive {};

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
    // Names of x, y and z alone do not tell whether they count east, north and up.
    const Sureness least = layout.name == "poses between blanks, w first" ? Sureness::Open
                           : layout.head.empty()                          ? Sureness::Likely
                                                                          : Sureness::Checked;
    EXPECT_LE(attitude->sureness, least);
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
    Progress calibrating;
    const calibration::CalibrationResult result = simulator::by_pairs(input, calibrating);
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

}  // namespace
}  // namespace remount::guesses

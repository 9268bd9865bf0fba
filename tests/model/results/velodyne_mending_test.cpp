#include "model/results/velodyne_mending.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "algorithms/geometry/rotation.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::results {
namespace {

using formats::CalibratedLaser;
using formats::NumberInText;
using formats::read_velodyne_calibration;
using formats::VelodyneCalibration;

// As the maker writes it: attributes of boost, tabs, and a third laser that is not in use.
const std::string kXml =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\" ?>\r\n<!DOCTYPE boost_serialization>\r\n"
    "<boost_serialization signature=\"serialization::archive\" version=\"4\">\r\n"
    "<DB class_id=\"0\" tracking_level=\"1\" version=\"0\" object_id=\"_0\">\r\n\t<distLSB_>0.2</distLSB_>\r\n"
    "\t<enabled_ class_id=\"4\"><count>3</count><item>1</item><item>1</item><item>0</item></enabled_>\r\n"
    "\t<points_ class_id=\"7\"><count>3</count><!-- <px> in a remark -->\r\n"
    "\t\t<item class_id=\"8\"><px class_id=\"9\" "
    "object_id=\"_1\"><id_>0</id_><rotCorrection_>-4.6461787</rotCorrection_>"
    "<vertCorrection_>-7.2296872</vertCorrection_><distCorrection_>118.20465</distCorrection_>"
    "<distCorrectionX_>123.05249</distCorrectionX_><distCorrectionY_>121.988</distCorrectionY_>"
    "<vertOffsetCorrection_>21.569468</vertOffsetCorrection_></px></item>\r\n"
    "\t\t<item><px><id_>1</id_><vertCorrection_> 2.5 </vertCorrection_><distCorrection_>0</distCorrection_>"
    "<distCorrectionX_>0</distCorrectionX_><distCorrectionY_>0</distCorrectionY_></px></item>\r\n"
    "\t\t<item><px><id_>2</id_><vertCorrection_>0</vertCorrection_><distCorrection_>0</distCorrection_></px></item>\r\n"
    "\t</points_>\r\n</DB>\r\n</boost_serialization>\r\n";

const std::string kYaml =
    "# of the second LiDAR\nlasers:\n"
    "- {dist_correction: 1.1820465, dist_correction_x: 1.2305249, dist_correction_y: 1.21988, laser_id: 0,\n"
    "  rot_correction: -0.08109, vert_correction: -0.12618184, vert_offset_correction: 0.21569468}\n"
    "- dist_correction: 0.0\n  laser_id: 1\n  vert_correction: 0.043633231\nnum_lasers: 2\n";

// Elevations 0.2 degrees up below the horizon and 0.1 above it, ranges 3 cm longer, and a scale that has no place.
cloud::BeamErrors some_errors() {
  const cloud::BeamNodes& nodes = cloud::BeamNodes::all_around();
  cloud::BeamErrors errors(nodes);
  for (Eigen::Index node = 0; node < nodes.count(); ++node) {
    errors.values[nodes.elevation_at(node)] = degrees_to_radians(nodes.elevation_rad(node) < 0.0 ? 0.2 : 0.1);
    errors.values[nodes.range_at(node)] = 0.03;
  }
  errors.values[nodes.range_scale()] = 0.001;
  return errors;
}

void expect_moved(const VelodyneCalibration& before, const VelodyneCalibration& after) {
  const double up_deg[] = {0.2, 0.1};
  ASSERT_EQ(after.lasers.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const CalibratedLaser &was = before.lasers[i], &is = after.lasers[i];
    const double moved_deg = radians_to_degrees((is.elevation.value - was.elevation.value) * before.elevation_unit_rad);
    std::printf("  laser %zu: elevation %+.6f deg", i, moved_deg);
    EXPECT_NEAR(moved_deg, up_deg[i], 2e-5);
    ASSERT_EQ(is.distances.size(), was.distances.size());
    for (std::size_t d = 0; d < was.distances.size(); ++d) {
      const double longer_m = (is.distances[d].value - was.distances[d].value) * before.distance_unit_m;
      std::printf(", distance %+.6f m", longer_m);
      EXPECT_NEAR(longer_m, 0.03, 3e-6);
    }
    std::printf("\n");
  }
}

// What is left of a text without the numbers that were found in it.
std::string without_numbers(const VelodyneCalibration& calibration) {
  std::string text = calibration.text;
  for (auto laser = calibration.lasers.rbegin(); laser != calibration.lasers.rend(); ++laser) {
    std::vector<NumberInText> numbers = laser->distances;
    numbers.push_back(laser->elevation);
    std::ranges::sort(numbers, std::greater(), &NumberInText::begin);
    for (const NumberInText& number : numbers) text.erase(number.begin, number.length);
  }
  return text;
}

TEST(velodyne_mending, gets_each_lasers_elevation_and_distances_in_its_own_units_and_nothing_else) {
  for (const std::string& text : {kXml, kYaml}) {
    const VelodyneCalibration before = read_velodyne_calibration(text, "db");
    ASSERT_EQ(before.lasers.size(), 2U) << "the third is not in use";
    EXPECT_NEAR(before.lasers[0].elevation.value * before.elevation_unit_rad, degrees_to_radians(-7.2296872), 1e-8);
    EXPECT_NEAR(before.lasers[0].distances.at(1).value * before.distance_unit_m, 1.2305249, 1e-9);
    EXPECT_EQ(before.lasers[1].distances.size(), 1U) << "near distances of 0 are none";
    const VelodyneCalibration after = read_velodyne_calibration(with_beams_mended(before, some_errors()), "db");
    expect_moved(before, after);
    EXPECT_EQ(without_numbers(after), without_numbers(before));
  }
  const VelodyneCalibration xml = read_velodyne_calibration(kXml, "db");
  EXPECT_NE(with_beams_mended(xml, some_errors()).find("<vertCorrection_> 2.6"), std::string::npos);
}

TEST(velodyne_mending, attributes_stand_in_either_quotes) {
  std::string single = kXml;
  std::ranges::replace(single, '"', '\'');
  const VelodyneCalibration one = read_velodyne_calibration(kXml, "db"),
                            other = read_velodyne_calibration(single, "db");
  ASSERT_EQ(other.lasers.size(), one.lasers.size());
  for (std::size_t i = 0; i < one.lasers.size(); ++i)
    EXPECT_EQ(other.lasers[i].elevation.value, one.lasers[i].elevation.value);
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(velodyne_mending, that_is_damaged_or_none_is_refused_with_the_place_and_what_was_expected) {
  const auto read = [](const std::string& text) { return read_velodyne_calibration(text, "db.xml"); };
  EXPECT_ERROR(read(changed(kXml, "</px>", "</py>")), "db.xml:8: closes \"py\", which is not open");
  EXPECT_ERROR(read(kXml.substr(0, kXml.size() - 30)), "is not closed");
  EXPECT_ERROR(read(changed(kXml, "<vertCorrection_>-7.2296872</vertCorrection_>", "")),
               "db.xml:8: the laser has no vert");
  EXPECT_ERROR(read(changed(kXml, "-7.2296872", "minus seven")), "db.xml:8: vertCorrection_ is 'minus seven'");
  EXPECT_ERROR(read(changed(kXml, "-7.2296872", "-722.96872")), "expected -90 to 90 degrees");
  EXPECT_ERROR(read(changed(kXml, "118.20465", "11820465")), "expected at most 10 m");
  EXPECT_ERROR(read(changed(kXml, "<id_>0", "<id_>-3")), "expected 0 to 255");
  EXPECT_ERROR(read("<boost_serialization></boost_serialization>"), "holds no laser that is in use");
  std::string deep;
  for (int i = 0; i < 100; ++i) deep += "<a>";
  EXPECT_ERROR(read(deep), "more than 32 deep");
  EXPECT_ERROR(read("lasers: []\n"), "holds no laser");
  EXPECT_ERROR(read(changed(kYaml, "vert_correction: -0.12618184", "vert_correction: -12.618184")),
               "in radians in YAML");
  EXPECT_ERROR(read(changed(kYaml, "# of the second LiDAR", "# vert_correction: 3")),
               "cannot be found again in the text");
}

}  // namespace
}  // namespace remount::results

// Tables as makers' programs export them, in which names, axes or letters are other than a program expects.
#include <gtest/gtest.h>

#include <iostream>

#include "algorithms/geodesy/earth_radius.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {
namespace {

/// "256.1234 10.5 …", as they stand in a row parted by blanks.
std::string blank_row(const Fields& fields) {
  std::string row;
  for (const std::string& field : fields) row += (row.empty() ? "" : " ") + field;
  return row + "\n";
}

/// Roll, pitch and heading, then velocities that change as much as they do.
Fields with_velocities(const WrittenSample& sample) {
  const drive::AttitudeAngles a = heading_angles(sample);
  return joined(joined({seconds_text(sample.ins.stamp_ns)}, place_deg(sample)),
                joined(angles(a), {number(4.0 * std::sin(a.yaw_rad)), number(4.0 * std::cos(a.yaw_rad)), "0.1"}));
}

class vendor_tables : public DescribedRows {
 protected:
  /// Of a table written in one piece.
  static Description described_text(const formats::TemporaryFolder& folder, const std::string& text) {
    folder.write("ins.txt", text);
    return described({folder.path()});
  }
};

// As an export of POSPac: titles parted by commas, a remark about units, rows parted by blanks.
TEST_F(vendor_tables, titles_may_be_parted_otherwise_than_rows) {
  for (const char* between : {", ", "; "}) {
    const formats::TemporaryFolder folder;
    std::string text = "Mission : 1\nDatum   : WGS84\n\n";
    bool first = true;
    for (const char* title : {"TIME", "LATITUDE", "LONGITUDE", "ELLIPSOID HEIGHT", "ROLL", "PITCH", "HEADING",
                              "EAST VELOCITY", "NORTH VELOCITY", "UP VELOCITY"})
      text += (std::exchange(first, false) ? "" : between) + std::string(title);
    text += "\n(time in Sec, lat, long in Degrees, orientation angles in Degrees, velocity in Meter/Sec)\n\n";
    for (const WrittenSample& sample : *samples_) text += blank_row(with_velocities(sample));
    const Description found = described_text(folder, text);
    const Guess* attitude = guess_of(found, GuessKind::Attitude);
    ASSERT_TRUE(attitude) << between;
    EXPECT_EQ(attitude->columns, (Fields{"HEADING", "PITCH", "ROLL"}));
    EXPECT_EQ(attitude->sureness, Sureness::Checked);
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    EXPECT_LT(motions_apart(opened(described({folder.path()}), folder.path()), *session_), kTextPrecision);
  }
}

TEST_F(vendor_tables, which_column_is_roll_is_left_open_where_none_has_a_name) {
  const formats::TemporaryFolder folder;
  std::string text;
  for (const WrittenSample& sample : *samples_) text += blank_row(with_velocities(sample));
  const Description found = described_text(folder, text);
  const Guess* attitude = guess_of(found, GuessKind::Attitude);
  ASSERT_TRUE(attitude);
  EXPECT_EQ(attitude->columns, (Fields{"6", "5", "4"})) << "a vehicle leans little";
  EXPECT_EQ(attitude->sureness, Sureness::Open);
  EXPECT_TRUE(says(attitude->evidence, "guess-roll-column-not-told"));
}

TEST_F(vendor_tables, a_quaternion_may_count_from_north_and_downwards) {
  for (const auto& [head, named] :
       {std::pair("timestamp,position[0],position[1],position[2],q[0],q[1],q[2],q[3]\n", false),
        {"timestamp,x,y,z,qw,qx,qy,qz\n", false},
        {"timestamp,pos_n,pos_e,pos_d,q0,q1,q2,q3\n", true}}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    write_rows(folder.path() / "ins.csv", head, [](std::size_t, const WrittenSample& sample) {
      const Fields east_north_up = place_m(sample);
      Eigen::Matrix3d ned_from_enu, frd_from_flu;
      ned_from_enu << 0, 1, 0, 1, 0, 0, 0, 0, -1;
      frd_from_flu << 1, 0, 0, 0, -1, 0, 0, 0, -1;
      const Eigen::Quaterniond q(ned_from_enu * sample.world_from_ins.linear() * frd_from_flu);
      return Fields{std::to_string(sample.ins.stamp_ns),
                    east_north_up[1],
                    east_north_up[0],
                    number(-sample.world_from_ins.translation().z()),
                    number(q.w()),
                    number(q.x()),
                    number(q.y()),
                    number(q.z())};
    });
    const Description found = described({folder.path()});
    const Guess* attitude = guess_of(found, GuessKind::Attitude);
    ASSERT_TRUE(attitude) << head;
    if (named) {
      EXPECT_EQ(attitude->sureness, Sureness::Checked) << head;
      EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision) << head;
      continue;
    }
    EXPECT_EQ(attitude->sureness, Sureness::Open) << head;
    EXPECT_TRUE(says(attitude->evidence, "guess-down-not-told")) << head;
    ASSERT_EQ(attitude->alternatives.size(), 1U) << head;
    const std::string other = english(attitude->alternatives.front());
    EXPECT_TRUE(formats::contains(other, "down: ") && formats::contains(other, "quaternion-ned")) << other;
  }
}

TEST_F(vendor_tables, latitude_and_longitude_may_be_called_each_other) {
  const formats::TemporaryFolder folder;
  write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
  write_rows(folder.path() / "ins.csv", "time,longitude,latitude,height,roll,pitch,heading\n",
             [](std::size_t, const WrittenSample& sample) {
               return joined({std::to_string(sample.ins.stamp_ns)}, geodetic(sample));
             });
  const Description found = described({folder.path()});
  const Guess* position = guess_of(found, GuessKind::Position);
  ASSERT_TRUE(position);
  EXPECT_EQ(position->columns, (Fields{"longitude", "latitude", "height"})) << "as they are, not as they are called";
  EXPECT_EQ(position->sureness, Sureness::Open);
  EXPECT_TRUE(says(position->evidence, "guess-latitude-exchanged"));
  EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision);
}

TEST_F(vendor_tables, titles_in_old_encodings_are_understood_and_columns_go_by_number) {
  for (const char* head : {"\xca\xb1\xbc\xe4,\xce\xb3\xb6\xc8,\xbe\xad\xb6\xc8,\xb8\xdf\xb3\xcc,\xba\xe1\xb9\xf6,"
                           "\xb8\xa9\xd1\xf6,\xba\xbd\xcf\xf2\xbd\xc7\n",  // GBK: 时间,纬度,…
                           // The same beside a name that only the larger of the two sets of characters has.
                           "\xca\xb1\xbc\xe4,\xce\xb3\xb6\xc8,\xbe\xad\xb6\xc8,\xb8\xdf\xb3\xcc,\xba\xe1\xb9\xf6,"
                           "\xb8\xa9\xd1\xf6,\xba\xbd\xcf\xf2\xbd\xc7,\x95\x6e\n",
                           "time,lat [\xb0],lon [\xb0],h,roll [\xb0],pitch [\xb0],heading [\xb0]\n"}) {
    const formats::TemporaryFolder folder;
    write_scans(native_drive(), folder.path(), ScanNames::Nanoseconds);
    const bool one_more = std::ranges::count(std::string_view(head), ',') == 7;
    write_rows(folder.path() / "ins.csv", head, [&](std::size_t, const WrittenSample& sample) {
      return joined(joined({std::to_string(sample.ins.stamp_ns)}, geodetic(sample)), one_more ? Fields{"7"} : Fields());
    });
    const Description found = described({folder.path()});
    const Guess* position = guess_of(found, GuessKind::Position);
    ASSERT_TRUE(position);
    EXPECT_EQ(position->sureness, Sureness::Named) << head;
    EXPECT_LT(motions_apart(opened(found, folder.path()), *session_), kTextPrecision) << head;
  }
}

TEST_F(vendor_tables, positions_from_the_middle_of_the_earth_are_refused_by_name) {
  const formats::TemporaryFolder folder;
  write_rows(folder.path() / "ins.csv", "time,X-ECEF (m),Y-ECEF (m),Z-ECEF (m),heading,pitch,roll\n",
             [](std::size_t, const WrittenSample& sample) {
               const double lat = sample.ins.latitude_rad, lon = sample.ins.longitude_rad,
                            r = geodesy::kEarthRadius_m + sample.ins.height_m;
               const Fields roll_pitch_yaw = angles(heading_angles(sample));
               return Fields{seconds_text(sample.ins.stamp_ns),
                             number(r * std::cos(lat) * std::cos(lon)),
                             number(r * std::cos(lat) * std::sin(lon)),
                             number(r * std::sin(lat)),
                             roll_pitch_yaw[2],
                             roll_pitch_yaw[1],
                             roll_pitch_yaw[0]};
             });
  const Description found = described({folder.path()});
  EXPECT_FALSE(found.ins);
  EXPECT_TRUE(says_why(found, "middle of the earth"));
}

}  // namespace
}  // namespace remount::guesses

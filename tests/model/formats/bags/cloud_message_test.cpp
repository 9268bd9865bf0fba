#include "model/formats/bags/cloud_message.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/formats/bags/message_writer.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/model/formats/bags/field_types.h"

namespace remount::bags {
namespace {

struct Field {
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t type = kF32;
  std::uint32_t count = 1;
};

struct Layout {
  std::vector<Field> fields;
  std::uint32_t point_bytes = 0;
  std::uint32_t height = 1, width = 2;
  std::uint32_t row_bytes = 0;
  bool big_endian = false;
};

/// A message whose points are `data`.
std::string message(const Layout& layout, const std::string& data, MessageEncoding encoding = MessageEncoding::Ros1) {
  MessageWriter writer(encoding);
  writer.header(kStart_ns, "lidar").number(layout.height).number(layout.width);
  writer.number(static_cast<std::uint32_t>(layout.fields.size()));
  for (const Field& field : layout.fields)
    writer.string(field.name).number(field.offset).number(field.type).number(field.count);
  writer.number(static_cast<std::uint8_t>(layout.big_endian)).number(layout.point_bytes);
  writer.number(layout.row_bytes > 0 ? layout.row_bytes : layout.point_bytes * layout.width);
  return writer.byte_sequence(data).number<std::uint8_t>(1).bytes();
}

formats::ReadCloud read_cloud(const std::string& bytes, MessageEncoding encoding = MessageEncoding::Ros1,
                              MessageKind kind = MessageKind::PointCloud2) {
  MessageReader reader(bytes, encoding, "a.bag: /points, message 1");
  return read_cloud(reader, kind, kStart_ns);
}

/// The bytes of one point, with values where the fields lie.
class Point {
 public:
  explicit Point(const Layout& layout) : layout_(layout), bytes_(layout.point_bytes, '\0') {}
  template <class T>
  Point& set(const std::string& name, T value) {
    std::string raw_value = raw(value);
    if (layout_.big_endian) std::reverse(raw_value.begin(), raw_value.end());
    for (const Field& field : layout_.fields)
      if (field.name == name) bytes_.replace(field.offset, raw_value.size(), raw_value);
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  const Layout& layout_;
  std::string bytes_;
};

/// Two points, (1, 2, 3) and (-4, 5, 6), with times as the driver writes them.
template <class Time>
std::string two_points(const Layout& layout, const std::string& time, Time first, Time second) {
  const std::string a = Point(layout).set("x", 1.0f).set("y", 2.0f).set("z", 3.0f).set(time, first).bytes();
  return a + Point(layout).set("x", -4.0f).set("y", 5.0f).set("z", 6.0f).set(time, second).bytes();
}

void expect_two_points(const cloud::PointCloud& cloud, float first_s, float second_s) {
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_EQ(cloud.points[0], Eigen::Vector3f(1, 2, 3));
  EXPECT_EQ(cloud.points[1], Eigen::Vector3f(-4, 5, 6));
  ASSERT_EQ(cloud.time_from_stamp_s.size(), 2u);
  EXPECT_NEAR(cloud.time_from_stamp_s[0], first_s, 1e-6);
  EXPECT_NEAR(cloud.time_from_stamp_s[1], second_s, 1e-6);
}

std::vector<Field> xyz_and(std::vector<Field> more) {
  std::vector<Field> fields{{"x", 0}, {"y", 4}, {"z", 8}};
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

TEST(cloud_message, of_velodyne_has_seconds_from_the_stamp) {
  const Layout layout{xyz_and({{"intensity", 12}, {"ring", 16, kU16}, {"time", 18}}), 22};
  for (const MessageEncoding encoding : {MessageEncoding::Ros1, MessageEncoding::Cdr}) {
    expect_two_points(read_cloud(message(layout, two_points(layout, "time", 0.0f, 0.09f), encoding), encoding).cloud,
                      0.0f, 0.09f);
    // Stamped at the end of the turn: times go back from there.
    expect_two_points(read_cloud(message(layout, two_points(layout, "time", -0.09f, 0.0f), encoding), encoding).cloud,
                      -0.09f, 0.0f);
  }
}

TEST(cloud_message, of_ouster_has_nanoseconds_from_the_stamp) {
  const Layout layout{xyz_and({{"intensity", 16},
                               {"t", 20, kU32},
                               {"reflectivity", 24, kU16},
                               {"ring", 26, kU16},
                               {"ambient", 28, kU16},
                               {"range", 32, kU32}}),
                      48};
  expect_two_points(read_cloud(message(layout, two_points(layout, "t", 100'000U, 99'900'000U))).cloud, 0.0001f,
                    0.0999f);
}

TEST(cloud_message, of_hesai_and_robosense_has_seconds_since_1970) {
  const double stamp_s = static_cast<double>(kStart_ns) * 1e-9;
  const Layout hesai{xyz_and({{"intensity", 16}, {"timestamp", 24, kF64}, {"ring", 32, kU16}}), 48};
  expect_two_points(read_cloud(message(hesai, two_points(hesai, "timestamp", stamp_s, stamp_s + 0.0999))).cloud, 0.0f,
                    0.0999f);
  const Layout robosense{xyz_and({{"intensity", 12}, {"ring", 16, kU16}, {"timestamp", 18, kF64}}), 26};
  expect_two_points(read_cloud(message(robosense, two_points(robosense, "timestamp", stamp_s - 0.1, stamp_s))).cloud,
                    -0.1f, 0.0f);
}

TEST(cloud_message, of_livox_has_nanoseconds_since_1970_or_from_the_stamp) {
  const Layout layout{xyz_and({{"intensity", 12}, {"tag", 16, kU8}, {"line", 17, kU8}, {"timestamp", 18, kF64}}), 26};
  const auto stamp = static_cast<double>(kStart_ns);
  expect_two_points(read_cloud(message(layout, two_points(layout, "timestamp", stamp, stamp + 5e7))).cloud, 0.0f,
                    0.05f);
  const Layout offsets{xyz_and({{"offset_time", 12, kU32}, {"line", 16, kU8}}), 17};
  expect_two_points(read_cloud(message(offsets, two_points(offsets, "offset_time", 0U, 50'000'000U))).cloud, 0.0f,
                    0.05f);
}

TEST(cloud_message, of_livox_own_kind_is_read_in_both_serialisations) {
  for (const MessageEncoding encoding : {MessageEncoding::Ros1, MessageEncoding::Cdr}) {
    MessageWriter writer(encoding);
    writer.header(kStart_ns, "livox").number(static_cast<std::uint64_t>(kStart_ns)).number<std::uint32_t>(2);
    for (int i = 0; i < 4; ++i) writer.number<std::uint8_t>(0);
    writer.number<std::uint32_t>(2);
    for (const float sign : {1.0f, -1.0f}) {
      writer.number<std::uint32_t>(sign > 0 ? 0 : 50'000'000);
      writer.number(sign * 1.0f).number(2.0f).number(3.0f);
      writer.number<std::uint8_t>(40).number<std::uint8_t>(16).number<std::uint8_t>(sign > 0 ? 0 : 5);
    }
    const cloud::PointCloud cloud = read_cloud(writer.bytes(), encoding, MessageKind::LivoxCustom).cloud;
    ASSERT_EQ(cloud.size(), 2u);
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f(-1, 2, 3));
    EXPECT_EQ(cloud.ring[1], 5);
    EXPECT_EQ(cloud.intensity[0], 40.0f);
    EXPECT_FLOAT_EQ(cloud.time_from_stamp_s[1], 0.05f);
  }
}

TEST(cloud_message, is_read_in_either_byte_order_and_any_order_of_fields) {
  Layout layout{{{"Z", 3, kF64}, {"time", 30}, {"x", 11}, {"ring", 16, kU8}, {"y", 20}}, 40};
  for (const bool big_endian : {false, true}) {
    layout.big_endian = big_endian;
    std::string data;
    for (const double z : {3.0, 6.0})
      data += Point(layout)
                  .set("Z", z)
                  .set("x", z < 4.0 ? 1.0f : -4.0f)
                  .set("y", z < 4.0 ? 2.0f : 5.0f)
                  .set("time", static_cast<float>(z / 100.0))
                  .set<std::uint8_t>("ring", 9)
                  .bytes();
    const cloud::PointCloud cloud = read_cloud(message(layout, data)).cloud;
    expect_two_points(cloud, 0.03f, 0.06f);
    EXPECT_EQ(cloud.ring[0], 9);
  }
}

TEST(cloud_message, has_rows_with_a_rest_at_their_end) {
  Layout layout{xyz_and({}), 12, 2, 1, 20};
  std::string data = Point(layout).set("x", 1.0f).bytes() + std::string(8, 'x');
  data += Point(layout).set("x", 2.0f).bytes();  // the last row may end with its last point
  const cloud::PointCloud cloud = read_cloud(message(layout, data)).cloud;
  ASSERT_EQ(cloud.size(), 2u);
  EXPECT_EQ(cloud.points[1].x(), 2.0f);
}

TEST(cloud_message, with_times_of_another_clock_starts_at_its_stamp) {
  const double stamp_s = static_cast<double>(kStart_ns) * 1e-9;
  const Layout layout{xyz_and({{"timestamp", 12, kF64}}), 20};
  // The leap seconds between UTC and TAI, as a sensor on PTP has them.
  const formats::ReadCloud apart =
      read_cloud(message(layout, two_points(layout, "timestamp", stamp_s + 37.0, stamp_s + 37.09)));
  EXPECT_TRUE(apart.points_have_another_clock);
  EXPECT_NEAR(apart.cloud.time_from_stamp_s[0], 0.0f, 1e-4);
  EXPECT_NEAR(apart.cloud.time_from_stamp_s[1], 0.09f, 1e-4);
  EXPECT_FALSE(
      read_cloud(message(layout, two_points(layout, "timestamp", stamp_s, stamp_s + 0.1))).points_have_another_clock);
}

/// A hundred points from `first` on, one time each.
template <class Time>
std::string points_with_times(const Layout& layout, const std::vector<Time>& times) {
  std::string data;
  for (const Time time : times)
    data += Point(layout).set("x", 1.0f).set("y", 2.0f).set("z", 3.0f).set("timestamp", time).bytes();
  return data;
}

TEST(cloud_message, with_times_since_power_up_keeps_its_sweep) {
  struct Sensor {
    const char* what;
    double first, sweep, unit_s;
  };
  for (const auto& [what, first, sweep, unit_s] :
       {Sensor{"Hesai and RoboSense, s", 1234.5, 0.1, 1.0}, Sensor{"Livox, ns", 2.0e11, 1e8, 1e-9}})
    for (const bool backwards : {false, true})
      for (const bool zero_among_them : {false, true}) {
        std::vector<double> times;
        for (int i = 0; i <= 100; ++i) times.push_back(first + sweep * (backwards ? 100 - i : i) / 100.0);
        if (zero_among_them) times[40] = 0.0;
        Layout layout{xyz_and({{"timestamp", 12, kF64}}), 20, 1, 101};
        const formats::ReadCloud cloud = read_cloud(message(layout, points_with_times(layout, times)));
        EXPECT_TRUE(cloud.points_have_another_clock) << what;
        ASSERT_EQ(cloud.cloud.size(), zero_among_them ? 100u : 101u) << what;
        EXPECT_EQ(cloud.cloud.dropped_points, zero_among_them ? 1u : 0u) << what;
        const std::vector<float>& from_stamp_s = cloud.cloud.time_from_stamp_s;
        EXPECT_NEAR(from_stamp_s.front(), backwards ? 0.1f : 0.0f, 1e-6) << what;
        EXPECT_NEAR(from_stamp_s.back(), backwards ? 0.0f : 0.1f, 1e-6) << what;
        std::printf("%s: a sweep of %.6f s\n", what,
                    static_cast<double>(std::abs(from_stamp_s.back() - from_stamp_s.front())));
      }
}

TEST(cloud_message, with_a_zero_among_dates_is_on_the_clock_of_its_stamp) {
  const auto stamp = static_cast<double>(kStart_ns);
  std::vector<double> times;
  for (int i = 0; i < 100; ++i) times.push_back(stamp + 1e6 * i);
  times[0] = times[50] = 0.0;
  Layout layout{xyz_and({{"timestamp", 12, kF64}}), 20, 1, 100};
  const formats::ReadCloud cloud = read_cloud(message(layout, points_with_times(layout, times)));
  EXPECT_FALSE(cloud.points_have_another_clock);
  ASSERT_EQ(cloud.cloud.size(), 98u);
  EXPECT_EQ(cloud.cloud.dropped_points, 2u);
  EXPECT_NEAR(cloud.cloud.time_from_stamp_s.front(), 0.001f, 1e-6);
  EXPECT_NEAR(cloud.cloud.time_from_stamp_s.back(), 0.099f, 1e-6);
}

TEST(cloud_message, of_columns_on_the_same_bytes_is_refused) {
  Layout one{{}, 1};
  for (const char* name : {"x", "y", "z", "intensity", "ring", "time"}) one.fields.push_back({name, 0, kU8});
  EXPECT_TRUE(
      formats::contains(formats::error_of([&] { read_cloud(message(one, "ab")); }), "the coordinate x has one byte"));
  for (Field& field : one.fields) field.type = kU16;
  one.point_bytes = 2;
  EXPECT_TRUE(formats::contains(formats::error_of([&] { read_cloud(message(one, "abcd")); }), "lie on the same bytes"));
  const Layout half{{{"x", 0}, {"y", 4}, {"z", 8}, {"time", 10}}, 16};
  EXPECT_TRUE(formats::contains(formats::error_of([&] { read_cloud(message(half, std::string(32, 'a'))); }),
                                "fields z and time lie on the same bytes of a point"));
  // What is not used may lie anywhere: colours are often there twice.
  const Layout colours{xyz_and({{"rgb", 12}, {"rgba", 12, kU32}, {"intensity", 16}}), 20};
  EXPECT_EQ(read_cloud(message(colours, std::string(40, '@'))).cloud.size(), 2u);
}

TEST(cloud_message, of_lies_is_refused) {
  const Layout good{xyz_and({{"time", 12}}), 16};
  const std::string data = two_points(good, "time", 0.0f, 0.1f);
  const auto refusal = [&](auto&& change) {
    Layout layout = good;
    change(layout);
    return formats::error_of([&] { read_cloud(message(layout, data)); });
  };
  EXPECT_EQ(refusal([](Layout&) {}), "");
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) { l.width = 3; }), "48 bytes"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) {
                                  l.height = 0xffffffffU;
                                  l.width = 1;
                                  l.row_bytes = 0xffffffffU;
                                }),
                                "rows"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) {
                                  l.height = 2;
                                  l.row_bytes = 8;
                                }),
                                "a row has 8"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) { l.fields[2].offset = 14; }), "field z lies at byte 14"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) { l.fields[2].offset = 0xffffffffU; }), "field z lies"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) { l.fields[0].type = 9; }), "type 9"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) { l.fields[0].name = "q"; }), "expected x, y and z"));
  EXPECT_TRUE(formats::contains(refusal([](Layout& l) { l.point_bytes = 0; }), "of a point of 0 bytes"));
  const std::string bytes = message(good, data);
  for (std::size_t length = 0; length < bytes.size() - 1; ++length)
    EXPECT_TRUE(
        formats::contains(formats::error_of([&] { read_cloud(bytes.substr(0, length)); }), "a.bag: /points, message 1"))
        << length;
}

TEST(cloud_message, is_written_and_read) {
  cloud::PointCloud cloud;
  for (int i = 1; i < 50; ++i) {
    cloud.points.emplace_back(static_cast<float>(i), 0.5f, -static_cast<float>(i));
    cloud.intensity.push_back(static_cast<float>(i) * 0.25f);
    cloud.ring.push_back(static_cast<std::uint16_t>(i));
    cloud.time_from_stamp_s.push_back(static_cast<float>(i) * 0.001f);
  }
  for (const MessageEncoding encoding : {MessageEncoding::Ros1, MessageEncoding::Cdr}) {
    const cloud::PointCloud back = read_cloud(cloud_message(cloud, kStart_ns, "lidar", encoding), encoding).cloud;
    EXPECT_EQ(back.points, cloud.points);
    EXPECT_EQ(back.intensity, cloud.intensity);
    EXPECT_EQ(back.ring, cloud.ring);
    EXPECT_EQ(back.time_from_stamp_s, cloud.time_from_stamp_s);
  }
}

}  // namespace
}  // namespace remount::bags

// PointCloud2 as other people's drivers write it: any types, offsets, order and padding, in both byte orders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/formats/bags/cloud_message.h"
#include "tests/model/formats/bags/bag_fixtures.h"
#include "tests/model/formats/bags/field_types.h"
#include "tests/model/formats/random_values.h"

namespace remount::bags {
namespace {

std::size_t bytes_of_type(std::uint8_t type) { return type <= kU8 ? 1 : type <= kU16 ? 2 : type <= kF32 ? 4 : 8; }

template <class T>
std::string ordered(T value, bool big_endian) {
  std::string bytes = raw(value);
  if (big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string encoded(double value, std::uint8_t type, bool big_endian) {
  switch (type) {
    case kI8:
      return ordered(static_cast<std::int8_t>(value), big_endian);
    case kU8:
      return ordered(static_cast<std::uint8_t>(value), big_endian);
    case kI16:
      return ordered(static_cast<std::int16_t>(value), big_endian);
    case kU16:
      return ordered(static_cast<std::uint16_t>(value), big_endian);
    case kI32:
      return ordered(static_cast<std::int32_t>(value), big_endian);
    case kU32:
      return ordered(static_cast<std::uint32_t>(value), big_endian);
    case kF32:
      return ordered(static_cast<float>(value), big_endian);
    default:
      return ordered(value, big_endian);
  }
}

/// The three serialisations: packed, or aligned behind a head of four bytes in either byte order.
class Serialiser {
 public:
  Serialiser(MessageEncoding encoding, bool big_endian) : aligned_(encoding == MessageEncoding::Cdr), big_(big_endian) {
    if (aligned_) bytes_ = {'\0', big_ ? '\0' : '\1', '\0', '\0'};
  }
  template <class T>
  Serialiser& number(T value) {
    while (aligned_ && (bytes_.size() - 4) % sizeof(T) != 0) bytes_ += '\0';
    bytes_ += ordered(value, big_);
    return *this;
  }
  Serialiser& string(const std::string& text) {
    number(static_cast<std::uint32_t>(text.size() + aligned_));
    bytes_ += text;
    if (aligned_) bytes_ += '\0';
    return *this;
  }
  Serialiser& data(const std::string& bytes) {
    number(static_cast<std::uint32_t>(bytes.size()));
    bytes_ += bytes;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  bool aligned_, big_;
  std::string bytes_;
};

struct LaidField {
  std::string name;
  std::uint8_t type = kF32;
  std::uint32_t count = 1, offset = 0;
};

struct LaidCloud {
  std::vector<LaidField> fields;
  std::uint32_t height = 1, width = 0, point_bytes = 0, row_bytes = 0;
  bool big_endian = false, dense = true;
};

std::string serialised(const LaidCloud& layout, const std::string& data, MessageEncoding encoding, bool big_endian) {
  Serialiser out(encoding, big_endian);
  if (encoding == MessageEncoding::Ros1) out.number<std::uint32_t>(7);  // a counter, of ROS 1 alone
  out.number(static_cast<std::uint32_t>(kStart_ns / 1'000'000'000)).number<std::uint32_t>(0).string("lidar");
  out.number(layout.height).number(layout.width).number(static_cast<std::uint32_t>(layout.fields.size()));
  for (const LaidField& field : layout.fields)
    out.string(field.name).number(field.offset).number(field.type).number(field.count);
  out.number(static_cast<std::uint8_t>(layout.big_endian)).number(layout.point_bytes).number(layout.row_bytes);
  return out.data(data).number(static_cast<std::uint8_t>(layout.dense)).bytes();
}

formats::ReadCloud read(const std::string& bytes, MessageEncoding encoding) {
  MessageReader reader(bytes, encoding, "a.mcap: /points, message 1");
  return read_cloud(reader, MessageKind::PointCloud2, kStart_ns);
}

// ---- Made by hand

TEST(cloud_layouts, a_whole_big_endian_message_is_read) {
  LaidCloud layout{{{"x", kF32, 1, 0}, {"y", kF32, 1, 4}, {"z", kF32, 1, 8}, {"t", kU32, 1, 12}}, 1, 2, 16, 32, true};
  std::string data;
  for (const float sign : {1.0f, -1.0f}) {
    for (const float value : {1.0f, 2.0f, 3.0f}) data += ordered(sign * value, true);
    data += ordered<std::uint32_t>(sign > 0 ? 100'000 : 99'900'000, true);
  }
  for (const bool message_is_big : {true, false}) {
    const cloud::PointCloud cloud =
        read(serialised(layout, data, MessageEncoding::Cdr, message_is_big), MessageEncoding::Cdr).cloud;
    ASSERT_EQ(cloud.size(), 2u) << message_is_big;
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f(-1, -2, -3));
    EXPECT_NEAR(cloud.time_from_stamp_s[0], 0.0001f, 1e-7);
    EXPECT_NEAR(cloud.time_from_stamp_s[1], 0.0999f, 1e-7);
  }
}

/// As drivers publish an image of the sensor: rows are beams, and what has no return is not a number.
TEST(cloud_layouts, organised_clouds_lose_their_padding_and_keep_the_rest_in_order) {
  constexpr std::uint32_t kRows = 16, kColumns = 50;
  LaidCloud layout{{{"x", kF32, 1, 0},
                    {"y", kF32, 1, 4},
                    {"z", kF32, 1, 8},
                    {"intensity", kF32, 1, 16},
                    {"t", kU32, 1, 20},
                    {"ring", kU8, 1, 24}},
                   kRows,
                   kColumns,
                   32,
                   kColumns * 32,
                   false,
                   false};
  std::string data;
  std::size_t returns = 0;
  for (std::uint32_t row = 0; row < kRows; ++row)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const bool none = (row + column) % 3 == 0;
      returns += !none;
      const float value = none ? std::nanf("") : static_cast<float>(100 * row + column + 1);
      std::string point(32, '\0');
      for (const std::size_t at : {0U, 4U, 8U}) point.replace(at, 4, raw(value));
      point.replace(16, 4, raw(static_cast<float>(row)));
      point.replace(20, 4, raw(std::uint32_t{column * 2'000'000}));
      point.replace(24, 1, raw(static_cast<std::uint8_t>(row)));
      data += point;
    }
  const formats::ReadCloud organised =
      read(serialised(layout, data, MessageEncoding::Cdr, false), MessageEncoding::Cdr);
  const cloud::PointCloud& cloud = organised.cloud;
  ASSERT_EQ(cloud.size(), returns);
  EXPECT_EQ(cloud.dropped_points, kRows * kColumns - returns);
  EXPECT_FALSE(organised.points_have_another_clock);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(cloud.points[i].x()) - 1;
    ASSERT_EQ(cloud.ring[i], number / 100);
    ASSERT_EQ(cloud.intensity[i], static_cast<float>(number / 100));
    ASSERT_NEAR(cloud.time_from_stamp_s[i], 0.002f * static_cast<float>(number % 100), 1e-7);
    if (i > 0) {
      ASSERT_GT(cloud.points[i].x(), cloud.points[i - 1].x());
    }
  }
}

// ---- Random ones

/// What a driver may call time: type, unit, and where it begins.
struct TimeKind {
  std::uint8_t type;
  double unit_s, zero_s;
  bool another_clock;
};
constexpr double kStart_s = 1.6e9;
constexpr TimeKind kTimes[] = {
    {kF32, 1.0, 0.0, false},      {kF64, 1.0, 0.0, false},       {kU32, 1e-9, 0.0, false},
    {kI32, 1e-6, 0.0, false},     {kF32, 1e-6, 0.0, false},      {kU16, 1e-3, 0.0, false},
    {kF64, 1.0, kStart_s, false}, {kF64, 1e-6, kStart_s, false}, {kF64, 1e-9, kStart_s, false},
    {kF64, 1.0, 1234.5, true},    {kF64, 1e-9, 234.5, true},
};

struct RandomMessage {
  LaidCloud layout;
  std::string data;
  cloud::PointCloud expected;
  bool another_clock = false;
};

/// Gives the fields offsets in another order than they are listed, with room between them.
void place(std::vector<LaidField>& fields, formats::RandomValues& random, std::uint32_t& point_bytes) {
  std::vector<LaidField*> order;
  for (LaidField& field : fields) order.push_back(&field);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  for (LaidField* field : order) {
    point_bytes += static_cast<std::uint32_t>(random.below(2) * random.below(5));
    field->offset = point_bytes;
    point_bytes += static_cast<std::uint32_t>(bytes_of_type(field->type) * std::max<std::uint32_t>(1, field->count));
  }
  point_bytes += static_cast<std::uint32_t>(random.below(9));
}

std::vector<LaidField> random_fields(formats::RandomValues& random, const TimeKind& time) {
  const std::uint8_t coordinates[] = {kI16, kI32, kF32, kF64}, any[] = {kI8, kU8, kI16, kU16, kI32, kU32, kF32, kF64};
  const char* intensities[] = {"intensity", "I", "reflectivity"};
  const char* times[] = {"time", "T", "timestamp", "offset_time"};
  std::vector<LaidField> fields;
  for (const char* name : {"x", "Y", "z"}) fields.push_back({name, coordinates[random.below(4)]});
  if (random.flip()) fields.push_back({intensities[random.below(3)], any[random.below(8)]});
  if (random.flip()) fields.push_back({"ring", any[1 + random.below(7)]});
  if (random.flip()) fields.push_back({times[random.below(4)], time.type});
  if (random.flip()) fields.push_back({"normal", kF32, 3});
  if (random.flip()) fields.push_back({"x", kF64, 2});  // several values: no coordinate
  for (std::size_t i = fields.size(); i > 1; --i) std::swap(fields[i - 1], fields[random.below(i)]);
  for (LaidField& field : fields)
    if (field.count == 1 && random.below(4) == 0) field.count = 0;  // as some drivers write one value
  return fields;
}

/// Values that every type holds; what is no point in the cloud is not a number, or zero range.
RandomMessage random_message(formats::RandomValues& random) {
  const TimeKind& time = kTimes[random.below(std::size(kTimes))];
  RandomMessage message;
  LaidCloud& layout = message.layout;
  layout.fields = random_fields(random, time);
  place(layout.fields, random, layout.point_bytes);
  layout.height = random.flip() ? 1 : 2 + static_cast<std::uint32_t>(random.below(5));
  layout.width = 30 + static_cast<std::uint32_t>(random.below(20));
  const std::uint32_t rest = layout.height > 1 ? static_cast<std::uint32_t>(random.below(12)) : 0;
  layout.row_bytes = layout.width * layout.point_bytes + rest;
  layout.big_endian = random.flip();
  layout.dense = random.flip();
  const std::size_t points = std::size_t{layout.height} * layout.width;
  for (std::size_t i = 0; i < points; ++i) {
    std::string bytes;
    for (std::uint32_t k = 0; k < layout.point_bytes; ++k) bytes += static_cast<char>(random.below(256));
    const bool none = random.below(8) == 0;
    double ring = 0.0, intensity = 0.0, since_stamp_s = 0.0;
    Eigen::Vector3f point = Eigen::Vector3f::Zero();
    bool has_ring = false, has_intensity = false, has_time = false;
    for (const LaidField& field : layout.fields) {
      if (field.count > 1) continue;
      double value = 0.0;
      const bool real = field.type >= kF32;
      const char name = static_cast<char>(std::tolower(field.name[0]));
      if (name == 'x' || name == 'y' || name == 'z') {
        value = none ? 0.0 : real ? random.between(-100.0, 100.0) : 1.0 + static_cast<double>(random.below(900));
        if (none && real && random.flip()) value = std::nan("");
        point[name - 'x'] = static_cast<float>(value);
      } else if (field.name == "ring") {
        has_ring = true, ring = value = static_cast<double>(random.below(128));
      } else if (name == 'i' || name == 'r') {
        has_intensity = true, intensity = value = static_cast<double>(random.below(128));
      } else {
        has_time = true, since_stamp_s = 0.1 * static_cast<double>(i) / static_cast<double>(points);
        value = (time.zero_s + since_stamp_s) / time.unit_s;
        if (field.type < kF32) since_stamp_s = (value = std::floor(value)) * time.unit_s;
      }
      const std::string put = encoded(value, field.type, layout.big_endian);
      bytes.replace(field.offset, put.size(), put);
    }
    message.data += bytes;
    if ((i + 1) % layout.width == 0 && (i + 1 < points || random.flip())) message.data += std::string(rest, '?');
    if (none) {
      ++message.expected.dropped_points;
      continue;
    }
    message.expected.points.push_back(point);
    if (has_intensity) message.expected.intensity.push_back(static_cast<float>(intensity));
    if (has_ring) message.expected.ring.push_back(static_cast<std::uint16_t>(ring));
    if (has_time) message.expected.time_from_stamp_s.push_back(static_cast<float>(since_stamp_s));
  }
  std::vector<float>& times = message.expected.time_from_stamp_s;
  message.another_clock = time.another_clock && !times.empty();
  if (message.another_clock)
    for (std::size_t i = times.size(); i > 0; --i) times[i - 1] -= times[0];
  return message;
}

TEST(cloud_layouts, random_ones_give_the_points_that_were_written) {
  formats::RandomValues random(17);
  double worst_s = 0.0;
  std::size_t points = 0, timed = 0;
  for (int draw = 0; draw < 600; ++draw) {
    const RandomMessage message = random_message(random);
    const bool cdr = random.flip();
    const MessageEncoding encoding = cdr ? MessageEncoding::Cdr : MessageEncoding::Ros1;
    const formats::ReadCloud cloud =
        read(serialised(message.layout, message.data, encoding, cdr && random.flip()), encoding);
    const cloud::PointCloud& expected = message.expected;
    ASSERT_EQ(cloud.cloud.points, expected.points) << draw;
    ASSERT_EQ(cloud.cloud.intensity, expected.intensity) << draw;
    ASSERT_EQ(cloud.cloud.ring, expected.ring) << draw;
    ASSERT_EQ(cloud.cloud.dropped_points, expected.dropped_points) << draw;
    ASSERT_EQ(cloud.points_have_another_clock, message.another_clock) << draw;
    ASSERT_EQ(cloud.cloud.time_from_stamp_s.size(), expected.time_from_stamp_s.size()) << draw;
    for (std::size_t i = 0; i < expected.time_from_stamp_s.size(); ++i) {
      const double off_s =
          std::abs(static_cast<double>(cloud.cloud.time_from_stamp_s[i] - expected.time_from_stamp_s[i]));
      worst_s = std::max(worst_s, off_s);
    }
    points += expected.size(), timed += !expected.time_from_stamp_s.empty();
  }
  std::printf("600 layouts, %zu points, %zu with times, off by %.2e s at most\n", points, timed, worst_s);
  EXPECT_LT(worst_s, 1e-6);
}

}  // namespace
}  // namespace remount::bags

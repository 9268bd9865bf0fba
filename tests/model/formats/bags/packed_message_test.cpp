#include "model/formats/bags/packed_message.h"

#include <gtest/gtest.h>
#include <zstd.h>

#include "tests/model/formats/bags/bag_maker.h"
#include "tests/model/formats/bags/sqlite_fixture.h"

namespace remount::bags {
namespace {

/// A frame that does not say what it unpacks to, as streams are packed.
std::string unsized_frame(const std::string& bytes) {
  ZSTD_CCtx* context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_contentSizeFlag, 0);
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  packed.resize(ZSTD_compress2(context, packed.data(), packed.size(), bytes.data(), bytes.size()));
  ZSTD_freeCCtx(context);
  return packed;
}

/// The beginning of a frame that promises `bytes`.
std::string promise(std::uint64_t bytes) {
  return "\x28\xb5\x2f\xfd\xe0" + raw(bytes) + "what follows is not looked at";
}

/// Bytes that do not pack.
std::string noise(std::size_t count) {
  std::string bytes(count, '\0');
  std::uint32_t state = 1;
  for (char& byte : bytes) byte = static_cast<char>((state = state * 1664525U + 1013904223U) >> 24);
  return bytes;
}

void write_mcap(const fs::path& path, const std::vector<TestMessage>& messages, MessageEncoding encoding) {
  write_messages(*make_mcap_writer(path, encoding, ChunkCompression::None, 300), messages);
}

TEST(packed_message, of_an_mcap_is_read_as_that_of_a_database) {
  const formats::TemporaryFolder folder;
  std::vector<TestMessage> plain = test_messages(60);
  plain[7].bytes += std::string(50'000, 'y');
  plain[8].bytes += noise(400'000);  // of several blocks, of which a header needs the first
  std::vector<TestMessage> frames = plain;
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].bytes = i % 2 == 0 ? packed(plain[i].bytes) : unsized_frame(plain[i].bytes);
  write_mcap(folder.path() / "a.mcap", frames, MessageEncoding::Cdr);
  write_database(folder.path() / "a.db3", frames);
  for (const char* name : {"a.mcap", "a.db3"}) {
    const auto bag = open_quietly(folder.path() / name);
    EXPECT_EQ(count_and_check(*bag, plain), plain.size()) << name;
    EXPECT_TRUE(bag->findings().empty());
  }
}

TEST(packed_message, is_none_in_ros_1_where_a_message_may_begin_as_a_frame_does) {
  const formats::TemporaryFolder folder;
  std::vector<TestMessage> messages = test_messages(6);
  messages[3].bytes = packed("the sequence number of this header looks like a frame");
  write_mcap(folder.path() / "a.mcap", messages, MessageEncoding::Ros1);
  EXPECT_EQ(count_and_check(*open_quietly(folder.path() / "a.mcap"), messages), messages.size());
}

TEST(packed_message, that_is_damaged_or_becomes_too_large_is_refused_by_name) {
  const formats::TemporaryFolder folder;
  const std::string good = packed(noise(400'000));
  std::string broken = good;
  broken.replace(broken.size() / 2, 40, 40, '\xff');
  const std::string zeros(std::size_t{80} << 20, '\0');
  const std::pair<std::string, const char*> cases[] = {
      {good.substr(0, good.size() - 9), "damaged after"},    {good.substr(0, 4), "damaged after 0"},
      {promise(std::uint64_t{1} << 60), "becomes larger"},   {promise(std::uint64_t{100} << 20), "becomes larger"},
      {packed(zeros), "becomes larger than 67108864 bytes"}, {unsized_frame(zeros), "becomes larger"}};
  for (const auto& [bytes, reason] : cases) {
    std::vector<TestMessage> messages = test_messages(6);
    messages[1].bytes = bytes;  // the first message of topic /a
    write_mcap(folder.path() / "a.mcap", messages, MessageEncoding::Cdr);
    fs::remove(folder.path() / "a.db3");
    write_database(folder.path() / "a.db3", messages);
    for (const char* name : {"a.mcap", "a.db3"}) {
      const auto bag = open_quietly(folder.path() / name);
      const std::string problem = formats::error_of([&] { bag->message(bag->topics()[0].entries[0]); });
      EXPECT_TRUE(formats::contains(problem, reason) && formats::contains(problem, name))
          << name << ": '" << problem << "'";
      EXPECT_EQ(bag->message(bag->topics()[0].entries[1]), messages[2].bytes) << "the next is not concerned";
    }
  }
}

TEST(packed_message, of_scans_and_ins_makes_the_same_session_as_a_plain_one) {
  const formats::TemporaryFolder folder;
  const auto write = [&](const char* name, bool frames) {
    const auto writer = make_mcap_writer(folder.path() / name, MessageEncoding::Cdr, ChunkCompression::None);
    const std::uint32_t points = writer->add_topic("/points", definition("sensor_msgs/PointCloud2")),
                        ins = writer->add_topic("/fix", definition("sensor_msgs/NavSatFix")),
                        imu = writer->add_topic("/imu", definition("sensor_msgs/Imu"));
    for (int i = 0; i < 41; ++i) {
      const motion::InsSample sample = BagMaker::on_circle(i);
      cloud::PointCloud cloud;
      for (int k = 0; k < 9000; ++k) cloud.points.emplace_back(static_cast<float>(k + 1), static_cast<float>(i), 1.0f);
      const motion::GnssFix fix{sample.stamp_ns, sample.latitude_rad, sample.longitude_rad, 100.0,
                                Eigen::Matrix3d::Identity()};
      const auto put = [&](std::uint32_t topic, const std::string& bytes) {
        writer->write(topic, sample.stamp_ns + 1'000'000, frames ? packed(bytes) : bytes);
      };
      put(imu, attitude_message(sample, 0.001, "ins", MessageEncoding::Cdr));
      put(ins, fix_message(fix, 2, "ins", MessageEncoding::Cdr));
      if (i % 2 == 0) put(points, cloud_message(cloud, sample.stamp_ns, "lidar", MessageEncoding::Cdr));
    }
    writer->finish();
    return formats::open(folder.path() / name);
  };
  const drive::Session plain = write("plain.mcap", false), frames = write("frames.mcap", true);
  ASSERT_TRUE(plain.scans && frames.scans);
  ASSERT_EQ(plain.scans->size(), frames.scans->size());
  ASSERT_EQ(plain.ins.size(), 41u);
  ASSERT_EQ(frames.ins.size(), 41u);
  for (std::size_t i = 0; i < plain.scans->size(); ++i) {
    EXPECT_EQ(plain.scans->stamp_ns(i), frames.scans->stamp_ns(i));
    EXPECT_EQ(plain.scans->load(i).points, frames.scans->load(i).points);
  }
  for (std::size_t i = 0; i < plain.ins.size(); ++i) EXPECT_EQ(plain.ins[i].stamp_ns, frames.ins[i].stamp_ns);
  std::cout << fs::file_size(folder.path() / "plain.mcap") << " bytes, with frames "
            << fs::file_size(folder.path() / "frames.mcap") << "\n";
}

}  // namespace
}  // namespace remount::bags

// The example of a session format in CONTRIBUTING.md, as it is compiled.
#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "messages/examples.h"
#include "model/formats/files/text_file.h"
#include "model/formats/poses/pose_file.h"
#include "model/formats/sessions/session_reader.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {

class WayReader final : public SessionReader {
 public:
  std::string_view id() const override { return "way"; }
  Message description() const override { return say::format_way(); }
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

namespace {

constexpr std::string_view kMark = "#way\n";

// The lines behind "[name]", up to the next section. Throws Error(Format).
std::string_view section(std::string_view text, const std::string& name, const std::filesystem::path& path) {
  const std::size_t begin = text.find("[" + name + "]\n");
  if (begin == std::string_view::npos) throw Error(ErrorCode::Format, path.string(), say::way_section_missing(name));
  const std::string_view lines = text.substr(begin + name.size() + 3);
  return lines.substr(0, lines.find('['));
}

}  // namespace

int WayReader::probe(const std::filesystem::path& path) const {
  return is_file(path) && read_text_head(path, 64).starts_with(kMark) ? 100 : 0;
}

drive::Session WayReader::open(const std::filesystem::path& path, Progress&) const {
  const std::string text = read_text_file(path);
  drive::Session session;
  session.name = path.filename().string();
  session.path = path;
  session.format = id();
  session.files = {path};
  session.world_from_ins = parse_poses(section(text, "ins", path), path, PoseFormat::Tum, session.findings);
  session.odometry_from_lidar = parse_poses(section(text, "lidar", path), path, PoseFormat::Tum, session.findings);
  return session;
}

namespace {

TEST(example_of_a_session_format, reads_both_sections) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("drive.way", "#way\n[ins]\n1 0 0 0 0 0 0 1\n2 5 0 0 0 0 0 1\n[lidar]\n1.5 1 2 3 0 0 0 1\n");
  const WayReader reader;
  EXPECT_EQ(reader.probe(path), 100);
  Progress progress;
  const drive::Session session = reader.open(path, progress);
  EXPECT_EQ(session.world_from_ins.size(), 2U);
  ASSERT_EQ(session.odometry_from_lidar.size(), 1U);
  EXPECT_EQ(session.odometry_from_lidar[0].stamp_ns, 1'500'000'000);
}

TEST(example_of_a_session_format, names_what_is_missing) {
  const TemporaryFolder folder;
  const auto path = folder.write("drive.way", "#way\n[ins]\n1 0 0 0 0 0 0 1\n");
  Progress progress;
  try {
    (void)WayReader().open(path, progress);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::Format);
    EXPECT_EQ(error.what_happened().code(), "way-section-missing");
  }
}

}  // namespace
}  // namespace remount::formats

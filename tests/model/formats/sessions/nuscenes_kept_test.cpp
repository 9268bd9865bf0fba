// Tables of nuScenes that are kept between sessions.
#include "model/formats/sessions/nuscenes_kept.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <stop_token>
#include <thread>

#include "model/formats/files/input_file.h"
#include "model/formats/sessions/several_sessions.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/sessions/nuscenes_fixture.h"

namespace remount::formats {
namespace {

/// So that they count as files that nobody writes any more.
void make_old(const TemporaryFolder& folder) {
  for (const auto& table : files_in(folder.path() / "v1.0-mini"))
    std::filesystem::last_write_time(table, std::filesystem::last_write_time(table) - std::chrono::hours(1));
}

TEST(nuscenes_kept, every_table_can_be_cancelled) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1");
  fixture.write(folder);
  // Asked to stop by the beginning of a table, it reads no further one.
  const auto expect_stopped = [](std::size_t at_table, const std::function<bool(Progress&)>& has_read) {
    std::stop_source stop;
    std::size_t begun = 0;
    Progress cancelled(stop.get_token(), [&](const ProgressUpdate&) {
      if (++begun == at_table) stop.request_stop();
    });
    EXPECT_FALSE(has_read(cancelled)) << at_table;
    EXPECT_EQ(begun, at_table);
  };
  constexpr std::size_t kTablesOfSweeps = 5;
  KeptNuscenes kept(std::chrono::minutes(2));
  for (std::size_t table = 1; table <= kTablesOfSweeps; ++table)
    expect_stopped(table,
                   [&](Progress& progress) { return kept.tables(folder.path() / "v1.0-mini", progress) != nullptr; });
  Progress progress;
  const auto tables = kept.tables(folder.path() / "v1.0-mini", progress);
  ASSERT_NE(tables, nullptr);
  expect_stopped(1, [&](Progress& cancelled) { return kept.ego_poses(tables, cancelled) != nullptr; });
  EXPECT_EQ(kept.ego_poses(tables, progress)->global_from_ego.size(), 4U);
}

TEST(nuscenes_kept, tables_that_nobody_asks_for_are_given_back) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1");
  fixture.write(folder);
  make_old(folder);
  Progress progress;
  KeptNuscenes kept(std::chrono::milliseconds(300));
  std::weak_ptr<const NuscenesTables> tables = kept.tables(folder.path() / "v1.0-mini", progress);
  EXPECT_FALSE(tables.expired()) << "for the next that asks";
  for (int i = 0; i < 1000 && !tables.expired(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_TRUE(tables.expired());
}

TEST(nuscenes_kept, nobody_waits_for_a_reading_but_who_reads) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1");
  fixture.write(folder);
  make_old(folder);
  KeptNuscenes kept(std::chrono::milliseconds(1));
  Progress progress;
  EXPECT_NE(kept.tables(folder.path() / "v1.0-mini", progress), nullptr);
  std::filesystem::last_write_time(folder.path() / "v1.0-mini" / "scene.json",
                                   std::filesystem::file_time_type::clock::now() - std::chrono::hours(2));
  std::size_t seen = 0;
  Progress asking(std::stop_token(), [&](const ProgressUpdate&) { seen += kept.readings(); });
  EXPECT_NE(kept.tables(folder.path() / "v1.0-mini", asking), nullptr);
  EXPECT_GT(seen, 0U) << "by a thread that holds the reading";
  EXPECT_EQ(kept.readings(), 2U);
}

TEST(nuscenes_kept, tables_are_read_once_for_all_sessions_and_anew_when_they_change) {
  const TemporaryFolder folder;
  NuscenesFixture fixture;
  fixture.add_scene(folder, "scene-1");
  fixture.add_scene(folder, "scene-2", 3);
  fixture.write(folder);
  make_old(folder);
  std::vector<std::filesystem::path> scans = files_in(folder.path() / "samples/LIDAR_TOP");
  ASSERT_EQ(scans.size(), 2U);
  const std::size_t before = kept_nuscenes().readings();
  Progress progress;
  EXPECT_EQ(open(scans[0]).world_from_ins.size(), 4U);
  EXPECT_EQ(open(scans[1]).world_from_ins.size(), 3U);
  EXPECT_EQ(offer_lidars(scans[1], progress).size(), 1U);
  EXPECT_EQ(kept_nuscenes().readings() - before, 2U) << "once the sweeps, once the poses";
  fixture.poses.replace(fixture.poses.find("\"p1\""), 4, "\"zz\"");
  fixture.write(folder);
  EXPECT_EQ(open(scans[0]).world_from_ins.size(), 3U);
}

}  // namespace
}  // namespace remount::formats

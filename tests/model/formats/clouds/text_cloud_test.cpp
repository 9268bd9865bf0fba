// Scans as text: what the columns are, and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "model/formats/clouds/cloud_fields.h"
#include "tests/model/formats/reader_fixtures.h"
#include "tests/model/formats/temporary_folder.h"

namespace remount::formats {
namespace {

class text_cloud : public ::testing::Test {
 protected:
  cloud::PointCloud load_text(const std::string& text, const std::string& name = "a.xyz", std::int64_t stamp_ns = 0) {
    return load_cloud(folder_.write(name, text), stamp_ns);
  }
  std::string columns_of_text(const std::string& text) {
    return english(read_cloud_file(folder_.write("a.csv", text), 0).columns_words());
  }
  TemporaryFolder folder_;
};

TEST_F(text_cloud, numbers_are_apart_by_blanks_commas_or_semicolons) {
  const struct {
    const char *name, *text;
  } cases[] = {{"a.xyz", "1.5 2 -3 0.5\n4 5 6 0.25\n"},
               {"a.txt", "1.5\t2\t-3\t0.5\r\n4\t5\t6\t0.25\r\n"},
               {"a.asc", "# exported\n\n1.5   2  -3   0.5\n4 5 6 0.25"},
               {"a.csv", "1.5,2,-3,0.5\n4, 5, 6, 0.25\n"},
               {"A.CSV", "1.5;2;-3;0.5\n4;5;6;0.25\n"},
               {"a.pts", "2\n1.5 2 -3 0.5\n4 5 6 0.25\n"},
               {"b.csv", "\xEF\xBB\xBFz,x,extra,y,i\n-3,1.5,9,2,0.5\n6,4,9,5,0.25\n"}};
  for (const auto& [name, text] : cases) {
    const cloud::PointCloud cloud = load_text(text, name);
    ASSERT_EQ(cloud.size(), 2U) << text;
    EXPECT_EQ(cloud.points[0], Eigen::Vector3f(1.5F, 2.0F, -3.0F)) << text;
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f(4.0F, 5.0F, 6.0F)) << text;
    EXPECT_EQ(cloud.intensity, (std::vector<float>{0.5F, 0.25F})) << text;
  }
}

TEST_F(text_cloud, columns_go_by_their_names_in_any_order_and_notation) {
  const char* const cases[] = {
      "//X Y Z Intensity Ring Time\n1 2 3 7 4 0\n4 5 6 8 5 0.05\n",
      "# x [m] y [m] z [m] reflectivity laser_id t [s]\n1 2 3 7 4 0\n4 5 6 8 5 0.05\n",
      "time_us;ring;scalar_intensity;X (m);Y (m);Z (m)\n0;4;7;1;2;3\n50000;5;8;4;5;6\n",
      ("\"intensity\",\"laser_id\",\"azimuth\",\"timestamp\",\"Points_m_XYZ:0\",\"Points_m_XYZ:1\",\"Points_m_XYZ:2\"\n"
       "7,4,100,0,1,2,3\n8,5,200,50000,4,5,6\n"),
      "t_ns,x,y,z,remission,channel\n0,1,2,3,7,4\n50000000,4,5,6,8,5\n"};
  for (const char* const text : cases) {
    const cloud::PointCloud cloud = load_text(text, "a.csv");
    ASSERT_EQ(cloud.size(), 2U) << text;
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f(4.0F, 5.0F, 6.0F)) << text;
    EXPECT_EQ(cloud.intensity, (std::vector<float>{7.0F, 8.0F})) << text;
    EXPECT_EQ(cloud.ring, (std::vector<std::uint16_t>{4, 5})) << text;
    ASSERT_EQ(cloud.time_from_stamp_s.size(), 2U) << text;
    EXPECT_NEAR(cloud.time_from_stamp_s[1] - cloud.time_from_stamp_s[0], 0.05F, 1e-6F) << text;
  }
}

TEST_F(text_cloud, without_names_the_count_says_what_they_are) {
  EXPECT_TRUE(load_text("1 2 3\n").intensity.empty());
  EXPECT_EQ(load_text("1 2 3 0.5\n").intensity, std::vector<float>{0.5F});
  EXPECT_EQ(load_text("1\n1 2 3 -900 10 20 30\n", "a.pts").intensity, std::vector<float>{-900.0F});
  EXPECT_TRUE(load_text("1 2 3 10 20 30\n").intensity.empty()) << "colours or normals";
  EXPECT_EQ(columns_of_text("1,2,3,10,20,30\n"), "x y z and others without names");
  EXPECT_EQ(columns_of_text("1,2,3,10\n"), "x y z intensity");
}

TEST_F(text_cloud, points_that_are_none_are_left_out_and_counted) {
  const cloud::PointCloud cloud = load_text("x,y,z,intensity\n1,2,3,4\n,,,\nnan,1,2,3\n0,0,0,1\n5,6,7,\n", "a.csv");
  ASSERT_EQ(cloud.size(), 2U);
  EXPECT_EQ(cloud.dropped_points, 3U);
  EXPECT_TRUE(std::isnan(cloud.intensity[1]));
}

TEST_F(text_cloud, what_is_wrong_is_told_with_line_and_remedy) {
  EXPECT_ERROR(load_text("1 2 3 4\n1 2\n"), "a.xyz:2: has 2 numbers, expected 4 at least: x y z intensity");
  EXPECT_ERROR(load_text("1 2 3\n1 two 3\n"), "a.xyz:2: 'two' is not a number");
  EXPECT_ERROR(load_text("1 2\n"), "a.xyz:1: expected lines of numbers");
  EXPECT_ERROR(load_text("a,b,c\n1,2,3\n", "a.csv"), "a.csv:1: expected lines of numbers");
  EXPECT_ERROR(load_text("1,5;2,5;3,5\n", "a.csv"), "'1,5' has a decimal comma, expected a point. Export the scans");
  EXPECT_ERROR(load_text("x;y;z\n1,5;2,5;3,5\n", "a.csv"), "a.csv:2: '1,5' has a decimal comma");
  EXPECT_ERROR(load_text("x [mm],y [mm],z [mm]\n1,2,3\n", "a.csv"), "the unit of x is mm, expected metres");
  EXPECT_ERROR(load_text("# nothing\n"), "holds no points");
  EXPECT_ERROR(load_text(""), "holds no points");
  std::string map;
  for (int i = 0; i < 20; ++i) map += "690000.5 5335000." + std::to_string(i) + " 520\n";
  EXPECT_ERROR(load_text(map), "holds coordinates of a map");
}

TEST_F(text_cloud, decimal_commas_are_never_read_as_separators) {
  const char* const cases[] = {"1,234;5,678;9,012\n",
                               "-1,5;2,5;3,5\n",
                               "1,5 2,5 3,5\n",
                               "-0,5\t12,25\t3\n",
                               "1,5, 2,5, -3,5\n",
                               "0,123,4,567,1,890\n12,045,-4,560,1,880\n",  // "045" is no whole number
                               "x,y,z\n1,5,2,5,3,5\n",
                               "x y z\n1,5 2,5 3,5\n",
                               "1;2;3\n1,5;2,5;3,5\n"};
  for (const char* const text : cases) {
    SCOPED_TRACE(text);
    EXPECT_ERROR(load_text(text, "a.csv"), "has a decimal comma");
  }
  std::string widths;
  for (int i = 0; i < 20; ++i)
    widths += std::to_string(i) + "," + std::to_string(100 + 7 * i) + ",-4," + std::to_string(990 - 3 * i) + ",1," +
              std::to_string(200 + i) + "\n";
  EXPECT_ERROR(load_text(widths, "a.csv"), "'0,100,-4,990,1,200' has a decimal comma");
  std::string coloured;  // whole metres with colours
  for (int i = 0; i < 20; ++i)
    coloured += std::to_string(i) + "," + std::to_string(5 + i) + ",3," + std::to_string(10 * i) + ",7,255\n";
  EXPECT_EQ(load_text(coloured, "a.csv").size(), 20U);
}

TEST_F(text_cloud, a_row_with_one_number_more_than_the_others_is_told) {
  EXPECT_ERROR(load_text("1 2 3 4\n1 2 3 4\n1 0 2 3 4\n1 2 3 4\n"),
               "a.xyz:3: has 5 numbers, expected 4 at most, as the other lines have");
  EXPECT_ERROR(load_text("x,y,z,intensity\n1,2,3,4\n1,5,2,3,4\n1,2,3,4\n", "a.csv"), "a.csv:3: has 5 numbers");
  EXPECT_ERROR(load_text("1 0 2 3 4\n1 2 3 4\n1 2 3 4\n1 2 3 4\n"), "a.xyz:1: has 5 numbers");
  EXPECT_EQ(load_text("x,y,z\n1,2,3,\n4,5,6,\n", "a.csv").size(), 2U) << "nothing stands behind the last comma";
  EXPECT_EQ(load_text("x y z\n1 2 3 7\n4 5 6 8\n7 8 9 9\n").size(), 3U) << "the last column has no name";
}

TEST_F(text_cloud, columns_behind_the_named_ones_are_left_aside) {
  for (const char* const text :
       {"x y z\n1.5 2.5 3.5 12 0\n2.5 3.5 4.5 13 1\n", "x,y,z\n1.5,2.5,3.5,12,0\n2,3,4.5,13,1\n",
        "x,y,z\n1.25,2.5,3.0,255,0,0\n2.25,2.5,3.0,255,0,0\n"}) {
    const cloud::PointCloud cloud = load_text(text, "a.csv");
    ASSERT_EQ(cloud.size(), 2U) << text;
    EXPECT_EQ(cloud.points[0].y(), 2.5F) << text;
  }
}

TEST_F(text_cloud, a_line_of_megabytes_is_no_point_and_no_names) {
  const std::string commas(1 << 20, ',');
  for (const std::string& text : {commas, "x,y,z" + commas, "1,2,3\n" + commas})
    EXPECT_ERROR(load_text(text + "\n", "a.csv"), "the line is longer than 66 kB");
  EXPECT_EQ(load_text("# " + commas + "\n1,2,3\n", "a.csv").size(), 1U) << "of comments nothing is asked";
}

TEST_F(text_cloud, native_sessions_list_them_by_names_that_are_stamps) {
  for (int i = 0; i < 3; ++i)
    folder_.write("s/160000000" + std::to_string(i) +
                      (i == 1   ? ".csv"
                       : i == 2 ? ".PTS"
                                : ".xyz"),
                  "1 2 3 4\n5 6 7 8\n");
  folder_.write("s/readme.txt", "nothing");
  folder_.write("ins.txt", "1600000000 0 0 0 0 0 0 1\n1600000001 1 0 0 0 0 0 1\n1600000002 2 0 0 0 0 0 1\n");
  folder_.write("session.yaml",
                "format: remount-session/1\nname: test\nscans: {directory: s, type: text, stamps: from-names, timing: "
                "instant}\nins_poses: {file: ins.txt, format: tum}\n");
  const drive::Session session = open(folder_.path());
  ASSERT_EQ(session.scans->size(), 3U);
  EXPECT_EQ(session.scans->stamp_ns(2), 1'600'000'002'000'000'000);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(session.scans->load(i).size(), 2U);
  EXPECT_NE(find(session, "bad-scan-names"), nullptr) << "readme.txt";
}

}  // namespace
}  // namespace remount::formats

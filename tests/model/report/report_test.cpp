#include "model/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "model/formats/files/base64.h"

namespace remount::report {
namespace {

Report example_report() {
  Report report;
  calibration::CalibrationResult& result = report.file.result;
  result.status = calibration::Status::Degenerate;
  result.message = Message::verbatim("Five of six <parameters> are observed.");
  result.mounting.reference_from_sensor = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  result.set_observed(~calibration::ParameterSet{calibration::Parameter::Z},
                      Message::verbatim("not shown by this drive"));
  result.covariance.setConstant(std::nan(""));
  for (const int i : {0, 1, 3, 4, 5}) result.covariance(i, i) = 4e-6;
  result.covariance(0, 1) = result.covariance(1, 0) = -2e-6;
  result.directions = {{Vector6d::Unit(2), 1e9, false, Message::verbatim("height z: not observable, flat driving")}};
  report.file.nominal_ins_from_lidar = rigid_from_six({1.0, 0.0, 0.75, 0.0, 0.0, 0.0});
  result.pairs_proposed = 8, result.pairs_accepted = 7, result.pairs_rejected = 1;
  result.translation_rms_m = 0.0123, result.rotation_rms_rad = 1e-3;
  report.file.settings.pairing.max_gap_s = 2.25;
  report.file.version = "1.2.3";
  report.file.inputs = {{"drive1", "ins.csv", 12, "0123abcd"}};
  report.file.sharpness = {{calibration::MountingSource::Result, {-3.5, 0.021, 400}},
                           {calibration::MountingSource::Nominal, {-3.1, 0.034, 400}}};
  for (int i = 0; i < 8; ++i) {
    results::PairRecord pair;
    pair.stamp_b_ns = 1'000'000'000;
    pair.residual_translation_m = 0.01 * ((i * 5) % 8);
    pair.state = i == 7 ? motion::PairState::Rejected : motion::PairState::Accepted;
    if (i == 7) pair.reason = Message::verbatim("overlap 0.21 is below 0.30");
    report.file.pairs.push_back(pair);
  }
  report.tracks = {{"drive1", true, {{0, 0}, {10, 5}, {20, 0}}}};
  report.pictures = {{"pair 3", "PNG"}};
  return report;
}

using Cells = std::vector<std::string>;

/// The cells of the table's row that begins with `first`, the first such row below `heading`; without marks.
Cells row_of(const std::string& html, const std::string& heading, const std::string& first) {
  static const std::regex kRow("<tr>(.*)</tr>"), kCell("<t[dh][^>]*>(.*?)</t[dh]>");
  const auto below = html.begin() + static_cast<std::ptrdiff_t>(std::min(html.find(heading), html.size()));
  for (std::sregex_iterator row(below, html.end(), kRow), none; row != none; ++row) {
    const std::string inside = (*row)[1];
    Cells cells;
    for (std::sregex_iterator cell(inside.begin(), inside.end(), kCell); cell != none; ++cell)
      cells.push_back((*cell)[1]);
    if (!cells.empty() && cells[0] == first) return cells;
  }
  return {};
}

TEST(report, parameters_have_their_value_sigma_and_change) {
  const std::string html = report_html(example_report());
  const char* const table = "<h2>LiDAR in the INS frame";
  EXPECT_EQ(row_of(html, table, "x"), (Cells{"x", "0.9000 m", "± 0.0020 m", "–", "1.0000 m", "-0.1000 m"}));
  EXPECT_EQ(row_of(html, table, "y"), (Cells{"y", "-0.2500 m", "± 0.0020 m", "–", "0.0000 m", "-0.2500 m"}));
  EXPECT_EQ(row_of(html, table, "z"), (Cells{"z", "0.7500 m", "not observed", "–", "0.7500 m", "0.0000 m"}));
  EXPECT_EQ(row_of(html, table, "yaw"), (Cells{"yaw", "1.7189 °", "± 0.1146 °", "–", "0.0000 °", "+1.7189 °"}));
  EXPECT_EQ(row_of(html, "<h2>Correlation", "x"), (Cells{"x", "1.00", "-0.50", "–", "–", "–", "–"}));
}

TEST(report, the_place_of_an_antenna_does_not_pass_for_the_pose_of_a_lidar) {
  Report report = example_report();
  calibration::CalibrationResult& result = report.file.result;
  result.mounting.reference = calibration::BodyFrame::Vehicle;
  result.mounting.sensor = calibration::BodyFrame::Antenna;
  std::string html = report_html(report);
  EXPECT_NE(html.find("<h2>Antenna in the reference frame: vehicle_from_antenna"), std::string::npos);
  EXPECT_EQ(html.find("LiDAR in the"), std::string::npos);
  EXPECT_EQ(html.find("takes points of the LiDAR"), std::string::npos);
  result.mounting.reference = calibration::BodyFrame::Antenna;
  result.mounting.sensor = calibration::BodyFrame::Lidar;
  html = report_html(report);
  EXPECT_NE(html.find("<h2>LiDAR from the antenna, in its own axes: antenna_from_lidar"), std::string::npos);
  EXPECT_NE(html.find("no attitude"), std::string::npos);
}

TEST(report, pairs_are_listed_with_what_was_found) {
  const std::string html = report_html(example_report());
  const Cells accepted = row_of(html, "<h2>Pairs</h2>", "3"), rejected = row_of(html, "<h2>Pairs</h2>", "7");
  ASSERT_EQ(accepted.size(), 12U);
  EXPECT_EQ(accepted[3], "1.0 s") << "from scan to scan";
  EXPECT_EQ(accepted[9], "7.0 cm 0.00 °");
  EXPECT_EQ(accepted[10], "accepted");
  ASSERT_EQ(rejected.size(), 12U);
  EXPECT_EQ(rejected[9], "3.0 cm 0.00 °");
  EXPECT_EQ(rejected[10], "rejected");
  EXPECT_EQ(rejected[11], "overlap 0.21 is below 0.30");
  EXPECT_NE(html.find("proposed: 8, accepted: 7, rejected: 1; rms of residuals: 1.23 cm, 0.057 deg"),
            std::string::npos);
}

TEST(report, says_what_it_is_made_from) {
  const std::string html = report_html(example_report());
  EXPECT_EQ(row_of(html, "<h2>Data</h2>", "drive1"), (Cells{"drive1", "ins.csv", "12", "0123abcd"}));
  EXPECT_EQ(row_of(html, "<h2>Check by", "result"), (Cells{"result", "-3.5000", "21.0 mm", "400"}));
  EXPECT_EQ(row_of(html, "<h2>Check by", "nominal"), (Cells{"nominal", "-3.1000", "34.0 mm", "400"}));
  EXPECT_NE(html.find("<li>pairing.max_gap_s = 2.25   (1.5)</li>"), std::string::npos);
  for (const char* part :
       {"height z: not observable", "Remount 1.2.3", "Five of six &lt;parameters&gt;", "data:image/png;base64,UE5H"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(report, each_session_has_a_chart_of_its_own) {
  Report report = example_report();
  const auto charts = [&] {
    const std::string html = report_html(report);
    static const std::regex kChart("<svg");
    return std::distance(std::sregex_iterator(html.begin(), html.end(), kChart), std::sregex_iterator());
  };
  EXPECT_EQ(charts(), 2 + 1) << "residuals, and one drive";
  report.tracks.push_back({"drive2", true, {{0, 0}, {3, 3}}});
  EXPECT_EQ(charts(), 2 + 2);
}

TEST(report, needs_no_other_file) {
  const std::string html = report_html(example_report());
  for (const char* outside : {"https://", "<script", "src=\"/", "href="})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

TEST(report, without_a_usable_result_no_number_passes_for_one) {
  Report report = example_report();
  report.file.result.status = calibration::Status::TooFewPairs;
  report.file.result.set_observed({}, Message::verbatim("not shown by this drive"));
  const std::string html = report_html(report);
  EXPECT_EQ(html.find("0.9000"), std::string::npos);
  EXPECT_NE(html.find("too_few_pairs"), std::string::npos);
}

TEST(report, an_empty_result_has_a_page_too) {
  const std::string html = report_html(Report{});
  EXPECT_NE(html.find("</html>"), std::string::npos);
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(report, pictures_the_worst_accepted_pairs_first) {
  const auto chosen = pairs_to_picture(example_report().file.pairs, 2, 1);
  ASSERT_EQ(chosen.size(), 3U);
  EXPECT_EQ(chosen[0], motion::PairIndex{3}) << "residual 7 cm";
  EXPECT_EQ(chosen[1], motion::PairIndex{6}) << "6 cm";
  EXPECT_EQ(chosen[2], motion::PairIndex{0}) << "none";
  EXPECT_TRUE(pairs_to_picture({}, 3, 2).empty());
  EXPECT_EQ(pairs_to_picture(example_report().file.pairs, 100, 5).size(), 7U) << "each pair once";
}

TEST(report, every_word_can_be_in_another_language) {
  ReportStyle style;
  style.language = Language::Chinese;
  Report report = example_report();
  report.file.result.directions.clear();  // of the example's own words
  report.file.pairs.back().reason = {};
  const std::string html = report_html(report, style);
  EXPECT_NE(html.find("lang=\"zh-CN\""), std::string::npos);
  for (const char* english : {"Residual", "Pairs", "Correlation", "overlap", "nominal", "observable"})
    EXPECT_EQ(html.substr(0, html.find("<pre>")).find(english), std::string::npos) << english;
}

TEST(base64, agrees_with_the_examples_of_rfc_4648) {
  EXPECT_EQ(formats::base64(""), "");
  EXPECT_EQ(formats::base64("f"), "Zg==");
  EXPECT_EQ(formats::base64("fo"), "Zm8=");
  EXPECT_EQ(formats::base64("foo"), "Zm9v");
  EXPECT_EQ(formats::base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace remount::report

#include "model/report/report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/io/base64.h"

namespace remount {
namespace {

Report example() {
  Report report;
  CalibrationResult& result = report.file.result;
  result.status = Status::Degenerate;
  result.message = "Five of six <parameters> are observed.";
  result.ins_from_lidar = rigid_from_six({0.9, -0.25, 0.75, 0.03, -0.02, 0.015});
  result.observed = {true, true, false, true, true, true};
  result.covariance.setConstant(std::nan(""));
  for (const int i : {0, 1, 3, 4, 5}) result.covariance(i, i) = 4e-6;
  result.covariance(0, 1) = result.covariance(1, 0) = -2e-6;
  result.directions = {{Vector6d::Unit(2), 1e9, false, "height z: not observable, flat driving"}};
  report.file.nominal_ins_from_lidar = rigid_from_six({1.0, 0.0, 0.75, 0.0, 0.0, 0.0});
  report.file.version = "1.2.3";
  report.file.inputs = {{"drive1", "ins.csv", 12, "0123abcd"}};
  report.file.sharpness = {{"result", {-3.5, 0.021, 400}}, {"nominal", {-3.1, 0.034, 400}}};
  for (int i = 0; i < 8; ++i) {
    PairRecord pair;
    pair.stamp_b_ns = 1'000'000'000;
    pair.residual_translation_m = 0.01 * ((i * 5) % 8);
    pair.state = i == 7 ? PairState::Rejected : PairState::Accepted;
    if (i == 7) pair.reason = "overlap 0.21 is below 0.30";
    report.file.pairs.push_back(pair);
  }
  report.tracks = {{"drive1", {{0, 0}, {10, 5}, {20, 0}}}};
  report.pictures = {{"pair 3", "PNG"}};
  return report;
}

TEST(report, says_everything_that_a_decision_needs) {
  const std::string html = report_html(example());
  for (const char* part : {"0.9000 m", "± 0.0020 m", "not observed", "-0.1000 m", "-0.50", "height z: not observable",
                           "-3.5000", "3.40 cm", "overlap 0.21 is below 0.30", "0123abcd", "ins.csv", "1.2.3", "drive1",
                           "data:image/png;base64,UE5H", "<svg", "Five of six &lt;parameters&gt;", "max_gap_s"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
  EXPECT_EQ(html.find("nan"), std::string::npos);
  for (const char* outside : {"http://www.w3.org/2000/svg", "https://", "<script", "src=\"/", "href="})
    if (std::string(outside) != "http://www.w3.org/2000/svg")
      EXPECT_EQ(html.find(outside), std::string::npos) << "the page needs nothing else: " << outside;
}

TEST(report, without_a_usable_result_no_number_passes_for_one) {
  Report report = example();
  report.file.result.status = Status::TooFewPairs;
  report.file.result.observed.fill(false);
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
  const auto chosen = pairs_to_picture(example().file.pairs, 2, 1);
  ASSERT_EQ(chosen.size(), 3U);
  EXPECT_EQ(chosen[0], 3U) << "residual 7 cm";
  EXPECT_EQ(chosen[1], 6U) << "6 cm";
  EXPECT_EQ(chosen[2], 0U) << "none";
  EXPECT_TRUE(pairs_to_picture({}, 3, 2).empty());
  EXPECT_EQ(pairs_to_picture(example().file.pairs, 100, 5).size(), 7U) << "each pair once";
}

TEST(report, every_word_can_be_in_another_language) {
  ReportStyle style;
  style.phrase = [](const char*, const char*) { return std::string("W"); };
  style.sentence = [](const std::string&) { return std::string("S"); };
  const std::string html = report_html(example(), style);
  for (const char* english : {"Residual", "Pairs", "Correlation", "overlap", "nominal", "observable"})
    EXPECT_EQ(html.substr(0, html.find("<pre>")).find(english), std::string::npos) << english;
}

TEST(base64, agrees_with_the_examples_of_rfc_4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace remount

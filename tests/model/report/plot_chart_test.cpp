#include "model/report/plot_chart.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "messages/parameters.h"
#include "messages/plots.h"

namespace remount::report {
namespace {

/// Where the names of the curves stand, from the first to the last.
std::vector<double> places_of_names(const std::vector<std::string>& names) {
  calibration::Plot plot{Message::verbatim("title"), say::plot_axis_x(), say::plot_axis_y(), false, {}};
  for (const std::string& name : names)
    plot.curves.push_back({Message::verbatim(name), {0.0, 1.0}, {0.0, 1.0}, {}, false, {}});
  std::vector<double> places(names.size());
  for (const auto& shape : plot_chart(plot, Language::English).shapes)
    if (const auto* text = std::get_if<DrawnText>(&shape))
      for (std::size_t i = 0; i < names.size(); ++i)
        if (text->text == names[i]) places[i] = text->base.x();
  return places;
}

TEST(plot_chart, names_of_curves_are_as_far_apart_as_their_letters_need) {
  const auto gap = [](const std::vector<double>& places) { return places[1] - places[0]; };
  const double latin = gap(places_of_names({"first", "abcd"})), chinese = gap(places_of_names({"first", "轨迹对齐"})),
               accents = gap(places_of_names({"first", "äöüß"}));
  std::printf("names of four letters take %.1f (Latin), %.1f (Chinese), %.1f (accents) points\n", latin, chinese,
              accents);
  EXPECT_GT(chinese, 4 * 10.0) << "letters of 10 points must not overlap";
  EXPECT_LT(chinese, 2.0 * latin) << "they have three bytes and not three widths";
  EXPECT_DOUBLE_EQ(accents, latin);
}

TEST(plot_chart, zero_on_an_axis_has_no_sign) {
  int zeros = 0;
  for (const double lowest : {-0.02, -0.3, -1.0, 0.0}) {
    calibration::Plot plot{Message::verbatim("title"), say::plot_axis_x(), say::plot_axis_y(), false, {}};
    plot.curves.push_back({Message::verbatim("curve"), {lowest, 0.9}, {lowest, 0.9}, {}, false, {}});
    for (const auto& shape : plot_chart(plot, Language::English).shapes)
      if (const auto* text = std::get_if<DrawnText>(&shape)) {
        EXPECT_FALSE(text->text.starts_with("-0") && std::stod(text->text) == 0.0) << text->text;
        zeros += text->text.starts_with("0") && std::stod(text->text) == 0.0;
      }
  }
  EXPECT_EQ(zeros, 8) << "one on each axis";
}

TEST(plot_chart, speaks_the_language_of_the_reader_with_the_names_of_sessions_as_they_are) {
  const calibration::Plot plot{say::plot_of_session(say::plot_height(), "drive1"),
                               say::plot_axis_time(),
                               say::plot_axis_z(),
                               false,
                               {{say::parameter_yaw(), {0.0, 1.0}, {0.0, 1.0}, {}, false, {}},
                                {Message::verbatim("aligned"), {0.0, 1.0}, {0.0, 1.0}, {}, false, {}}}};
  std::vector<std::string> texts;
  for (const auto& shape : plot_chart(plot, Language::Chinese).shapes)
    if (const auto* text = std::get_if<DrawnText>(&shape)) texts.push_back(text->text);
  for (const char* said : {"高度：drive1", "时间（秒）", "z（米）", "偏航", "aligned"})
    EXPECT_EQ(std::ranges::count(texts, said), 1) << said;
}

}  // namespace
}  // namespace remount::report

#include "model/formats/documents/method_document.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/core/error.h"
#include "messages/parameters.h"
#include "messages/plots.h"
#include "messages/quantities.h"
#include "model/formats/documents/parse_document.h"

namespace remount::formats {
namespace {

std::vector<calibration::Plot> way_in_space() {
  const double nan = std::nan("");
  calibration::Curve way{say::plot_curve_aligned(), {0.0, 1.5, nan}, {2.0, -3.25, nan}, {}, false, {0.5, 0.75, nan}};
  calibration::Curve flat{say::plot_curve_gnss_fixes(), {1.0}, {2.0}, {0.02}, true, {}};
  return {{say::plot_trajectory_before_and_after(), say::plot_axis_east(), say::plot_axis_north(), true, {way, flat}}};
}

DocumentNode& at(DocumentNode& node, std::string_view key) { return const_cast<DocumentNode&>(*node.find(key)); }

TEST(method_document, plots_come_back_as_they_were_written) {
  DocumentNode file = DocumentNode::map();
  file.add("plots", plots_document(way_in_space()));
  const DocumentNode node = parse_yaml(to_yaml(file), "r.yaml");
  const std::vector<calibration::Plot> back = plots_from_document(DocumentView(node, "r").at("plots"));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_TRUE(back[0].equal_axes);
  EXPECT_EQ(back[0].title, say::plot_trajectory_before_and_after());
  EXPECT_EQ(back[0].x_label, say::plot_axis_east());
  EXPECT_EQ(back[0].y_label, say::plot_axis_north());
  ASSERT_EQ(back[0].curves.size(), 2U);
  const calibration::Curve &way = back[0].curves[0], &flat = back[0].curves[1];
  EXPECT_EQ(way.name, say::plot_curve_aligned());
  ASSERT_EQ(way.z.size(), 3U);
  EXPECT_EQ(way.z[1], 0.75);
  EXPECT_TRUE(std::isnan(way.z[2]));
  EXPECT_TRUE(flat.z.empty()) << "a curve need not have heights";
  EXPECT_EQ(flat.sigma, std::vector<double>{0.02});
  EXPECT_TRUE(flat.dots);
}

TEST(method_document, plots_of_former_versions_are_recognised_by_their_english_words) {
  const DocumentNode node = parse_yaml(
      "plots:\n  - {title: \"Height: drive1\", x_label: time (s), y_label: anything, equal_axes: false, curves: "
      "[{name: yaw, dots: false, x: [0], y: [0]}]}\n",
      "r.yaml");
  const std::vector<calibration::Plot> plots = plots_from_document(DocumentView(node, "r").at("plots"));
  ASSERT_EQ(plots.size(), 1U);
  EXPECT_EQ(plots[0].title, say::plot_of_session(say::plot_height(), "drive1"));
  EXPECT_EQ(plots[0].x_label, say::plot_axis_time());
  EXPECT_EQ(plots[0].y_label, Message::verbatim("anything"));
  EXPECT_EQ(plots[0].curves.at(0).name, say::parameter_yaw());
}

std::vector<calibration::NamedQuantity> quantities_in(const std::string& yaml) {
  const DocumentNode node = parse_yaml(yaml, "r.yaml");
  return quantities_from_document(DocumentView(node, "r").at("quantities"));
}

TEST(method_document, quantities_keep_their_id_under_name_and_come_back_with_their_words) {
  DocumentNode file = DocumentNode::map();
  file.add("quantities",
           quantities_document({{"odometry scale 2", say::quantity_odometry_scale_of(2), 1.0, 0.1, "", true}}));
  const std::string yaml = to_yaml(file);
  EXPECT_NE(yaml.find("name: \"odometry scale 2\""), std::string::npos) << yaml;
  EXPECT_NE(yaml.find("quantity-odometry-scale-of"), std::string::npos) << yaml;
  const std::vector<calibration::NamedQuantity> back = quantities_in(yaml);
  ASSERT_EQ(back.size(), 1U);
  EXPECT_EQ(back[0].id, "odometry scale 2");
  EXPECT_EQ(back[0].name, say::quantity_odometry_scale_of(2));
}

TEST(method_document, quantities_of_former_versions_are_named_by_their_id) {
  const auto named = [](const std::string& id) {
    return quantities_in("quantities:\n  - {name: \"" + id + "\", value: 1, sigma: 0.1, unit: m, observed: true}\n")
        .at(0)
        .name;
  };
  EXPECT_EQ(named("slew centre x"), say::quantity_slew_centre_x());
  EXPECT_EQ(named("odometry scale"), say::quantity_odometry_scale());
  EXPECT_EQ(named("odometry scale 3"), say::quantity_odometry_scale_of(3));
  EXPECT_EQ(named("distance driven, drive 1"), say::quantity_distance_driven_in("drive 1"));
  EXPECT_EQ(named("rotation equation singular value 4"), say::quantity_rotation_equation_singular_value(4));
  EXPECT_EQ(named("of a later version"), Message::verbatim("of a later version"));
}

TEST(method_document, heights_of_another_length_are_refused) {
  DocumentNode node = plots_document(way_in_space());
  at(at(node.items[0], "curves").items[0], "z") = DocumentNode::numbers({0.5});
  try {
    plots_from_document(DocumentView(node, "plots"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("expected as many numbers as in x"), std::string::npos) << error.what();
  }
}

TEST(method_document, thinning_keeps_the_coordinates_of_a_point_together) {
  calibration::Curve way{say::plot_curve_aligned(), {}, {}, {}, false, {}};
  for (int i = 0; i < 1000; ++i) {
    way.x.push_back(i);
    way.y.push_back(2 * i);
    way.z.push_back(3 * i);
  }
  std::vector<calibration::Plot> plots{{say::plot_height(), say::plot_axis_x(), say::plot_axis_y(), true, {way}}};
  calibration::thin(plots, 10);
  const calibration::Curve& kept = plots[0].curves[0];
  ASSERT_EQ(kept.z.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(kept.z[i], 3.0 * kept.x[i]);
  EXPECT_EQ(kept.z.back(), 2997.0);
}

}  // namespace
}  // namespace remount::formats

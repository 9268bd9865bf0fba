#include "model/formats/documents/method_document.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/core/error.h"
#include "model/formats/documents/parse_document.h"

namespace remount {
namespace {

std::vector<Plot> way_in_space() {
  const double nan = std::nan("");
  Curve way{"aligned", {0.0, 1.5, nan}, {2.0, -3.25, nan}, {}, false, {0.5, 0.75, nan}};
  Curve flat{"GNSS fixes", {1.0}, {2.0}, {0.02}, true, {}};
  return {{"Trajectory before and after", "east (m)", "north (m)", true, {way, flat}}};
}

DocumentNode& at(DocumentNode& node, std::string_view key) { return const_cast<DocumentNode&>(*node.find(key)); }

TEST(method_document, plots_come_back_as_they_were_written) {
  DocumentNode file = DocumentNode::map();
  file.add("plots", plots_document(way_in_space()));
  const DocumentNode node = parse_yaml(to_yaml(file), "r.yaml");
  const std::vector<Plot> back = plots_from_document(DocumentView(node, "r").at("plots"));
  ASSERT_EQ(back.size(), 1U);
  EXPECT_TRUE(back[0].equal_axes);
  ASSERT_EQ(back[0].curves.size(), 2U);
  const Curve &way = back[0].curves[0], &flat = back[0].curves[1];
  ASSERT_EQ(way.z.size(), 3U);
  EXPECT_EQ(way.z[1], 0.75);
  EXPECT_TRUE(std::isnan(way.z[2]));
  EXPECT_TRUE(flat.z.empty()) << "a curve need not have heights";
  EXPECT_EQ(flat.sigma, std::vector<double>{0.02});
  EXPECT_TRUE(flat.dots);
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
  Curve way{"way", {}, {}, {}, false, {}};
  for (int i = 0; i < 1000; ++i) {
    way.x.push_back(i);
    way.y.push_back(2 * i);
    way.z.push_back(3 * i);
  }
  std::vector<Plot> plots{{"way", "x", "y", true, {way}}};
  thin(plots, 10);
  const Curve& kept = plots[0].curves[0];
  ASSERT_EQ(kept.z.size(), 10U);
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(kept.z[i], 3.0 * kept.x[i]);
  EXPECT_EQ(kept.z.back(), 2997.0);
}

}  // namespace
}  // namespace remount

#include "model/formats/packets/beam_rings.h"

#include <gtest/gtest.h>

namespace remount::formats {
namespace {

using Rings = std::vector<std::uint16_t>;

TEST(beam_rings, count_from_the_lowest_and_beams_of_one_elevation_have_one_each) {
  EXPECT_EQ(rings_of({15.0, -3.0, 2.0, -25.0}), (Rings{3, 1, 2, 0}));
  EXPECT_EQ(rings_of({1.0, -2.0, 1.0, -2.0}), (Rings{2, 0, 3, 1})) << "in their order";
  EXPECT_TRUE(rings_of({}).empty());
}

}  // namespace
}  // namespace remount::formats

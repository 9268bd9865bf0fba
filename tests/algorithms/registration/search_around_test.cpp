#include "algorithms/registration/search_around.h"

#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "tests/algorithms/support/room.h"

namespace remount::registration {
namespace {

// A yard 60 m long whose ends, boards and boxes tell where one stands.
std::vector<testing::Rectangle> yard() {
  std::vector<testing::Rectangle> world{{{-30, -12, -1.7}, {60, 0, 0}, {0, 24, 0}},
                                        {{-30, -12, -1.7}, {60, 0, 0}, {0, 0, 6}},
                                        {{-30, 12, -1.7}, {60, 0, 0}, {0, 0, 6}},
                                        {{30, -12, -1.7}, {0, 24, 0}, {0, 0, 6}}};
  const double boards[][2] = {{-22, 7}, {-15, -8}, {-9, 4}, {-2, -6}, {5, 8}, {9, -3}, {16, 5}, {23, -7}};
  for (const auto& at : boards) {
    world.push_back({{at[0], at[1], -1.7}, {1.8, 0.7, 0}, {0, 0, 2.5}});
    world.push_back({{at[0], at[1], -1.7}, {-0.6, 1.6, 0}, {0, 0, 2.5}});
  }
  return world;
}

// Boxes that repeat every four metres, between walls without an end.
std::vector<testing::Rectangle> colonnade() {
  std::vector<testing::Rectangle> world{{{-60, -5, -1.7}, {120, 0, 0}, {0, 10, 0}},
                                        {{-60, -5, -1.7}, {120, 0, 0}, {0, 0, 5}},
                                        {{-60, 5, -1.7}, {120, 0, 0}, {0, 0, 5}}};
  for (double x = -58.0; x < 60.0; x += 4.0)
    for (const double y : {-4.0, 3.4}) {
      world.push_back({{x, y, -1.7}, {0, 0.6, 0}, {0, 0, 4}});
      world.push_back({{x, y, -1.7}, {0.6, 0, 0}, {0, 0, 4}});
    }
  return world;
}

const RigidTransform kTruth = make_rigid(so3_exp({0.01, -0.01, 0.1}), {1.5, 0.3, 0.02});

struct SearchScans {
  explicit SearchScans(const std::vector<testing::Rectangle>& world)
      : source(testing::scan_of(world, kTruth, 0.01, 1, 40000), {}),
        target(testing::scan_of(world, RigidTransform::Identity(), 0.01, 2, 40000), {}) {}
  PreparedCloud source, target;
};

const SearchScans& yard_scans() {
  static const SearchScans scans(yard());
  return scans;
}

RigidTransform start_off(const Eigen::Vector3d& shift_m, const Eigen::Vector3d& turn_deg) {
  Vector6d step;
  step << shift_m, degrees_to_radians(1.0) * turn_deg;
  return perturb(kTruth, step);
}

std::string describe_search(const RegistrationResult& result) {
  const Vector6d error = difference(kTruth, result.target_from_source);
  return "error " + std::to_string(error.head<3>().norm()) + " m, " +
         std::to_string(radians_to_degrees(error.tail<3>().norm())) + " deg; " + english(result.quality.failure);
}

TEST(search_around, finds_a_pair_from_five_metres_and_thirty_degrees) {
  const SearchScans& scans = yard_scans();
  const Eigen::Vector3d shifts[] = {{4.9, 1.0, 0.0}, {-3.5, 3.5, 0.7}, {0.5, -4.9, 0.5}, {-4.9, -0.8, -0.5}};
  const Eigen::Vector3d turns[] = {{0, 0, 30}, {17, 17, -17}, {0, -26, 15}, {5, 0, -29.6}};
  int alone = 0;
  for (int i = 0; i < 4; ++i) {
    const RigidTransform start = start_off(shifts[i], turns[i]);
    const RegistrationResult result = align_scans(scans.source, scans.target, start, {}, {});
    const Vector6d error = difference(kTruth, result.target_from_source);
    EXPECT_EQ(result.quality.failure, Message()) << i << ": " << describe_search(result);
    EXPECT_LT(error.head<3>().norm(), 0.02) << i << ": " << describe_search(result);
    EXPECT_LT(error.tail<3>().norm(), degrees_to_radians(0.1)) << i << ": " << describe_search(result);
    RegistrationOptions without;
    without.search_when_doubtful = false;
    const RegistrationResult plain = align_scans(scans.source, scans.target, start, without, {});
    alone += difference(kTruth, plain.target_from_source).head<3>().norm() < 0.2;
  }
  EXPECT_LT(alone, 4) << "these starts need no search: the test shows nothing";
}

TEST(search_around, leaves_a_good_start_alone) {
  const SearchScans& scans = yard_scans();
  const RigidTransform start = start_off({0.2, 0.1, 0.0}, {0, 0, 1});
  RegistrationOptions without;
  without.search_when_doubtful = false;
  const RegistrationResult searched = align_scans(scans.source, scans.target, start, {}, {}),
                           plain = align_scans(scans.source, scans.target, start, without, {});
  EXPECT_TRUE(searched.target_from_source.matrix() == plain.target_from_source.matrix());
  EXPECT_EQ(searched.quality.iterations, plain.quality.iterations);
}

TEST(search_around, says_that_repeating_surroundings_are_ambiguous) {
  const SearchScans scans(colonnade());
  // Between two of the places that fit, and turned: whichever comes out is a guess.
  const RegistrationResult result =
      align_scans(scans.source, scans.target, start_off({2.0, 0.0, 0.0}, {0, 0, 25}), {}, {});
  const double off_m = difference(kTruth, result.target_from_source).head<3>().norm();
  EXPECT_NE(english(result.quality.failure).find("ambiguous: another alignment"), std::string::npos)
      << describe_search(result) << ", off " << off_m << " m";
}

TEST(search_around, gives_the_same_bytes_again) {
  const SearchScans& scans = yard_scans();
  const RigidTransform start = start_off({-3.5, 3.5, 0.7}, {17, 17, -17});
  const RegistrationResult first = align_scans(scans.source, scans.target, start, {}, {}),
                           second = align_scans(scans.source, scans.target, start, {}, {});
  EXPECT_TRUE(first.target_from_source.matrix() == second.target_from_source.matrix());
}

}  // namespace
}  // namespace remount::registration

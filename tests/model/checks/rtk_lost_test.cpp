#include <gtest/gtest.h>

#include "algorithms/messages/render.h"
#include "model/checks/builtin.h"
#include "tests/model/checks/check_fixture.h"

namespace remount::checks {
namespace {

TEST(rtk_check, a_stated_error_that_grows_from_centimetres_to_metres_is_named) {
  drive::Session session = good_drive();
  for (std::size_t i = 300; i < 400; ++i) session.ins[i].sigma.position_enu_m.setConstant(1.2);
  const std::string said = testing::said_of(found_by(rtk_check(), session), "rtk-lost");
  EXPECT_EQ(said,
            "The stated error of the position grows from 0.014 m to 1.70 m in 1 stretch, 20 % of the drive: "
            "corrections (RTK) were lost.");
}

TEST(rtk_check, fixes_of_a_receiver_are_judged_alike) {
  drive::Session session;
  for (int i = 0; i < 100; ++i) {
    motion::GnssFix fix;
    fix.stamp_ns = i * 100'000'000LL;
    fix.covariance_enu_m2 = Eigen::Matrix3d::Identity() * (i % 50 < 10 ? 4.0 : 1e-4);
    session.gnss.push_back(fix);
  }
  const std::vector<drive::Finding> findings = found_by(rtk_check(), session);
  ASSERT_TRUE(testing::has_code(findings, "rtk-lost"));
  EXPECT_EQ(drive::english(findings[0].where), "GNSS");
  EXPECT_NE(english(findings[0].explanation).find("in 2 stretches, 20 %"), std::string::npos)
      << english(findings[0].explanation);
}

TEST(rtk_check, errors_that_stay_the_same_or_are_not_stated_say_nothing) {
  EXPECT_TRUE(found_by(rtk_check(), good_drive()).empty());
  drive::Session coarse = good_drive(), silent = good_drive(), slightly = good_drive();
  for (motion::InsSample& sample : coarse.ins) sample.sigma.position_enu_m.setConstant(2.0);
  for (motion::InsSample& sample : silent.ins) sample.sigma = {};
  for (std::size_t i = 300; i < 400; ++i) slightly.ins[i].sigma.position_enu_m.setConstant(0.05);
  for (const drive::Session& session : {coarse, silent, slightly}) EXPECT_TRUE(found_by(rtk_check(), session).empty());
}

}  // namespace
}  // namespace remount::checks

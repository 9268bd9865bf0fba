// The bars of what the sigmas are made of: their shares, what is hit, and when nothing is shown.
#include "widgets/result/sigma_budget_view.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

#include "messages/parameters.h"
#include "tests/widgets/support/restored.h"

namespace remount::widgets {
namespace {

using calibration::Parameter;

/// x of 3 mm and 4 mm, yaw of the second alone; z is not observed.
calibration::CalibrationResult result_of_two_parts() {
  calibration::CalibrationResult result;
  result.conclude(calibration::Status::Degenerate, Message::verbatim("z is not observed"));
  result.set_observed(~calibration::ParameterSet{Parameter::Z}, Message::verbatim("flat"));
  calibration::SigmaPart first{say::sigma_part_registration(), {}}, second{say::sigma_part_ins(), {}};
  for (const Parameter parameter : calibration::kParameters) second.sigma[parameter] = 0.004;
  first.sigma[Parameter::X] = 0.003;
  result.sigma_parts = {first, second};
  result.covariance = Matrix6d::Identity() * 1.6e-5;
  result.covariance(0, 0) = 2.5e-5;
  return result;
}

TEST(sigma_budget_view, bars_are_parted_by_variances) {
  const testing::LanguageFor english("en");
  const calibration::CalibrationResult result = result_of_two_parts();
  SigmaBudgetView view;
  view.resize(900, 240);
  view.show();
  view.show_result(&result);
  SigmaBars& bars = *view.bars();
  ASSERT_TRUE(bars.isVisible());
  EXPECT_NEAR(bars.share(0, Parameter::X), 0.36, 1e-12);
  EXPECT_NEAR(bars.share(1, Parameter::X), 0.64, 1e-12);
  EXPECT_EQ(bars.share(0, Parameter::Yaw), 0.0);
  EXPECT_EQ(bars.share(1, Parameter::Z), 0.0) << "not observed";
  QTest::qWait(50);
  int first = 0, second = 0;
  for (int x = 0; x < bars.width(); ++x) {
    const auto place = bars.place_at({x, bars.height() / 12});
    if (!place) continue;
    EXPECT_EQ(place->parameter, Parameter::X);
    ++(place->part == 0 ? first : second);
  }
  std::printf("x is drawn %d px by registrations, %d px by the INS\n", first, second);
  EXPECT_NEAR(first / static_cast<double>(first + second), 0.36, 0.02);
  const QString words = bars.words_of({0, Parameter::X});
  EXPECT_TRUE(words.contains("3.00 mm") && words.contains("36 %")) << words.toStdString();
}

TEST(sigma_budget_view, shows_nothing_that_does_not_add_up) {
  const testing::LanguageFor english("en");
  SigmaBudgetView view;
  view.show();
  EXPECT_FALSE(view.bars()->isVisible());
  calibration::CalibrationResult result = result_of_two_parts();
  view.show_result(&result);
  EXPECT_TRUE(view.bars()->isVisible());
  result.covariance(0, 0) *= 1.5;
  view.show_result(&result);
  EXPECT_FALSE(view.bars()->isVisible());
  EXPECT_TRUE(view.findChild<QLabel*>()->text().contains("does not tell"));
}

}  // namespace
}  // namespace remount::widgets

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "algorithms/core/error.h"
#include "model/method_registry/method_choice.h"
#include "model/settings/settings.h"

namespace remount::method_registry {
namespace {

// The settings choose by place, files and the command line by id.
TEST(method_registry, names_every_method_once_and_finds_it_again) {
  const std::vector<std::string_view> ids = method_ids();
  ASSERT_EQ(ids.size(), calibration_methods().size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const CalibrationMethod& method = *calibration_methods()[i];
    EXPECT_EQ(ids[i], method.id);
    EXPECT_EQ(std::count(ids.begin(), ids.end(), method.id), 1) << method.id;
    EXPECT_EQ(&calibration_method(method.id), &method);
    EXPECT_EQ(find_method(method.id), &method);
    EXPECT_EQ(MethodChoice(method.id), MethodChoice(i));
    EXPECT_EQ(&*MethodChoice(i), &method);
    EXPECT_EQ(static_cast<std::size_t>(MethodChoice(method.id)), i);
  }
  EXPECT_EQ(&*MethodChoice(), &default_method());
  EXPECT_EQ(find_method("guess"), nullptr);
}

TEST(method_registry, has_all_that_others_ask_of_a_method) {
  for (const CalibrationMethod* method : calibration_methods()) {
    SCOPED_TRACE(method->id);
    EXPECT_FALSE(method->title().empty() || method->needs().empty());
    EXPECT_TRUE(method->lack && method->run);
    const ForOtherMachine& other = method->other_machine;
    EXPECT_EQ(!other.proviso, !other.or_else);
    EXPECT_EQ(!other.proviso, !other.or_choose);
  }
}

TEST(method_registry, answers_what_is_unknown_with_the_known_ones) {
  for (const auto choose : {+[] { calibration_method("guess"); }, +[] { (void)MethodChoice("guess"); }}) {
    try {
      choose();
      FAIL() << "no method is called so";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("pairwise"), std::string::npos) << error.what();
    }
  }
}

TEST(method_registry, a_choice_of_no_place_is_a_problem_of_the_settings) {
  settings::Settings settings;
  settings.run.method = MethodChoice(calibration_methods().size());
  EXPECT_EQ(settings.check().size(), 1U);
  EXPECT_THROW((void)*settings.run.method, std::out_of_range);
}

}  // namespace
}  // namespace remount::method_registry

#include "algorithms/calibration/parameter.h"

#include <gtest/gtest.h>

namespace remount::calibration {
namespace {

TEST(parameter, comes_back_from_its_name) {
  for (const Parameter parameter : kParameters)
    EXPECT_EQ(parameter_from_string(to_string(parameter)), parameter) << to_string(parameter);
  EXPECT_FALSE(parameter_from_string("heading"));
}

TEST(parameter, sets_hold_what_was_put_in) {
  ParameterSet set{Parameter::X, Parameter::Roll};
  EXPECT_EQ(parameter_names(set), "x, roll");
  EXPECT_EQ(parameter_names(~set), "y, z, yaw, pitch");
  EXPECT_EQ(parameter_names(~set & kPositionParameters), "y, z");
  set.erase(Parameter::X);
  set.insert(Parameter::Yaw);
  EXPECT_EQ(set, (ParameterSet{Parameter::Yaw, Parameter::Roll}));
  EXPECT_TRUE(ParameterSet::all().is_all() && (~ParameterSet::all()).empty() && !set.is_all() && !set.empty());
}

TEST(parameter, a_transform_comes_back_from_its_parameters) {
  const RigidTransform transform = rigid_from_six({1.0, -2.0, 3.0, 0.4, -0.5, 0.6});
  const PerParameter<double> values = parameters_of(transform);
  EXPECT_NEAR(values[Parameter::Z], 3.0, 1e-12);
  EXPECT_NEAR(values[Parameter::Yaw], 0.4, 1e-12);
  EXPECT_NEAR(values[Parameter::Roll], 0.6, 1e-12);
  EXPECT_LT(difference(rigid_of(values), transform).norm(), 1e-12);
}

TEST(parameter, those_that_are_kept_are_those_of_the_other) {
  const RigidTransform found = rigid_from_six({1.0, -2.0, 3.0, 0.4, -0.5, 0.6}), nominal = rigid_from_six({});
  const PerParameter<double> mixed = parameters_of(with_kept(found, nominal, {Parameter::Z, Parameter::Yaw}));
  const PerParameter<double> own = parameters_of(found);
  for (const Parameter parameter : kParameters) {
    const bool kept = parameter == Parameter::Z || parameter == Parameter::Yaw;
    EXPECT_NEAR(mixed[parameter], kept ? 0.0 : own[parameter], 1e-12) << to_string(parameter);
  }
  EXPECT_EQ(with_kept(found, nominal, {}).matrix(), found.matrix()) << "to the bit";
}

}  // namespace
}  // namespace remount::calibration

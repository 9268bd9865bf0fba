#include "algorithms/odometry/fusion/joint_step.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace remount::odometry {
namespace {

StepAnchor anchor_of_joint_step() {
  return {make_rigid(so3_exp({0.1, -0.05, 0.8}), {120.0, -40.0, 3.0}),
          make_rigid(so3_exp({0.12, -0.03, 0.9}), {121.2, -39.1, 3.1})};
}

/// Unknowns of very different units, correlated.
LinearFusionTerm linear_of_joint_step(const FusionVector& expected) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  FusionJacobian root(30, kFusionUnknowns);
  for (Eigen::Index i = 0; i < root.rows(); ++i)
    for (Eigen::Index j = 0; j < root.cols(); ++j) root(i, j) = normal(random) * std::pow(10.0, j % 5);
  return LinearFusionTerm(root, expected);
}

FusionVector gradient_of_joint_step(const std::vector<WeighedTerm>& terms, const FusionVector& x) {
  FusionVector gradient = FusionVector::Zero();
  for (const WeighedTerm& weighed : terms) {
    Eigen::VectorXd residuals(weighed.term->rows());
    FusionJacobian jacobian(weighed.term->rows(), kFusionUnknowns);
    weighed.term->evaluate(x, residuals, &jacobian);
    const double weight = weighed.robust ? 1.0 / (1.0 + residuals.squaredNorm() / 9.0) : 1.0;
    gradient += weight * jacobian.transpose() * residuals;
  }
  return gradient;
}

/// Weak beliefs about all unknowns but the wheels' scale, a turn that the prediction does not have, and wheels.
std::vector<WeighedTerm> bent_terms(double wheel_travel_m) {
  FusionJacobian beliefs = FusionJacobian::Identity(kFusionUnknowns, kFusionUnknowns) * 0.5;
  beliefs(kDrift + 3, kDrift + 3) = 1e3;
  std::vector<WeighedTerm> terms;
  terms.push_back({std::make_unique<LinearFusionTerm>(beliefs, FusionVector::Zero()), false});
  terms.push_back({std::make_unique<TurnTerm>(anchor_of_joint_step(), so3_exp({0.2, -0.1, 0.7}), 0.1,
                                              Eigen::Vector3d(1e-3, 1e-3, 1e-3), true),
                   false});
  terms.push_back(
      {std::make_unique<LevelTerm>(anchor_of_joint_step(), LevelMeasurement{0.3, -0.2, 0.01, 0.01}), false});
  terms.push_back({std::make_unique<HeightTerm>(anchor_of_joint_step(), 4.0, 0.1), false});
  terms.push_back({std::make_unique<TravelTerm>(anchor_of_joint_step(), Eigen::Vector3d(wheel_travel_m, 0.0, 0.0),
                                                Eigen::Vector3d(0.02, 0.02, 0.02), true),
                   true});
  return terms;
}

TEST(joint_step, linear_terms_are_solved_exactly_with_their_information) {
  FusionVector truth;
  for (int i = 0; i < kFusionUnknowns; ++i) truth[i] = 0.1 * i - 1.0;
  const LinearFusionTerm term = linear_of_joint_step(truth);
  std::vector<WeighedTerm> terms;
  terms.push_back({std::make_unique<LinearFusionTerm>(term), false});
  const JointStep step = solve_joint_step(terms, FusionVector::Zero());
  ASSERT_TRUE(step.usable);
  EXPECT_LT((step.x - truth).norm(), 1e-8) << (step.x - truth).transpose();
  Eigen::VectorXd residuals(term.rows());
  FusionJacobian root(term.rows(), kFusionUnknowns);
  term.evaluate(truth, residuals, &root);
  const FusionInformation information = root.transpose() * root;
  EXPECT_LT((step.information - information).norm(), 1e-12 * information.norm());
}

TEST(joint_step, bent_terms_end_where_no_direction_leads_down) {
  const std::vector<WeighedTerm> terms = bent_terms(1.5);
  const FusionVector start = FusionVector::Zero();
  const JointStep step = solve_joint_step(terms, start);
  ASSERT_TRUE(step.usable);
  const double before = gradient_of_joint_step(terms, start).norm();
  const double after = gradient_of_joint_step(terms, step.x).norm();
  RecordProperty("gradient", std::to_string(after / before));
  EXPECT_LT(after, 1e-4 * before);
}

TEST(joint_step, a_robust_term_that_is_far_off_hardly_counts) {
  const FusionVector start = FusionVector::Zero();
  const JointStep right = solve_joint_step(bent_terms(1.5), start), slipped = solve_joint_step(bent_terms(60.0), start);
  std::vector<WeighedTerm> trusted = bent_terms(60.0);
  trusted.back().robust = false;
  const JointStep dragged = solve_joint_step(trusted, start);
  ASSERT_TRUE(right.usable && slipped.usable && dragged.usable);
  const Eigen::Vector3d there = right.x.segment<3>(kMotion);
  EXPECT_LT((slipped.x.segment<3>(kMotion) - there).norm(), 5.0);
  EXPECT_GT((dragged.x.segment<3>(kMotion) - there).norm(), 20.0);
  EXPECT_LT(slipped.information(kMotion, kMotion), 0.01 * right.information(kMotion, kMotion));
}

TEST(joint_step, what_nothing_tells_of_stays) {
  std::vector<WeighedTerm> terms;
  terms.push_back({std::make_unique<HeightTerm>(anchor_of_joint_step(), 4.0, 0.1), false});
  FusionVector start = FusionVector::Zero();
  start[kDrift] = 0.25;
  const JointStep step = solve_joint_step(terms, start);
  ASSERT_TRUE(step.usable);
  EXPECT_NEAR(fused_pose(anchor_of_joint_step(), step.x).translation().z(), 4.0, 1e-6);
  EXPECT_EQ(step.x[kDrift], 0.25);
}

/// Has a value only where the first unknown is less than one, and would like it to be two.
class EdgeTerm : public FusionTerm {
 public:
  int rows() const override { return 1; }
  void evaluate(const FusionVector& x, Eigen::Ref<Eigen::VectorXd> residuals, FusionJacobian* jacobian) const override {
    residuals[0] = x[0] < 1.0 ? x[0] - 2.0 : std::numeric_limits<double>::quiet_NaN();
    if (!jacobian) return;
    jacobian->setZero();
    (*jacobian)(0, 0) = 1.0;
  }
};

TEST(joint_step, terms_without_a_value_are_not_usable_and_not_run_into) {
  EXPECT_FALSE(solve_joint_step({}, FusionVector::Zero()).usable);
  std::vector<WeighedTerm> terms;
  terms.push_back({std::make_unique<EdgeTerm>(), false});
  FusionVector beyond = FusionVector::Zero();
  beyond[0] = 1.5;
  const JointStep from_beyond = solve_joint_step(terms, beyond);
  EXPECT_FALSE(from_beyond.usable);
  EXPECT_EQ(from_beyond.x, beyond);
  const JointStep step = solve_joint_step(terms, FusionVector::Zero());
  EXPECT_TRUE(step.usable);
  EXPECT_LT(step.x[0], 1.0);
}

}  // namespace
}  // namespace remount::odometry

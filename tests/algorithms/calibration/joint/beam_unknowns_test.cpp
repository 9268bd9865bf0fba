#include "algorithms/calibration/joint/beam_unknowns.h"

#include <gtest/gtest.h>

#include "algorithms/cloud/beam_options.h"

namespace remount::calibration {
namespace {

const cloud::BeamNodes& nodes() { return cloud::BeamNodes::all_around(); }

std::vector<motion::PairIndex> all_of(const std::vector<motion::Pair>& pairs) {
  std::vector<motion::PairIndex> all;
  for (motion::PairIndex i; i < pairs.size(); ++i) all.push_back(i);
  return all;
}

// Pairs of scans whose registrations move along x with the range of one beam.
std::vector<motion::Pair> pairs_that_show(Eigen::Index error, float response) {
  std::vector<motion::Pair> pairs(20);
  for (motion::Pair& pair : pairs) {
    pair.weight = 1.0;
    pair.registration.information = 1e6 * Matrix6d::Identity();
    pair.registration.beam_response.setZero(6, nodes().errors());
    pair.registration.beam_response(0, error) = response;
  }
  return pairs;
}

TEST(beam_unknowns, are_those_that_registrations_show) {
  const cloud::BeamPrior believed = cloud::believed_of_beams({}, cloud::LidarKind::Spinning, nodes());
  const std::vector<motion::Pair> pairs = pairs_that_show(nodes().range_at(12), 1.0f);
  const BeamUnknowns unknowns = choose_beam_unknowns(believed, {}, pairs, all_of(pairs));
  EXPECT_EQ(unknowns.of_single, 1);
  EXPECT_EQ(unknowns.basis.cols(), believed.common.cols() + 1);
  const Eigen::VectorXd single = unknowns.basis.rightCols(1);
  EXPECT_NEAR(std::abs(single[nodes().range_at(12)]), 0.015, 1e-9);
  EXPECT_EQ(choose_beam_unknowns({}, {}, pairs, all_of(pairs)).basis.cols(), 0);
  const std::vector<motion::Pair> untold = pairs_that_show(nodes().range_at(12), 0.0f);
  EXPECT_EQ(choose_beam_unknowns(believed, {}, untold, all_of(untold)).basis.cols(), 0)
      << "of a former version, or registered as if there were none";
  const std::vector<motion::Pair> blind = pairs_that_show(nodes().range_at(12), 1e-6f);
  EXPECT_EQ(choose_beam_unknowns(believed, {}, blind, all_of(blind)).of_single, 0);
}

TEST(beam_unknowns, what_is_taken_out_is_found_as_a_whole_and_the_rest_stays_as_believed) {
  const cloud::BeamPrior believed = cloud::believed_of_beams({}, cloud::LidarKind::Spinning, nodes());
  cloud::BeamErrors mended(nodes());
  mended.values[nodes().range_at(12)] = 0.02;
  const std::vector<motion::Pair> pairs = pairs_that_show(nodes().range_at(12), 1.0f);
  const BeamUnknowns unknowns = choose_beam_unknowns(believed, mended, pairs, all_of(pairs));
  EXPECT_EQ(unknowns.mean, -mended.values) << "what the mended scans are believed to have too much";
  const Eigen::Index count = unknowns.basis.cols();
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(count);
  solution[count - 1] = 0.02 / unknowns.basis(nodes().range_at(12), count - 1);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Identity(count, count);
  covariance(count - 1, count - 1) = 0.01;
  const cloud::BeamEstimate estimate = estimate_beams(believed, mended, unknowns, solution, covariance);
  EXPECT_NEAR(estimate.errors[nodes().range_at(12)], 0.02, 1e-9);
  EXPECT_NEAR(estimate.sigmas[nodes().range_at(40)], std::hypot(0.02, 0.015), 1e-6) << "common and own";
  EXPECT_NEAR(estimate.sigmas[nodes().range_at(12)], std::hypot(0.02, 0.0015), 1e-6);
  EXPECT_FALSE(estimate.elevation.told);
  // Of beams that an earlier drive told, what is left of it is the unknown.
  cloud::BeamPrior told = believed;
  told.mean = 2.0 * mended.values;
  EXPECT_EQ(choose_beam_unknowns(told, mended, pairs, all_of(pairs)).mean, mended.values);
  EXPECT_TRUE(estimate_beams({}, mended, {}, {}, {}).empty());
}

// A file keeps the columns up to the last that moves the registration.
TEST(beam_unknowns, a_response_that_ends_early_moves_nothing_with_the_rest) {
  std::vector<motion::Pair> pairs = pairs_that_show(nodes().range_at(12), 1.0f), whole = pairs;
  for (motion::Pair& pair : pairs)
    pair.registration.beam_response = pair.registration.beam_response.leftCols(nodes().range_at(12) + 1).eval();
  const cloud::BeamPrior believed = cloud::believed_of_beams({}, cloud::LidarKind::Spinning, nodes());
  EXPECT_EQ(choose_beam_unknowns(believed, {}, pairs, all_of(pairs)).basis,
            choose_beam_unknowns(believed, {}, whole, all_of(whole)).basis);
  EXPECT_EQ(response_of(pairs[0], nodes().errors()), response_of(whole[0], nodes().errors()));
}

}  // namespace
}  // namespace remount::calibration

// Which of many pairs are worth their registration, by what they are expected to tell of X. docs/maths/pairwise.md
// (P23) to (P26)
#pragma once

#include <optional>
#include <vector>

#include "algorithms/calibration/pairwise/pairwise.h"

namespace remount::calibration {

/// Gives each pair that was not registered the motion that P and X predict, and of the accepted ones near it in the
/// list what that tells whose motion is most alike; without one, what an ordinary scan tells.
void expect_registrations(const RigidTransform& ins_from_lidar, std::vector<motion::Pair>& pairs);

/// Information of X under `perturb` from all pairs with a weight, with the errors of INS poses and all else that is
/// solved for marginalised, those of the beams apart. Their residuals do not matter.
/// @param weights of each pair
Matrix6d expected_information(const PairwiseInput& input, const std::vector<motion::Pair>& pairs,
                              const std::vector<double>& weights, const NoiseModel& noise,
                              const RigidTransform& ins_from_lidar, const Progress& progress);

/// Takes pairs one after the other, each time the one that adds most to what those before tell, for the work it is: as
/// pairs share the errors of their keyframes, and as a scan that is prepared already costs nothing more. Spread over
/// the time of every session, headings, ways of turning and lengths.
class PairChooser {
 public:
  /// @param pairs with what their registrations tell or are expected to tell
  /// @param taken of each pair, whether it is taken already
  PairChooser(const PairwiseInput& input, const std::vector<motion::Pair>& pairs, const NoiseModel& noise,
              const RigidTransform& ins_from_lidar, std::vector<bool> taken);

  /// Takes so many more; fewer where there are no more.
  void take(std::size_t count);

  const std::vector<bool>& taken() const { return taken_; }
  std::size_t taken_count() const { return taken_count_; }

 private:
  /// The upper triangle of a symmetric matrix, so that the product of two such is the trace of their product where one
  /// of them is `doubled` beside the diagonal.
  using Triangle = Eigen::Matrix<double, 21, 1>;
  struct Stretch {  // of the time of a session
    std::vector<motion::PairIndex> pairs;
    std::size_t taken = 0;
    std::optional<motion::PairIndex> best;
    double worth = 0.0;  // of the best, when it was looked for
  };
  static Triangle triangle_of(const Matrix6d& symmetric, double doubled);
  double worth_of(motion::PairIndex pair, const Stretch& stretch) const;
  void find_best(Stretch& stretch) const;
  void count_in(motion::PairIndex pair, Stretch& stretch);
  void invert_known();

  std::vector<Triangle> adds_;  // of each pair: its information, in units of what counts as observed
  std::vector<motion::KeyframeIndex> keyframe_a_, keyframe_b_;
  std::vector<std::size_t> sector_, length_, way_turned_;  // of each pair: the classes of its heading, length and turn
  std::vector<Stretch> stretches_;
  std::vector<bool> taken_;
  std::vector<std::size_t> uses_, sector_taken_, length_taken_, way_turned_taken_;
  std::size_t taken_count_ = 0;
  Triangle known_;       // information of those that are taken, and of the prior
  Triangle covariance_;  // its inverse, doubled beside the diagonal
};

}  // namespace remount::calibration

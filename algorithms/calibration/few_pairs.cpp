#include "algorithms/calibration/few_pairs.h"

#include <algorithm>
#include <set>

namespace remount {

// Cornish and Fisher's expansion at z = 3. docs/maths/covariance.md (C32)
double student_of_three_sigma(double freedom) {
  const double share = 1.0 / freedom;
  return 3.0 + share * (7.5 + share * (17.25 + share * (30.1875 + share * 38.60156)));
}

double widening_of_few(int motions, double log_spread) {
  constexpr double kPlenty = 40.0;
  // Distances and turns have noise of their own; each shows in three residuals a motion, of which X takes six at most.
  constexpr double kResiduals = 3.0, kTaken = 6.0, kLeast = 3.0;
  const double believed = 0.5 / (log_spread * log_spread);
  const auto reach = [&](double count) {
    return student_of_three_sigma(std::max(kLeast, kResiduals * count - kTaken) + believed);
  };
  return std::max(1.0, reach(motions) / reach(kPlenty));
}

int independent_motions(const JointProblem& problem) {
  int pairs = 0;
  std::set<int> keyframes;
  for (const JointTerm& term : problem.terms) {
    if (!(term.weight > 0.0)) continue;
    ++pairs;
    keyframes.insert({term.node_a, term.node_b});
  }
  return std::min(pairs, static_cast<int>(keyframes.size()));
}

}  // namespace remount

#include "algorithms/calibration/pairwise/few_pairs.h"

#include <algorithm>
#include <map>

namespace remount::calibration {

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

// A pair between keyframes that others link already only repeats what those say: what is left is a tree over each group
// of linked keyframes.
int independent_motions(const JointProblem& problem) {
  // Of each keyframe one of its group; the last of a way stands for the group.
  std::map<motion::KeyframeIndex, motion::KeyframeIndex> towards;
  const auto group_of = [&](motion::KeyframeIndex keyframe) {
    for (auto at = towards.try_emplace(keyframe, keyframe).first; at->first != at->second; at = towards.find(keyframe))
      keyframe = at->second;
    return keyframe;
  };
  int motions = 0;
  for (const JointTerm& term : problem.terms) {
    if (!(term.weight > 0.0)) continue;
    const motion::KeyframeIndex a = group_of(term.node_a), b = group_of(term.node_b);
    if (a == b) continue;
    towards[a] = b;
    ++motions;
  }
  return motions;
}

}  // namespace remount::calibration

#include "algorithms/calibration/pairwise/bootstrap.h"

#include <algorithm>
#include <limits>
#include <map>

namespace remount::calibration {
namespace {

double block_length_s(const PairwiseInput& input, double least_s) {
  std::vector<double> first(input.sessions.size(), std::numeric_limits<double>::infinity()),
      last(input.sessions.size(), 0.0);
  for (const JointNode& node : input.nodes) {
    first[node.session] = std::min(first[node.session], node.time_s);
    last[node.session] = std::max(last[node.session], node.time_s);
  }
  double total_s = 0.0;
  for (std::size_t s = 0; s < first.size(); ++s) total_s += std::max(0.0, last[s] - first[s]);
  return std::max(least_s, std::min(total_s / kBootstrapBlocks, input.options.bootstrap_block_s));
}

}  // namespace

std::vector<BlockPull> blocks_of_time(const PairwiseInput& input, const std::vector<MeasurementPull>& pulls,
                                      double least_s) {
  constexpr std::size_t kMostOfSession = 1'000'000;
  const double block_s = block_length_s(input, least_s);
  std::vector<BlockPull> out;
  for (const MeasurementPull& pull : pulls) {
    const JointNode& node = input.nodes[pull.node];
    const double of_session = std::clamp(node.time_s / block_s, 0.0, kMostOfSession - 1.0);
    out.push_back({pull.step, node.session * kMostOfSession + static_cast<std::size_t>(of_session)});
  }
  return out;
}

Eigen::MatrixXd bootstrap_covariance(const std::vector<BlockPull>& pulls, Eigen::Index unknowns) {
  constexpr std::size_t kFewestBlocks = 4;
  std::map<std::size_t, Eigen::VectorXd> blocks;
  for (const BlockPull& pull : pulls)
    blocks.try_emplace(pull.block, Eigen::VectorXd::Zero(unknowns)).first->second += pull.step;
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(unknowns, unknowns);
  if (blocks.size() < kFewestBlocks) return covariance;
  const auto count = static_cast<double>(blocks.size());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(unknowns);
  for (const auto& [block, step] : blocks) mean += step / count;
  for (const auto& [block, step] : blocks) covariance += (step - mean) * (step - mean).transpose();
  // Resampling n blocks underestimates by (n - 1) / n.
  return covariance * count / (count - 1.0);
}

}  // namespace remount::calibration

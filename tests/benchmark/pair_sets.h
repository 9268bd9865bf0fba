// Pairs of scans for benchmarks, with the truth.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithms/registration/registration.h"

namespace remount::testing {

struct BenchmarkPair {
  std::size_t source = 0, target = 0;
  RigidTransform truth = RigidTransform::Identity(), start = RigidTransform::Identity();
};

struct DataSet {
  std::vector<cloud::PointCloud> clouds;
  std::vector<std::unique_ptr<registration::PreparedCloud>> prepared;
  std::vector<BenchmarkPair> pairs;
};

/// Neighbouring scans of a simulated street, half a second apart; the truth is exact.
DataSet make_street(std::size_t scans);
/// Every `every`-th pair of neighbouring scans of recorded drives; the truth is the own engine's best of several good
/// starts. Empty where there is no data.
DataSet make_kitti(const std::vector<std::string>& drives, std::size_t every);

double median(std::vector<double> values);

}  // namespace remount::testing

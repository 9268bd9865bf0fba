// Results of several methods, drives or days on one vehicle, side by side.
#pragma once

#include <string>
#include <vector>

#include "algorithms/calibration/agreement.h"
#include "model/results/result_file.h"

namespace remount::report {

struct NamedResult {
  std::string name;  ///< "trajectory", or the file's name
  results::ResultFile file;
};

struct ComparedResults {
  std::size_t a = 0, b = 0;                  ///< places in the list
  calibration::ResultDifference difference;  ///< a minus b
  bool contradict = false;                   ///< by more than both claim
  Message words;                             ///< what to make of it, one sentence
};

/// "yaw differs by 0.50 deg, 12.3 times the sigma of both together".
Message words_of_largest(const calibration::ResultDifference& difference,
                         const calibration::LargestDifference& largest);

/// Every two results once, in order. Those in different frames or INS axes are not compared, and say so; all NaN then.
std::vector<ComparedResults> compare_results(const std::vector<NamedResult>& results);

}  // namespace remount::report

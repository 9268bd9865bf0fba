#include "model/results/preliminary.h"

#include "messages/results.h"

namespace remount::results {

void mark_preliminary(calibration::CalibrationResult& result) {
  // Whoever looks at the status alone is to look again.
  result.conclude(calibration::Status::Degenerate, say::result_preliminary());
  result.advice.insert(result.advice.begin(), say::result_calibrate_again());
}

bool is_preliminary(const calibration::CalibrationResult& result) {
  return result.message == say::result_preliminary();
}

}  // namespace remount::results

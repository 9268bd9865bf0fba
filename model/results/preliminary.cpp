#include "model/results/preliminary.h"

#include "messages/results.h"

namespace remount {

void mark_preliminary(CalibrationResult& result) {
  // Whoever looks at the status alone is to look again.
  result.conclude(Status::Degenerate, say::result_preliminary());
  result.advice.insert(result.advice.begin(), say::result_calibrate_again());
}

bool is_preliminary(const CalibrationResult& result) { return result.message == say::result_preliminary(); }

}  // namespace remount

#include "model/preliminary.h"

#include "messages/pipeline.h"

namespace remount {

void mark_preliminary(CalibrationResult& result) {
  result.status = Status::Degenerate;  // whoever looks at the status alone is to look again
  result.message = say::pipeline_preliminary();
  result.advice.insert(result.advice.begin(), say::pipeline_calibrate_to_end());
}

bool is_preliminary(const CalibrationResult& result) {
  return result.message.code() == say::pipeline_preliminary().code();
}

}  // namespace remount

#include "model/preliminary.h"

#include "algorithms/messages/render.h"
#include "messages/results.h"

namespace remount {

void mark_preliminary(CalibrationResult& result) {
  result.status = Status::Degenerate;  // whoever looks at the status alone is to look again
  result.message = say::result_preliminary();
  result.advice.insert(result.advice.begin(), say::result_calibrate_again());
}

bool is_preliminary(const CalibrationResult& result) {
  const Message preliminary = say::result_preliminary();
  // Files hold the words.
  return result.message == preliminary || result.message == Message::verbatim(english(preliminary));
}

}  // namespace remount

#include "model/preliminary.h"

namespace remount {
namespace {

constexpr const char* kPreliminary =
    "Preliminary: the calibration was cancelled before its end, and its sigmas do not hold.";

}  // namespace

void mark_preliminary(CalibrationResult& result) {
  result.status = Status::Degenerate;  // whoever looks at the status alone is to look again
  result.message = kPreliminary;
  result.advice.insert(result.advice.begin(), "Calibrate again, to the end.");
}

bool is_preliminary(const CalibrationResult& result) { return result.message == kPreliminary; }

}  // namespace remount

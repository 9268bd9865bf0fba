// Whether the attitude means what it is taken for; the judgement itself is model/attitude_check.
#include "model/attitude_check.h"
#include "model/checks/builtin.h"

namespace remount {
namespace {

void look_at_attitude(const CheckedSession& checked, std::vector<Finding>& findings, const Progress&) {
  for (Finding& finding : attitude_findings(checked.session, checked.poses)) findings.push_back(std::move(finding));
}

}  // namespace

DataCheck attitude_data_check() {
  return {
      .kinds =
          {{"attitude-convention", "Every relative motion of the INS is wrong; no result stands on it.",
            "Declare the convention that the finding names (CSV: ins.columns.attitude.convention), or set it in the "
            "INS."},
           {"attitude-columns", "Relative motions of the INS turn about the wrong axes; no result stands on them.",
            "Correct the columns or the signs that the finding names; of the path's slope only pitch can be told, look "
            "at the sign of roll as well."},
           {"attitude-unit", "To the calibration the vehicle hardly turns; no result stands on that.",
            "Give the unit of the angles as the log has it, or have the driver convert them to radians once."},
           {"poses-inverted", "The inverse of a motion is another motion, about another place; no result stands on it.",
            "Export the poses as those of the body in the world, or invert each of them; check those of the other "
            "sensor as well."},
           {"position-columns", "The path is mirrored, and goes its own way; no result stands on it.",
            "Exchange the columns of latitude and longitude."},
           {"heading-against-travel", "Heading and direction of travel have nothing to do with each other.",
            "Look what the log has for a heading, and how it counts; set the mounting of the INS in the INS itself."},
           {"attitude-upside-down", "Roll of the INS is off by half a turn, and that of the result with it.",
            "Declare the convention of the attitude (ENU or NED) as the INS has it."}},
      .look = look_at_attitude};
}

}  // namespace remount

// Whether the attitude means what it is taken for; the judgement itself is model/conventions/attitude_check.
#include "messages/checks.h"
#include "model/checks/builtin.h"
#include "model/conventions/attitude_check.h"

namespace remount::checks {
namespace {

void look_at_attitude(const CheckedSession& checked, std::vector<drive::Finding>& findings, const Progress&) {
  for (drive::Finding& finding : conventions::attitude_findings(checked.session, checked.poses))
    findings.push_back(std::move(finding));
}

}  // namespace

DataCheck attitude_data_check() {
  return {.kinds = {{"attitude-convention", say::attitude_convention_meaning, say::attitude_convention_remedy},
                    {"attitude-columns", say::attitude_columns_meaning, say::attitude_columns_remedy},
                    {"attitude-unit", say::attitude_unit_meaning, say::attitude_unit_remedy},
                    {"poses-inverted", say::poses_inverted_meaning, say::poses_inverted_remedy},
                    {"position-columns", say::position_columns_meaning, say::position_columns_remedy},
                    {"heading-against-travel", say::heading_against_travel_meaning, say::heading_against_travel_remedy},
                    {"attitude-upside-down", say::attitude_upside_down_meaning, say::attitude_upside_down_remedy}},
          .look = look_at_attitude};
}

}  // namespace remount::checks

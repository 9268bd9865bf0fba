#include "model/method_registry/method_needs.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/drives.h"

namespace remount::method_registry {
namespace {

bool takes_all(const CalibrationMethod& method, const GivenSessions& sessions) {
  return std::all_of(sessions.begin(), sessions.end(),
                     [&](const auto& session) { return method.lack(*session, sessions).empty(); });
}

/// For another machine than a vehicle, where that is what the sessions may be of. Null: none takes them.
const CalibrationMethod* other_machine_that_takes(const GivenSessions& sessions) {
  for (const CalibrationMethod* method : calibration_methods())
    if (method->for_other_machine() && takes_all(*method, sessions)) return method;
  return nullptr;
}

}  // namespace

bool has_scans(const drive::Session& session) { return session.scans && session.scans->size() > 0; }

bool has_lidar(const drive::Session& session) { return has_scans(session) || !session.odometry_from_lidar.empty(); }

bool has_ins(const drive::Session& session) { return session.ins.size() > 1 || session.world_from_ins.size() > 1; }

std::vector<MethodFit> method_fits(const drive::Session& session) {
  std::vector<MethodFit> fits;
  for (const CalibrationMethod* method : calibration_methods()) {
    MethodFit fit{method, method->lack(session, {}), {}, {}};
    if (fit.serves() && method->limit) fit.limit = method->limit(session);
    if (method->for_other_machine()) fit.proviso = method->other_machine.proviso();
    fits.push_back(std::move(fit));
  }
  return fits;
}

Message methods_that_take(const GivenSessions& sessions) {
  Message methods;
  for (const CalibrationMethod* each : calibration_methods()) {
    if (each->for_other_machine() || !takes_all(*each, sessions)) continue;
    Message method = Message::verbatim(std::string(each->id));
    methods = methods.empty() ? std::move(method) : say::either_method(std::move(methods), std::move(method));
  }
  return methods;
}

void require_served(const CalibrationMethod& method, const GivenSessions& sessions) {
  for (const auto& session : sessions) {
    const Message lack = method.lack(*session, sessions);
    if (lack.empty()) continue;
    const Message others = methods_that_take(sessions);
    const CalibrationMethod* machine = other_machine_that_takes(sessions);
    // One half of a recording, given instead of the folder that has both, is what is seen most.
    throw Error(ErrorCode::Unsupported, drive::path_or_name(*session),
                !others.empty() ? say::served_by_others(lack, others)
                : machine       ? machine->other_machine.or_choose(lack)
                                : say::served_with_rest(lack));
  }
}

}  // namespace remount::method_registry

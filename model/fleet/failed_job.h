// Why a job of a fleet could not be run, kept beside its result, with what it was asked to do then.
#pragma once

#include "model/fleet/fleet.h"

namespace remount::fleet {

/// The English words for people; below a line "---" the message itself, and version, nominal, topics and settings for
/// why_failure_is_old. Where nothing can be written nothing more can be done about it: whoever caught the failure tells
/// it, too.
void note_failure(const Fleet& fleet, const FleetJob& job, const Message& reason);

/// The reason; of earlier versions' files, and of damaged ones, the words as they are. Empty where there is none.
/// Throws Error(Io).
Message failure_message(const FleetJob& job);

/// What has changed since the job failed, so that it may not fail any more: the program, what the fleet asks for, or
/// something where its sessions lie. Empty where nothing has. Throws Error(Io).
Message why_failure_is_old(const Fleet& fleet, const FleetJob& job);

}  // namespace remount::fleet

// What session.yaml declares beside the streams.
#pragma once

#include "model/drive/session.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

/// Takes `ins_noise` and `nominal`. Throws Error(Format) with the line of what is wrong.
void read_declared(const DocumentView& root, drive::Session& session);

/// Throws where times of points are declared and the points of the first scans tell none: they would be used as if they
/// had been measured at once. @param session as far as it is read
/// @return with `misfit` where the times are of no sweep, which is no reason to refuse the session
FoundPointTimes require_point_times(const DocumentView& timing, const TimedScanSource& scans,
                                    const drive::Session& session);

}  // namespace remount::formats

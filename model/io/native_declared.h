// What session.yaml declares beside the streams.
#pragma once

#include "model/io/document.h"
#include "model/session.h"

namespace remount {

/// Takes `ins_noise` and `nominal`. Throws Error(Format) with the line of what is wrong.
void read_declared(const DocumentView& root, Session& session);

}  // namespace remount

// An INS of a native session whose attitudes stand in a table of their own.
#pragma once

#include <filesystem>

#include "model/drive/session.h"
#include "model/formats/documents/document.h"
#include "model/formats/sessions/session_source.h"

namespace remount::formats {

/// @param node the map `ins`, with columns of positions, and a map `attitude` with file, table and columns of its own
/// Throws Error(Format).
void read_two_tables(const DocumentView& node, const std::filesystem::path& folder, SessionSource& source,
                     drive::Session& session);

}  // namespace remount::formats

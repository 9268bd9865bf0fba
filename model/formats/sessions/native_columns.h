// The columns of an INS table as session.yaml declares them.
#pragma once

#include "model/formats/documents/document.h"
#include "model/formats/ins/ins_table.h"

namespace remount::formats {

/// @param columns the map `ins.columns`. Throws Error(Format) with the line of what is wrong.
InsTableLayout read_layout(const DocumentView& columns);

}  // namespace remount::formats

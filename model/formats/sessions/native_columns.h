// The columns of an INS table as session.yaml declares them.
#pragma once

#include "model/formats/documents/document.h"
#include "model/formats/ins/ins_table.h"

namespace remount::formats {

/// `table` beside a `file`: how its rows are parted. As a CSV has them where there is none. Throws Error(Format) with
/// the line of what is wrong, as the others do.
TableText read_table_text(const DocumentView& beside);

/// A column by its number from 0, or by its name.
ColumnRef read_column(const DocumentView& node);

TimeColumns read_time_columns(const DocumentView& node);

/// @param columns the map `ins.columns`
InsTableLayout read_layout(const DocumentView& columns);

/// Where positions and attitudes stand in tables of their own. @param columns the maps `ins.columns` and
/// `ins.attitude.columns`
InsTableLayout read_position_layout(const DocumentView& columns);
InsTableLayout read_attitude_layout(const DocumentView& columns);

/// @param columns the map `ins_poses.columns`: positions in a metric world
InsTableLayout read_pose_layout(const DocumentView& columns);

/// `offset_s`, in nanoseconds; 0 where there is none.
std::int64_t read_offset_ns(const DocumentView& node);

}  // namespace remount::formats

// Trajectories that post-processing programs export as text: Inertial Explorer, Qinertia, OxTS' NAVsolve.
#pragma once

#include "model/formats/ins/ins_log.h"

namespace remount::formats {

/// A table whose head names latitude and longitude, and an angle of attitude or one of these programs, and that has a
/// row with numbers in these two. Never throws.
bool recognise_trajectory_text(const std::filesystem::path& path);

/// Whether the head of such a table names a program that works after the drive, and the columns are all there, in units
/// that are known: of others nobody says that they were not written on the drive. Never throws.
bool is_post_processed_text(const std::filesystem::path& path);

/// Columns by the names of the head in any order, with the units that stand there; degrees and metres where none do.
/// Latitude and longitude as decimals or as degrees, minutes and seconds. Heading from true north clockwise, pitch
/// positive nose up, roll positive right side down: of Inertial Explorer for axes right-forward-up, of others for
/// forward-right-down, which are forward-left-up here. Times by GPS week, by date, or since 1970 or 1980; with the
/// seconds of a week alone the week is open (InsLog::week_open). Errors where the table has columns of them. Lines that
/// cannot be used are counted. Throws Error as InsLogKind::read says, and where a column is missing or has a unit that
/// is not known, naming it.
InsLog read_trajectory_text(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats

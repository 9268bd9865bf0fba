// Sentences about the state of the work that several parts of the window say alike.
#pragma once

#include "app/gui/workbench/workbench.h"
#include "widgets/result/result_panel.h"

namespace remount::gui {

/// The first few of a list that may be long, and how many more there are.
QString in_short(const QStringList& entries, const QString& separator);

/// Of sessions that are open, or of those that a calibration was made from.
QStringList names_of(const std::vector<std::shared_ptr<const drive::Session>>& sessions);
/// "scan12.pcd", or which of the LiDAR poses it is.
QString scan_name(const std::vector<std::shared_ptr<const drive::Session>>& sessions, const motion::Keyframe& keyframe);

/// What the status strip says while nothing runs there.
/// What the view of a pair says where none is selected.
QString no_pair_text(const Workbench& workbench);
QString idle_text(const Workbench& workbench);

/// What is next, or under way, as long as there is no result; short for the result, longer for the middle of the
/// window.
QString next_text(const Workbench& workbench);
QString next_hint(const Workbench& workbench);

/// How the result that is shown stands to what is set now, and why.
widgets::ResultStanding standing_of(const Workbench& workbench);
QString standing_note(const Workbench& workbench);

/// What distances under the result and the mounting before it rest on that nobody measured; empty for nothing.
QString distance_caution(const Workbench& workbench);

/// Who has a project open.
QString holder_text(const project::LockHolder& holder);

/// What is to be known of the result before it is written for other software; empty for nothing.
QString export_warning(const Workbench& workbench);

}  // namespace remount::gui

// Files the window reads and writes around a result: nominal mountings in, exports out.
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/geometry/rigid_transform.h"
#include "app/gui/workbench/workbench.h"
#include "widgets/result/export_dialog.h"

namespace remount::gui {

std::vector<widgets::ExportFormat> export_formats();

/// Text of the present result in a format; throws Error where the format cannot hold it.
QString export_text(const Workbench& workbench, const QString& format_id);

/// Whole or not at all; throws Error.
void save_text(const QString& path, const QString& text);

/// The mounting of a result or of any format that can be exported, in the INS axes of the sessions; throws Error. What
/// the file leaves open, and that it was turned, is added to `doubts`.
RigidTransform nominal_from_file(const QString& path, const Workbench& workbench, QStringList& doubts);

/// Those of a file that holds mountings of LiDARs of the vehicle by their names; empty where it holds a single mounting
/// whose name is that of none. Which are left over, and which LiDARs have none, is added to `doubts`. Throws as
/// nominal_from_file.
std::map<std::string, RigidTransform> nominals_from_file(const QString& path, const Workbench& workbench,
                                                         QStringList& doubts);

}  // namespace remount::gui

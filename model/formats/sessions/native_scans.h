// The scans that session.yaml declares: which files, when each was taken, and how they were swept.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/drive/session.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/clouds/cloud_file.h"
#include "model/formats/documents/document.h"
#include "model/formats/sessions/session_source.h"

namespace remount::formats {

struct ListedScans {
  std::filesystem::path directory;
  CloudFormat format = CloudFormat::Pcd;
  std::optional<std::filesystem::path> table;  ///< of the stamps, where they stand in one
  std::vector<drive::ScanFile> scans;
};

/// @param node the map `scans`. Throws Error(Format) with the line of what is wrong.
ListedScans listed_scans(const DocumentView& node, const std::filesystem::path& folder, SessionSource& source,
                         std::vector<drive::Finding>& findings, Progress& progress);

/// Whether the scans have to be read to know when they were taken.
bool stamps_are_in_points(const DocumentView& node);

/// Makes them the scans of the session, with their timing; likewise.
void read_scans(const DocumentView& node, const std::filesystem::path& folder, SessionSource& source,
                drive::Session& session, Progress& progress);

}  // namespace remount::formats

// Findings as they stand in results and projects.
#pragma once

#include <vector>

#include "model/drive/session.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

DocumentNode findings_document(const std::vector<drive::Finding>& findings);

/// Throws Error(Format). Severities are names; projects of earlier versions hold their numbers, and results
/// of the first one sentences alone.
std::vector<drive::Finding> findings_from_document(const DocumentView& list);

}  // namespace remount::formats

// What a method tells beside X, as part of results and projects.
#pragma once

#include <vector>

#include "algorithms/calibration/method_details.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

/// Each with its id under `name` and its name for people under `words`.
DocumentNode quantities_document(const std::vector<calibration::NamedQuantity>& quantities);
/// Throws Error(Format) where the schema is not kept, or a sigma is negative. Files of former versions have no `words`:
/// they follow from the id.
std::vector<calibration::NamedQuantity> quantities_from_document(const DocumentView& view);

DocumentNode plots_document(const std::vector<calibration::Plot>& plots);
/// Throws Error(Format) where the schema is not kept, or the columns of a curve differ in length. Titles, axes and
/// names of curves are messages; files of former versions have their English words, which are recognised.
std::vector<calibration::Plot> plots_from_document(const DocumentView& view);

}  // namespace remount::formats

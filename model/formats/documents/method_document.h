// What a method tells beside X, as part of results and projects.
#pragma once

#include <vector>

#include "algorithms/calibration/method_details.h"
#include "model/formats/documents/document.h"

namespace remount {

DocumentNode quantities_document(const std::vector<NamedQuantity>& quantities);
/// Throws Error(Format) where the schema is not kept, or a sigma is negative.
std::vector<NamedQuantity> quantities_from_document(const DocumentView& view);

DocumentNode plots_document(const std::vector<Plot>& plots);
/// Throws Error(Format) where the schema is not kept, or the columns of a curve differ in length.
std::vector<Plot> plots_from_document(const DocumentView& view);

}  // namespace remount

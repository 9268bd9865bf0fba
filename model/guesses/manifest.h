// The manifest of data that had none.
#pragma once

#include <filesystem>

#include "algorithms/messages/catalogue.h"
#include "model/formats/documents/document.h"
#include "model/guesses/description.h"

namespace remount::guesses {

/// As session.yaml has it, with a comment for each guess. Where a description is not complete, what there is.
/// @param folder of the manifest: paths are relative to it
formats::DocumentNode manifest_of(const Description& description, const std::filesystem::path& folder,
                                  Language language);

}  // namespace remount::guesses

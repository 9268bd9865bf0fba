// How the version of the program stands in files.
#pragma once

#include <string>

#include "model/formats/documents/notations.h"
#include "remount_version.h"

namespace remount::results {

/// A file that is written anew keeps the version that it was made by.
inline constexpr formats::Through kVersionName{
    [](const std::string& version) { return formats::DocumentNode::string(version.empty() ? kVersion : version); },
    [](const formats::DocumentView& view) { return view.string(); }};

}  // namespace remount::results

// Keyframes and pairs, in full, as they stand in a project.
#pragma once

#include <vector>

#include "algorithms/motion/pair.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

DocumentNode keyframe_document(const motion::Keyframe& keyframe);
DocumentNode pair_document(const motion::Pair& pair);

/// Throw Error(Format). `session_count` and `keyframe_count` bound the indices.
motion::Keyframe keyframe_from_document(const DocumentView& view, std::size_t session_count);
motion::Pair pair_from_document(const DocumentView& view, std::size_t keyframe_count);

}  // namespace remount::formats

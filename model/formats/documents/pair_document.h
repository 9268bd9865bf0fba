// Keyframes and pairs, in full, as they stand in a project.
#pragma once

#include <vector>

#include "algorithms/motion/pair.h"
#include "model/formats/documents/document.h"

namespace remount {

DocumentNode keyframe_document(const Keyframe& keyframe);
DocumentNode pair_document(const Pair& pair);

/// Throw Error(Format). `session_count` and `keyframe_count` bound the indices.
Keyframe keyframe_from_document(const DocumentView& view, std::size_t session_count);
Pair pair_from_document(const DocumentView& view, std::size_t keyframe_count);

}  // namespace remount

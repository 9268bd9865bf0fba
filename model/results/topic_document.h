// Topics that were chosen, as they stand in files.
#pragma once

#include "model/drive/topic_choice.h"
#include "model/formats/documents/document.h"

namespace remount::results {

/// A map from roles to topics, on one line.
formats::DocumentNode topic_choice_document(const drive::TopicChoice& choice);

/// A map from roles to topics. `changed` is what it begins with; null for a role leaves that one to be suggested.
/// Throws Error(Format) with file and line for a role that is none, and for a topic without a name.
drive::TopicChoice topic_choice_from_document(const formats::DocumentView& view, drive::TopicChoice changed = {});

}  // namespace remount::results

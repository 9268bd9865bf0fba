// Messages as they stand in results and projects: code, arguments and words.
#pragma once

#include "algorithms/messages/message.h"
#include "model/formats/documents/document.h"

namespace remount::formats {

/// A map of `code`, `arguments` and `text`, which is English; of words without a code `text` alone; an empty string
/// where nothing is said. Each argument is a map of one key that names its kind and unit: "distance: {length_m: 0.5}".
DocumentNode message_document(const Message& message);

/// What message_document() wrote, or a plain text, as files of earlier versions hold. Throws Error(Format). A code or
/// an argument that this version does not know is kept.
Message message_from_document(const DocumentView& view);

DocumentNode messages_document(const std::vector<Message>& messages);
std::vector<Message> messages_from_document(const DocumentView& list);

}  // namespace remount::formats

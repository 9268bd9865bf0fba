// Files that are no session, but known: what they are, and how to get to one.
#pragma once

#include <filesystem>
#include <optional>

#include "algorithms/messages/message.h"

namespace remount::formats {

struct KnownFile {
  Message (*what)();    ///< "a capture of network packets (pcap)"
  Message (*remedy)();  ///< a sentence
};

/// By its first bytes, and where these say nothing, by its name. Nothing where neither is known. Never throws.
std::optional<KnownFile> known_file(const std::filesystem::path& path);

}  // namespace remount::formats

// Files that are no session, but known: what they are, and how to get to one.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace remount {

struct KnownFile {
  std::string_view what;    ///< "a capture of network packets (pcap)"
  std::string_view remedy;  ///< a sentence
};

/// By its first bytes, and where these say nothing, by its name. Nothing where neither is known. Never throws.
std::optional<KnownFile> known_file(const std::filesystem::path& path);

}  // namespace remount

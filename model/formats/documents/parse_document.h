// YAML and JSON from files that were written by others: bounded in size, depth and number of values.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "model/formats/documents/document.h"

namespace remount::formats {

struct DocumentLimits {
  std::size_t max_bytes = 1 << 20;
  std::size_t max_nodes = 200000;
  int max_depth = 32;
};

/// One YAML document. Refuses anchors, aliases and tags (with them a small file can grow without bound), duplicate
/// keys (of which one would be ignored silently), keys that are no scalars, and a second document.
/// Throws Error(Format) with "where:line".
DocumentNode parse_yaml(std::string_view text, const std::string& where, const DocumentLimits& limits = {});

/// One JSON value, with the same limits and refusals.
DocumentNode parse_json(std::string_view text, const std::string& where, const DocumentLimits& limits = {});

/// A regular file as JSON where its name ends in ".json", or in neither ".yaml" nor ".yml" while its text starts with
/// "{"; as YAML otherwise.
/// Throws Error(Io) as read_regular_file does, Error(Format) as above.
DocumentNode read_document(const std::filesystem::path& path, const DocumentLimits& limits = {});

}  // namespace remount::formats

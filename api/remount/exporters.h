// Results as files of other programs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "remount/result.h"
#include "remount/text.h"

namespace remount::api {

struct ExportFormat {
  std::string id;  ///< "autoware"
  Text description;
  Text direction;         ///< which way its numbers go
  std::string file_name;  ///< under which its users look for it
};
std::vector<ExportFormat> export_formats();

/// For formats that carry names of frames; empty: the format's usual ones.
struct FrameNames {
  std::string ins, lidar;
};

/// The whole file. Throws Error(Contract) for a format that is none, a result that is not usable, and where the format
/// would be wrong for the result.
std::string export_text(const Result& result, std::string_view format, const FrameNames& frames = {});

/// What whoever uses an export must know: the status, and each parameter that is not observed. For exporters of your
/// own as well; empty for a result that is observed in full.
std::vector<Text> export_warnings(const Result& result);

/// Replaces the file by the text, atomically. Throws Error(Io).
void save_text(const std::filesystem::path& path, std::string_view text);

}  // namespace remount::api

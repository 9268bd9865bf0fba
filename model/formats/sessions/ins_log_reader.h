// The whole solution of an INS (ins_log.h), alone or in a folder with LiDAR poses.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Clocks are trusted where they meet, and aligned by the rates of rotation where they do not. Of several logs none is
/// taken: Error(Unsupported) names two.
class InsLogReader final : public SessionReader {
 public:
  std::string_view id() const override { return "ins-log"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats

// Remount's own session folder, declared by session.yaml: see resources/formats/native-session.md.
#pragma once

#include "model/io/session_reader.h"

namespace remount {

class NativeSessionReader final : public SessionReader {
 public:
  std::string_view id() const override { return "native"; }
  std::string_view description() const override {
    return "Remount session: a folder with session.yaml (or that file) that declares scans or LiDAR poses and an INS "
           "table";
  }
  int probe(const std::filesystem::path& path) const override;
  Session open(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount

// Drives whose INS is a NovAtel SPAN with INSPVAX.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a folder with an INSPVAX log (ASCII or CSV from a bag) and a file of LiDAR poses, or a log alone to inspect
/// it. The INS frame is SPAN's own body frame, x right, y forward, z up, so that X refers to what the INS itself puts
/// out. The LiDAR's stamps are of the host's clock, which is not trusted: they are moved to GPS time by the rates of
/// rotation. Of several INSPVAX files the one whose host times are intact is used, then the one with more samples.
class NovatelReader final : public SessionReader {
 public:
  std::string_view id() const override { return "novatel-inspvax"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

}  // namespace remount::formats

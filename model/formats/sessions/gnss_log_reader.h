// An NMEA log, a solution of RTKLIB or a GPX track, alone or in a folder with LiDAR poses.
#pragma once

#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

class GnssLogReader final : public SessionReader {
 public:
  std::string_view id() const override { return "gnss-log"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

/// Fixes of a file by its content: NMEA, RTKLIB, GPX, NovAtel, SBF, or the table of a native session.
std::vector<motion::GnssFix> read_gnss(const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats

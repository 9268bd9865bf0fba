// Drives whose INS is a NovAtel SPAN.
#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "model/formats/ins/novatel_log.h"
#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// Opens a folder with NovAtel's logs (ASCII, binary, or a CSV from a bag) and a file of LiDAR poses, or a log alone to
/// inspect it. The INS frame is SPAN's own body frame, x right, y forward, z up, so that X refers to what the INS
/// itself puts out. The LiDAR's stamps are of the host's clock, which is not trusted: they are moved to GPS time by the
/// rates of rotation. Of several logs the one whose host times are intact gives the samples, then the one with more;
/// others give it the errors that it does not state. Where one solution lies beside them that was post-processed, it is
/// taken instead, in its own axes.
class NovatelReader final : public SessionReader {
 public:
  std::string_view id() const override { return "novatel"; }
  Message description() const override;
  int probe(const std::filesystem::path& path) const override;
  drive::Session open(const std::filesystem::path& path, Progress& progress) const override;
};

using NovatelLogs = std::vector<std::pair<std::filesystem::path, NovatelFormat>>;

/// Takes those out that hold raw measurements of an IMU alone, where there is a motion beside them.
/// @param beside a motion of another make lies there
std::vector<std::filesystem::path> part_raw_imu(NovatelLogs& logs, bool beside);

/// Reads every log and makes the samples of the best the session's, with the errors of all; the others are named in a
/// finding. Its raw measurements are the session's `imu`; where it has none, those of another log or of `imu` are,
/// which is told. Throws what is wrong with the first where none is usable.
/// @return the best
std::filesystem::path read_best_novatel(const NovatelLogs& files, const std::vector<std::filesystem::path>& imu,
                                        drive::Session& session);

}  // namespace remount::formats

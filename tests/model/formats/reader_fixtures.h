// What the tests of session readers share.
#pragma once

#include <cstdio>
#include <string>

#include "model/formats/ins/novatel_frames.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/session_readers.h"
#include "tests/model/formats/temporary_folder.h"
#include "tests/support/findings.h"

namespace remount::formats {

/// The first finding with this code, or null.
inline const drive::Finding* find(const drive::Session& session, const std::string& code) {
  return testing::finding_of(session.findings, code);
}

inline drive::Session open(const std::filesystem::path& path) {
  Progress progress;
  return open_session(path, progress);
}

/// What a reader makes of a file of its kind.
template <class Read>
auto recognised_and_read(const std::string& name, const std::string& bytes,
                         bool (*recognise)(const std::filesystem::path& path), Read read,
                         std::vector<drive::Finding>& findings) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.write(name, bytes);
  EXPECT_TRUE(recognise(path)) << name;
  return read(path, findings);
}

/// A line of an ASCII log with its checksum.
inline std::string inspvaxa(int week, double seconds, double azimuth_deg,
                            const std::string& status = "INS_SOLUTION_GOOD") {
  char body[512];
  std::snprintf(body, sizeof body,
                "INSPVAXA,COM1,0,73.5,FINESTEERING,%d,%.3f,00000040,4e77,43562;%s,INS_PSRSP,51.11637873403,-114."
                "03825114994,1063.6093,-16.9000,0.1,0.2,"
                "0.3,1.5,-2.5,%.6f,0.8,0.9,1.2,0.01,0.02,0.03,0.5,0.6,0.7,37343000,0",
                week, seconds, status.c_str(), azimuth_deg);
  char crc[16];
  std::snprintf(crc, sizeof crc, "%08x", novatel_crc32(body));
  return std::string("#") + body + "*" + crc + "\r\n";
}

}  // namespace remount::formats

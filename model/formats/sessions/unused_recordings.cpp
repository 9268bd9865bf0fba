#include "model/formats/sessions/unused_recordings.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

#include "algorithms/core/error.h"
#include "messages/sessions.h"
#include "model/drive/bad_items.h"
#include "model/formats/files/input_file.h"
#include "model/formats/packets/capture_index.h"
#include "model/formats/packets/capture_records.h"
#include "model/formats/packets/capture_scans.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

bool is_called_recording(const fs::path& file) {
  constexpr std::array<std::string_view, 8> kEndings{".pcap", ".pcapng", ".lvx", ".lvx2",
                                                     ".bag",  ".mcap",   ".db3", ".record"};
  return std::ranges::find(kEndings, lower_case(file.extension().string())) != kEndings.end();
}

/// Of a capture that holds no LiDAR or cannot be read.
Message why_no_scans(const fs::path& capture) {
  try {
    return why_no_lidar(index_begin(capture), capture.string()).what_happened();
  } catch (const Error& error) {
    return error.what_happened();
  }
}

/// Nothing where it is no recording. Bags that begin as such are read, or refused with their reason.
std::optional<Message> why_unused(const fs::path& file) {
  if (is_capture(file)) return why_no_scans(file);
  if (is_called_recording(file)) return say::recording_begins_otherwise();
  return std::nullopt;
}

}  // namespace

void tell_unused_recordings(drive::Session& session) {
  if (session.scans || !session.odometry_from_lidar.empty() || !is_folder(session.path)) return;
  for (const fs::path& file : files_in(session.path)) {
    if (std::ranges::find(session.files, file) != session.files.end()) continue;
    if (const std::optional<Message> why = why_unused(file))
      session.findings.push_back(drive::make_finding(drive::Severity::Problem, "recording-unused", file.string(),
                                                     say::recording_unused(*why)));
  }
}

}  // namespace remount::formats

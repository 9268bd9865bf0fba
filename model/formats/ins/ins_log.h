// Logs that hold the whole solution of an INS, by their makers: one list for all who read such a log.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

/// What such a log gives.
struct InsLog {
  std::vector<motion::InsSample> ins;  ///< ascending stamps, at least one
  drive::InsAxes axes = drive::InsAxes::ForwardLeftUp;
  bool stamps_from_gps = false;                ///< see Session::ins_stamps_from_gps
  bool week_open = false;                      ///< see Session::ins_week_open
  std::vector<std::filesystem::path> files{};  ///< that were read, the log first
};

struct InsLogKind {
  std::string_view id;
  /// By its content. Never throws.
  bool (*recognise)(const std::filesystem::path& path);
  /// Whether such a log says that it was written after the drive, with what came later in it, and holds all that is
  /// needed. Never throws; null where logs of this kind are written on the drive.
  bool (*post_processed)(const std::filesystem::path& path);
  /// Throws Error(Io), Error(Format) where the log holds no usable sample; what is broken in it becomes findings.
  InsLog (*read)(const std::filesystem::path& path, std::vector<drive::Finding>& findings);
};

/// Applanix SBET, OxTS NCOM, Septentrio SBF, and tables of post-processing programs.
const std::vector<InsLogKind>& ins_log_kinds();

/// Of a file; null where it is none of these.
const InsLogKind* ins_log_kind(const std::filesystem::path& path);

/// Makes the log the INS of a session.
void take_ins_log(const InsLogKind& kind, const std::filesystem::path& path, drive::Session& session);

}  // namespace remount::formats

// What every session format offers, and the list of those that are built in.
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/checks/data_check.h"
#include "model/session.h"

namespace remount {

class SessionReader {
 public:
  virtual ~SessionReader() = default;
  virtual std::string_view id() const = 0;  ///< "kitti-raw"
  virtual Message description() const = 0;  ///< one line for help and file dialogs
  /// How sure, from the content and not only from names: 0 (no) to 100 (certain). Reads little. Throws Error(Io) where
  /// it cannot be seen what lies there; what cannot be read is not recognised.
  virtual int probe(const std::filesystem::path& path) const = 0;
  /// Throws Error (file, place, expectation) where nothing usable is there; a bad scan or line inside a usable
  /// session becomes a Finding.
  virtual Session open(const std::filesystem::path& path, Progress& progress) const = 0;
  /// As open, with topics that were chosen. Throws Error(Contract) where some were and the format has none.
  virtual Session open_topics(const std::filesystem::path& path, const TopicChoice& topics, Progress& progress) const;
};

/// The built-in readers. Adding one: a file in this folder and a line in session_readers.cpp.
const std::vector<std::unique_ptr<SessionReader>>& session_readers();

/// Opens with the reader that is surest, and looks at what it read (model/checks): what is suspicious is among the
/// session's findings. Throws Error that names what each reader looks for where none recognises it.
Session open_session(const std::filesystem::path& path, Progress& progress, LookAt look_at = LookAt::StreamsAndScans);
/// As above with topics of a bag that were chosen; none: all are suggested.
Session open_session(const std::filesystem::path& path, const TopicChoice& topics, Progress& progress,
                     LookAt look_at = LookAt::StreamsAndScans);

}  // namespace remount

// What is no session itself but holds some.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/core/error.h"
#include "model/formats/files/printable_text.h"

namespace remount::formats {

/// Thrown in place of a session: a program with somebody to ask offers to open those that it names.
class SeveralSessions : public Error {
 public:
  SeveralSessions(const std::filesystem::path& folder, Message what_happened,
                  std::vector<std::filesystem::path> sessions)
      : Error(ErrorCode::Unsupported, folder.string(), std::move(what_happened)), sessions_(std::move(sessions)) {}

  /// What open_session takes, each.
  const std::vector<std::filesystem::path>& sessions() const { return sessions_; }

 private:
  std::vector<std::filesystem::path> sessions_;
};

/// The first of the paths, a line each, for a message.
inline std::vector<std::string> lines_of(const std::vector<std::filesystem::path>& paths) {
  constexpr std::size_t kShown = 20;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < paths.size() && i < kShown; ++i)
    lines.push_back("  " + printable(paths[i].string(), LineBreaks::Escaped));
  if (paths.size() > kShown) lines.push_back("  …");
  return lines;
}

}  // namespace remount::formats

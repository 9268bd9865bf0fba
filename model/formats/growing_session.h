// A session that is written while it is read.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>

#include "messages/sessions.h"
#include "model/drive/session.h"
#include "model/formats/sessions/session_source.h"

namespace remount::formats {

class AppendedScans;

/// Holds what has been written of a session so far: of its streams those that trajectory alignment takes. Of a native
/// session each look costs in proportion to what has been added; a session that cannot be read in parts (another
/// format, a log of NMEA sentences, clocks that have to be aligned) is opened anew, for at most a fifth of the time.
class GrowingSession {
 public:
  GrowingSession(std::filesystem::path path, drive::TopicChoice topics)
      : path_(std::move(path)), topics_(std::move(topics)) {}

  /// The session as far as it is written, valid until the next look; null where it cannot be read now, see problem().
  /// What comes in the wrong order is left out, as it would be of the whole.
  const drive::Session* look();
  const Message& problem() const { return problem_; }

  std::uint64_t bytes_read() const { return bytes_before_ + source_.bytes_read(); }
  std::size_t files_examined() const { return source_.files_examined(); }

 private:
  using Clock = std::chrono::steady_clock;
  void look_at_parts();
  void look_at_whole();
  void begin_anew();

  std::filesystem::path path_;
  drive::TopicChoice topics_;
  Message problem_ = say::session_not_opened();
  std::string manifest_;
  GrowingSource source_;
  std::uint64_t bytes_before_ = 0;
  drive::Session session_;
  std::shared_ptr<AppendedScans> scans_;
  bool opened_ = false, as_whole_ = false;
  Clock::time_point next_whole_ = Clock::time_point::min();
};

}  // namespace remount::formats

// Records of Apollo's Cyber (`.record`): what its recorder writes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/formats/bags/bag_file.h"
#include "model/formats/files/random_access_file.h"

namespace remount::bags {

/// How sure that a file or folder is one record, from the content; in a folder those that are called ".record" are
/// looked at. 0 (no) to 100. Never throws.
int probe_record(const std::filesystem::path& path);

/// Opens a record, or a folder with one: alone, or in the parts that its recorder began anew after some time
/// (`NAME.record.00000`, `NAME.record.00001`), in their order. Of a folder with several it throws SeveralSessions.
/// Parts that are missing in between become a finding "record-part-missing", those that cannot be read
/// "record-part-unreadable".
std::shared_ptr<const BagFile> open_record(const std::filesystem::path& path, Progress& progress);

/// Goes from section to section, and in chunks from message to message: lengths lead from one to the next, and nothing
/// else is read of the messages. (The index is not used: a recorder that was killed writes none, and its positions are
/// those behind what they are of.) A record that was not closed, or was cut, gives what is whole, with a finding
/// "record-cut".
class RecordFile final : public BagFile {
 public:
  /// Throws Error where the file is no record or holds no readable message at all; Error(Unsupported) where its chunks
  /// are compressed, which Apollo's own recorder never does.
  RecordFile(const std::filesystem::path& path, Progress& progress);
  std::string message(const BagEntry& entry, std::size_t at_most) const override;
  std::string message_end(const BagEntry& entry, std::size_t at_most) const override;

 private:
  /// A range of the file.
  struct Span {
    std::uint64_t begin = 0, end = 0;
  };
  /// What stands in front of a message's content.
  struct Head {
    std::string channel;
    std::int64_t time_ns = 0;
    Span content;
  };
  class Window;

  void read_header();
  void read_sections(Progress& progress);
  void read_channel(const Span& section);
  void index_chunk(const Span& body, Progress& progress);
  static Head read_head(Window& window, std::uint64_t offset, std::uint64_t end);
  Span content_of(const BagEntry& entry) const;
  std::size_t topic_of(const std::string& channel);
  void report();

  formats::RandomAccessFile file_;
  std::map<std::string, std::string, std::less<>> types_;  ///< of channels
  std::map<std::string, std::size_t, std::less<>> topic_of_channel_;
  std::vector<Span> chunks_;    ///< their bodies
  std::uint64_t promised_ = 0;  ///< messages
  bool closed_ = false;
  std::uint64_t cut_at_ = 0;    ///< where what is readable ends
  std::size_t damaged_ = 0;     ///< messages
  std::size_t rests_lost_ = 0;  ///< of those, behind which the rest of the chunk is lost as well
  Message first_damage_;
};

}  // namespace remount::bags

// The frames of a capture of network packets, one after the other: pcap and pcapng in either byte order.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/formats/files/random_access_file.h"

namespace remount::formats {

/// By the first bytes: pcap, pcapng, or a recording of Livox Viewer (lvx_file.h). Never throws.
bool is_capture(const std::filesystem::path& path);

struct CapturedFrame {
  std::uint64_t offset = 0;     ///< of its bytes in the file
  std::uint32_t link_type = 0;  ///< kind of network, as captures number them
  std::int64_t time_ns = 0;     ///< Unix time of the host; of frames without one, that of the frame before
  std::string_view bytes;       ///< as far as it was captured; until the next is read
  bool other = false;           ///< a record of something else, without bytes
};

/// Walks a file from its beginning, in blocks of a bounded size.
class CaptureRecords {
 public:
  virtual ~CaptureRecords() = default;
  /// False at the end, and where nothing behind can be read: see unread_bytes().
  virtual bool next(CapturedFrame& frame) = 0;
  /// Bytes at the end of the file that are no whole record.
  virtual std::uint64_t unread_bytes() const = 0;
  /// The file ends within a record; otherwise what is unread is damaged.
  virtual bool cut() const = 0;
  virtual std::uint64_t position() const = 0;
};

/// Throws Error(Format) where the file is no capture, and Error(Unsupported) for a version that is not known.
/// @param file outlives what is returned
std::unique_ptr<CaptureRecords> read_records(const RandomAccessFile& file);

}  // namespace remount::formats

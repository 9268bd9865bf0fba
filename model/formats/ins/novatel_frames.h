// NovAtel's logs as they lie in a recording: ASCII and binary, with long and short headers, among anything else.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "algorithms/messages/message.h"

namespace remount::formats {

/// Logs that are known by their number (OEM7 Commands and Logs Reference Manual).
enum class NovatelUse {
  None,      ///< named and counted
  Inspvax,   ///< position, attitude and errors of the INS
  Inspva,    ///< without errors, and with its time in the body
  Insstdev,  ///< errors alone
  Bestpos,   ///< a position with its errors: of the receiver, or of the INS where there is one
  RawImu,    ///< counts whose scale goes by the type of the IMU
};
struct NovatelLogType {
  std::uint16_t id = 0;
  std::string_view name;
  NovatelUse use = NovatelUse::None;
};
/// Null where this program has no name for it.
const NovatelLogType* novatel_log_type(std::uint16_t id);

/// One log.
struct NovatelFrame {
  bool binary = false;
  std::uint16_t id = 0;   ///< of a binary log
  unsigned source = 0;    ///< of the measurement: 1 is the second antenna
  std::string_view name;  ///< of an ASCII log, without the 'A' at its end; of the second antenna as "BESTPOSA_1"
  const NovatelLogType* type = nullptr;  ///< null where it is not known, or not of the first antenna
  std::string_view header;               ///< ASCII: the text before ';'; binary: the bytes from the first on
  bool short_header = false;
  std::string_view body;
  std::size_t at = 0, bytes = 0;  ///< place in the recording
  Message problem;                ///< why it cannot be used; empty where its checksum is right
};

/// Walks through the logs of a recording. What is none is passed over; what is a broken log of a type that is known has
/// a problem. Takes time that grows with the bytes alone, whatever they are.
class NovatelScanner {
 public:
  explicit NovatelScanner(std::string_view recording) : recording_(recording) {}
  /// False at the end.
  bool next(NovatelFrame& frame);

 private:
  bool binary_at(std::size_t at, NovatelFrame& frame);
  bool ascii_at(std::size_t at, NovatelFrame& frame);

  std::string_view recording_;
  std::size_t next_ = 0;
  std::size_t in_vain_ = 0;  ///< bytes whose checksum was computed and was another
};

/// NovAtel's CRC-32 of a log: of its text between '#' and '*', or of its bytes.
std::uint32_t novatel_crc32(std::string_view bytes);

/// Whether bytes contain what binary logs begin with.
bool holds_binary_sync(std::string_view bytes);

}  // namespace remount::formats

#include "model/formats/ins/novatel_frames.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "messages/ins_logs.h"
#include "model/formats/files/crc32.h"
#include "model/formats/files/number_bytes.h"

namespace remount::formats {
namespace {

constexpr NovatelLogType kNovatelLogTypes[] = {{1465, "INSPVAX", NovatelUse::Inspvax},
                                               {507, "INSPVA", NovatelUse::Inspva},
                                               {508, "INSPVAS", NovatelUse::Inspva},
                                               {1778, "IMURATEPVA", NovatelUse::Inspva},
                                               {1305, "IMURATEPVAS", NovatelUse::Inspva},
                                               {2051, "INSSTDEV", NovatelUse::Insstdev},
                                               {2052, "INSSTDEVS", NovatelUse::Insstdev},
                                               {42, "BESTPOS", NovatelUse::Bestpos},
                                               {268, "RAWIMU", NovatelUse::RawImu},
                                               {325, "RAWIMUS", NovatelUse::RawImu},
                                               {1461, "RAWIMUX", NovatelUse::RawImu},
                                               {1462, "RAWIMUSX", NovatelUse::RawImu},
                                               {37, "VERSION"},
                                               {41, "RAWEPHEM"},
                                               {43, "RANGE"},
                                               {93, "RXSTATUS"},
                                               {99, "BESTVEL"},
                                               {101, "TIME"},
                                               {128, "RXCONFIG"},
                                               {140, "RANGECMP"},
                                               {241, "BESTXYZ"},
                                               {263, "INSATT"},
                                               {264, "INSCOV"},
                                               {265, "INSPOS"},
                                               {266, "INSSPD"},
                                               {267, "INSVEL"},
                                               {319, "INSATTS"},
                                               {320, "INSCOVS"},
                                               {321, "INSPOSS"},
                                               {323, "INSSPDS"},
                                               {324, "INSVELS"},
                                               {723, "GLOEPHEMERIS"},
                                               {726, "BESTUTM"},
                                               {812, "CORRIMUDATA"},
                                               {813, "CORRIMUDATAS"},
                                               {1163, "PSRDOP2"},
                                               {1335, "HEADING2"},
                                               {1362, "IMURATECORRIMUS"},
                                               {1429, "BESTGNSSPOS", NovatelUse::Bestpos},
                                               {1430, "BESTGNSSVEL"},
                                               {1457, "INSATTX"},
                                               {1458, "INSVELX"},
                                               {1459, "INSPOSX"},
                                               {1538, "PPPPOS"},
                                               {1825, "INSUPDATESTATUS"},
                                               {1945, "INSCONFIG"},
                                               {2264, "CORRIMUS"}};

/// Of an ASCII log, which is named in its text.
const NovatelLogType* type_named(std::string_view name) {
  const auto* found = std::ranges::find(kNovatelLogTypes, name, &NovatelLogType::name);
  return found == std::end(kNovatelLogTypes) ? nullptr : found;
}

constexpr std::size_t kLongHeaderBytes = 28, kShortHeaderBytes = 12, kCrcBytes = 4;

bool is_binary_mark(std::string_view text, std::size_t at) {
  return at + 2 < text.size() && text[at] == '\xAA' && text[at + 1] == '\x44' &&
         (text[at + 2] == '\x12' || text[at + 2] == '\x13');
}

/// The name behind a '#' or '%', with its 'A'; empty where what stands there is no log.
std::string_view ascii_name(std::string_view text, std::size_t at) {
  constexpr std::size_t kLongestName = 32;
  if (at >= text.size() || (text[at] != '#' && text[at] != '%')) return {};
  std::size_t end = at + 1;
  const auto belongs = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_'; };
  while (end < text.size() && end - at <= kLongestName && belongs(text[end])) ++end;
  if (end >= text.size() || text[end] != ',') return {};
  const std::string_view name = text.substr(at + 1, end - at - 1);
  const std::string_view without_source = name.ends_with("_1") ? name.substr(0, name.size() - 2) : name;
  return without_source.size() >= 4 && without_source.ends_with('A') ? name : std::string_view();
}

/// Without the 'A', which says that it is ASCII.
std::string_view without_a(std::string_view name) {
  return name.ends_with("_1") ? name : name.substr(0, name.size() - 1);
}

/// Eight digits in base 16.
std::optional<std::uint32_t> crc_digits(std::string_view digits) {
  std::uint32_t crc = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), crc, 16);
  if (error != std::errc() || digits.size() != 8 || end != digits.data() + digits.size()) return std::nullopt;
  return crc;
}

}  // namespace

std::uint32_t novatel_crc32(std::string_view bytes) { return plain_crc32(bytes); }

const NovatelLogType* novatel_log_type(std::uint16_t id) {
  const auto* found = std::ranges::find(kNovatelLogTypes, id, &NovatelLogType::id);
  return found == std::end(kNovatelLogTypes) ? nullptr : found;
}

bool holds_binary_sync(std::string_view bytes) {
  for (std::size_t at = bytes.find('\xAA'); at != std::string_view::npos; at = bytes.find('\xAA', at + 1))
    if (is_binary_mark(bytes, at)) return true;
  return false;
}

bool NovatelScanner::next(NovatelFrame& frame) {
  for (std::size_t at = next_; at < recording_.size(); ++at) {
    const char c = recording_[at];
    if (c != '\xAA' && c != '#' && c != '%') continue;
    if (c == '\xAA' ? binary_at(at, frame) : ascii_at(at, frame)) return true;
  }
  next_ = recording_.size();
  return false;
}

bool NovatelScanner::binary_at(std::size_t at, NovatelFrame& frame) {
  if (!is_binary_mark(recording_, at)) return false;
  const std::string_view rest = recording_.substr(at);
  const bool is_short = rest[2] == '\x13';
  if (rest.size() < (is_short ? kShortHeaderBytes : kLongHeaderBytes)) return false;
  const std::size_t header = is_short ? kShortHeaderBytes : little_number<std::uint8_t>(rest, 3);
  if (header < (is_short ? kShortHeaderBytes : kLongHeaderBytes)) return false;
  const std::size_t body = is_short ? little_number<std::uint8_t>(rest, 3) : little_number<std::uint16_t>(rest, 8);
  const std::size_t whole = header + body + kCrcBytes;
  const unsigned message_type = is_short ? 0U : little_number<std::uint8_t>(rest, 6);
  constexpr unsigned kSource = 0x1F, kResponse = 0x80;
  frame = {};
  frame.binary = true;
  frame.id = little_number<std::uint16_t>(rest, 4);
  frame.source = message_type & kSource;
  frame.short_header = is_short;
  frame.at = at;
  if ((message_type & kResponse) != 0) return false;  // to a command: a text
  if (frame.source == 0) frame.type = novatel_log_type(frame.id);
  // A log whose length is made up costs as many bytes of a checksum: those of types that are used are short.
  constexpr std::size_t kLongestUsed = 512;
  const bool used = frame.type != nullptr && frame.type->use != NovatelUse::None;
  if (used ? body > kLongestUsed : in_vain_ > 4 * recording_.size()) return false;
  if (whole > rest.size()) {
    if (frame.type == nullptr) return false;
    frame.problem = say::novatel_cut(Bytes{whole}, Bytes{rest.size()});
  } else if (little_number<std::uint32_t>(rest, header + body) != novatel_crc32(rest.substr(0, header + body))) {
    in_vain_ += whole;
    if (frame.type == nullptr) return false;
    frame.problem = say::novatel_checksum();
  }
  if (!frame.problem.empty()) {
    frame.bytes = 3;
    next_ = at + frame.bytes;  // what it is made up of may hold whole logs
    return true;
  }
  frame.header = rest.substr(0, header);
  frame.body = rest.substr(header, body);
  frame.bytes = whole;
  next_ = at + whole;
  return true;
}

bool NovatelScanner::ascii_at(std::size_t at, NovatelFrame& frame) {
  const std::string_view name = ascii_name(recording_, at);
  if (name.empty()) return false;
  std::size_t end = at + 1 + name.size(), semicolon = std::string_view::npos;
  for (; end < recording_.size(); ++end) {
    const char c = recording_[end];
    if (c == '\n' || c == '\r' || (c == '*' && semicolon != std::string_view::npos)) break;
    if ((c == '#' || c == '%') && !ascii_name(recording_, end).empty()) break;  // its end was lost
    if (c == '\xAA' && is_binary_mark(recording_, end)) break;
    if (c == ';' && semicolon == std::string_view::npos) semicolon = end;
  }
  frame = {};
  frame.name = without_a(name);
  frame.type = type_named(frame.name);
  frame.short_header = recording_[at] == '%';
  frame.at = at;
  const bool starred = end < recording_.size() && recording_[end] == '*';
  if (!starred) {
    frame.problem = say::inspvax_no_record(std::string(recording_.substr(at, name.size() + 2)));
  } else {
    const std::string_view log = recording_.substr(at + 1, end - at - 1);
    const auto crc = crc_digits(recording_.substr(end + 1, 8));
    if (crc != novatel_crc32(log)) frame.problem = say::inspvax_checksum();
    frame.header = log.substr(0, semicolon - at - 1);
    frame.body = log.substr(semicolon - at);
    end = std::min(end + 1 + (crc ? 8 : 0), recording_.size());
    while (end < recording_.size() && (recording_[end] == '\r' || recording_[end] == '\n')) ++end;
  }
  frame.bytes = end - at;
  next_ = end;
  return frame.problem.empty() || frame.type != nullptr;
}

}  // namespace remount::formats

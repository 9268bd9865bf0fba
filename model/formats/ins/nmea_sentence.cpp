#include "model/formats/ins/nmea_sentence.h"

#include <algorithm>
#include <cmath>

#include "algorithms/geometry/rotation.h"
#include "model/formats/files/input_file.h"

namespace remount::formats {
namespace {

std::optional<unsigned> hexadecimal(std::string_view two) {
  unsigned value = 0;
  if (two.size() != 2) return std::nullopt;
  for (const char c : two) {
    const char lower = static_cast<char>(c | 0x20);
    const bool digit = c >= '0' && c <= '9', letter = lower >= 'a' && lower <= 'f';
    if (!digit && !letter) return std::nullopt;
    value = value * 16 + static_cast<unsigned>(digit ? c - '0' : lower - 'a' + 10);
  }
  return value;
}

/// Letters and digits, as names of sentences are.
bool is_name(std::string_view head) {
  constexpr std::size_t kShortest = 4, kLongest = 10;
  return head.size() >= kShortest && head.size() <= kLongest && std::all_of(head.begin(), head.end(), [](char c) {
           return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
         });
}

/// Makers that say in the first field what a sentence of theirs is.
bool divides_its_sentences(std::string_view maker) {
  return maker == "PTNL" || maker == "PSAT" || maker == "PSSN" || maker == "PUBX";
}

}  // namespace

unsigned nmea_checksum(std::string_view body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  return sum;
}

NmeaLine parse_nmea(std::string_view line, NmeaSentence& sentence) {
  const std::size_t begin = line.find('$');
  if (begin == std::string_view::npos) return NmeaLine::NoSentence;
  line = trim(line.substr(begin + 1));
  const std::size_t star = line.rfind('*');
  sentence.has_checksum = star != std::string_view::npos;
  bool right = true;
  if (sentence.has_checksum) {
    right = hexadecimal(line.substr(star + 1)) == nmea_checksum(line.substr(0, star));
    line = line.substr(0, star);
  }
  split_csv(line, sentence.fields);
  const std::string_view head = sentence.fields.empty() ? std::string_view{} : sentence.fields.front();
  if (!is_name(head)) return right ? NmeaLine::NoSentence : NmeaLine::WrongChecksum;
  const bool of_talker = head.size() == 5 && head.front() != 'P';
  const std::size_t names = divides_its_sentences(head) ? std::min<std::size_t>(sentence.fields.size(), 2) : 1;
  sentence.talker = of_talker ? head.substr(0, 2) : std::string_view{};
  // Both names stand side by side in the line.
  const std::string_view last = sentence.fields[names - 1];
  sentence.type =
      of_talker ? head.substr(2)
                : std::string_view(head.data(), static_cast<std::size_t>(last.data() - head.data()) + last.size());
  sentence.fields.erase(sentence.fields.begin(), sentence.fields.begin() + static_cast<std::ptrdiff_t>(names));
  return right ? NmeaLine::Sentence : NmeaLine::WrongChecksum;
}

std::optional<std::int64_t> nmea_time_ns(std::string_view text) {
  if (text.size() < 6) return std::nullopt;
  const auto hours = parse_integer(text.substr(0, 2)), minutes = parse_integer(text.substr(2, 2));
  const auto seconds_ns = parse_seconds_ns(text.substr(4));
  if (!hours || !minutes || !seconds_ns || *hours < 0 || *hours > 23 || *minutes < 0 || *minutes > 59 ||
      *seconds_ns < 0 || *seconds_ns >= 61'000'000'000)
    return std::nullopt;
  return (*hours * 3600 + *minutes * 60) * 1'000'000'000 + *seconds_ns;
}

std::optional<double> nmea_degrees_rad(std::string_view text) {
  const auto degrees = parse_number(text);
  if (!degrees || std::abs(*degrees) > 720.0) return std::nullopt;
  return degrees_to_radians(*degrees);
}

std::optional<double> nmea_angle_rad(std::string_view text, std::string_view side) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const bool latitude = side == "N" || side == "S";
  if (point < 3 || !(latitude || side == "E" || side == "W")) return std::nullopt;
  const auto degrees = parse_integer(text.substr(0, point - 2));
  const auto minutes = parse_number(text.substr(point - 2));
  if (!degrees || !minutes || *degrees < 0 || *degrees > (latitude ? 90 : 180) || *minutes < 0.0 || *minutes >= 60.0)
    return std::nullopt;
  const double angle = degrees_to_radians(static_cast<double>(*degrees) + *minutes / 60.0);
  return side == "S" || side == "W" ? -angle : angle;
}

}  // namespace remount::formats

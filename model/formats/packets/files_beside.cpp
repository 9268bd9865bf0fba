#include "model/formats/packets/files_beside.h"

#include <algorithm>
#include <charconv>

namespace remount::formats {

namespace {

/// Four numbers up to 255 with dots between them are an address; more may stand around.
std::vector<std::uint32_t> addresses_in(std::string_view text) {
  constexpr std::size_t kNumbers = 4, kMostDigits = 3;
  constexpr std::uint32_t kMostNumber = 255;
  std::vector<std::uint32_t> addresses, numbers;  // those right before, with dots between
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
    if (end == at) {
      numbers.clear(), ++at;
      continue;
    }
    std::uint32_t number = kMostNumber + 1;
    if (end - at <= kMostDigits) std::from_chars(text.data() + at, text.data() + end, number);
    if (number > kMostNumber)
      numbers.clear();
    else
      numbers.push_back(number);
    std::uint32_t address = 0;
    for (std::size_t i = 0; i < kNumbers && numbers.size() >= kNumbers; ++i)
      address = address << 8U | numbers[numbers.size() - kNumbers + i];
    if (numbers.size() >= kNumbers) addresses.push_back(address);
    at = end < text.size() && text[end] == '.' ? end + 1 : end;
  }
  return addresses;
}

/// Whether it was said on a topic of this sensor.
bool is_said_of(const SaidOfSensors& said, const DatagramRoute& route) {
  return !said.device.empty() && route.topic.starts_with(said.device);
}

}  // namespace

bool names_address(const std::filesystem::path& file, const DatagramRoute& route) {
  if (!route.topic.empty()) return file.stem() == address_text(route);
  const std::vector<std::uint32_t> named = addresses_in(file.stem().string());
  return std::ranges::find(named, route.address) != named.end();
}

int rank_of_address(const std::filesystem::path& file, const BesidePackets& beside) {
  constexpr int kCalledAsTopic = 10'000;
  constexpr std::size_t kLongest = 1000;
  if (const SaidOfSensors* said = beside.said_on(file))
    return is_said_of(*said, beside.route) ? 2 + static_cast<int>(std::min(said->device.size(), kLongest)) : 1;
  if (file.stem() == address_text(beside.route)) return beside.route.topic.empty() ? 2 : kCalledAsTopic;
  return names_address(file, beside.route) ? 1 : 0;
}

namespace {

/// Sensors have addresses of a local network, or one near to those that are heard. Other four numbers with dots are a
/// date or a version ("angles_24.11.28.10.csv").
bool can_be_of_sensor(std::uint32_t address, const DatagramRoute& route) {
  const std::uint32_t first = address >> 24U, second = address >> 16U & 0xFFU;
  const bool local = first == 10 || (first == 172 && second >= 16 && second < 32) || (first == 192 && second == 168) ||
                     (first == 169 && second == 254);
  return local || address >> 16U == route.address >> 16U;
}

}  // namespace

bool names_other_address(const std::filesystem::path& file, const BesidePackets& beside) {
  if (!beside.route.topic.empty()) {
    const SaidOfSensors* said = beside.said_on(file);
    return said && said->of_sensor && !is_said_of(*said, beside.route);
  }
  if (file.stem() == beside.recording.stem() || names_address(file, beside.route)) return false;
  const std::vector<std::uint32_t> named = addresses_in(file.stem().string());
  return std::ranges::any_of(named, [&](std::uint32_t address) { return can_be_of_sensor(address, beside.route); });
}

std::string name_beside(const std::filesystem::path& file) {
  return file.has_extension() ? file.filename().string() : file.string();
}

}  // namespace remount::formats

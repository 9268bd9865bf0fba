// What the data packets of all Velodynes share: 12 blocks of 32 returns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

#include "algorithms/core/median.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/packets/packet_decoder.h"

namespace remount::formats {

constexpr std::size_t kDataBytes = 1206, kBlocks = 12, kBlockBytes = 100, kReturns = 32, kReturnBytes = 3;
constexpr std::size_t kStampAt = 1200;
constexpr std::uint32_t kTurn = 36000;  ///< hundredths of a degree
constexpr std::uint16_t kHour_s = 3600;

inline std::uint16_t flag_of(std::string_view payload, std::size_t block) {
  return little_number<std::uint16_t>(payload, block * kBlockBytes);
}
/// Blocks say which 32 lasers they are of: 0xEEFF, 0xDDFF, 0xCCFF, 0xBBFF.
constexpr std::uint16_t flag_of_bank(std::size_t bank) { return static_cast<std::uint16_t>(0xeeff - 0x1100 * bank); }
inline std::uint16_t azimuth_of(std::string_view payload, std::size_t block) {
  return little_number<std::uint16_t>(payload, block * kBlockBytes + 2);
}

/// Hundredths of a degree in a step, by all that follow each other: what is rounded in each matters least then. A
/// sensor that looks at a part of the turn leaves the rest out between two of them. Nothing of a single one.
inline std::optional<double> mean_step(const std::vector<std::uint16_t>& azimuths) {
  std::vector<std::uint32_t> steps;
  for (std::size_t i = 1; i < azimuths.size(); ++i) steps.push_back((azimuths[i] + kTurn - azimuths[i - 1]) % kTurn);
  if (steps.empty()) return std::nullopt;
  const std::uint32_t most = 2 * median_of(steps);
  std::erase_if(steps, [&](std::uint32_t step) { return step > most; });
  return std::accumulate(steps.begin(), steps.end(), 0.0) / static_cast<double>(steps.size());
}

/// Whether it is a packet of an HDL-64E, S2 or S3: blocks of the upper lasers and the lower in turn.
bool is_hdl64(std::string_view payload);
std::unique_ptr<PacketDecoder> make_hdl64_decoder();

}  // namespace remount::formats

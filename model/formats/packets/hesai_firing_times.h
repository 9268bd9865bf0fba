// When the channels of Hesai's sensors with 128 lasers fire, from the time of their block on: tables of the manuals.
#pragma once

#include <cstdint>
#include <vector>

namespace remount::formats {

/// By the state of the packet and of its block, and by the range: see HesaiModel::times_us. 0 where a channel does not
/// fire.
std::vector<std::vector<double>> pandar128_times_us();
std::vector<std::vector<double>> ot128_times_us();
std::vector<double> at128_times_us();
/// Of its two loops, in which channels 33 to 64 fire, or 1 to 32, beside all others.
std::vector<std::vector<double>> qt128_times_us();

}  // namespace remount::formats

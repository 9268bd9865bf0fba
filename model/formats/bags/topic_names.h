// What the names of topics tell of the devices that they are of.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace remount::bags {

/// The words of a topic's name, parted by '/' and '_'.
std::vector<std::string_view> words_of(std::string_view topic);

/// How many words the names of two topics begin with alike: of "/left_packets" and "/left_packets_difop" two, of
/// "/left_packets2" and the latter one.
std::size_t words_alike(std::string_view topic, std::string_view other);

/// Whether two topics are published under the name of one device, as "/ins/imu" and "/ins/fix".
bool of_one_device(std::string_view topic, std::string_view other);

}  // namespace remount::bags

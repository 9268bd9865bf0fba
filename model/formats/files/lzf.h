// Decoder of the LZF compression that binary_compressed PCD files use.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace remount::formats {

/// The longest output that `compressed_size` bytes can stand for: three bytes repeat at most 264.
inline constexpr std::size_t lzf_max_output(std::size_t compressed_size) { return compressed_size * 88 + 264; }

/// Decodes to exactly `expected_size` bytes. Nothing where the stream is broken or stands for another length. Takes no
/// memory where `expected_size` is more than the stream can stand for.
std::optional<std::string> lzf_decode(std::string_view compressed, std::size_t expected_size);

/// Encodes; used by tests and by writers. The result may be longer than the input where that does not compress.
std::string lzf_encode(std::string_view bytes);

}  // namespace remount::formats

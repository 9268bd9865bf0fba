#include "model/formats/files/lzf.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/formats/files/number_bytes.h"

namespace remount::formats {

namespace {

constexpr std::size_t kMaxLiteral = 32;
constexpr std::size_t kMaxDistance = 8192;
constexpr std::size_t kMaxMatch = 264;

void put_literals(std::string& out, std::string_view literals) {
  while (!literals.empty()) {
    const std::size_t count = std::min(literals.size(), kMaxLiteral);
    out.push_back(static_cast<char>(count - 1));
    out.append(literals.substr(0, count));
    literals.remove_prefix(count);
  }
}

void put_match(std::string& out, std::size_t distance, std::size_t length) {
  const std::size_t back = distance - 1, code = length - 2;
  out.push_back(static_cast<char>((std::min<std::size_t>(code, 7) << 5) | (back >> 8)));
  if (code >= 7) out.push_back(static_cast<char>(code - 7));
  out.push_back(static_cast<char>(back & 0xff));
}

}  // namespace

std::optional<std::string> lzf_decode(std::string_view compressed, std::size_t expected_size) {
  if (expected_size > lzf_max_output(compressed.size())) return std::nullopt;
  std::string out;
  out.reserve(expected_size);
  std::size_t in = 0;
  while (in < compressed.size()) {
    const std::size_t control = byte_at(compressed, in++);
    if (control < kMaxLiteral) {
      const std::size_t count = control + 1;
      if (count > compressed.size() - in || count > expected_size - out.size()) return std::nullopt;
      out.append(compressed.substr(in, count));
      in += count;
      continue;
    }
    std::size_t length = control >> 5;
    if (length == 7) {
      if (in >= compressed.size()) return std::nullopt;
      length += byte_at(compressed, in++);
    }
    if (in >= compressed.size()) return std::nullopt;
    const std::size_t distance = ((control & 0x1f) << 8) + byte_at(compressed, in++) + 1;
    length += 2;
    if (distance > out.size() || length > expected_size - out.size()) return std::nullopt;
    // Byte by byte: the source may overlap what is being written.
    for (std::size_t from = out.size() - distance, i = 0; i < length; ++i) out.push_back(out[from + i]);
  }
  if (out.size() != expected_size) return std::nullopt;
  return out;
}

std::string lzf_encode(std::string_view bytes) {
  std::string out;
  std::vector<std::size_t> last_seen(1 << 14, std::string_view::npos);
  std::size_t literals_from = 0, at = 0;
  while (at + 2 < bytes.size()) {
    const std::uint32_t three = byte_at(bytes, at) << 16 | byte_at(bytes, at + 1) << 8 | byte_at(bytes, at + 2);
    std::size_t& slot = last_seen[(three * 2654435761u) >> 18];
    const std::size_t earlier = slot;
    slot = at;
    std::size_t length = 0;
    if (earlier != std::string_view::npos && at - earlier <= kMaxDistance)
      while (length < kMaxMatch && at + length < bytes.size() && bytes[earlier + length] == bytes[at + length])
        ++length;
    if (length < 3) {
      ++at;
      continue;
    }
    put_literals(out, bytes.substr(literals_from, at - literals_from));
    put_match(out, at - earlier, length);
    at += length;
    literals_from = at;
  }
  put_literals(out, bytes.substr(literals_from));
  return out;
}

}  // namespace remount::formats

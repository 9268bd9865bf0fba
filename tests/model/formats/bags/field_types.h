// What a field of a PointCloud2 message may be, as its definition numbers them.
#pragma once

#include <cstdint>

namespace remount::bags {

enum : std::uint8_t { kI8 = 1, kU8, kI16, kU16, kI32, kU32, kF32, kF64 };

}  // namespace remount::bags

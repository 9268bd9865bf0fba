// Integers, as what they differ from what was expected of them by.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "model/formats/laz/entropy_decoder.h"

namespace remount::formats {

/// How integers of so many bits stand in the bytes: first how many bits the difference has, by a model for each
/// context, then the difference itself, of which the upper eight bits have a model.
class IntegerDecoder {
 public:
  explicit IntegerDecoder(unsigned bits, unsigned contexts = 1);
  std::int32_t next(EntropyDecoder& decoder, std::int32_t expected, unsigned context = 0);
  /// How many bits the last difference had.
  unsigned last_bits() const { return last_bits_; }

 private:
  std::uint32_t difference(EntropyDecoder& decoder);

  unsigned bits_, last_bits_ = 0;
  std::vector<SymbolModel> lengths_;
  BitModel one_bit_;
  std::vector<std::optional<SymbolModel>> differences_;  ///< by their bits, once they are met: most never are
};

}  // namespace remount::formats

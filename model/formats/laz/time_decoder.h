// GPS times of compressed points.
#pragma once

#include <array>
#include <cstdint>

#include "model/formats/laz/integer_decoder.h"

namespace remount::formats {

/// Which codes stand for times: those of chunks in layers lack the one of a time that stays as it is.
enum class TimeCodes { PointWise, Layered };

/// Times as integers of their 64 bits, of up to four sequences between which they change. Each sequence goes on by
/// multiples of its last step.
class TimeDecoder {
 public:
  TimeDecoder(TimeCodes codes, double first);
  /// Throws Error(Format) at `where` for codes that no writer makes.
  double next(EntropyDecoder& decoder, const std::string& where);

 private:
  struct Sequence {
    std::uint64_t time = 0;
    std::int32_t step = 0;
    int unusual_steps = 0;  ///< one after another; then the step is another one
  };

  bool goes_on(EntropyDecoder& decoder);
  bool goes_on_from_standing(EntropyDecoder& decoder);
  bool goes_on_by_steps(EntropyDecoder& decoder);
  void multiply_step(EntropyDecoder& decoder, int multiple);
  void begin_sequence(EntropyDecoder& decoder);

  unsigned skipped_codes_;  ///< of times that stay: there are so many fewer
  SymbolModel standing_, multiples_;
  IntegerDecoder steps_{32, 9};
  std::array<Sequence, 4> sequences_;
  unsigned current_ = 0, newest_ = 0;
};

}  // namespace remount::formats

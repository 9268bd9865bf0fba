#include "model/formats/laz/time_decoder.h"

#include <bit>

#include "algorithms/core/error.h"
#include "messages/laz.h"

namespace remount::formats {
namespace {

constexpr int kMostMultiple = 500, kLeastMultiple = -10;

/// Codes behind the multiples: the time stays, stands there in full, is of another sequence.
constexpr unsigned kStays = kMostMultiple - kLeastMultiple + 1, kInFull = kStays + 1;

/// Contexts of what a time differs from its expectation by.
enum Context : unsigned {
  kFirstStep,
  kOneStep,
  kFewSteps,
  kManySteps,
  kMostSteps,
  kStepsBack,
  kLeastSteps,
  kNoStep,
  kUpperHalf
};

}  // namespace

TimeDecoder::TimeDecoder(TimeCodes codes, double first)
    : skipped_codes_(codes == TimeCodes::Layered ? 1 : 0),
      standing_(6 - skipped_codes_),
      multiples_(kInFull + 4 - skipped_codes_) {
  sequences_[0].time = std::bit_cast<std::uint64_t>(first);
}

double TimeDecoder::next(EntropyDecoder& decoder, const std::string& where) {
  // A writer changes the sequence once, to the one that the time goes on.
  for (int changes = 0; !goes_on(decoder); ++changes)
    if (changes == 3) throw Error(ErrorCode::Format, where, say::laz_damaged());
  return std::bit_cast<double>(sequences_[current_].time);
}

/// False where another sequence goes on instead.
bool TimeDecoder::goes_on(EntropyDecoder& decoder) {
  return sequences_[current_].step == 0 ? goes_on_from_standing(decoder) : goes_on_by_steps(decoder);
}

bool TimeDecoder::goes_on_from_standing(EntropyDecoder& decoder) {
  const unsigned code = decoder.symbol(standing_) + skipped_codes_;
  Sequence& sequence = sequences_[current_];
  if (code == 1) {
    sequence.step = steps_.next(decoder, 0, kFirstStep);
    sequence.time += static_cast<std::uint64_t>(static_cast<std::int64_t>(sequence.step));
    sequence.unusual_steps = 0;
  } else if (code == 2) {
    begin_sequence(decoder);
  } else if (code > 2) {
    current_ = (current_ + code - 2) % sequences_.size();
    return false;
  }
  return true;
}

bool TimeDecoder::goes_on_by_steps(EntropyDecoder& decoder) {
  unsigned code = decoder.symbol(multiples_);
  if (code >= kStays) code += skipped_codes_;
  if (code < kStays) {
    const int multiple = static_cast<int>(code);
    multiply_step(decoder, multiple <= kMostMultiple ? multiple : kMostMultiple - multiple);
  } else if (code == kInFull) {
    begin_sequence(decoder);
  } else if (code > kInFull) {
    current_ = (current_ + code - kInFull) % sequences_.size();
    return false;
  }
  return true;
}

void TimeDecoder::multiply_step(EntropyDecoder& decoder, int multiple) {
  constexpr int kMany = 10, kUnusualInARow = 4;
  Sequence& sequence = sequences_[current_];
  const bool unusual = multiple == 0 || multiple == kMostMultiple || multiple == kLeastMultiple;
  const Context context = multiple == 0                ? kNoStep
                          : multiple == 1              ? kOneStep
                          : multiple == kMostMultiple  ? kMostSteps
                          : multiple == kLeastMultiple ? kLeastSteps
                          : multiple < 0               ? kStepsBack
                          : multiple < kMany           ? kFewSteps
                                                       : kManySteps;
  const std::uint32_t expected = static_cast<std::uint32_t>(multiple) * static_cast<std::uint32_t>(sequence.step);
  const std::int32_t step = steps_.next(decoder, static_cast<std::int32_t>(expected), context);
  sequence.time += static_cast<std::uint64_t>(static_cast<std::int64_t>(step));
  if (multiple == 1) sequence.unusual_steps = 0;
  if (!unusual || ++sequence.unusual_steps < kUnusualInARow) return;
  sequence.step = step;
  sequence.unusual_steps = 0;
}

void TimeDecoder::begin_sequence(EntropyDecoder& decoder) {
  const auto upper_half = static_cast<std::int32_t>(sequences_[current_].time >> 32);
  newest_ = (newest_ + 1) % sequences_.size();
  const auto upper = static_cast<std::uint32_t>(steps_.next(decoder, upper_half, kUpperHalf));
  sequences_[newest_] = {std::uint64_t{upper} << 32 | decoder.number(32)};
  current_ = newest_;
}

}  // namespace remount::formats

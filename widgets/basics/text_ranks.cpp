#include "widgets/basics/text_ranks.h"

#include <algorithm>
#include <cstdint>

namespace remount::widgets {
namespace {

constexpr std::size_t kChunk = 8;

struct Keyed {
  std::uint64_t key = 0;  // the bytes from `depth` on, the first one highest
  std::uint32_t text = 0;
  bool ends = false;  // within these bytes: sorts before one that goes on with zeros
  bool operator<(const Keyed& other) const { return key != other.key ? key < other.key : ends && !other.ends; }
  bool operator==(const Keyed& other) const { return key == other.key && ends == other.ends; }
};

/// A stretch of texts that are the same up to `depth`.
struct Stretch {
  std::size_t begin, end, depth;
};

/// The first eight, the first one highest.
std::uint64_t first_bytes(std::string_view text) {
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < kChunk; ++i) bytes = bytes << 8U | static_cast<unsigned char>(text[i]);
  return bytes;
}

class Ranking {
 public:
  explicit Ranking(const std::vector<std::string_view>& texts)
      : texts_(texts), sorted_(texts.size()), ranks_(texts.size()) {
    for (std::size_t i = 0; i < texts.size(); ++i) sorted_[i].text = static_cast<std::uint32_t>(i);
    if (!texts.empty()) waiting_.push_back({0, texts.size(), 0});
  }

  std::vector<int> ranks() {
    while (!waiting_.empty()) {
      const Stretch stretch = waiting_.back();
      waiting_.pop_back();
      sort(stretch);
    }
    return std::move(ranks_);
  }

 private:
  Keyed key_of(std::uint32_t text, std::size_t depth) const {
    const std::string_view rest = texts_[text].substr(std::min(depth, texts_[text].size()));
    if (rest.size() > kChunk) return {first_bytes(rest), text, false};
    Keyed out{0, text, true};
    for (std::size_t i = 0; i < kChunk; ++i)
      out.key = out.key << 8U | (i < rest.size() ? static_cast<unsigned char>(rest[i]) : 0U);
    return out;
  }

  void sort(Stretch stretch) {
    const auto begin = sorted_.begin() + static_cast<std::ptrdiff_t>(stretch.begin),
               end = sorted_.begin() + static_cast<std::ptrdiff_t>(stretch.end);
    stretch.depth = common_depth(begin, end, stretch.depth);
    for (auto it = begin; it != end; ++it) *it = key_of(it->text, stretch.depth);
    if (!std::all_of(begin, end, [&](const Keyed& other) { return other == *begin; })) std::sort(begin, end);
    for (auto first = begin; first != end;) {
      const auto last = std::find_if(first, end, [&](const Keyed& other) { return !(other == *first); });
      const auto from = static_cast<std::size_t>(first - sorted_.begin());
      if (first->ends || last - first == 1)
        rank_ended(first, last);
      else
        waiting_.push_back({from, static_cast<std::size_t>(last - sorted_.begin()), stretch.depth + kChunk});
      first = last;
    }
  }

  /// Up to where the texts, the same up to `depth`, are the same: sentences differ in a number behind many words.
  std::size_t common_depth(std::vector<Keyed>::const_iterator begin, std::vector<Keyed>::const_iterator end,
                           std::size_t depth) const {
    std::string_view common = texts_[begin->text];
    for (auto it = begin + 1; it != end && common.size() > depth; ++it) {
      const std::string_view other = texts_[it->text];
      const std::size_t least = std::min(common.size(), other.size());
      std::size_t same = depth;
      while (same < least && common[same] == other[same]) ++same;
      common = common.substr(0, same);
    }
    return std::max(depth, common.size());
  }

  /// All bytes are the same here, but for zeros at the end.
  void rank_ended(std::vector<Keyed>::iterator first, std::vector<Keyed>::iterator last) {
    const auto size = [&](const Keyed& keyed) { return texts_[keyed.text].size(); };
    if (std::any_of(first, last, [&](const Keyed& other) { return size(other) != size(*first); }))
      std::sort(first, last, [&](const Keyed& a, const Keyed& b) { return size(a) < size(b); });
    auto rank = static_cast<int>(first - sorted_.begin());
    for (auto it = first; it != last; ++it) {
      if (it != first && size(*it) != size(*(it - 1))) rank = static_cast<int>(it - sorted_.begin());
      ranks_[it->text] = rank;
    }
  }

  const std::vector<std::string_view>& texts_;
  std::vector<Keyed> sorted_;
  std::vector<int> ranks_;
  std::vector<Stretch> waiting_;
};

}  // namespace

std::vector<int> text_ranks(const std::vector<std::string_view>& texts) { return Ranking(texts).ranks(); }

}  // namespace remount::widgets

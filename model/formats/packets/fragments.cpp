#include "model/formats/packets/fragments.h"

#include <algorithm>
#include <cstdlib>

namespace remount::formats {

namespace {
constexpr std::size_t kMostWaiting = 64, kMostPieces = 64;
constexpr std::uint32_t kMostDatagramBytes = 65535;
constexpr std::int64_t kLongest_ns = 1'000'000'000;
}  // namespace

Fragments::Waiting& Fragments::waiting_for(const UdpPart& part, std::int64_t time_ns) {
  const auto found = std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& one) {
    return one.source == part.source && one.destination == part.destination && one.id == part.id;
  });
  if (found != waiting_.end()) {
    if (std::abs(time_ns - found->begun_ns) <= kLongest_ns) return *found;
    ++given_up_;
    found->begun_ns = time_ns, found->total = 0;
    found->pieces.clear();
    return *found;
  }
  if (waiting_.size() == kMostWaiting) {
    waiting_.pop_front();
    ++given_up_;
  }
  return waiting_.emplace_back(Waiting{part.source, part.destination, part.id, time_ns, 0, {}});
}

std::vector<DatagramPiece> Fragments::add(const UdpPart& part, std::uint64_t offset, std::int64_t time_ns) {
  const auto bytes = static_cast<std::uint32_t>(part.bytes);
  if (bytes == 0 || part.at + bytes > kMostDatagramBytes) return {};
  Waiting& waiting = waiting_for(part, time_ns);
  const auto place = std::lower_bound(waiting.pieces.begin(), waiting.pieces.end(), part.at,
                                      [](const Piece& piece, std::uint32_t at) { return piece.at < at; });
  if (place != waiting.pieces.end() && place->at == part.at) return {};  // the same again
  waiting.pieces.insert(place, {part.at, bytes, offset});
  if (part.last) waiting.total = part.at + bytes;
  std::uint32_t reached = 0;
  bool gapless = true;
  for (const Piece& piece : waiting.pieces) {
    gapless = gapless && piece.at == reached;
    reached = piece.at + piece.bytes;
  }
  const bool complete = gapless && waiting.total > 0 && reached == waiting.total;
  if (!complete && waiting.pieces.size() < kMostPieces) return {};
  std::vector<DatagramPiece> pieces;
  if (complete)
    for (const Piece& piece : waiting.pieces) pieces.push_back({piece.offset, piece.bytes});
  else
    ++given_up_;
  waiting_.erase(std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& one) { return &one == &waiting; }));
  return pieces;
}

}  // namespace remount::formats

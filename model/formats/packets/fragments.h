// Datagrams that networks cut into pieces, put together again by where their pieces lie.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "model/formats/packets/frames.h"

namespace remount::formats {

/// Bytes of a datagram in the file of its capture.
struct DatagramPiece {
  std::uint64_t offset = 0;  ///< in the file
  std::uint32_t bytes = 0;
};

/// Keeps places, not bytes. Few datagrams are under way at a time: the oldest is given up for a new one.
class Fragments {
 public:
  /// Numbers of datagrams come again: a piece that comes more than a second after the first is of another datagram, and
  /// the former is given up.
  /// @param offset of the part in the file @param time_ns of the host
  /// @return the pieces of the datagram that is complete with this one, in their order; none where it is not
  std::vector<DatagramPiece> add(const UdpPart& part, std::uint64_t offset, std::int64_t time_ns);
  /// Datagrams of which pieces are missing, so far and of those that are still under way.
  std::size_t incomplete() const { return given_up_ + waiting_.size(); }

 private:
  struct Piece {
    std::uint32_t at = 0, bytes = 0;
    std::uint64_t offset = 0;
  };
  struct Waiting {
    std::uint32_t source = 0, destination = 0;
    std::uint16_t id = 0;
    std::int64_t begun_ns = 0;  ///< when its first piece was captured
    std::uint32_t total = 0;    ///< 0: the last piece is not there yet
    std::vector<Piece> pieces;
  };
  Waiting& waiting_for(const UdpPart& part, std::int64_t time_ns);

  std::deque<Waiting> waiting_;
  std::size_t given_up_ = 0;
};

}  // namespace remount::formats

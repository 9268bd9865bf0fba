#include "model/formats/bags/chunk_codec.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "algorithms/core/error.h"
#include "messages/bags.h"

namespace remount::bags {
namespace {

constexpr std::uint64_t kStepBytes = std::uint64_t{1} << 20;

class Bzip2Unpacker final : public Unpacker {
 public:
  Bzip2Unpacker() {
    if (BZ2_bzDecompressInit(&stream_, 0, 0) != BZ_OK) throw std::bad_alloc();
  }
  ~Bzip2Unpacker() override { BZ2_bzDecompressEnd(&stream_); }
  Bzip2Unpacker(const Bzip2Unpacker&) = delete;
  Bzip2Unpacker& operator=(const Bzip2Unpacker&) = delete;
  UnpackStep step(std::string_view& packed, char* to, std::size_t& room) override {
    const auto given =
        static_cast<unsigned>(std::min<std::size_t>(packed.size(), std::numeric_limits<unsigned>::max()));
    stream_.next_in = const_cast<char*>(packed.data());
    stream_.avail_in = given;
    stream_.next_out = to;
    stream_.avail_out = static_cast<unsigned>(room);
    const int code = BZ2_bzDecompress(&stream_);
    packed.remove_prefix(given - stream_.avail_in);
    room -= stream_.avail_out;
    return code == BZ_OK ? UnpackStep::More : code == BZ_STREAM_END ? UnpackStep::Done : UnpackStep::Broken;
  }

 private:
  bz_stream stream_{};
};

class Lz4Unpacker final : public Unpacker {
 public:
  Lz4Unpacker() {
    LZ4F_dctx* context = nullptr;
    if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) throw std::bad_alloc();
    context_.reset(context);
  }
  UnpackStep step(std::string_view& packed, char* to, std::size_t& room) override {
    std::size_t read = packed.size();
    const std::size_t hint = LZ4F_decompress(context_.get(), to, &room, packed.data(), &read, nullptr);
    if (LZ4F_isError(hint)) {
      room = 0;
      return UnpackStep::Broken;
    }
    packed.remove_prefix(read);
    return hint == 0 ? UnpackStep::Done : UnpackStep::More;
  }

 private:
  std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context_{nullptr, LZ4F_freeDecompressionContext};
};

class ZstdUnpacker final : public Unpacker {
 public:
  ZstdUnpacker() : context_(ZSTD_createDCtx(), ZSTD_freeDCtx) {
    if (!context_) throw std::bad_alloc();
  }
  UnpackStep step(std::string_view& packed, char* to, std::size_t& room) override {
    ZSTD_inBuffer input{packed.data(), packed.size(), 0};
    ZSTD_outBuffer output{to, room, 0};
    const std::size_t hint = ZSTD_decompressStream(context_.get(), &output, &input);
    room = output.pos;
    packed.remove_prefix(input.pos);
    if (ZSTD_isError(hint)) return UnpackStep::Broken;
    return hint == 0 && packed.empty() ? UnpackStep::Done : UnpackStep::More;  // several frames may follow each other
  }

 private:
  std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context_;
};

/// Gives room for a piece of output at a time until the data end, nothing more is there to read, or `size` is reached.
/// The first piece is what the data promise to become (0: nothing), or what small messages become at most: room is
/// zeroed, and a recording has a hundred thousand of them.
UnpackStep unpack_in_steps(Unpacker& unpacker, std::string_view packed, std::uint64_t size, std::uint64_t promised,
                           std::string& out) {
  const std::uint64_t first = promised > 0 ? promised : 1024 + 16 * std::uint64_t{packed.size()};
  while (out.size() < size) {
    const std::size_t before = out.size(), left = packed.size();
    std::size_t room =
        static_cast<std::size_t>(std::min({before == 0 ? first : kStepBytes, kStepBytes, size - before}));
    out.resize(before + room);
    const UnpackStep outcome = unpacker.step(packed, out.data() + before, room);
    out.resize(before + room);
    if (outcome != UnpackStep::More) return outcome;
    if (room == 0 && packed.size() == left) return UnpackStep::Broken;  // neither read nor written: cut off
  }
  return UnpackStep::Done;
}

/// What the data say that they become, where they do; 0 otherwise.
std::uint64_t promised_bytes(ChunkCompression compression, std::string_view packed) {
  if (compression != ChunkCompression::Zstd) return 0;
  const unsigned long long promised = ZSTD_getFrameContentSize(packed.data(), packed.size());
  return promised == ZSTD_CONTENTSIZE_UNKNOWN || promised == ZSTD_CONTENTSIZE_ERROR ? 0 : promised;
}

[[noreturn]] void cannot_pack() {
  throw Error(ErrorCode::Contract, "", Message::verbatim("a chunk cannot be compressed"));
}

std::string pack_bzip2(std::string_view bytes) {
  std::string packed(bytes.size() + bytes.size() / 100 + 600, '\0');
  auto length = static_cast<unsigned>(packed.size());
  if (BZ2_bzBuffToBuffCompress(packed.data(), &length, const_cast<char*>(bytes.data()),
                               static_cast<unsigned>(bytes.size()), 9, 0, 0) != BZ_OK)
    cannot_pack();
  packed.resize(length);
  return packed;
}

}  // namespace

ChunkCompression chunk_compression(std::string_view name, const std::string& where) {
  if (name.empty() || name == "none") return ChunkCompression::None;
  if (name == "bz2") return ChunkCompression::Bzip2;
  if (name == "lz4") return ChunkCompression::Lz4;
  if (name == "zstd") return ChunkCompression::Zstd;
  throw Error(ErrorCode::Unsupported, where, say::bag_chunk_compression(std::string(name.substr(0, 40))));
}

std::unique_ptr<Unpacker> make_unpacker(ChunkCompression compression) {
  switch (compression) {
    case ChunkCompression::Bzip2:
      return std::make_unique<Bzip2Unpacker>();
    case ChunkCompression::Lz4:
      return std::make_unique<Lz4Unpacker>();
    case ChunkCompression::Zstd:
      return std::make_unique<ZstdUnpacker>();
    case ChunkCompression::None:
      break;
  }
  throw Error(ErrorCode::Contract, "", Message::verbatim("a chunk that is not compressed needs no unpacking"));
}

std::string unpack_chunk(ChunkCompression compression, std::string_view packed, std::uint64_t size, ChunkEnd end,
                         const std::string& where) {
  std::string out;
  UnpackStep outcome = UnpackStep::Done;
  if (compression == ChunkCompression::None) {
    out = packed.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(packed.size(), size)));
  } else {
    // Growing step by step would take it twice.
    const std::uint64_t promised = promised_bytes(compression, packed);
    out.reserve(static_cast<std::size_t>(end == ChunkEnd::Whole ? size : std::min(promised, size)));
    outcome = unpack_in_steps(*make_unpacker(compression), packed, size, promised, out);
  }
  if (end == ChunkEnd::Early && outcome == UnpackStep::Broken)
    throw Error(ErrorCode::Format, where, say::bag_packed_message_damaged(Bytes{out.size()}));
  if (end == ChunkEnd::Whole && (outcome == UnpackStep::Broken || out.size() != size))
    throw Error(ErrorCode::Format, where, say::bag_packed_chunk_damaged(out.size(), Bytes{size}));
  return out;
}

std::string pack_chunk(ChunkCompression compression, std::string_view bytes) {
  std::string packed;
  switch (compression) {
    case ChunkCompression::None:
      return std::string(bytes);
    case ChunkCompression::Bzip2:
      return pack_bzip2(bytes);
    case ChunkCompression::Lz4: {
      // ROS's own decoder knows no other kind of frame.
      LZ4F_preferences_t preferences{};
      preferences.frameInfo.blockSizeID = LZ4F_max1MB;
      preferences.frameInfo.blockMode = LZ4F_blockIndependent;
      preferences.frameInfo.contentChecksumFlag = LZ4F_contentChecksumEnabled;
      packed.resize(LZ4F_compressFrameBound(bytes.size(), &preferences));
      const std::size_t length =
          LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), &preferences);
      if (LZ4F_isError(length)) cannot_pack();
      packed.resize(length);
      return packed;
    }
    case ChunkCompression::Zstd: {
      packed.resize(ZSTD_compressBound(bytes.size()));
      const std::size_t length = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1);
      if (ZSTD_isError(length)) cannot_pack();
      packed.resize(length);
      return packed;
    }
  }
  return packed;
}

}  // namespace remount::bags

#include "model/io/bag/chunk_codec.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "algorithms/core/error.h"

namespace remount {
namespace {

constexpr std::size_t kStepBytes = std::size_t{1} << 20;

enum class Step { More, Done, Broken };

/// Gives `step` room for a piece of output at a time until it is done, has nothing more to read, or `size` is reached.
/// step(packed, room): advances `packed`, says in `room` how much it wrote.
template <class OneStep>
Step unpack_in_steps(std::string_view packed, std::uint64_t size, std::string& out, OneStep&& step) {
  while (out.size() < size) {
    const std::size_t before = out.size();
    std::size_t room = static_cast<std::size_t>(std::min<std::uint64_t>(kStepBytes, size - before));
    const std::size_t left = packed.size();
    out.resize(before + room);
    const Step outcome = step(packed, out.data() + before, room);
    out.resize(before + room);
    if (outcome != Step::More) return outcome;
    if (room == 0 && packed.size() == left) return Step::Broken;  // neither read nor written: cut off
  }
  return Step::Done;
}

Step unpack_bzip2(std::string_view packed, std::uint64_t size, std::string& out) {
  bz_stream stream{};
  if (BZ2_bzDecompressInit(&stream, 0, 0) != BZ_OK) throw std::bad_alloc();
  const std::unique_ptr<bz_stream, int (*)(bz_stream*)> guard(&stream, BZ2_bzDecompressEnd);
  return unpack_in_steps(packed, size, out, [&](std::string_view& in, char* to, std::size_t& room) {
    const auto given = static_cast<unsigned>(std::min<std::size_t>(in.size(), std::numeric_limits<unsigned>::max()));
    stream.next_in = const_cast<char*>(in.data());
    stream.avail_in = given;
    stream.next_out = to;
    stream.avail_out = static_cast<unsigned>(room);
    const int code = BZ2_bzDecompress(&stream);
    in.remove_prefix(given - stream.avail_in);
    room -= stream.avail_out;
    return code == BZ_OK ? Step::More : code == BZ_STREAM_END ? Step::Done : Step::Broken;
  });
}

Step unpack_lz4(std::string_view packed, std::uint64_t size, std::string& out) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION))) throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> guard(context, LZ4F_freeDecompressionContext);
  return unpack_in_steps(packed, size, out, [&](std::string_view& in, char* to, std::size_t& room) {
    std::size_t read = in.size();
    const std::size_t hint = LZ4F_decompress(context, to, &room, in.data(), &read, nullptr);
    if (LZ4F_isError(hint)) {
      room = 0;
      return Step::Broken;
    }
    in.remove_prefix(read);
    return hint == 0 ? Step::Done : Step::More;
  });
}

Step unpack_zstd(std::string_view packed, std::uint64_t size, std::string& out) {
  const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(), ZSTD_freeDCtx);
  if (!context) throw std::bad_alloc();
  const unsigned long long promised = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (promised != ZSTD_CONTENTSIZE_UNKNOWN && promised != ZSTD_CONTENTSIZE_ERROR)
    out.reserve(static_cast<std::size_t>(std::min<std::uint64_t>(promised, size)));
  return unpack_in_steps(packed, size, out, [&](std::string_view& in, char* to, std::size_t& room) {
    ZSTD_inBuffer input{in.data(), in.size(), 0};
    ZSTD_outBuffer output{to, room, 0};
    const std::size_t hint = ZSTD_decompressStream(context.get(), &output, &input);
    room = output.pos;
    in.remove_prefix(input.pos);
    if (ZSTD_isError(hint)) return Step::Broken;
    return hint == 0 && in.empty() ? Step::Done : Step::More;  // several frames may follow each other
  });
}

[[noreturn]] void cannot_pack() { throw Error(ErrorCode::Contract, "", "a chunk cannot be compressed"); }

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
  throw Error(ErrorCode::Unsupported, where,
              "a chunk is compressed with '" + std::string(name.substr(0, 40)) + "', expected none, bz2, lz4 or zstd");
}

std::string unpack_chunk(ChunkCompression compression, std::string_view packed, std::uint64_t size, ChunkEnd end,
                         const std::string& where) {
  std::string out;
  // Growing step by step would take it twice.
  if (end == ChunkEnd::Whole && compression != ChunkCompression::None) out.reserve(static_cast<std::size_t>(size));
  Step outcome = Step::Done;
  switch (compression) {
    case ChunkCompression::None:
      out = packed.substr(0, static_cast<std::size_t>(std::min<std::uint64_t>(packed.size(), size)));
      break;
    case ChunkCompression::Bzip2:
      outcome = unpack_bzip2(packed, size, out);
      break;
    case ChunkCompression::Lz4:
      outcome = unpack_lz4(packed, size, out);
      break;
    case ChunkCompression::Zstd:
      outcome = unpack_zstd(packed, size, out);
      break;
  }
  if (end == ChunkEnd::Whole && (outcome == Step::Broken || out.size() != size))
    throw Error(ErrorCode::Format, where,
                "the compressed chunk is damaged: " + std::to_string(out.size()) + " of " + std::to_string(size) +
                    " bytes can be unpacked");
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

}  // namespace remount

#include "model/formats/packets/index_store.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "messages/captures.h"
#include "messages/stages.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/sha256.h"
#include "model/formats/packets/kept_index.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kIndexEnding = ".index";

/// Of the index of a capture: a packet takes a dozen of the thousand bytes that it has there.
std::uint64_t most_index_bytes(std::uint64_t capture_bytes) {
  constexpr std::uint64_t kOfNames = 1U << 16U, kShare = 32;
  return kOfNames + capture_bytes / kShare;
}

bool keeps(const IndexStore& store, const RandomAccessFile& file) {
  return !store.folder.empty() && file.size() >= store.least_bytes;
}

std::string payload_at(const RandomAccessFile& file, const SensorPackets& sensor, const IndexedPacket& packet) {
  const DatagramPiece whole{packet.offset, packet.bytes};
  return packet.pieces == 1 ? read_payload(file, &whole, 1)
                            : read_payload(file, &sensor.pieces[packet.offset], packet.pieces);
}

/// Whether some packets, evenly drawn, are in the capture what the index says of them.
bool fits(const RandomAccessFile& file, const SensorPackets& sensor) {
  constexpr std::size_t kDrawn = 32;
  const std::size_t count = sensor.packets.size(), drawn = std::min(count, kDrawn);
  const std::uint32_t places = sensor.decoder->places();
  const auto beyond = [&](const IndexedPacket& packet) {
    return packet.first_place >= places || packet.last_place >= places;
  };
  if (std::ranges::any_of(sensor.packets, beyond)) return false;
  for (std::size_t i = 0; i < drawn; ++i) {
    const IndexedPacket& packet = sensor.packets[drawn == 1 ? 0 : i * (count - 1) / (drawn - 1)];
    const std::string payload = payload_at(file, sensor, packet);
    const auto glance = sensor.decoder->glance(payload);
    if (!glance) return false;
    IndexedPacket now = indexed_packet(*glance, payload.size());
    now.host_ns = packet.host_ns, now.offset = packet.offset, now.pieces = packet.pieces;
    if (now != packet) return false;
  }
  return true;
}

/// Throws Error where it is not to be used.
IndexedCapture take_up_kept(const fs::path& path, const RandomAccessFile& file, const fs::path& kept) {
  const std::string where = kept.string();
  KeptIndex index = read_kept_index(read_regular_file(kept, most_index_bytes(file.size())), where);
  if (index.capture != state_of(path)) throw Error(ErrorCode::Format, where, say::kept_index_old());
  IndexedCapture capture{PacketIndexing(path), index.counts, {}};
  capture.indexing.take_up(std::move(index.passed), [&](const RoutePackets& route) {
    return read_payload(file, route.told_by.data(), route.told_by.size());
  });
  const PassedPackets& passed = capture.indexing.passed();
  if (known_sensors(passed) != index.sensors) throw Error(ErrorCode::Format, where, say::kept_index_beside());
  for (const auto& [key, route] : passed.routes)
    if (route.sensor.decoder ? !fits(file, route.sensor) : !route.sensor.packets.empty())
      throw Error(ErrorCode::Format, where, say::kept_index_contradicts());
  return capture;
}

/// What a program that was ended while it saved an index has left: NAME.index.a1b2c3.
bool is_left_behind(const fs::path& file, fs::file_time_type used) {
  constexpr auto kLongest = std::chrono::hours(24);
  return file.stem().extension() == kIndexEnding && fs::file_time_type::clock::now() - used > kLongest;
}

/// Those used last stay. Nothing of it is an error: another program may clear the folder at the same time.
void leave_room(const IndexStore& store, const fs::path& newest) {
  struct Kept {
    fs::file_time_type used;
    fs::path path;
    std::uint64_t bytes = 0;
  };
  std::vector<Kept> all;
  std::uint64_t sum = 0;
  for (const fs::path& file : files_in(store.folder)) {
    std::error_code gone;
    Kept kept{fs::last_write_time(file, gone), file, 0};
    if (!gone && is_left_behind(file, kept.used)) fs::remove(file, gone);
    if (file.extension() != kIndexEnding) continue;
    if (!gone) kept.bytes = fs::file_size(file, gone);
    if (gone) continue;
    sum += kept.bytes;
    if (file != newest) all.push_back(std::move(kept));
  }
  std::ranges::sort(all, {}, &Kept::used);
  for (const Kept& kept : all) {
    if (sum <= store.most_bytes) break;
    std::error_code not_removed;
    if (fs::remove(kept.path, not_removed) || !not_removed) sum -= kept.bytes;
  }
}

/// What is cached is read back by its user alone: receivers say where the vehicle was.
void make_own_folder(const fs::path& folder) {
  std::error_code ignored;
  const bool there = fs::exists(folder, ignored);
  make_directories(folder);
  if (!there) fs::permissions(folder, fs::perms::owner_all, ignored);
}

/// @param before how the capture was before it was read: one that is still written is not kept
Message keep(const fs::path& path, const FileState& before, const IndexedCapture& capture, const fs::path& kept,
             const IndexStore& store) {
  try {
    if (state_of(path) != before) return say::kept_index_growing();
    const std::string bytes = kept_index_bytes(before, capture.counts, capture.indexing.passed());
    if (bytes.size() > most_index_bytes(before.bytes)) return {};
    make_own_folder(store.folder);
    write_file(kept, bytes);
  } catch (const Error& error) {
    return say::kept_index_unsaved(error.message());
  }
  try {
    leave_room(store, kept);
  } catch (const Error&) {  // the folder cannot be listed: the index is kept all the same
  }
  return {};
}

IndexedCapture pass_through(const fs::path& path, const RandomAccessFile& file, Progress& progress) {
  IndexedCapture capture{PacketIndexing(path), {}, {}};
  capture.counts = visit_datagrams(
      file, [&](const Datagram& datagram) { capture.indexing.take(datagram); }, progress);
  return capture;
}

}  // namespace

IndexStore users_index_store() {
  const auto folder_in = [](const char* variable) -> fs::path {
    const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nothing of ours sets variables
    const fs::path folder = value == nullptr ? "" : value;
    return folder.is_absolute() ? folder : fs::path();  // as the specification of XDG_CACHE_HOME demands
  };
  IndexStore store;
  if (const fs::path cache = folder_in("XDG_CACHE_HOME"); !cache.empty())
    store.folder = cache / "remount" / "captures";
  else if (const fs::path home = folder_in("HOME"); !home.empty())
    store.folder = home / ".cache" / "remount" / "captures";
  return store;
}

fs::path kept_index_file(const fs::path& capture, const IndexStore& store) {
  constexpr std::size_t kDigits = 32;
  Sha256 hash;
  hash.update(fs::absolute(capture).lexically_normal().string());
  return store.folder / (hash.finish().substr(0, kDigits) + std::string(kIndexEnding));
}

IndexedCapture index_once(const fs::path& path, const RandomAccessFile& file, const IndexStore& store,
                          Progress& progress) {
  if (!keeps(store, file)) return pass_through(path, file, progress);
  const fs::path kept = kept_index_file(path, store);
  Message why_not;
  try {
    if (is_file(kept)) {
      progress.report(say::stage_reading_packets, 0, file.size() >> 20U);
      IndexedCapture capture = take_up_kept(path, file, kept);
      std::error_code ignored;
      fs::last_write_time(kept, fs::file_time_type::clock::now(), ignored);
      return capture;
    }
  } catch (const Error& error) {
    why_not = say::kept_index_unused(error.what_happened());
  } catch (const std::exception&) {  // no memory for what it claims to hold, or a folder that goes away
    why_not = say::kept_index_unused(say::kept_index_damaged());
  }
  const FileState before = state_of(path);
  IndexedCapture capture = pass_through(path, file, progress);
  capture.remark = std::move(why_not);
  if (progress.cancelled()) return capture;
  if (Message unsaved = keep(path, before, capture, kept, store); !unsaved.empty()) capture.remark = std::move(unsaved);
  return capture;
}

}  // namespace remount::formats

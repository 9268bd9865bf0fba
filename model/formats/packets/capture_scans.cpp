#include "model/formats/packets/capture_scans.h"

#include <algorithm>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/packets/files_beside.h"
#include "model/formats/packets/packet_times.h"
#include "model/formats/packets/sensor_clock.h"

namespace remount::formats {

PacketScanSource::PacketScanSource(std::shared_ptr<const PacketFile> file, SensorPackets sensor,
                                   std::vector<PacketScan> scans)
    : TimedScanSource(TimesOfPoints::Required),
      file_(std::move(file)),
      sensor_(std::move(sensor)),
      scans_(std::move(scans)) {}

const PacketScan& PacketScanSource::at(std::size_t scan) const {
  if (scan >= scans_.size())
    throw Error(
        ErrorCode::Contract, "",
        Message::verbatim("scan " + std::to_string(scan) + " of " + std::to_string(scans_.size()) + " does not exist"));
  return scans_[scan];
}

std::string PacketScanSource::name(std::size_t scan) const {
  return file_->name().filename().string() + ": " + name_of(sensor_) + ", scan " + std::to_string(scan + 1);
}

/// By the packet behind, or the one before where that is missing.
double PacketScanSource::places_per_s(std::size_t packet) const {
  constexpr std::int64_t kNear_ns = 10'000'000;
  const std::uint32_t turn = sensor_.decoder->places();
  for (const std::size_t second : {packet + 1, packet}) {
    if (second == 0 || second >= sensor_.packets.size()) continue;
    const std::size_t first = second - 1;
    const IndexedPacket &a = sensor_.packets[first], &b = sensor_.packets[second];
    const std::int64_t step_ns = b.time_ns - a.time_ns;
    if (step_ns <= 0 || step_ns > kNear_ns) continue;
    return (b.first_place + turn - a.first_place) % turn / (1e-9 * static_cast<double>(step_ns));
  }
  return 0.0;
}

ReadCloud PacketScanSource::read(std::size_t scan) const {
  const PacketScan& its = at(scan);
  ReadCloud read;
  std::string before;
  file_->read(sensor_, its.first, its.last, [&](std::size_t i, std::string bytes) {
    const IndexedPacket& packet = sensor_.packets[i];
    const PacketColumns columns{i == its.first ? its.first_column : 0,
                                i == its.last ? its.end_column : PacketDecoder::kAllColumns};
    const PacketSurroundings around{1e-9 * static_cast<double>(packet.time_ns - its.stamp_ns), places_per_s(i), before};
    sensor_.decoder->decode(bytes, columns, around, read.cloud);
    before = std::move(bytes);
  });
  read.columns = "x y z intensity";
  if (!read.cloud.ring.empty()) read.columns += " ring";
  read.columns += " time";
  return read;
}

std::vector<std::string> sensor_names(const PacketIndex& index) {
  std::vector<std::string> names;
  for (const SensorPackets& sensor : index.sensors)
    names.push_back(name_of(sensor) + " (" + sensor.decoder->model() + ")");
  return names;
}

Error why_no_lidar(const PacketIndex& index, const std::string& where) {
  constexpr std::size_t kMostNamed = 10;
  if (!index.refused.empty()) return index.refused.front();
  std::vector<std::string> others;
  for (const auto& [route, count] : index.others)
    if (others.size() < kMostNamed) others.push_back(to_string(route));
  const CaptureCounts& counts = index.counts;
  const auto unsupported = [&](Message what) { return Error(ErrorCode::Unsupported, where, std::move(what)); };
  if (!others.empty()) return unsupported(say::capture_no_lidar(others));
  if (counts.frames == 0) return unsupported(say::capture_empty());
  if (counts.truncated > 0 && counts.datagrams == 0) return unsupported(say::capture_no_whole(counts.truncated));
  if (counts.unknown_link > 0 && counts.datagrams == 0) return unsupported(say::capture_unknown_link());
  return unsupported(say::capture_no_datagrams());
}

std::size_t choose_sensor(const PacketIndex& index, const std::string& asked, const std::string& where) {
  if (index.sensors.empty()) throw why_no_lidar(index, where);
  std::vector<std::size_t> meant;
  for (std::size_t i = 0; i < index.sensors.size(); ++i) {
    const SensorPackets& sensor = index.sensors[i];
    const DatagramRoute& route = sensor.route;
    const bool part = sensor.name.empty() && route.topic.empty() &&
                      (asked == address_text(route) || asked == std::to_string(route.port));
    if (asked.empty() || asked == name_of(sensor) || part) meant.push_back(i);
  }
  if (meant.size() == 1) return meant.front();
  if (!asked.empty() && meant.empty())
    throw Error(ErrorCode::Unsupported, where, say::capture_no_such_sensor(asked, sensor_names(index)));
  throw Error(ErrorCode::Unsupported, where, say::capture_several_sensors(sensor_names(index)));
}

namespace {

std::vector<PacketScan> ascending(const std::vector<PacketScan>& scans, const std::string& where,
                                  std::vector<drive::Finding>& findings) {
  std::vector<drive::IndexedScan> stamps;
  for (std::size_t i = 0; i < scans.size(); ++i) stamps.push_back({i, scans[i].stamp_ns});
  drive::keep_ascending(stamps, "scan", where, findings);
  std::vector<PacketScan> kept;
  for (const drive::IndexedScan& stamp : stamps) kept.push_back(scans[stamp.index]);
  return kept;
}

/// Of no packet: by what other clock the recording has.
Message why_no_date(const SensorPackets& sensor) {
  if (!sensor.route.topic.empty()) return say::capture_no_date_of_recorder();
  return sensor.name.empty() ? say::capture_no_date_of_host() : say::capture_no_date();
}

/// Neither the sensor's clock nor that of a host: nothing ties the times to those of others. Where some packets have a
/// date, the others are left out: their times are not those of the same drive.
void leave_out_undated(SensorPackets& sensor, const std::string& where, std::vector<drive::Finding>& findings) {
  std::vector<IndexedPacket>& packets = sensor.packets;
  const auto undated = [](const IndexedPacket& packet) { return !has_date(packet.time_ns); };
  const std::size_t all = packets.size();
  const auto count = static_cast<std::size_t>(std::count_if(packets.begin(), packets.end(), undated));
  if (count == 0) return;
  findings.push_back(drive::make_finding(drive::Severity::Warning, "capture-no-date", where,
                                         count < all ? say::capture_no_date_before(count, all) : why_no_date(sensor)));
  if (count < all) std::erase_if(packets, undated);
}

/// Where many are no packets of the sensor, it was set otherwise on the way, and a part of the drive may be missing.
void report_unused(const SensorPackets& packets, const std::string& where, std::vector<drive::Finding>& findings) {
  constexpr std::size_t kFewInHundred = 1;
  if (packets.of_others > 0)
    findings.push_back(drive::make_finding(drive::Severity::Note, "capture-other-sensors", where,
                                           say::capture_other_sensors(packets.of_others)));
  if (packets.foreign == 0) return;
  const bool many = 100 * packets.foreign > kFewInHundred * (packets.packets.size() + packets.foreign);
  findings.push_back(drive::make_finding(many ? drive::Severity::Warning : drive::Severity::Note, "capture-foreign",
                                         where, say::capture_foreign(packets.foreign, packets.decoder->model())));
}

/// Sensors that would be read if something did not lack: nobody misses what is not named.
void report_refused(const PacketIndex& index, std::vector<drive::Finding>& findings) {
  for (const Error& refused : index.refused)
    findings.push_back(drive::make_finding(drive::Severity::Warning, "capture-refused", refused.where(),
                                           say::capture_refused(refused.what_happened())));
}

/// Whether the name of a file says that it is of the one sensor and not of the other.
bool told_apart(const std::filesystem::path& file, const SensorPackets& one, const SensorPackets& other) {
  const bool other_device = one.route.address != other.route.address || one.route.topic != other.route.topic;
  return other_device && names_address(file, one.route);
}

/// What lies beside the packets, or is said in the recording, and serves several of its sensors can be of one alone.
void report_shared(const SourceBeside& source, const PacketIndex& index, const SensorPackets& packets,
                   const std::string& where, std::vector<drive::Finding>& findings) {
  std::vector<std::string> others;
  bool same_address = false;
  for (const SensorPackets& sensor : index.sensors) {
    if (!sensor.decoder || sensor.decoder == packets.decoder) continue;
    if (!source.said && told_apart(source.name, packets, sensor)) continue;
    const auto same = [&](const SourceBeside& its) { return its.name == source.name && its.said == source.said; };
    if (std::ranges::none_of(sensor.decoder->sources_beside(), same)) continue;
    others.push_back(name_of(sensor));
    same_address = same_address || sensor.route.address == packets.route.address;
  }
  if (others.empty()) return;
  const std::string name = source.said ? source.name.string() : source.name.filename().string(),
                    own = address_text(packets.route) + source.ending;
  findings.push_back(drive::make_finding(drive::Severity::Warning, "capture-angles", where,
                                         source.said || !packets.route.topic.empty()
                                             ? say::capture_shared_topics(name, std::move(others), own)
                                         : same_address ? say::capture_shared_address(name, std::move(others))
                                                        : say::capture_shared_file(name, std::move(others), own)));
}

}  // namespace

std::shared_ptr<const PacketScanSource> take_scans(PacketIndex& index, std::size_t sensor, drive::Session& session) {
  SensorPackets packets = std::move(index.sensors[sensor]);
  const std::string file = index.file->name().string(), where = file + ": " + name_of(packets);
  report_counts(index.counts, file, session.findings);
  if (!index.remark.empty())
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "capture-index", file, index.remark));
  packets.foreign += settle_second_parts(packets.packets);
  report_unused(packets, where, session.findings);
  report_refused(index, session.findings);
  const std::vector<SourceBeside> sources = packets.decoder->sources_beside();
  for (const SourceBeside& source : sources)
    if (!source.said) session.files.push_back(source.name);
  if (Message remark = packets.decoder->remark(); !remark.empty())
    session.findings.push_back(
        drive::make_finding(drive::Severity::Warning, "capture-angles", where, std::move(remark)));
  for (const SourceBeside& source : sources)
    if (!source.of_this_sensor) report_shared(source, index, packets, where, session.findings);
  const auto receiver = index.receivers.find(packets.route.address);
  settle_clock(packets.packets,
               receiver == index.receivers.end() ? std::vector<SensorReceiver::State>{} : receiver->second.states,
               where, session.findings);
  leave_out_undated(packets, where, session.findings);
  const PacketSequence sequence = order_packets(packets.packets, packets.decoder->places(), where, session.findings);
  if (sequence.falls && !packets.decoder->decodes_falling())
    throw Error(ErrorCode::Unsupported, where, say::capture_turns_back(packets.decoder->model()));
  packets.decoder->tune(sequence, where);
  std::vector<PacketScan> scans =
      ascending(cut_scans(packets.packets, packets.decoder->places()), where, session.findings);
  auto source = std::make_shared<PacketScanSource>(index.file, std::move(packets), std::move(scans));
  session.scans = source;
  session.scan_timing = drive::ScanTiming::PerPoint;
  session.times_count = drive::TimesCount::Forwards;
  return source;
}

}  // namespace remount::formats

#include "model/formats/packets/packet_scans.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include "algorithms/core/median.h"
#include "messages/captures.h"
#include "model/drive/bad_items.h"

namespace remount::formats {

namespace {

constexpr std::int64_t kLongGap_ns = 100'000'000;
/// The slowest sensors turn five times a second; one that stands still makes no scan of a whole drive.
constexpr std::int64_t kLongestScan_ns = 1'000'000'000;

/// Where packets do not follow each other as usual.
struct PacketGap {
  std::uint32_t place = 0;  ///< in the turn, of the packet before
  std::size_t missing = 0;
};

/// A sensor that looks at a part of the turn is silent at the same place of each.
bool of_the_field(const std::vector<PacketGap>& gaps, std::size_t i, std::uint32_t places) {
  const auto alike = [&](std::size_t other) {
    const std::uint32_t apart = (gaps[i].place + places - gaps[other].place) % places;
    const std::size_t longer = std::max(gaps[i].missing, gaps[other].missing),
                      shorter = std::min(gaps[i].missing, gaps[other].missing);
    return std::min(apart, places - apart) < places / 36 && longer > 2 && 5 * (longer - shorter) <= longer;
  };
  return (i > 0 && alike(i - 1)) || (i + 1 < gaps.size() && alike(i + 1));
}

std::size_t count_missing(const std::vector<IndexedPacket>& packets, std::int64_t interval_ns, std::uint32_t places) {
  constexpr std::int64_t kPause_ns = 10'000'000'000;  // a recording that was interrupted misses nothing
  std::vector<PacketGap> gaps;
  if (interval_ns <= 0 || interval_ns >= kPause_ns) return 0;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    const std::int64_t step_ns = packets[i].time_ns - packets[i - 1].time_ns;
    if (step_ns < kPause_ns && 2 * step_ns > 3 * interval_ns)
      gaps.push_back(
          {packets[i - 1].last_place, static_cast<std::size_t>((step_ns + interval_ns / 2) / interval_ns - 1)});
  }
  std::size_t missing = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (!of_the_field(gaps, i, places)) missing += gaps[i].missing;
  return missing;
}

/// Where most pairs of steps take the same time, half of it: of two returns, packets of an odd number of blocks begin
/// one column and two columns behind each other in turn.
std::int64_t usual_interval_ns(const std::vector<IndexedPacket>& packets) {
  std::vector<std::int64_t> steps_ns, pairs_ns;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    steps_ns.push_back(packets[i].time_ns - packets[i - 1].time_ns);
    if (i > 1) pairs_ns.push_back(packets[i].time_ns - packets[i - 2].time_ns);
  }
  if (pairs_ns.empty()) return steps_ns.empty() ? 0 : steps_ns.front();
  const std::int64_t pair_ns = median_of(pairs_ns);
  const auto alike =
      std::ranges::count_if(pairs_ns, [&](std::int64_t its_ns) { return std::abs(its_ns - pair_ns) <= pair_ns / 10; });
  const bool most = 2 * static_cast<std::size_t>(alike) > pairs_ns.size();
  return most ? pair_ns / 2 : median_of(std::move(steps_ns));
}

/// The longest step of places from a packet to the next that is none over a gap. Packets follow each other by their own
/// columns, which of a short turn (512 columns) are more than ten degrees; columns far from each other within a packet
/// are of a sensor that looks at a part of the turn.
std::uint32_t longest_step(const IndexedPacket& packet, std::uint32_t places) {
  const bool rising = packet.cut_column == 0 && packet.last_place >= packet.first_place;
  const std::uint32_t own = rising ? packet.last_place - packet.first_place + 1 : 0;
  return std::max(places / 36, std::min(own, places / 16));
}

/// Steps of place and time from one packet to the next of the same frame, where neither is a gap.
template <class Take>
void visit_steps(const std::vector<IndexedPacket>& packets, std::uint32_t places, const Take& take) {
  constexpr std::int64_t kNearPacket_ns = 10'000'000;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    const std::int64_t step_ns = packets[i].time_ns - packets[i - 1].time_ns;
    if (step_ns <= 0 || step_ns > kNearPacket_ns || packets[i].frame != packets[i - 1].frame) continue;
    const std::uint32_t ahead = (packets[i].first_place + places - packets[i - 1].first_place) % places;
    const std::int64_t step = ahead > places / 2 ? std::int64_t{ahead} - places : std::int64_t{ahead};
    if (std::abs(step) <= longest_step(packets[i - 1], places)) take(step, step_ns);
  }
}

bool places_fall(const std::vector<IndexedPacket>& packets, std::uint32_t places) {
  std::int64_t falling = 0;
  visit_steps(packets, places, [&](std::int64_t step, std::int64_t) { falling += step < 0 ? 1 : step > 0 ? -1 : 0; });
  return falling > 0;
}

/// How many places the sensor passes from the begin of a frame to that of the next. The first frame may not be whole.
double places_in_turn(const std::vector<IndexedPacket>& packets, std::uint32_t places) {
  std::vector<double> turns_ns, per_ns;
  std::optional<std::int64_t> began_ns;
  for (std::size_t i = 1; i < packets.size(); ++i) {
    if (packets[i].frame == 0 || packets[i].frame == packets[i - 1].frame) continue;
    if (began_ns) turns_ns.push_back(static_cast<double>(packets[i].time_ns - *began_ns));
    began_ns = packets[i].time_ns;
  }
  visit_steps(packets, places, [&](std::int64_t step, std::int64_t step_ns) {
    per_ns.push_back(static_cast<double>(step) / static_cast<double>(step_ns));
  });
  return turns_ns.empty() || per_ns.empty() ? 0.0 : median_of(std::move(turns_ns)) * median_of(std::move(per_ns));
}

}  // namespace

PacketSequence order_packets(std::vector<IndexedPacket>& packets, std::uint32_t places, const std::string& where,
                             std::vector<drive::Finding>& findings) {
  const auto earlier = [](const IndexedPacket& a, const IndexedPacket& b) { return a.time_ns < b.time_ns; };
  if (!std::is_sorted(packets.begin(), packets.end(), earlier))
    std::stable_sort(packets.begin(), packets.end(), earlier);
  const std::size_t before = packets.size();
  packets.erase(std::unique(packets.begin(), packets.end(),
                            [](const IndexedPacket& a, const IndexedPacket& b) {
                              return a.time_ns == b.time_ns && a.first_place == b.first_place;
                            }),
                packets.end());
  const std::size_t repeated = before - packets.size();
  PacketSequence sequence{usual_interval_ns(packets), places_fall(packets, places), places_in_turn(packets, places)};
  for (IndexedPacket& packet : packets)
    if (sequence.falls)
      packet.first_place = places - 1 - packet.first_place, packet.last_place = places - 1 - packet.last_place;
  const std::size_t missing = count_missing(packets, sequence.interval_ns, places);
  const auto add = [&](drive::Severity severity, const char* code, Message what) {
    findings.push_back(drive::make_finding(severity, code, where, std::move(what)));
  };
  if (repeated > 0) add(drive::Severity::Note, "capture-repeated", say::capture_repeated(repeated, before));
  const bool many = 100 * missing > packets.size();
  if (missing > 0)
    add(many ? drive::Severity::Warning : drive::Severity::Note, "capture-missing",
        say::capture_missing(missing, packets.size() + missing));
  return sequence;
}

namespace {

bool begins_anew(const IndexedPacket& before, const IndexedPacket& packet, std::uint32_t places) {
  if (before.frame != 0 && packet.frame != 0) return before.frame != packet.frame;
  return before.last_place > packet.first_place + places / 36;
}

}  // namespace

std::vector<PacketScan> cut_scans(const std::vector<IndexedPacket>& packets, std::uint32_t places) {
  std::vector<PacketScan> scans;
  const auto begin = [&](std::size_t packet, std::uint32_t column, std::int64_t after_ns) {
    const auto place = static_cast<std::uint32_t>(packet);
    scans.push_back({place, place, column, PacketDecoder::kAllColumns, packets[packet].time_ns + after_ns});
  };
  for (std::size_t i = 0; i < packets.size(); ++i) {
    const IndexedPacket& packet = packets[i];
    const IndexedPacket* before = i == 0 ? nullptr : &packets[i - 1];
    const bool another = !before || begins_anew(*before, packet, places) ||
                         packet.time_ns - before->time_ns > kLongGap_ns ||
                         packet.time_ns - scans.back().stamp_ns > kLongestScan_ns;
    if (another) begin(i, 0, 0);
    scans.back().last = static_cast<std::uint32_t>(i);
    if (packet.cut_column == 0) continue;
    scans.back().end_column = packet.cut_column;
    begin(i, packet.cut_column, packet.cut_after_ns);
  }
  if (scans.empty()) return scans;
  std::vector<std::uint32_t> sizes;
  for (const PacketScan& scan : scans) sizes.push_back(scan.last - scan.first + 1);
  const double usual = median_of(sizes);
  const double first = sizes.front(), last = sizes.back();
  // Of one or two nobody can say which is whole.
  if (scans.size() > 2 && last < 0.9 * usual) scans.pop_back();
  if (scans.size() > 2 && first < 0.9 * usual) scans.erase(scans.begin());
  std::erase_if(scans, [&](const PacketScan& scan) { return scan.last - scan.first + 1 < 0.5 * usual; });
  return scans;
}

}  // namespace remount::formats

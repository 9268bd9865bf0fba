// What a make of LiDAR is to everybody else: packets to points.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/cloud/point_cloud.h"
#include "algorithms/messages/message.h"
#include "model/formats/packets/frames.h"

namespace remount::formats {

/// What the part of a second in a packet's time counts.
enum class SecondPart : std::uint8_t {
  Known,        ///< the same in all firmware of the sensor
  Either,       ///< microseconds, or nanoseconds of early firmware, which all packets of the sensor tell together
  Nanoseconds,  ///< of such a sensor, where they are too many to be microseconds
};

/// What a packet of points says of itself before it is decoded. Its columns are fired one after the other, each by all
/// lasers.
struct PacketGlance {
  /// Of the first column, by the sensor's clock; where SecondPart::Either says so, as if its part counted microseconds.
  std::int64_t sensor_time_ns = 0;
  SecondPart second_part = SecondPart::Known;
  /// Where the first column and the last stand in a turn, or in a frame of a sensor that does not turn: they rise, and
  /// begin anew with each. In [0, PacketDecoder::places()).
  std::uint32_t first_place = 0, last_place = 0;
  /// The first column of another turn, and its time since that of the first column; 0: all are of one.
  std::uint32_t cut_column = 0, cut_after_ns = 0;
  /// After how long the sensor's clock begins anew; 0: it has the date (Unix time).
  std::uint16_t clock_period_s = 0;
  /// Whether another clock sets the sensor's, where the packet or the sensor's metadata say.
  std::optional<bool> clock_follows;
  /// Of sensors that number their frames, by which scans are cut then: from 1. 0: this one does not.
  std::uint32_t frame = 0;
};

/// Columns of a packet: [first, end).
struct PacketColumns {
  std::uint32_t first = 0, end = 0;
};

/// What a packet does not say by itself.
struct PacketSurroundings {
  double time_from_stamp_s = 0.0;  ///< of the first column
  double places_per_s = 0.0;       ///< how fast the sensor turns here, by the packets around; 0: not known
  std::string_view before = {};    ///< the packet before it in the scan; empty: there is none
};

/// What the packets of a sensor tell together.
struct PacketSequence {
  std::int64_t interval_ns = 0;  ///< the usual time from one to the next; 0: there is one
  /// Whether places fall from packet to packet, as those of a sensor do that turns the other way where no packet shows
  /// it by itself. They are counted from the other end then.
  bool falls = false;
  double places_in_turn = 0.0;  ///< by how long the numbered frames take; 0: not known
};

/// What a recording says itself of its sensors, beside their packets: a topic of a bag with a file of the sensor.
struct SaidOfSensors {
  std::string topic;
  std::string bytes;
  std::string device;      ///< topics that begin so are of that sensor; empty: of no one in particular
  bool of_sensor = false;  ///< there are packets on a topic that begins so: it is of no other
};
/// Of a whole recording; null: nothing.
using SaidInRecording = std::shared_ptr<const std::vector<SaidOfSensors>>;

/// Where it stands what packets do not say of their sensor.
struct BesidePackets {
  std::filesystem::path recording;  ///< files in its folder are looked at
  DatagramRoute route;
  std::span<const SaidOfSensors> said = {};

  /// What was said on the topic of that name; null where that is a file. Files are known by their endings.
  const SaidOfSensors* said_on(const std::filesystem::path& topic) const;
};

/// A file beside packets, or what stands in its place, from which a decoder took what packets do not say.
struct SourceBeside {
  std::filesystem::path name;   ///< of the file, or of the topic on which the recording says it itself
  bool said = false;            ///< on a topic
  std::string ending;           ///< which a file in its place has: ".csv"
  bool of_this_sensor = false;  ///< the packets say that it is of this very sensor
};

/// Decodes the packets of one sensor. Thread-safe once it has looked beside them, and been described and tuned.
class PacketDecoder {
 public:
  static constexpr std::uint32_t kAllColumns = ~std::uint32_t{0};

  virtual ~PacketDecoder() = default;
  virtual std::string model() const = 0;     ///< "VLP-16"
  virtual std::uint32_t places() const = 0;  ///< in a turn
  /// Reads what packets do not say of their sensor from what stands beside them. Called once, before all below, with
  /// the packet by which the sensor was recognised. Throws Error at `where`, or of a file: it is not decoded then.
  virtual void look_beside(const BesidePackets& beside, std::string_view payload, const std::string& where) {
    static_cast<void>(beside), static_cast<void>(payload), static_cast<void>(where);
  }
  /// What it found there.
  virtual std::vector<SourceBeside> sources_beside() const { return {}; }
  /// Whether describe() throws without descriptions.
  virtual bool needs_description() const { return false; }
  /// Takes what the sensor says of itself (PositionPacket::description). Descriptions that have the same lasting part
  /// are one; there are several where the sensor's address has several sensors. Called once, before any packet is
  /// decoded. Throws Error(Unsupported) at `where` where packets cannot be decoded without.
  virtual void describe(const std::vector<std::string>& descriptions, const std::string& where) {
    static_cast<void>(descriptions), static_cast<void>(where);
  }
  /// A warning for users where the directions of its points may be wrong, as they are those of a data sheet, or those
  /// of a file or a description that may be of another sensor or setting; else empty.
  virtual Message remark() const { return {}; }
  /// Nothing for what is no packet of points of this sensor.
  virtual std::optional<PacketGlance> glance(std::string_view payload) const = 0;
  /// Whether it is a packet of this sensor all the same, of its IMU for example: it is passed over without a word.
  virtual bool has_no_points(std::string_view payload) const { return static_cast<void>(payload), false; }
  /// Whether it is a whole packet of points of another sensor, which sends from the same address to the same port.
  virtual bool is_of_another(std::string_view payload) const { return static_cast<void>(payload), false; }
  /// Adds the returns of some columns, in the frame that the sensor's ROS driver uses: z up, x ahead (where azimuths
  /// begin) and y left, of an Ouster the frame of its housing, of a Hesai y ahead and x to the right; with intensity,
  /// time, and ring (0 is the lowest) where the sensor has such.
  /// @param payload of which glance() gave something
  virtual void decode(std::string_view payload, const PacketColumns& columns, const PacketSurroundings& around,
                      cloud::PointCloud& cloud) const = 0;
  /// Whether it knows the times and directions of a sensor that turns the other way too (PacketSequence::falls).
  virtual bool decodes_falling() const { return false; }
  /// Called before any is decoded. Throws Error(Unsupported) at `where` where packets contradict what lies beside
  /// them.
  virtual void tune(const PacketSequence& packets, const std::string& where) {
    static_cast<void>(packets), static_cast<void>(where);
  }
};

/// What a sensor sends beside its points about its own clock and about the receiver it hangs on.
struct PositionPacket {
  bool clock_locked = false;  ///< the sensor's clock follows that receiver
  std::string sentences;      ///< NMEA, a line each; empty where there is none
  std::string description;    ///< what the sensor says of itself, for PacketDecoder::describe
  std::string lasting;        ///< what of it does not change with time
};

/// By the makes that are built in; nothing where it is none of any.
std::optional<PositionPacket> read_position(std::string_view payload);

/// The sentence of NMEA that a text begins with, as a line; empty where it begins with none.
std::string position_sentence(std::string_view text);

/// An entry of the list of makes.
struct PacketFormat {
  std::string_view id;
  /// The decoder for the sensor that sends such packets; null where this is no packet of points of this make. Throws
  /// Error(Unsupported) at `where` for a sensor of this make that is not decoded.
  std::unique_ptr<PacketDecoder> (*recognise)(std::string_view payload, const std::string& where);
  /// Null where the make sends no such packets.
  std::optional<PositionPacket> (*position)(std::string_view payload);
};

/// The makes that are built in. Adding one: a file beside velodyne_packets.cpp and a line in packet_formats.cpp.
const std::vector<PacketFormat>& packet_formats();

}  // namespace remount::formats

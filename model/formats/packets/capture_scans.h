// The scans of a LiDAR in a recording of its network packets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/drive/session.h"
#include "model/drive/topic_offer.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/packets/packet_index.h"
#include "model/formats/packets/packet_scans.h"

namespace remount::formats {

/// Reads the packets of a scan when it is asked for.
class PacketScanSource final : public TimedScanSource {
 public:
  PacketScanSource(std::shared_ptr<const PacketFile> file, SensorPackets sensor, std::vector<PacketScan> scans);
  std::size_t size() const override { return scans_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).stamp_ns; }
  std::string name(std::size_t scan) const override;
  ReadCloud read(std::size_t scan) const override;
  /// In the order of their times.
  const std::vector<IndexedPacket>& packets() const { return sensor_.packets; }
  /// The packet that a scan ends with.
  const IndexedPacket& last_packet(std::size_t scan) const { return sensor_.packets[at(scan).last]; }

 private:
  const PacketScan& at(std::size_t scan) const;
  double places_per_s(std::size_t packet) const;

  std::shared_ptr<const PacketFile> file_;
  SensorPackets sensor_;
  std::vector<PacketScan> scans_;
};

/// "192.168.1.201:2368 (VLP-16)", of each sensor, for messages and lists.
std::vector<std::string> sensor_names(const PacketIndex& index);

/// Why a recording gives no scans: a sensor that is not decoded, or what it holds instead. Of one without sensors.
Error why_no_lidar(const PacketIndex& index, const std::string& where);

/// Which sensor is meant by its address and port, or by what of the two tells it from the others ("192.168.1.201",
/// "2368"); empty: the only one. Throws Error(Unsupported) at `where` that names all of them, and the error of
/// why_no_lidar where there is none.
std::size_t choose_sensor(const PacketIndex& index, const std::string& asked, const std::string& where);

/// Makes the sensor's scans those of the session, and says what is to be known of its packets. Throws
/// Error(Unsupported) where they contradict what lies beside them, or are of a sensor that turns the other way than its
/// decoder knows.
std::shared_ptr<const PacketScanSource> take_scans(PacketIndex& index, std::size_t sensor, drive::Session& session);

}  // namespace remount::formats

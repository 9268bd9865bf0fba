// The scans of a LiDAR in a capture of its network packets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/drive/session.h"
#include "model/drive/topic_offer.h"
#include "model/formats/clouds/timed_scans.h"
#include "model/formats/packets/capture_index.h"
#include "model/formats/packets/packet_scans.h"

namespace remount::formats {

/// Reads the packets of a scan when it is asked for.
class CaptureScanSource final : public TimedScanSource {
 public:
  CaptureScanSource(std::shared_ptr<const RandomAccessFile> file, SensorPackets sensor, std::vector<PacketScan> scans);
  std::size_t size() const override { return scans_.size(); }
  std::int64_t stamp_ns(std::size_t scan) const override { return at(scan).stamp_ns; }
  std::string name(std::size_t scan) const override;
  ReadCloud read(std::size_t scan) const override;

 private:
  const PacketScan& at(std::size_t scan) const;
  std::string payload(const IndexedPacket& packet) const;
  double places_per_s(std::size_t packet) const;

  std::shared_ptr<const RandomAccessFile> file_;
  SensorPackets sensor_;
  std::vector<PacketScan> scans_;
};

/// "192.168.1.201:2368 (VLP-16)", of each sensor, for messages and lists.
std::vector<std::string> sensor_names(const CaptureIndex& index);

/// Which sensor is meant by its address and port, or by what of the two tells it from the others ("192.168.1.201",
/// "2368"); empty: the only one. Throws Error(Unsupported) at `where` that names all of them, and Error(Format) where
/// there is none.
std::size_t choose_sensor(const CaptureIndex& index, const std::string& asked, const std::string& where);

/// Makes the sensor's scans those of the session, and says what is to be known of its packets. Throws
/// Error(Unsupported) where they contradict what lies beside the capture, or are of a sensor that turns the other way
/// than its decoder knows.
void take_scans(CaptureIndex& index, std::size_t sensor, drive::Session& session);

}  // namespace remount::formats

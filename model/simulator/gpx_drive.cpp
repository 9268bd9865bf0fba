// A GPX track of the GNSS antenna.
#include "algorithms/core/error.h"
#include "messages/simulation.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace fs = std::filesystem;

void write_gpx_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  const drive::Session& session = drive.session;
  if (session.gnss.empty()) throw Error(ErrorCode::Contract, "gpx", say::simulation_gpx_without_fixes());
  std::string track =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<gpx version=\"1.1\" creator=\"Remount\" "
      "xmlns=\"http://www.topografix.com/GPX/1/1\">\n<trk><name>" +
      session.name + "</name><trkseg>\n";
  for (const motion::GnssFix& fix : session.gnss) {
    std::string time = formats::format_date_ns(fix.stamp_ns);
    time[10] = 'T';
    track += "<trkpt lat=\"" + formats::exact_text(radians_to_degrees(fix.latitude_rad)) + "\" lon=\"" +
             formats::exact_text(radians_to_degrees(fix.longitude_rad)) + "\"><ele>" +
             formats::exact_text(fix.height_m) + "</ele><time>" + time + "Z</time></trkpt>\n";
  }
  formats::write_file(folder / "track.gpx", track + "</trkseg></trk>\n</gpx>\n");
  formats::write_file(folder / "lidar_odometry.txt", formats::tum_text(exact_odometry(drive)));
}

}  // namespace remount::simulator

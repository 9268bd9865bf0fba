// Poses of the INS as Apollo's GNSS driver records them.
#include <cstdio>

#include "algorithms/core/error.h"
#include "algorithms/geodesy/geodesy.h"
#include "messages/simulation.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/output_file.h"
#include "model/formats/sessions/native_session_writer.h"
#include "model/simulator/drive_formats.h"

namespace remount::simulator {

namespace fs = std::filesystem;

void write_apollo_drive(const SimulatedDrive& drive, const fs::path& folder, int, Progress&) {
  const std::vector<motion::InsSample>& ins = drive.session.ins;
  if (ins.empty()) throw Error(ErrorCode::Contract, "apollo-csv", say::simulation_no_ins_to_write());
  // NovAtel's types of a position: with whole ambiguities, and without.
  constexpr int kFixed = 56, kFloating = 55;
  const geodesy::UtmGrid grid(ins.front().latitude_rad, ins.front().longitude_rad);
  const Eigen::Quaterniond flu_from_rfu(drive::forward_left_up_from(drive::InsAxes::RightForwardUp).linear());
  std::string table = "timestamp,position_type,qw,qx,qy,qz,x,y,z\n";
  for (const motion::InsSample& sample : ins) {
    const geodesy::GridFix place = grid.project(sample.latitude_rad, sample.longitude_rad);
    const Eigen::Quaterniond turn = sample.enu_from_ins * flu_from_rfu;
    char head[48];
    std::snprintf(head, sizeof head, "%lld.%09lld,%d", static_cast<long long>(sample.stamp_ns / 1'000'000'000),
                  static_cast<long long>(sample.stamp_ns % 1'000'000'000),
                  sample.quality == motion::InsQuality::Degraded ? kFloating : kFixed);
    table += head;
    for (const double value :
         {turn.w(), turn.x(), turn.y(), turn.z(), place.easting_m, place.northing_m, sample.height_m})
      (table += ',') += formats::exact_text(value);
    table += '\n';
  }
  formats::write_file(folder / "ins.csv", table);
  formats::write_file(folder / "lidar.txt", formats::tum_text(exact_odometry(drive)));
}

}  // namespace remount::simulator

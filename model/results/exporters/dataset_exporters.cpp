// Calibration files that go from the INS to the LiDAR: KITTI and OpenCalib. Both hold the inverse of X.
#include <algorithm>
#include <array>

#include "algorithms/core/error.h"
#include "messages/exports.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/time_stamp.h"
#include "model/results/exporters/export_text.h"

namespace remount::results {

using formats::DocumentNode;

namespace {

/// "26-Sep-2011 13:02:25", as KITTI writes it: of the last scan of an accepted pair, so that the same result gives the
/// same bytes. No date where there is none, or where stamps count from the beginning of the recording.
std::string calibration_time(const ResultFile& result) {
  constexpr std::array<const char*, 12> kMonths{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  std::int64_t last_ns = 0;
  for (const PairRecord& pair : result.pairs)
    if (pair.state == motion::PairState::Accepted) last_ns = std::max(last_ns, pair.stamp_b_ns);
  if (last_ns < formats::kFirstRecording_ns) return "unknown";
  const std::string utc = formats::format_date_ns(last_ns);
  const std::size_t month = static_cast<std::size_t>(std::stoi(utc.substr(5, 2))) - 1;
  return utc.substr(8, 2) + "-" + kMonths.at(month) + "-" + utc.substr(0, 4) + utc.substr(10, 9);
}

class KittiExporter final : public Exporter {
 public:
  std::string_view id() const override { return "kitti"; }
  Message description() const override { return say::export_kitti(); }
  Message direction() const override { return say::export_direction_kitti(); }
  std::string_view file_name() const override { return "calib_imu_to_velo.txt"; }
  int strictness() const override { return 40; }
  std::string write(const ResultFile& result, const ExportNames&) const override {
    const RigidTransform lidar_from_ins = result.result.mounting.reference_from_sensor.inverse();
    const Eigen::Matrix3d r = lidar_from_ins.linear();
    const Eigen::Vector3d t = lidar_from_ins.translation();
    // Readers look for the lines they know by their names; those of notes are none of them.
    return "calib_time: " + calibration_time(result) + "\n" + comment_out(export_header(*this, result), "note: ") +
           "R: " + join({r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)}) +
           "\nT: " + join({t.x(), t.y(), t.z()}) + "\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    std::vector<double> r, t;
    formats::LineReader lines(text);
    for (std::string_view line; lines.next(line);) {
      if (line.starts_with("delta_f:")) throw Error(ErrorCode::Format, where, say::mounting_kitti_camera());
      if (line.starts_with("R:")) r = numbers_in(line.substr(2), where);
      if (line.starts_with("T:")) t = numbers_in(line.substr(2), where);
    }
    if (r.size() != 9 || t.size() != 3) throw Error(ErrorCode::Format, where, say::mounting_kitti_lines());
    return rigid_from_rows({r[0], r[1], r[2], t[0], r[3], r[4], r[5], t[1], r[6], r[7], r[8], t[2]}, where).inverse();
  }
};

class OpenCalibExporter final : public Exporter {
 public:
  std::string_view id() const override { return "opencalib"; }
  Message description() const override { return say::export_opencalib(); }
  Message direction() const override { return say::export_direction_opencalib(); }
  std::string_view file_name() const override { return "gnss-to-lidar-extrinsic.json"; }
  int strictness() const override { return 90; }
  std::string write(const ResultFile& result, const ExportNames& names) const override {
    // There is no room to say that the numbers are of other frames, and whoever reads them takes them for the INS's.
    const RigidTransform lidar_from_ins = result.result.mounting.ins_from_lidar().inverse();
    const std::string ins = names.ins_frame.empty() ? "gnss" : names.ins_frame;
    const std::string lidar = names.lidar_frame.empty() ? "lidar" : names.lidar_frame;
    DocumentNode root = DocumentNode::map();
    DocumentNode& entry = root.add(ins + "-to-" + lidar + "-extrinsic", DocumentNode::map());
    entry.add("param_type", DocumentNode::string("extrinsic"));
    entry.add("sensor_name", DocumentNode::string(ins));
    entry.add("target_sensor_name", DocumentNode::string(lidar));
    entry.add("device_type", DocumentNode::string("relational"));
    DocumentNode& parameters = entry.add("param", DocumentNode::map());
    DocumentNode& calibration = parameters.add("sensor_calib", DocumentNode::map());
    DocumentNode& data = calibration.add("data", DocumentNode::sequence());
    for (int row = 0; row < 4; ++row)
      data.add(DocumentNode::numbers(
          {lidar_from_ins(row, 0), lidar_from_ins(row, 1), lidar_from_ins(row, 2), lidar_from_ins(row, 3)}));
    calibration.add("continuous", DocumentNode::boolean(true));
    calibration.add("rows", DocumentNode::integer(4));
    calibration.add("type", DocumentNode::integer(6));
    calibration.add("cols", DocumentNode::integer(4));
    parameters.add("time_lag", DocumentNode::integer(0));
    return formats::to_json(root);
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const DocumentNode document = formats::parse_json(text, where);
    const auto entries = formats::DocumentView(document, where).entries();
    if (entries.empty()) throw Error(ErrorCode::Format, where, say::mounting_opencalib_entry());
    const formats::DocumentView& entry = entries.front().second;
    const auto names_lidar = [&](const char* key) {
      return entry.has(key) && formats::lower_case(entry.at(key).string()).find("lidar") != std::string::npos;
    };
    if (names_lidar("sensor_name") && !names_lidar("target_sensor_name"))
      entry.at("sensor_name").fail(say::mounting_opencalib_of_lidar());
    return formats::matrix_from_document(entry.at("param").at("sensor_calib").at("data")).inverse();
  }
};

}  // namespace

std::unique_ptr<Exporter> make_kitti_exporter() { return std::make_unique<KittiExporter>(); }
std::unique_ptr<Exporter> make_opencalib_exporter() { return std::make_unique<OpenCalibExporter>(); }

}  // namespace remount::results

// The example of an exporter in CONTRIBUTING.md, as it is compiled.
#include <gtest/gtest.h>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/examples.h"
#include "model/results/exporters/export_text.h"

namespace remount::results {
namespace {

class SixExporter final : public Exporter {
 public:
  std::string_view id() const override { return "six"; }
  Message description() const override { return say::export_six(); }
  Message direction() const override { return say::export_direction_six(); }
  std::string_view file_name() const override { return "ins_from_lidar.txt"; }
  int strictness() const override { return 5; }  // any six numbers
  std::string write(const ResultFile& result, const ExportNames&) const override {
    const RigidTransform& x = result.result.mounting.ins_from_lidar();
    const Eigen::Vector3d t = x.translation();
    const YawPitchRoll angles = exact_angles(x.linear());
    return comment_out(export_header(*this, result), "# ") +
           join({t.x(), t.y(), t.z(), radians_to_degrees(angles.yaw_rad), radians_to_degrees(angles.pitch_rad),
                 radians_to_degrees(angles.roll_rad)}) +
           "\n";
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const std::vector<double> numbers = numbers_in(text, where);
    std::array<double, 6> six{};
    if (numbers.size() != six.size()) throw Error(ErrorCode::Format, where, say::export_six_count(numbers.size()));
    std::copy(numbers.begin(), numbers.end(), six.begin());
    return rigid_from_typed(six, where, ErrorCode::Format);
  }
};

TEST(example_of_an_exporter, comes_back_as_it_was_written) {
  ResultFile file;
  file.result.status = calibration::Status::Ok;
  file.result.mounting.reference_from_sensor = rigid_from_six({1.2, -0.3, 1.9, 0.5, -0.02, 0.01});
  const SixExporter exporter;
  const std::string text = exporter.write(file, {});
  EXPECT_NE(text.find("# "), std::string::npos) << text;
  EXPECT_TRUE(exporter.read(text, "here").isApprox(file.result.mounting.reference_from_sensor, 1e-12)) << text;
}

TEST(example_of_an_exporter, refuses_another_number_of_values) {
  for (const char* text : {"", "1 2 3 4 5", "1 2 3 4 5 6 7"})
    EXPECT_THROW((void)SixExporter().read(text, "here"), Error) << text;
}

}  // namespace
}  // namespace remount::results

// The result file itself in either notation, and the plain 4x4 matrix.
#include "messages/exports.h"
#include "model/formats/documents/parse_document.h"
#include "model/results/exporters/export_text.h"
#include "model/results/exporters/several_exporter.h"

namespace remount::results {
namespace {

/// Of one LiDAR without a name its result, of named ones the vehicle.
formats::DocumentNode document_of_all(const VehicleFile& vehicle) {
  const bool one = vehicle.lidars.size() == 1 && vehicle.lidars.front().name.empty();
  return one ? result_document(vehicle.lidars.front().file) : vehicle_document(vehicle);
}

std::vector<NamedTransform> transforms_in(const formats::DocumentView& root) {
  if (root.at("format").string() != kVehicleFormat)
    return {{"", result_from_document(root).result.mounting.reference_from_sensor}};
  std::vector<NamedTransform> transforms;
  for (const LidarResult& lidar : vehicle_from_document(root).lidars)
    transforms.push_back({lidar.name, lidar.file.result.mounting.reference_from_sensor});
  return transforms;
}

/// The result file itself in either notation.
class ResultExporter : public SeveralExporter {
 public:
  Message direction() const override { return say::export_direction_result(); }
  int strictness() const override { return 0; }  // read_any_mounting knows results before all else
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const formats::DocumentNode document = parse(text, where);
    return result_from_document(formats::DocumentView(document, where)).result.mounting.reference_from_sensor;
  }
  std::vector<NamedTransform> read_all(std::string_view text, const std::string& where) const override {
    const formats::DocumentNode document = parse(text, where);
    return transforms_in(formats::DocumentView(document, where));
  }

 protected:
  virtual formats::DocumentNode parse(std::string_view text, const std::string& where) const = 0;
};

class YamlExporter final : public ResultExporter {
 public:
  std::string_view id() const override { return "yaml"; }
  Message description() const override { return say::export_yaml(); }
  std::string_view file_name() const override { return "remount-result.yaml"; }
  std::string write_all(const VehicleFile& vehicle, const ExportNames& names) const override {
    formats::DocumentNode document = document_of_all(vehicle);
    for (const std::string& line : export_header(*this, vehicle, names)) document.comment += line + "\n";
    return formats::to_yaml(document);
  }

 private:
  formats::DocumentNode parse(std::string_view text, const std::string& where) const override {
    return formats::parse_yaml(text, where, kVehicleLimits);
  }
};

class JsonExporter final : public ResultExporter {
 public:
  std::string_view id() const override { return "json"; }
  Message description() const override { return say::export_json(); }
  std::string_view file_name() const override { return "remount-result.json"; }
  std::string write_all(const VehicleFile& vehicle, const ExportNames&) const override {
    return formats::to_json(document_of_all(vehicle));
  }

 private:
  formats::DocumentNode parse(std::string_view text, const std::string& where) const override {
    return formats::parse_json(text, where, kVehicleLimits);
  }
};

class MatrixExporter final : public Exporter {
 public:
  std::string_view id() const override { return "matrix"; }
  Message description() const override { return say::export_matrix(); }
  Message direction() const override { return say::export_direction_matrix(); }
  std::string_view file_name() const override { return "ins_from_lidar.txt"; }
  int strictness() const override { return 20; }  // any twelve or sixteen numbers that are rigid
  std::string write(const ResultFile& result, const ExportNames&) const override {
    std::string text = comment_out(export_header(*this, result), "# ");
    const RigidTransform& x = result.result.mounting.reference_from_sensor;
    for (int row = 0; row < 4; ++row) text += join({x(row, 0), x(row, 1), x(row, 2), x(row, 3)}) + "\n";
    return text;
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    return rigid_from_rows(numbers_in(text, where), where);
  }
};

}  // namespace

std::unique_ptr<Exporter> make_yaml_exporter() { return std::make_unique<YamlExporter>(); }
std::unique_ptr<Exporter> make_json_exporter() { return std::make_unique<JsonExporter>(); }
std::unique_ptr<Exporter> make_matrix_exporter() { return std::make_unique<MatrixExporter>(); }

}  // namespace remount::results

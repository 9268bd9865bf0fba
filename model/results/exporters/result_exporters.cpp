// The result file itself in either notation, and the plain 4x4 matrix.
#include "messages/exports.h"
#include "model/formats/documents/parse_document.h"
#include "model/results/exporters/export_text.h"

namespace remount::results {
namespace {

constexpr formats::DocumentLimits kResultLimits{64U << 20U, 2000000, 32};

class YamlExporter final : public Exporter {
 public:
  std::string_view id() const override { return "yaml"; }
  Message description() const override { return say::export_yaml(); }
  Message direction() const override { return say::export_direction_result(); }
  std::string_view file_name() const override { return "remount-result.yaml"; }
  int strictness() const override { return 0; }  // read_any_mounting knows results before all else
  std::string write(const ResultFile& result, const ExportNames&) const override {
    formats::DocumentNode document = result_document(result);
    for (const std::string& line : export_header(*this, result)) document.comment += line + "\n";
    return formats::to_yaml(document);
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const formats::DocumentNode document = formats::parse_yaml(text, where, kResultLimits);
    return result_from_document(formats::DocumentView(document, where)).result.mounting.reference_from_sensor;
  }
};

class JsonExporter final : public Exporter {
 public:
  std::string_view id() const override { return "json"; }
  Message description() const override { return say::export_json(); }
  Message direction() const override { return say::export_direction_result(); }
  std::string_view file_name() const override { return "remount-result.json"; }
  int strictness() const override { return 0; }
  std::string write(const ResultFile& result, const ExportNames&) const override {
    return formats::to_json(result_document(result));
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    const formats::DocumentNode document = formats::parse_json(text, where, kResultLimits);
    return result_from_document(formats::DocumentView(document, where)).result.mounting.reference_from_sensor;
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

// What a result holds of the LiDAR's beams, for another calibration or the LiDAR's own.
#include "messages/exports.h"
#include "model/formats/documents/parse_document.h"
#include "model/results/beam_file.h"
#include "model/results/exporters/export_text.h"

namespace remount::results {
namespace {

const std::vector<std::string> kAllAround{
    "Point p of the LiDAR, at distance d from its z axis and range r, with elevation e (rad), range c (m)",
    "and scale s, each linear in z / d between the elevations given: x, y of p by -z e / d of themselves,",
    "z by d e, and all of p by c / r + s."};
const std::vector<std::string> kOverField{
    "Point p of the LiDAR, at distance d from its z axis and range r, with elevation e (rad), range c (m),",
    "azimuth a (rad) and scale s, each linear in the azimuth and in z / d between the four nodes around it: x, y",
    "of p by -z e / d of themselves and by (-y, x) a r / d, z by d e, and all of p by c / r + s."};

class BeamsExporter final : public Exporter {
 public:
  std::string_view id() const override { return "beams"; }
  Message description() const override { return say::export_beams(); }
  Message direction() const override { return say::export_direction_beams(); }
  std::string_view file_name() const override { return "beams.yaml"; }
  int strictness() const override { return 0; }
  bool holds_mounting() const override { return false; }
  std::string write(const ResultFile& result, const ExportNames&) const override {
    formats::DocumentNode document = beams_document(told_beams(result, ErrorCode::Contract, std::string(id())));
    for (const std::string& line : heading(result)) document.comment += line + "\n";
    return formats::to_yaml(document);
  }
  void require_own(std::string_view text, const std::string& where) const override {
    const formats::DocumentNode document = formats::parse_yaml(text, where);
    (void)beams_from_document(formats::DocumentView(document, where));
  }
  RigidTransform read(std::string_view text, const std::string& where) const override {
    require_own(text, where);
    throw Error(ErrorCode::Format, where, say::mounting_of_beams());
  }

 private:
  // Of the lines that every export has, those on axes of the INS say nothing here.
  std::vector<std::string> heading(const ResultFile& result) const {
    std::vector<std::string> lines = export_header(*this, result);
    lines.resize(2);
    const bool by_azimuth = result.result.beams.nodes.by_azimuth();
    const std::vector<std::string> formula = by_azimuth ? kOverField : kAllAround;
    lines.insert(lines.end(), formula.begin(), formula.end());
    lines.insert(lines.end(),
                 {"Sigma is 1-sigma; correlations are not kept. A mean is that of the beams that the drive tells, null",
                  "where it tells none; what it does not tell has the sigma of the belief before the drive."});
    return lines;
  }
};

}  // namespace

std::unique_ptr<Exporter> make_beams_exporter() { return std::make_unique<BeamsExporter>(); }

}  // namespace remount::results

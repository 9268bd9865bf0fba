#include "model/report/vehicle_report.h"

#include "algorithms/messages/render.h"
#include "messages/report.h"
#include "messages/rig.h"
#include "model/formats/files/number_text.h"
#include "model/formats/files/printable_text.h"
#include "model/results/display_units.h"

namespace remount::report {
namespace {

/// What stands before the reports of the LiDARs.
class VehiclePart {
 public:
  VehiclePart(const results::VehicleFile& vehicle, Language language) : vehicle_(vehicle), language_(language) {}

  std::string write() {
    html_ = "<h1>" + words(say::report_of_lidars(results::lidar_names(vehicle_))) + "</h1>\n";
    write_relatives();
    write_findings();
    return std::move(html_);
  }

 private:
  std::string words(const Message& message) const { return formats::escape_html(render(message, language_)); }

  std::string value(const results::RelativeRecord& two, calibration::Parameter parameter) const {
    const auto sigma = two.sigma[parameter];
    if (!sigma) return words(say::report_not_observed());
    const double shown = results::on_screen(parameter, *sigma);
    const int decimals = results::justified_decimals(shown);
    return formats::rounded_text(results::six_on_screen(two.lidar_a_from_lidar_b)[parameter], decimals) + " ± " +
           formats::spread_text(shown, decimals) + (calibration::is_angle(parameter) ? " °" : " m");
  }

  void row(const std::vector<std::string>& cells, const std::string& tag) {
    html_ += "<tr>";
    for (const std::string& cell : cells) html_ += "<" + tag + ">" + cell + "</" + tag + ">";
    html_ += "</tr>\n";
  }

  void write_relatives() {
    if (vehicle_.relatives.empty()) return;
    html_ +=
        "<h2>" + words(say::report_relatives()) + "</h2>\n<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n";
    std::vector<std::string> cells{""};
    for (const calibration::Parameter parameter : calibration::kParameters)
      cells.push_back(words(calibration::parameter_word(parameter)));
    cells.push_back(words(say::report_height_above()));
    row(cells, "th");
    for (const results::RelativeRecord& two : vehicle_.relatives) {
      cells = {words(say::rig_relative_title(two.lidar_b, two.lidar_a))};
      for (const calibration::Parameter parameter : calibration::kParameters) cells.push_back(value(two, parameter));
      const int decimals = results::justified_decimals(two.height_sigma_m);
      cells.push_back(formats::rounded_text(two.height_m, decimals) + " ± " +
                      formats::spread_text(two.height_sigma_m, decimals) + " m");
      row(cells, "td");
    }
    html_ += "</table>\n";
  }

  void write_findings() {
    html_ += vehicle_.findings.empty() ? "" : "<ul>";
    for (const drive::Finding& finding : vehicle_.findings)
      html_ += "<li>" + words(finding.where.words()) + ": " + words(finding.explanation) + "</li>";
    html_ += vehicle_.findings.empty() ? "" : "</ul>\n";
  }

  const results::VehicleFile& vehicle_;
  Language language_;
  std::string html_;
};

}  // namespace

std::string vehicle_report_html(const results::VehicleFile& vehicle, const Report& of_each, const ReportStyle& style) {
  std::string body = VehiclePart(vehicle, style.language).write();
  Report report = of_each;
  for (const results::LidarResult& lidar : vehicle.lidars) {
    report.file = lidar.file;
    report.lidar = lidar.name;
    body += report_body(report, style);
  }
  return report_page(body, style);
}

}  // namespace remount::report

#include "app/gui/document/vehicle_report.h"

#include "app/gui/document/report_maker.h"
#include "messages/report.h"
#include "model/formats/files/atomic_save.h"
#include "model/formats/files/current_time.h"
#include "model/report/vehicle_report.h"

namespace remount::gui {

void make_vehicle_report(Workbench& workbench, const QString& html_path) {
  const CommonSolutionPtr common = workbench.vehicle().common();
  if (!common) return;
  workbench.jobs().start(
      [&workbench, common, html_path, style = report_style()](Progress&) -> JobRunner::Deliver {
        formats::check_replaces_its_like(html_path.toStdString(), "<!DOCTYPE html>");
        report::Report of_each;
        of_each.created = formats::now_in_utc();
        of_each.no_pictures = say::report_pictures_of_one();
        formats::save_atomically(html_path.toStdString(), report::vehicle_report_html(common->file, of_each, style));
        return [&workbench, html_path] {
          workbench.notices().say(drive::Severity::Note, html_path, Vehicle::tr("report of all LiDARs saved"));
          offer_to_open_report(workbench.notices(), html_path);
        };
      },
      workbench.notices().report_failure());
}

}  // namespace remount::gui

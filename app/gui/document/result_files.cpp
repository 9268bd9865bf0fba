#include "app/gui/document/result_files.h"

#include "model/drive/session_frames.h"
#include "model/formats/files/atomic_save.h"
#include "model/project/project.h"
#include "model/results/exporters/exporter.h"
#include "widgets/text/model_text.h"

namespace remount::gui {

std::vector<widgets::ExportFormat> export_formats() {
  std::vector<widgets::ExportFormat> formats;
  for (const auto& format : results::exporters())
    formats.push_back({QString::fromUtf8(format->id()), widgets::model_text(format->description()),
                       widgets::model_text(format->direction()), QString::fromUtf8(format->file_name())});
  return formats;
}

QString export_text(const Workbench& workbench, const QString& format_id) {
  const results::ResultFile file = project::make_result_file(workbench.outcome().input(), *workbench.outcome().output(),
                                                             workbench.outcome().input_files());
  return QString::fromStdString(results::exporter(format_id.toStdString()).write(file, {}));
}

void save_text(const QString& path, const QString& contents) {
  formats::save_atomically(path.toStdString(), contents.toStdString());
}

RigidTransform nominal_from_file(const QString& path, const Workbench& workbench, QStringList& doubts) {
  std::vector<Message> texts;
  const results::ReadMounting mounting = results::read_any_mounting(path.toStdString(), &texts);
  if (const Message problem = results::not_in_ins_frame(mounting.frames); !problem.empty())
    throw Error(ErrorCode::Contract, path.toStdString(), problem);
  const RigidTransform ins_from_lidar =
      results::in_axes_of(mounting, drive::common_axes(workbench.sessions().all()), texts);
  for (const Message& doubt : texts) doubts << widgets::model_text(doubt);
  return ins_from_lidar;
}

}  // namespace remount::gui

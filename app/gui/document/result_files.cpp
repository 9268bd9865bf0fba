#include "app/gui/document/result_files.h"

#include "model/drive/session_frames.h"
#include "model/formats/files/atomic_save.h"
#include "model/project/project.h"
#include "model/results/exporters/exporter.h"
#include "widgets/text/model_text.h"

namespace remount {

std::vector<ExportFormat> export_formats() {
  std::vector<ExportFormat> formats;
  for (const auto& format : exporters())
    formats.push_back({QString::fromUtf8(format->id()), model_text(format->description()),
                       model_text(format->direction()), QString::fromUtf8(format->file_name())});
  return formats;
}

QString export_text(const Workbench& workbench, const QString& format_id) {
  const ResultFile file =
      make_result_file(workbench.outcome().input(), *workbench.outcome().output(), workbench.outcome().input_files());
  return QString::fromStdString(exporter(format_id.toStdString()).write(file, {}));
}

void save_text(const QString& path, const QString& contents) {
  save_atomically(path.toStdString(), contents.toStdString());
}

RigidTransform nominal_from_file(const QString& path, const Workbench& workbench, QStringList& doubts) {
  std::vector<Message> texts;
  const ReadMounting mounting = read_any_mounting(path.toStdString(), &texts);
  if (const Message problem = not_in_ins_frame(mounting.frames); !problem.empty())
    throw Error(ErrorCode::Contract, path.toStdString(), problem);
  const RigidTransform ins_from_lidar = in_axes_of(mounting, common_axes(workbench.sessions().all()), texts);
  for (const Message& doubt : texts) doubts << model_text(doubt);
  return ins_from_lidar;
}

}  // namespace remount

#include "app/gui/result_files.h"

#include "model/exporters/exporter.h"
#include "model/io/atomic_save.h"
#include "model/project.h"
#include "model/session_frames.h"

namespace remount {
namespace {

QString text(std::string_view words) { return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size())); }

}  // namespace

std::vector<ExportFormat> export_formats() {
  std::vector<ExportFormat> formats;
  for (const auto& format : exporters())
    formats.push_back(
        {text(format->id()), text(format->description()), text(format->direction()), text(format->file_name())});
  return formats;
}

QString export_text(const Workbench& workbench, const QString& format_id) {
  const ResultFile file = make_result_file(workbench.input_of_output(), *workbench.output(), workbench.input_files());
  return QString::fromStdString(exporter(format_id.toStdString()).write(file, {}));
}

void save_text(const QString& path, const QString& contents) {
  save_atomically(path.toStdString(), contents.toStdString());
}

RigidTransform nominal_from_file(const QString& path, const Workbench& workbench, QStringList& doubts) {
  std::vector<std::string> texts;
  const ReadMounting mounting = read_any_mounting(path.toStdString(), &texts);
  const RigidTransform ins_from_lidar = in_axes_of(mounting, common_axes(workbench.sessions()), texts);
  for (const std::string& doubt : texts) doubts << QString::fromStdString(doubt);
  return ins_from_lidar;
}

}  // namespace remount

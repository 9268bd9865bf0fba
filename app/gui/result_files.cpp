#include "app/gui/result_files.h"

#include "model/exporters/exporter.h"
#include "model/io/atomic_save.h"
#include "model/project.h"

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

RigidTransform nominal_from_file(const QString& path) { return read_any_ins_from_lidar(path.toStdString()); }

}  // namespace remount

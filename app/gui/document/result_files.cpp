#include "app/gui/document/result_files.h"

#include "messages/rig.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/atomic_save.h"
#include "model/project/project.h"
#include "model/results/exporters/exporter.h"
#include "model/results/exporters/named_mountings.h"
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
  results::require_ins_frame(mounting, path.toStdString());
  const RigidTransform ins_from_lidar =
      results::in_axes_of(mounting, drive::common_axes(workbench.sessions().all()), texts);
  for (const Message& doubt : texts) doubts << widgets::model_text(doubt);
  return ins_from_lidar;
}

std::map<std::string, RigidTransform> nominals_from_file(const QString& path, const Workbench& workbench,
                                                         QStringList& doubts) {
  std::vector<std::string> lidars;
  for (const VehicleLidar& lidar : workbench.vehicle().lidars()) lidars.push_back(lidar.name());
  if (lidars.size() < 2) return {};
  std::vector<Message> texts;
  const std::vector<results::NamedMounting> mountings = results::read_any_mountings(path.toStdString(), &texts);
  results::MountingsOfLidars found = results::mountings_of_lidars(mountings, lidars, path.toStdString());
  if (found.of.empty() && mountings.size() > 1) results::no_lidar_is_named(mountings, lidars, path.toStdString());
  std::map<std::string, RigidTransform> nominals;
  for (const auto& [lidar, mounting] : found.of)
    nominals[lidar] = results::in_axes_of(mounting, drive::common_axes(workbench.sessions().all()), texts);
  if (nominals.empty()) return nominals;
  std::erase_if(lidars, [&](const std::string& lidar) { return nominals.contains(lidar); });
  if (!found.others.empty()) texts.push_back(say::rig_nominal_of_others(path.toStdString(), std::move(found.others)));
  if (!lidars.empty()) texts.push_back(say::rig_nominal_not_of_all(std::move(lidars)));
  for (const Message& doubt : texts) doubts << widgets::model_text(doubt);
  return nominals;
}

}  // namespace remount::gui

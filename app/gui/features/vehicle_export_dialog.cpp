#include "app/gui/features/vehicle_export_dialog.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSettings>
#include <memory>

#include "app/gui/basics/ask_to_replace.h"
#include "app/gui/document/result_files.h"
#include "app/gui/jobs/error_words.h"
#include "messages/rig.h"
#include "model/formats/files/atomic_save.h"
#include "model/results/exporters/several_exporter.h"
#include "model/results/exporters/vehicle_export.h"
#include "model/results/lidar_names.h"
#include "widgets/basics/remembering.h"
#include "widgets/result/export_dialog.h"
#include "widgets/text/model_text.h"

namespace remount::gui {
namespace {

const QString kFrames = QStringLiteral("export/frames/");
const QString kInsFrame = QStringLiteral("export/ins-frame");

QString remembered(const QString& key) { return widgets::remembers() ? QSettings().value(key).toString() : QString(); }

QString key_of(const std::string& lidar) {
  return kFrames + QString::fromStdString(lidar).replace('/', '|');  // which is a level of settings
}

/// In whose frame the LiDARs are, and what the frames are called.
class FramesForm : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(remount::gui::FramesForm)

 public:
  explicit FramesForm(const results::VehicleFile& vehicle) : relative_(new QComboBox), ins_(new QLineEdit) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("Frames:")), 0, 0);
    relative_->setAccessibleName(tr("In whose frame all are"));
    relative_->addItem(tr("in the frame of the INS"), QString());
    for (const results::LidarResult& lidar : vehicle.lidars) {
      const QString name = QString::fromStdString(lidar.name);
      if (lidar.joined && vehicle.lidars.size() > 1) relative_->addItem(tr("in the frame of %1").arg(name), name);
    }
    grid->addWidget(relative_, 0, 1);
    add(*grid, *ins_, tr("INS"), kInsFrame, {});
    for (const results::LidarResult& lidar : vehicle.lidars) {
      auto* frame = new QLineEdit;
      add(*grid, *frame, QString::fromStdString(lidar.name), key_of(lidar.name),
          QString::fromStdString(results::usual_frame(lidar.name)));
      lidars_.emplace_back(lidar.name, frame);
    }
    grid->setColumnStretch(2 * kInRow + 2, 1);
  }

  void on_edit(QObject* context, const std::function<void()>& follow) {
    QObject::connect(relative_, &QComboBox::currentIndexChanged, context, follow);
    QObject::connect(ins_, &QLineEdit::textEdited, context, follow);
    for (const auto& [name, frame] : lidars_) QObject::connect(frame, &QLineEdit::textEdited, context, follow);
  }

  results::ExportNames names() const {
    results::ExportNames names;
    names.ins_frame = ins_->text().trimmed().toStdString();
    names.relative_to = relative_->currentData().toString().toStdString();
    for (const auto& [name, frame] : lidars_)
      if (const QString text = frame->text().trimmed(); !text.isEmpty()) names.lidar_frames[name] = text.toStdString();
    return names;
  }

  void remember() const {
    if (!widgets::remembers()) return;
    QSettings settings;
    settings.setValue(kInsFrame, ins_->text().trimmed());
    for (const auto& [name, frame] : lidars_) settings.setValue(key_of(name), frame->text().trimmed());
  }

 private:
  static constexpr int kInRow = 4;

  void add(QGridLayout& grid, QLineEdit& edit, const QString& title, const QString& key, const QString& usual) {
    edit.setText(remembered(key));
    edit.setPlaceholderText(usual);
    edit.setMaximumWidth(140);
    edit.setAccessibleName(tr("Name of the frame of %1").arg(title));
    edit.setToolTip(tr("Name of the frame of %1; empty: the usual one").arg(title));
    const int row = count_ / kInRow, column = 2 + 2 * (count_ % kInRow);
    grid.addWidget(new QLabel(title), row, column, Qt::AlignRight);
    grid.addWidget(&edit, row, column + 1);
    ++count_;
  }

  int count_ = 0;
  QComboBox* relative_;
  QLineEdit* ins_;
  std::vector<std::pair<std::string, QLineEdit*>> lidars_;
};

/// Throws Error for a LiDAR that the format has no place for: here its user sees what is written before it is.
std::vector<results::ExportedFile> files_of(const results::VehicleFile& vehicle, const QString& format_id,
                                            const results::ExportNames& names) {
  const results::Exporter& format = results::exporter(format_id.toStdString());
  std::vector<results::LeftOut> left_out;
  std::vector<results::ExportedFile> files;
  if (names.relative_to.empty()) {
    files = results::export_vehicle(vehicle, format, names, left_out);
  } else {
    results::require_frames(format, names.relative_to);
    files = results::export_vehicle(results::relative_to(vehicle, names.relative_to, names.relative_to), format, names,
                                    left_out);
  }
  if (!left_out.empty()) throw Error(ErrorCode::Contract, left_out.front().lidar, left_out.front().why);
  return files;
}

/// One text to look at; where there are several files, each below its name.
QString preview_of(const std::vector<results::ExportedFile>& files) {
  if (files.size() == 1) return QString::fromStdString(files.front().text);
  QString text;
  for (const results::ExportedFile& file : files)
    text += QStringLiteral("===== %1\n%2\n").arg(QString::fromStdString(file.name), QString::fromStdString(file.text));
  return text;
}

std::vector<widgets::ExportFormat> formats_of_vehicle() {
  std::vector<widgets::ExportFormat> formats;
  for (widgets::ExportFormat& format : export_formats()) {
    const results::Exporter& exporter = results::exporter(format.id.toStdString());
    if (!exporter.holds_mounting()) continue;
    format.folder = !exporter.holds_several();
    formats.push_back(std::move(format));
  }
  return formats;
}

QString warning_of(const results::VehicleFile& vehicle, const results::VehicleFile& all) {
  QStringList warnings;
  for (const results::LidarResult& lidar : all.lidars)
    if (!results::find_lidar(vehicle, lidar.name))
      warnings << widgets::model_text(say::export_lidar_left_out(lidar.name, lidar.file.result.message));
  for (const results::LidarResult& lidar : vehicle.lidars)
    for (const Message& warning : results::export_warnings(lidar.file.result))
      warnings << widgets::model_text(say::export_warning_of_lidar(lidar.name, warning));
  return warnings.join('\n');
}

QStringList paths_in(const QString& folder, const std::vector<results::ExportedFile>& files) {
  QStringList paths;
  for (const results::ExportedFile& file : files) paths << QDir(folder).filePath(QString::fromStdString(file.name));
  return paths;
}

void save(const std::vector<results::ExportedFile>& files, const QString& path, bool folder) {
  std::vector<formats::BytesToSave> to_save;
  for (const results::ExportedFile& file : files)
    to_save.push_back(
        {folder ? std::filesystem::path(path.toStdString()) / file.name : std::filesystem::path(path.toStdString()),
         file.text});
  formats::save_together(to_save);
}

}  // namespace

void export_vehicle_from(const Workbench& workbench, const results::VehicleFile& all, QWidget& window) {
  auto vehicle = std::make_shared<results::VehicleFile>(all);
  results::keep_lidars(*vehicle,
                       [](const results::LidarResult& lidar) { return calibration::is_usable(lidar.file.result); });
  auto* form = new FramesForm(*vehicle);
  const auto text_of = [vehicle, form](const QString& id) -> widgets::ExportText {
    try {
      const results::ExportNames names = form->names();
      return {preview_of(files_of(*vehicle, id, names)),
              {},
              names.relative_to.empty() ? QString()
                                        : widgets::model_text(say::export_direction_relative(names.relative_to))};
    } catch (const Error& error) {
      return {{}, widgets::ExportDialog::tr("Cannot be written in this format: %1").arg(failure_of(error).what), {}};
    }
  };
  auto* dialog = new widgets::ExportDialog(formats_of_vehicle(), text_of, &window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(widgets::ExportDialog::tr("Export all LiDARs"));
  dialog->add_form(form);
  dialog->show_warning(warning_of(*vehicle, all));
  form->on_edit(dialog, [dialog] { dialog->show_current(); });
  QObject::connect(dialog, &widgets::ExportDialog::save_requested, dialog,
                   [dialog, form, vehicle, &workbench](const QString& id, const QString& path, const QString&) {
                     try {
                       const bool folder = !results::exporter(id.toStdString()).holds_several();
                       const std::vector<results::ExportedFile> files = files_of(*vehicle, id, form->names());
                       if (folder && !ask_to_replace(paths_in(path, files), *dialog)) return;
                       save(files, path, folder);
                       form->remember();
                       workbench.vehicle().mark_written(results::lidar_names(*vehicle));
                       workbench.notices().say(drive::Severity::Note, path, Vehicle::tr("saved"));
                       dialog->show_outcome(widgets::ExportDialog::tr("Saved: %1").arg(path), false);
                     } catch (const Error& error) {
                       const JobFailure failure = failure_of(error);
                       workbench.notices().say(drive::Severity::Problem, failure.where, failure.what);
                       dialog->show_outcome(in_words(failure), true);
                     }
                   });
  dialog->show_current();
  dialog->open();
}

}  // namespace remount::gui

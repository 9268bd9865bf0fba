// What was found: tables that may be the motion of the INS, scans with a box to leave them out, and what is not used.
#pragma once

#include <QTreeWidget>
#include <filesystem>
#include <memory>
#include <set>

#include "model/guesses/table_import.h"

namespace remount::widgets {

class FoundFilesTree : public QTreeWidget {
  Q_OBJECT
 public:
  explicit FoundFilesTree(QWidget* parent = nullptr);

  /// @param found null for nothing
  /// @param used the file of the motion; empty for none
  void show_files(std::shared_ptr<const guesses::ImportData> found, const std::filesystem::path& used,
                  const std::set<std::size_t>& left_out);
  /// From the folder of the data where it lies below it.
  QString shown_path(const std::filesystem::path& path) const;

 signals:
  void motion_chosen(const QString& file);  ///< another than the one in use
  void lidar_checked(std::size_t lidar, bool used);

 private:
  QTreeWidgetItem* add_heading(const QString& title);
  void add_motions();
  void add_scans(const std::set<std::size_t>& left_out);
  void add_not_used();
  void take_check(QTreeWidgetItem* item);
  void take_motion(QTreeWidgetItem* item);

  std::shared_ptr<const guesses::ImportData> data_;
  std::filesystem::path used_;
  bool filling_ = false;
};

}  // namespace remount::widgets

// Open sessions with what was found in them, as a tree: session, and beneath it its findings.
#pragma once

#include <QAbstractItemModel>
#include <QPalette>
#include <memory>
#include <optional>
#include <vector>

#include "model/overview/drive_overview.h"
#include "model/pipeline/pipeline.h"
#include "widgets/text/pair_counts.h"

namespace remount::widgets {

class SessionListModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { Name, ColumnCount };

  using QAbstractItemModel::QAbstractItemModel;
  void show_sessions(std::vector<std::shared_ptr<const drive::Session>> sessions);
  /// What was found out about each session's drive since it was opened; null where nothing is known yet.
  void show_drives(std::vector<std::shared_ptr<const overview::DriveOverview>> drives);
  /// How much of each session the result rests on; null: nothing is calibrated.
  /// `calibrated`: so many of the sessions took part, the first.
  void show_use(const std::shared_ptr<const pipeline::PipelineOutput>& output, std::size_t calibrated);
  void set_palette(const QPalette& palette);
  /// The session of an index, itself or its parent; nothing for none.
  std::optional<motion::SessionIndex> session_of(const QModelIndex& index) const;
  bool has_topics(motion::SessionIndex session) const;  ///< that can be chosen

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void collect_findings();
  QString use_text(motion::SessionIndex session) const;
  bool is_unused(motion::SessionIndex session) const { return session < uses_.size() && uses_[session].unused(); }

  std::vector<std::shared_ptr<const drive::Session>> sessions_;
  std::vector<std::shared_ptr<const overview::DriveOverview>> drives_;
  std::vector<std::vector<drive::Finding>> findings_;  // of each session's files and of its drive
  std::vector<SessionUse> uses_;                       // empty where there is no result from pairs
  QPalette palette_;
};

/// "kitti-raw · 120 scans in 12.0 s · 1200 INS samples".
QString session_summary(const drive::Session& session);

}  // namespace remount::widgets

// Open sessions with what was found in them, as a tree: session, and beneath it its findings.
#pragma once

#include <QAbstractItemModel>
#include <QPalette>
#include <memory>
#include <vector>

#include "model/session.h"

namespace remount {

class SessionListModel : public QAbstractItemModel {
  Q_OBJECT
 public:
  enum Column { Name, ColumnCount };

  using QAbstractItemModel::QAbstractItemModel;
  void show_sessions(std::vector<std::shared_ptr<const Session>> sessions);
  void set_palette(const QPalette& palette);
  /// The session of an index, itself or its parent; -1 for none.
  int session_of(const QModelIndex& index) const;
  bool has_topics(int session) const;  ///< that can be chosen

  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex& child) const override;
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::vector<std::shared_ptr<const Session>> sessions_;
  QPalette palette_;
};

/// "kitti-raw · 120 scans · 12.0 s · 1200 INS samples".
QString session_summary(const Session& session);

}  // namespace remount

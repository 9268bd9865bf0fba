// The first rows of a table, with a list above each column of what it is.
#pragma once

#include <QTableWidget>
#include <memory>
#include <vector>

#include "model/guesses/table_import.h"

class QComboBox;

namespace remount::widgets {

class ColumnTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit ColumnTable(QWidget* parent = nullptr);
  void show_table(const guesses::ImportTable& table);
  void show_roles(const std::vector<guesses::ColumnRole>& roles);
  QComboBox* roles_of(std::size_t column) const { return lists_.at(column); }

 signals:
  void role_chosen(std::size_t column, guesses::ColumnRole role);

 private:
  QComboBox* make_list(std::size_t column, const QString& title);
  std::vector<QComboBox*> lists_;
};

}  // namespace remount::widgets

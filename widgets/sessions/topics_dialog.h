// Which topics of a bag a session is made of: all that there are, what each could be, and what is suggested.
#pragma once

#include <QDialog>
#include <vector>

#include "model/drive/topic_offer.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace remount::widgets {

class TopicsDialog : public QDialog {
  Q_OBJECT
 public:
  /// `topics` as they are used or suggested now; that is what is selected first.
  TopicsDialog(const QString& recording, std::vector<drive::OfferedTopic> topics, QWidget* parent = nullptr);
  /// A topic, or kNoTopic, for each role that some topic could have.
  drive::TopicChoice choice() const;
  void choose(std::string_view role, const std::string& topic);

 private:
  struct Row {
    std::string role;
    QComboBox* topics = nullptr;
    QLabel* why = nullptr;
  };
  void add_row(QGridLayout& grid, std::string_view role);
  QTreeWidget* make_table();
  void fill_table();
  void show_choice();
  const Row* row(std::string_view role) const;
  const drive::OfferedTopic* chosen(std::string_view role) const;  ///< null for none
  bool completes_ins() const;                                      ///< the INS is an orientation that needs positions
  QString problem() const;  ///< why no session can be made of it; empty for nothing

  std::vector<drive::OfferedTopic> topics_;
  drive::TopicChoice suggested_;
  std::vector<Row> rows_;
  QTreeWidget* table_;
  QLabel* problem_;
  QPushButton *open_ = nullptr, *reset_ = nullptr;
};

}  // namespace remount::widgets

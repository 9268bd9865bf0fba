// All pairs as small pictures.
#pragma once

#include <QComboBox>
#include <QHash>
#include <QListView>
#include <QPixmap>

#include "widgets/pairs/pair_filter.h"

class QLabel;

namespace remount::widgets {

/// In the order of the table, whose selection it shares.
class ContactSheet : public QWidget {
  Q_OBJECT
 public:
  ContactSheet(PairFilter& filter, QItemSelectionModel& selection, QWidget* parent = nullptr);
  /// @param caption below the picture, beside the number of the pair
  void show_thumbnail(motion::PairIndex pair, const QImage& picture, const QString& caption);
  /// All pictures are to be made anew.
  void forget_thumbnails();
  bool has_thumbnail(motion::PairIndex pair) const { return thumbnails_.contains(pair); }
  /// Pairs in sight that have no picture yet, in their order, then those a page further.
  std::vector<motion::PairIndex> missing() const;
  void set_thumbnail_size(QSize size);
  bool with_result() const;
  void show_legend(const QString& text);
  QListView* list() const { return list_; }

 signals:
  void wanted();             ///< missing() is another
  void alignment_changed();  ///< with_result() is another
  void opened(motion::PairIndex pair);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  class Painter;
  struct Thumbnail {
    QPixmap picture;
    QString caption;
  };
  PairFilter& filter_;
  QListView* list_;
  QComboBox* alignment_;
  QLabel* legend_;
  QHash<std::size_t, Thumbnail> thumbnails_;
  QSize size_{220, 168};
};

}  // namespace remount::widgets

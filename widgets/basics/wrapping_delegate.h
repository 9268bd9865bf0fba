// Items of a tree that are as high as their text is when wrapped to the width of the view.
#pragma once

#include <QStyledItemDelegate>

class QTreeView;

namespace remount::widgets {

/// For a tree of one column. Sizes follow the width of the view, which lays out anew when it is resized.
class WrappingDelegate : public QStyledItemDelegate {
  Q_OBJECT
 public:
  explicit WrappingDelegate(QTreeView& view);
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  QTreeView& view_;
};

}  // namespace remount::widgets

#include "widgets/basics/wrapping_delegate.h"

#include <QHeaderView>
#include <QTreeView>
#include <algorithm>

namespace remount::widgets {

WrappingDelegate::WrappingDelegate(QTreeView& view) : QStyledItemDelegate(&view), view_(view) {
  view_.setWordWrap(true);
  view_.setUniformRowHeights(false);
  view_.setTextElideMode(Qt::ElideNone);
  view_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  view_.header()->setSectionResizeMode(QHeaderView::Stretch);
  connect(view_.header(), &QHeaderView::sectionResized, &view_, &QTreeView::doItemsLayout);
}

QSize WrappingDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  int depth = view_.rootIsDecorated() ? 1 : 0;
  for (QModelIndex parent = index.parent(); parent.isValid(); parent = parent.parent()) ++depth;
  QStyleOptionViewItem item = option;
  initStyleOption(&item, index);
  // Measured narrower than it is drawn, by the margins of the style: a line more than needed does no harm.
  const int margin = view_.style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, &view_) + 1;
  const int box = item.features.testFlag(QStyleOptionViewItem::HasCheckIndicator)
                      ? view_.style()->pixelMetric(QStyle::PM_IndicatorWidth, &item, &view_) + 2 * margin
                      : 0;
  const int width = std::max(40, view_.viewport()->width() - depth * view_.indentation() - 2 * margin - box);
  const QRect text = item.fontMetrics.boundingRect(QRect(0, 0, width, 100000), Qt::TextWordWrap, item.text);
  return {width, text.height() + 4};
}

}  // namespace remount::widgets

#include "widgets/pairs/contact_sheet.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QScrollBar>
#include <QStyledItemDelegate>
#include <algorithm>

#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/charts/chart_axis.h"

namespace remount::widgets {
namespace {

constexpr int kMargin_px = 4;

/// Its rows are whole pairs, also for the table.
class PairList : public QListView {
 public:
  using QListView::QListView;

 protected:
  QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index, const QEvent* event) const override {
    return QListView::selectionCommand(index, event) | QItemSelectionModel::Rows;
  }
};

}  // namespace

/// Paints a pair: its picture, its number and what is said below it, and how it was decided as the frame.
class ContactSheet::Painter : public QStyledItemDelegate {
 public:
  explicit Painter(ContactSheet& sheet) : QStyledItemDelegate(&sheet), sheet_(sheet) {}

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return sheet_.size_ + QSize(2 * kMargin_px + 4, 2 * kMargin_px + option.fontMetrics.height() + 4);
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const motion::PairIndex pair = sheet_.filter_.pairs().at(index_at(index.row()));
    const auto& model = static_cast<const PairTableModel&>(*sheet_.filter_.sourceModel());
    const motion::Pair* const shown = model.pair(pair);
    if (!shown) return;
    const bool selected = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    if (selected) painter->fillRect(option.rect, option.palette.highlight());
    const QRect picture(option.rect.topLeft() + QPoint(kMargin_px + 2, kMargin_px + 2), sheet_.size_);
    const auto found = sheet_.thumbnails_.find(pair);
    if (found != sheet_.thumbnails_.end()) {
      painter->drawPixmap(picture, found->picture);
    } else {
      painter->fillRect(picture, option.palette.alternateBase());
      painter->setPen(faint_text_color(option.palette));
      painter->drawText(picture, Qt::AlignCenter, QStringLiteral("…"));
    }
    painter->setPen(QPen(state_color(shown->state, option.palette), 2.0));
    painter->setBrush(Qt::NoBrush);
    painter->drawRect(picture.adjusted(-1, -1, 1, 1));
    QFont font = option.font;
    font.setBold(!model.mark_of(pair).seen);
    painter->setFont(font);
    painter->setPen(option.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
    const QString flag = model.mark_of(pair).flagged ? QStringLiteral("⚑ ") : QString();
    const QString sign = shown->state == motion::PairState::Rejected   ? QStringLiteral("✕ ")
                         : shown->state == motion::PairState::Accepted ? QStringLiteral("✓ ")
                                                                       : QString();
    QString words = flag + sign + QString::number(pair);
    if (found != sheet_.thumbnails_.end()) words += QStringLiteral("  ") + found->caption;
    const QRect below(picture.left(), picture.bottom() + 3, picture.width(), option.fontMetrics.height());
    painter->drawText(below, Qt::AlignLeft, option.fontMetrics.elidedText(words, Qt::ElideRight, below.width()));
    painter->restore();
  }

 private:
  ContactSheet& sheet_;
};

ContactSheet::ContactSheet(PairFilter& filter, QItemSelectionModel& selection, QWidget* parent)
    : QWidget(parent),
      filter_(filter),
      list_(new PairList(this)),
      alignment_(new QComboBox(this)),
      legend_(new QLabel(this)) {
  list_->setViewMode(QListView::IconMode);
  list_->setResizeMode(QListView::Adjust);
  list_->setMovement(QListView::Static);
  list_->setUniformItemSizes(true);
  list_->setLayoutMode(QListView::Batched);
  list_->setBatchSize(500);
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setItemDelegate(new Painter(*this));
  list_->setModel(&filter_);
  list_->setSelectionModel(&selection);
  list_->setAccessibleName(tr("Pictures of all pairs"));
  list_->viewport()->installEventFilter(this);
  alignment_->addItems({tr("Aligned"), tr("With result")});
  alignment_->setAccessibleName(tr("Alignment in the pictures"));
  alignment_->setToolTip(tr("As the scans were aligned with each other, or as INS and the present result put them"));
  connect(alignment_, &QComboBox::currentIndexChanged, this, &ContactSheet::alignment_changed);
  connect(list_->verticalScrollBar(), &QScrollBar::valueChanged, this, &ContactSheet::wanted);
  connect(list_, &QListView::doubleClicked, this,
          [this](const QModelIndex& index) { emit opened(filter_.pairs().at(index_at(index.row()))); });
  connect(&filter_, &PairFilter::shown_changed, this, &ContactSheet::wanted);
  legend_->setTextFormat(Qt::RichText);
  legend_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // the view may be narrower than its words
  auto* row = new QHBoxLayout;
  row->setContentsMargins(6, 2, 6, 0);
  row->addWidget(alignment_);
  row->addWidget(legend_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(row);
  column->addWidget(list_, 1);
}

bool ContactSheet::with_result() const { return alignment_->currentIndex() == 1; }

void ContactSheet::show_legend(const QString& text) { legend_->setText(text); }

void ContactSheet::set_thumbnail_size(QSize size) {
  size_ = size;
  forget_thumbnails();
}

void ContactSheet::show_thumbnail(motion::PairIndex pair, const QImage& picture, const QString& caption) {
  thumbnails_[pair] = {QPixmap::fromImage(picture), caption};
  if (const int row = filter_.row_of(pair); row >= 0) list_->update(filter_.index(row, 0));
}

void ContactSheet::forget_thumbnails() {
  thumbnails_.clear();
  list_->viewport()->update();
  emit wanted();
}

std::vector<motion::PairIndex> ContactSheet::missing() const {
  std::vector<motion::PairIndex> missing;
  const QRect sight = list_->viewport()->rect();
  const QModelIndex first = list_->indexAt(QPoint(sight.left() + 2 * kMargin_px + 4, sight.top() + 2 * kMargin_px + 4));
  const int columns = std::max(1, sight.width() / (size_.width() + 2 * kMargin_px + 4));
  const int rows = sight.height() / (size_.height() + 2 * kMargin_px) + 2;
  const int begin = first.isValid() ? first.row() : 0;
  const int end = std::min(filter_.rowCount(), begin + 2 * rows * columns);
  for (int row = begin; row < end; ++row)
    if (const motion::PairIndex pair = filter_.pairs()[index_at(row)]; !has_thumbnail(pair)) missing.push_back(pair);
  return missing;
}

bool ContactSheet::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize) emit wanted();
  return QWidget::eventFilter(watched, event);
}

void ContactSheet::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  emit wanted();
}

}  // namespace remount::widgets

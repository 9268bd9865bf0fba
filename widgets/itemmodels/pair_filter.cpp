#include "widgets/itemmodels/pair_filter.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "widgets/theme.h"

namespace remount {

void PairFilter::setSourceModel(QAbstractItemModel* model) {
  beginResetModel();
  if (sourceModel()) sourceModel()->disconnect(this);
  QAbstractProxyModel::setSourceModel(model);
  connect(model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
  connect(model, &QAbstractItemModel::modelReset, this, &PairFilter::after_source_reset);
  connect(model, &QAbstractItemModel::dataChanged, this, [this] {
    update_shown();
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
  });
  connect(model, &QAbstractItemModel::headerDataChanged, this, &QAbstractItemModel::headerDataChanged);
  set_shown(choose());
  endResetModel();
  emit shown_changed();
}

void PairFilter::after_source_reset() {
  set_shown(choose());
  endResetModel();
  emit shown_changed();
}

void PairFilter::set_criteria(const PairCriteria& criteria) {
  criteria_ = criteria;
  criteria_.text = criteria.text.trimmed();
  update_shown();
}

void PairFilter::sort(int column, Qt::SortOrder order) {
  sort_column_ = column < 0 ? static_cast<int>(PairTableModel::Number) : column;
  sort_order_ = order;
  update_shown();
}

void PairFilter::set_shown(std::vector<int> shown) {
  shown_ = std::move(shown);
  rows_.assign(static_cast<std::size_t>(sourceModel() ? sourceModel()->rowCount() : 0), -1);
  for (std::size_t row = 0; row < shown_.size(); ++row)
    rows_[static_cast<std::size_t>(shown_[row])] = static_cast<int>(row);
}

void PairFilter::update_shown() {
  std::vector<int> shown = choose();
  if (shown == shown_) return;
  emit layoutAboutToBeChanged();
  const QModelIndexList kept = persistentIndexList();
  QModelIndexList sources, moved;
  for (const QModelIndex& index : kept) sources << mapToSource(index);
  set_shown(std::move(shown));
  for (const QModelIndex& source : sources) moved << mapFromSource(source);
  changePersistentIndexList(kept, moved);
  emit layoutChanged();
  emit shown_changed();
}

std::vector<int> PairFilter::choose() const {
  std::vector<int> pairs;
  const int count = sourceModel() ? sourceModel()->rowCount() : 0;
  for (int pair = 0; pair < count; ++pair)
    if (matches(pair)) pairs.push_back(pair);
  if (criteria_.group == PairGroup::Worst10) keep_worst(pairs);
  sort_pairs(pairs);
  return pairs;
}

bool PairFilter::matches(int index) const {
  const Pair& pair = *pairs_model()->pair(index);
  if (criteria_.state && pair.state != *criteria_.state) return false;
  switch (criteria_.group) {
    case PairGroup::All:
      break;
    case PairGroup::Undecided:
      if (pair.decided_by == DecidedBy::User) return false;
      break;
    case PairGroup::Worst10:
      if (!measured(pair, criteria_.measure)) return false;
      break;
    case PairGroup::ScrewFailed:
      if (!is_aligned(pair) || pair.screw.passed) return false;
      break;
    case PairGroup::FewShared:
      if (pair.shared_objects >= kFewShared) return false;
      break;
    case PairGroup::NotAligned:
      if (is_aligned(pair)) return false;
      break;
  }
  if (criteria_.text.isEmpty()) return true;
  if (QString::fromStdString(pair.reason).contains(criteria_.text, Qt::CaseInsensitive)) return true;
  if (QString::number(index) == criteria_.text) return true;
  return state_text(pair).contains(criteria_.text, Qt::CaseInsensitive) ||
         pairs_model()->session_name(pair).contains(criteria_.text, Qt::CaseInsensitive);
}

void PairFilter::keep_worst(std::vector<int>& pairs) const {
  const auto value = [&](int pair) { return *measured(*pairs_model()->pair(pair), criteria_.measure); };
  const auto last = pairs.begin() + std::min<std::ptrdiff_t>(kWorst, std::ssize(pairs));
  std::partial_sort(pairs.begin(), last, pairs.end(), [&](int a, int b) { return value(a) > value(b); });
  pairs.erase(last, pairs.end());
  std::sort(pairs.begin(), pairs.end());
}

void PairFilter::sort_pairs(std::vector<int>& pairs) const {
  const bool down = sort_order_ == Qt::DescendingOrder;
  if (sort_column_ == PairTableModel::Number) {
    if (down) std::reverse(pairs.begin(), pairs.end());
    return;
  }
  const auto by = [&](const auto& key, const auto& missing) {
    std::stable_sort(pairs.begin(), pairs.end(), [&](int a, int b) {
      const auto &first = key[static_cast<std::size_t>(a)], &second = key[static_cast<std::size_t>(b)];
      if (missing(first) || missing(second)) return !missing(first) && missing(second);  // last in either order
      return down ? second < first : first < second;
    });
  };
  const auto count = static_cast<std::size_t>(sourceModel()->rowCount());
  if (sort_column_ == PairTableModel::Reason) {
    std::vector<std::string_view> reasons(count);
    for (int pair : pairs) reasons[static_cast<std::size_t>(pair)] = pairs_model()->pair(pair)->reason;
    by(reasons, [](std::string_view reason) { return reason.empty(); });
  } else {
    std::vector<double> numbers(count);
    for (int pair : pairs) numbers[static_cast<std::size_t>(pair)] = pairs_model()->sort_number(pair, sort_column_);
    by(numbers, [](double number) { return std::isnan(number); });
  }
}

int PairFilter::row_of(int pair) const {
  return pair >= 0 && pair < std::ssize(rows_) ? rows_[static_cast<std::size_t>(pair)] : -1;
}

QModelIndex PairFilter::mapToSource(const QModelIndex& proxy) const {
  if (!proxy.isValid() || proxy.row() >= std::ssize(shown_)) return {};
  return sourceModel()->index(shown_[static_cast<std::size_t>(proxy.row())], proxy.column());
}

QModelIndex PairFilter::mapFromSource(const QModelIndex& source) const {
  const int row = source.isValid() ? row_of(source.row()) : -1;
  return row < 0 ? QModelIndex() : createIndex(row, source.column());
}

QModelIndex PairFilter::index(int row, int column, const QModelIndex& parent) const {
  return hasIndex(row, column, parent) ? createIndex(row, column) : QModelIndex();
}

int PairFilter::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(shown_.size());
}

int PairFilter::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(PairTableModel::ColumnCount);
}

}  // namespace remount

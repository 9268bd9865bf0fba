#include "widgets/pairs/pair_filter.h"

#include <QStringMatcher>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"

namespace remount::widgets {

using motion::PairIndex;

namespace {

/// A text in number, state, session or reason of pairs; state and session are the same for many.
class TextMatch {
 public:
  TextMatch(const QString& text, const PairTableModel& model)
      : text_(text), reason_(text.toCaseFolded()), reasons_(&model.reason_texts().folded()) {
    bool whole = false;
    const int number = text.toInt(&whole);
    if (whole && QString::number(number) == text) number_ = at_row<PairIndex>(number);
  }
  bool operator()(const PairTableModel& model, PairIndex index) {
    const motion::Pair& pair = *model.pair(index);
    if (model.mark_of(index).comment.contains(text_, Qt::CaseInsensitive)) return true;
    if (index == number_ || reason_.indexIn((*reasons_)[index]) >= 0) return true;
    const int state = 3 * static_cast<int>(pair.state) + static_cast<int>(pair.decided_by);
    return once(states_, state, [&] { return state_text(pair); }) ||
           once(sessions_, model.session_of(pair), [&] { return model.session_name(pair); });
  }

 private:
  template <class Key, class Words>
  bool once(std::map<Key, bool>& known, Key key, const Words& words) const {
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    return known[key] = words().contains(text_, Qt::CaseInsensitive);
  }

  QString text_;
  QStringMatcher reason_;
  const std::vector<QString>* reasons_;
  std::optional<PairIndex> number_;
  std::map<int, bool> states_;
  std::map<motion::SessionIndex, bool> sessions_;
};

/// In the order of their ranks, which are below their number; -1 comes last in either order. Keeps the order of equals.
void sort_by_rank(std::vector<PairIndex>& pairs, const std::vector<int>& ranks, bool down) {
  const std::size_t last = ranks.size();
  const auto place_of = [&](PairIndex pair) {
    if (ranks[pair] < 0) return last;
    const auto rank = index_at(ranks[pair]);
    return down ? last - 1 - rank : rank;
  };
  std::vector<std::size_t> next(last + 2);  // of each place: where its next pair goes
  for (const PairIndex pair : pairs) ++next[place_of(pair) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<PairIndex> sorted(pairs.size());
  for (const PairIndex pair : pairs) sorted[next[place_of(pair)]++] = pair;
  pairs = std::move(sorted);
}

/// Pairs without a number (NaN) come last in either order. Keeps the order of equals.
void sort_by_number(std::vector<PairIndex>& pairs, const std::vector<double>& numbers, bool down) {
  struct Keyed {
    double key;
    std::size_t before;  // where it was
    PairIndex pair;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(pairs.size());
  for (const PairIndex pair : pairs) {
    const double number = numbers[pair];
    const double key = std::isnan(number) ? std::numeric_limits<double>::infinity() : down ? -number : number;
    keyed.push_back({key, keyed.size(), pair});
  }
  std::sort(keyed.begin(), keyed.end(),
            [](const Keyed& a, const Keyed& b) { return a.key != b.key ? a.key < b.key : a.before < b.before; });
  std::transform(keyed.begin(), keyed.end(), pairs.begin(), [](const Keyed& one) { return one.pair; });
}

}  // namespace

void PairFilter::setSourceModel(QAbstractItemModel* model) {
  beginResetModel();
  if (sourceModel()) sourceModel()->disconnect(this);
  QAbstractProxyModel::setSourceModel(model);
  connect(model, &QAbstractItemModel::modelAboutToBeReset, this, [this] { beginResetModel(); });
  connect(model, &QAbstractItemModel::modelReset, this, &PairFilter::after_source_reset);
  connect(model, &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex&, const QModelIndex&, const QList<int>& roles) {
            // A pair is looked at with every step: a hundred thousand are not sorted for that.
            if (roles != QList<int>{Qt::FontRole} || asks_for_marks()) {
              known_column_ = -1;
              keep_place();
            }
            if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
          });
  connect(model, &QAbstractItemModel::headerDataChanged, this, &QAbstractItemModel::headerDataChanged);
  known_column_ = -1;
  set_shown(choose());
  endResetModel();
  emit shown_changed();
}

bool PairFilter::asks_for_marks() const {
  return criteria_.group == PairGroup::NotSeen || criteria_.group == PairGroup::Noted || !criteria_.text.isEmpty() ||
         sort_column_ == PairTableModel::Note;
}

void PairFilter::after_source_reset() {
  known_column_ = -1;
  in_order_ = true;
  set_shown(choose());
  endResetModel();
  emit shown_changed();
}

void PairFilter::hold(std::optional<PairIndex> pair) {
  held_ = pair;
  // Where the former one belongs here anyway and the new one is shown, nothing moves.
  if (held_is_extra_ || (pair && row_of(pair) < 0)) keep_place();
}

void PairFilter::sort_again() { update_shown(); }

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

void PairFilter::set_shown(std::vector<PairIndex> shown) {
  shown_ = std::move(shown);
  rows_.assign(index_at(sourceModel() ? sourceModel()->rowCount() : 0), -1);
  int row = 0;
  for (const PairIndex pair : shown_) rows_[pair] = row++;
}

void PairFilter::update_shown() {
  show(choose());
  in_order_ = true;
  emit order_kept();
}

/// Pairs that no longer belong here go, others come where they are sorted to, and the rest stays as it is.
void PairFilter::keep_place() {
  const std::vector<PairIndex> sorted = choose();
  std::vector<PairIndex> kept = keep_order(sorted);
  in_order_ = kept == sorted;
  show(std::move(kept));
  emit order_kept();
}

/// The pairs of `sorted` in the order that is shown; each that is not shown yet follows the one before it in `sorted`.
std::vector<PairIndex> PairFilter::keep_order(const std::vector<PairIndex>& sorted) const {
  std::vector<std::vector<PairIndex>> follow(shown_.size() + 1);  // of each row, the first: of none
  std::vector<bool> stays(shown_.size(), false);
  std::size_t after = 0;
  for (const PairIndex pair : sorted) {
    const int row = row_of(pair);
    if (row >= 0) {
      stays[index_at(row)] = true;
      after = index_at(row) + 1;
    } else {
      follow[after].push_back(pair);
    }
  }
  std::vector<PairIndex> kept = follow[0];
  kept.reserve(sorted.size());
  for (std::size_t row = 0; row < shown_.size(); ++row) {
    if (stays[row]) kept.push_back(shown_[row]);
    kept.insert(kept.end(), follow[row + 1].begin(), follow[row + 1].end());
  }
  return kept;
}

void PairFilter::show(std::vector<PairIndex> shown) {
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

std::vector<PairIndex> PairFilter::choose() {
  std::vector<PairIndex> pairs;
  const auto count = index_at(sourceModel() ? sourceModel()->rowCount() : 0);
  pairs.reserve(count);
  std::optional<TextMatch> text;
  if (count > 0 && !criteria_.text.isEmpty()) text.emplace(criteria_.text, *pairs_model());
  for (PairIndex pair; pair < count; ++pair)
    if (matches(pair) && (!text || (*text)(*pairs_model(), pair))) pairs.push_back(pair);
  if (criteria_.group == PairGroup::Worst10) keep_worst(pairs);
  matching_ = pairs.size();
  held_is_extra_ = held_ && *held_ < count && !std::binary_search(pairs.begin(), pairs.end(), *held_);
  if (held_is_extra_) pairs.insert(std::lower_bound(pairs.begin(), pairs.end(), *held_), *held_);
  sort_pairs(pairs);
  return pairs;
}

bool PairFilter::matches(PairIndex index) const {
  if (!criteria_.state && criteria_.group == PairGroup::All) return true;
  const motion::Pair& pair = *pairs_model()->pair(index);
  if (criteria_.state && pair.state != *criteria_.state) return false;
  switch (criteria_.group) {
    case PairGroup::All:
      break;
    case PairGroup::Undecided:
      if (pair.decided_by == motion::DecidedBy::User) return false;
      break;
    case PairGroup::NotSeen:
      if (pairs_model()->mark_of(index).seen) return false;
      break;
    case PairGroup::Noted:
      if (const PairMark& mark = pairs_model()->mark_of(index); !mark.flagged && mark.comment.isEmpty()) return false;
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
  return true;
}

void PairFilter::keep_worst(std::vector<PairIndex>& pairs) const {
  const auto value = [&](PairIndex pair) { return *measured(*pairs_model()->pair(pair), criteria_.measure); };
  const auto last = pairs.begin() + std::min<std::ptrdiff_t>(kWorst, std::ssize(pairs));
  std::partial_sort(pairs.begin(), last, pairs.end(), [&](PairIndex a, PairIndex b) { return value(a) > value(b); });
  pairs.erase(last, pairs.end());
  std::sort(pairs.begin(), pairs.end());
}

void PairFilter::sort_pairs(std::vector<PairIndex>& pairs) {
  const bool down = sort_order_ == Qt::DescendingOrder;
  if (sort_column_ == PairTableModel::Number) {
    if (down) std::reverse(pairs.begin(), pairs.end());
    return;
  }
  if (sort_column_ != known_column_) find_sort_keys();
  if (sort_column_ == PairTableModel::Reason)
    sort_by_rank(pairs, reason_ranks_, down);
  else
    sort_by_number(pairs, sort_numbers_, down);
}

void PairFilter::find_sort_keys() {
  const auto count = index_at(sourceModel()->rowCount());
  known_column_ = sort_column_;
  reason_ranks_.clear();
  sort_numbers_.clear();
  if (count == 0) return;  // there are no reasons of nothing
  if (sort_column_ == PairTableModel::Reason) {
    reason_ranks_ = pairs_model()->reason_texts().ranks();
  } else {
    sort_numbers_.reserve(count);
    for (PairIndex pair; pair < count; ++pair) sort_numbers_.push_back(pairs_model()->sort_number(pair, sort_column_));
  }
}

int PairFilter::row_of(std::optional<PairIndex> pair) const { return pair && *pair < rows_.size() ? rows_[*pair] : -1; }

QModelIndex PairFilter::mapToSource(const QModelIndex& proxy) const {
  if (!proxy.isValid() || proxy.row() >= std::ssize(shown_)) return {};
  return sourceModel()->index(qt_row(shown_[index_at(proxy.row())]), proxy.column());
}

QModelIndex PairFilter::mapFromSource(const QModelIndex& source) const {
  const int row = row_of(at_row<PairIndex>(source.row()));
  return row < 0 ? QModelIndex() : createIndex(row, source.column());
}

QModelIndex PairFilter::index(int row, int column, const QModelIndex& parent) const {
  return hasIndex(row, column, parent) ? createIndex(row, column) : QModelIndex();
}

int PairFilter::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : qt_count(shown_.size()); }

int PairFilter::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(PairTableModel::ColumnCount);
}

}  // namespace remount::widgets

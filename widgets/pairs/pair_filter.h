// Which pairs the table shows, and in which order. The bar chart follows it.
#pragma once

#include <QAbstractProxyModel>
#include <optional>
#include <vector>

#include "widgets/pairs/pair_measure.h"
#include "widgets/pairs/pair_table_model.h"

namespace remount::widgets {

/// What an engineer looks for.
enum class PairGroup { All, Undecided, NotSeen, Noted, Worst10, ScrewFailed, FewShared, NotAligned };
inline constexpr int kFewShared = 5;  ///< fewer static objects in common are few
inline constexpr int kWorst = 10;

struct PairCriteria {
  std::optional<motion::PairState> state;
  PairGroup group = PairGroup::All;
  PairMeasure measure = PairMeasure::ResidualTranslation;  ///< of the worst
  QString text;                                            ///< in number, state, session or reason
};

/// Whoever decides about pairs one after the other must not lose the place: what a decision changes in a pair moves no
/// row. The order is made anew when the user sorts, filters or asks for it.
/// Sorts and filters a hundred thousand pairs in one go: Qt's own proxy takes rows out one range at a time, which
/// stalls the window for seconds.
class PairFilter : public QAbstractProxyModel {
  Q_OBJECT
 public:
  explicit PairFilter(QObject* parent = nullptr) : QAbstractProxyModel(parent) {}
  void setSourceModel(QAbstractItemModel* model) override;  ///< a PairTableModel
  void set_criteria(const PairCriteria& criteria);
  /// The pair that is looked at: it stays in the list until it is left, whatever the criteria are.
  void hold(std::optional<motion::PairIndex> pair);
  std::size_t matching() const { return matching_; }  ///< pairs that the criteria choose, without the held one
  /// False where decisions and results since then would put pairs elsewhere; sort_again does.
  bool in_order() const { return in_order_; }
  void sort_again();
  const PairCriteria& criteria() const { return criteria_; }
  /// Pairs in the order shown.
  const std::vector<motion::PairIndex>& pairs() const { return shown_; }
  /// The row of a pair; -1 where it is not shown.
  int row_of(std::optional<motion::PairIndex> pair) const;

  void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;
  QModelIndex mapToSource(const QModelIndex& proxy) const override;
  QModelIndex mapFromSource(const QModelIndex& source) const override;
  QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  QModelIndex parent(const QModelIndex&) const override { return {}; }
  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;

 signals:
  void shown_changed();  ///< other pairs, or another order
  void order_kept();     ///< in_order may be another

 private:
  const PairTableModel* pairs_model() const { return static_cast<const PairTableModel*>(sourceModel()); }
  std::vector<motion::PairIndex> choose();
  std::vector<motion::PairIndex> keep_order(const std::vector<motion::PairIndex>& sorted) const;
  void keep_place();
  void show(std::vector<motion::PairIndex> shown);
  bool matches(motion::PairIndex pair) const;
  bool asks_for_marks() const;
  void keep_worst(std::vector<motion::PairIndex>& pairs) const;
  void sort_pairs(std::vector<motion::PairIndex>& pairs);
  void find_sort_keys();
  void set_shown(std::vector<motion::PairIndex> shown);
  void update_shown();
  void after_source_reset();

  PairCriteria criteria_;
  std::optional<motion::PairIndex> held_;
  bool held_is_extra_ = false;  // it is shown although the criteria leave it out
  bool in_order_ = true;
  std::size_t matching_ = 0;
  int sort_column_ = PairTableModel::Number;
  Qt::SortOrder sort_order_ = Qt::AscendingOrder;
  std::vector<motion::PairIndex> shown_;  // pair of each row
  std::vector<int> rows_;                 // row of each pair, -1 where it is not shown
  // Of all pairs, in the column they were last sorted by (-1: they have changed since); pairs are too large to be gone
  // through whenever a letter is typed.
  int known_column_ = -1;
  std::vector<double> sort_numbers_;
  std::vector<int> reason_ranks_;  // -1 where there is no reason
};

}  // namespace remount::widgets

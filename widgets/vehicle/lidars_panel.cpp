#include "widgets/vehicle/lidars_panel.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTabWidget>
#include <QTableView>
#include <QTextBrowser>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <functional>

#include "model/results/relative_record.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/theme.h"
#include "widgets/result/result_tables.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

/// Lets through the pairs of one LiDAR, or of two.
class CrossPairOrder : public QSortFilterProxyModel {
 public:
  using QSortFilterProxyModel::QSortFilterProxyModel;
  void choose(std::optional<motion::LidarIndex> first, std::optional<motion::LidarIndex> second) {
    first_ = first;
    second_ = second;
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex&) const override {
    const auto& pairs = static_cast<const CrossPairTableModel*>(sourceModel())->pairs();
    const calibration::CrossPair& cross = pairs[index_at(row)];
    const auto has = [&](motion::LidarIndex lidar) { return cross.lidar_a == lidar || cross.lidar_b == lidar; };
    return (!first_ || has(*first_)) && (!second_ || has(*second_));
  }
  /// Pairs without a number come last in either order.
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
    const QVariant a = left.data(CrossPairTableModel::SortRole), b = right.data(CrossPairTableModel::SortRole);
    if (a.typeId() != QMetaType::Double || b.typeId() != QMetaType::Double)
      return QSortFilterProxyModel::lessThan(left, right);
    const bool none_a = std::isnan(a.toDouble()), none_b = std::isnan(b.toDouble());
    if (none_a != none_b) return sortOrder() == Qt::AscendingOrder ? none_b : none_a;
    return !none_a && a.toDouble() < b.toDouble();
  }

 private:
  std::optional<motion::LidarIndex> first_, second_;
};

void prepare(QTableView& table) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.verticalHeader()->hide();
  table.setAlternatingRowColors(true);
  table.setWordWrap(false);
  table.horizontalHeader()->setHighlightSections(false);
}

}  // namespace

LidarsPanel::LidarsPanel(QWidget* parent)
    : QWidget(parent),
      model_(new LidarTableModel(this)),
      cross_model_(new CrossPairTableModel(this)),
      cross_order_(new CrossPairOrder(this)),
      table_(new QTableView),
      cross_table_(new QTableView),
      pages_(new QTabWidget),
      picture_(new VehiclePicture),
      words_(new QTextBrowser),
      hint_(new QLabel(tr("These recordings have one LiDAR. Where they have several, all of them are calibrated "
                          "together here."))) {
  pages_->addTab(make_table(), tr("Mountings"));
  words_->setFrameShape(QFrame::NoFrame);
  words_->setAccessibleName(tr("What the LiDARs say together"));
  pages_->addTab(picture_, tr("Vehicle"));
  pages_->addTab(words_, tr("Against each other"));
  pages_->addTab(make_cross_pairs(), tr("Pairs across"));
  pages_->setDocumentMode(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(2);
  layout->addLayout(make_buttons());
  layout->addWidget(pages_, 1);
  model_->set_palette(palette());
  cross_model_->set_palette(palette());
  connect(model_, &LidarTableModel::ticked, this, &LidarsPanel::ticked);
  show_lidars({});
  show_verdict({});
  allow(false, false, false);
}

QHBoxLayout* LidarsPanel::make_buttons() {
  auto* row = new QHBoxLayout;
  const auto add = [&](const QString& text, const QString& help, void (LidarsPanel::*signal)()) {
    auto* button = new QPushButton(text);
    button->setToolTip(help);
    row->addWidget(button);
    connect(button, &QPushButton::clicked, this, signal);
    return button;
  };
  calibrate_ = add(tr("Calibrate ticked"), tr("Calibrates each of the ticked LiDARs, then all of them together"),
                   &LidarsPanel::calibrate_clicked);
  solve_ =
      add(tr("Solve together again"), tr("From the pairs as they are now: after decisions on the pairs of one of them"),
          &LidarsPanel::solve_clicked);
  export_ = add(tr("Export…"), tr("The mountings of all of them, for other programs"), &LidarsPanel::export_clicked);
  save_ = add(tr("Save results…"), tr("Everything that is known of all of them, as a file that can be compared"),
              &LidarsPanel::save_clicked);
  row->addStretch();
  reference_ = new QComboBox;
  reference_->setSizeAdjustPolicy(QComboBox::AdjustToContents);  // LiDARs come after it is shown first
  reference_->setObjectName(QStringLiteral("reference"));
  reference_->setAccessibleName(tr("In whose frame the numbers are"));
  reference_->setToolTip(tr("In whose frame the numbers are: of the INS, or of a LiDAR"));
  row->addWidget(new QLabel(tr("in the frame of")));
  row->addWidget(reference_);
  connect(reference_, &QComboBox::currentIndexChanged, this, &LidarsPanel::show_reference);
  return row;
}

QWidget* LidarsPanel::make_table() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 2, 0, 0);
  table_->setModel(model_);
  prepare(*table_);
  // Sigmas stand below their values, so that all six columns have room.
  table_->verticalHeader()->setDefaultSectionSize(2 * table_->fontMetrics().lineSpacing() + 6);
  table_->setAccessibleName(tr("LiDARs of the vehicle"));
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  layout->addWidget(hint_, 1);
  layout->addWidget(table_, 1);
  connect(table_, &QTableView::activated, this, [this](const QModelIndex& index) {
    if (index.isValid()) emit lidar_chosen(index_at<motion::LidarIndex>(index.row()));
  });
  return box;
}

QWidget* LidarsPanel::make_cross_pairs() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(4, 4, 4, 4);
  cross_of_ = new QComboBox;
  cross_of_->setAccessibleName(tr("Pairs of which LiDARs are shown"));
  layout->addWidget(cross_of_);
  cross_order_->setSourceModel(cross_model_);
  cross_order_->setSortRole(CrossPairTableModel::SortRole);
  cross_table_->setModel(cross_order_);
  cross_table_->setSortingEnabled(true);
  cross_table_->sortByColumn(CrossPairTableModel::LidarA, Qt::AscendingOrder);
  prepare(*cross_table_);
  cross_table_->setAccessibleName(tr("Pairs across LiDARs"));
  cross_table_->setToolTip(tr("Scans of two LiDARs that see the same. A click shows them in the 3-D view."));
  layout->addWidget(cross_table_);
  connect(cross_of_, &QComboBox::currentIndexChanged, this, &LidarsPanel::filter_cross_pairs);
  const auto choose = [this](const QModelIndex& index) {
    if (index.isValid()) emit cross_pair_chosen(index_at<CrossPairIndex>(cross_order_->mapToSource(index).row()));
  };
  connect(cross_table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, choose);
  connect(cross_table_, &QTableView::activated, this, choose);
  return box;
}

void LidarsPanel::show_lidars(std::vector<LidarEntry> lidars) {
  const bool other = lidars.size() != model_->lidars().size();
  hint_->setVisible(lidars.size() < 2);
  table_->setVisible(lidars.size() >= 2);
  model_->show_lidars(std::move(lidars));
  if (other) table_->resizeColumnsToContents();
}

void LidarsPanel::allow(bool calibrate, bool solve, bool write) {
  calibrate_->setEnabled(calibrate);
  solve_->setEnabled(solve);
  export_->setEnabled(write);
  save_->setEnabled(write);
}

QString LidarsPanel::reference() const { return reference_->currentData().toString(); }

void LidarsPanel::offer_references() {
  const QString before = reference();
  const QSignalBlocker quiet(reference_);
  reference_->clear();
  reference_->addItem(tr("the INS"), QString());
  if (file_)
    for (const results::LidarResult& lidar : file_->lidars)
      if (lidar.joined) {
        const QString name = QString::fromStdString(lidar.name);
        reference_->addItem(name, name);
      }
  reference_->setCurrentIndex(std::max(0, reference_->findData(before)));
}

void LidarsPanel::show_reference() {
  std::optional<LidarTableModel::Relatives> relatives;
  if (file_ && !reference().isEmpty()) {
    relatives.emplace();
    for (const results::LidarResult& lidar : file_->lidars)
      if (const auto two = results::relative_record(*file_, reference().toStdString(), lidar.name))
        relatives->emplace(QString::fromStdString(lidar.name),
                           LidarTableModel::Numbers{two->lidar_a_from_lidar_b, two->sigma});
  }
  model_->show_relative(std::move(relatives));
  table_->resizeColumnsToContents();
}

void LidarsPanel::show_verdict(const VehicleVerdict& verdict) {
  verdict_ = verdict;
  if (file_ == verdict.file && file_) {
    show_words(verdict);
    return;
  }
  file_ = verdict.file;
  show_words(verdict);
  offer_references();
  show_reference();
}

/// The gravest first, with the sign and the colour of their severity.
QString LidarsPanel::findings_of(const results::VehicleFile& vehicle) const {
  std::vector<drive::Finding> findings = vehicle.findings;
  std::ranges::stable_sort(findings, std::greater(), &drive::Finding::severity);
  QString html;
  for (const drive::Finding& finding : findings) {
    const QString text = QStringLiteral("%1 %2").arg(
        severity_sign(finding.severity),
        tr("%1: %2").arg(model_text(finding.where.words()), model_text(finding.explanation)));
    html += QStringLiteral("<li><span style='color:%1'>%2</span></li>")
                .arg(severity_color(finding.severity, palette()).name(), text.toHtmlEscaped());
  }
  if (html.isEmpty()) return {};
  return "<p><b>" + tr("To look at").toHtmlEscaped() + "</b></p><ul style='margin-left:-22px; margin-top:0'>" + html +
         "</ul>";
}

void LidarsPanel::show_words(const VehicleVerdict& verdict) {
  words_->setHtml(words_of(verdict));
  drive::Severity gravest = drive::Severity::Note;
  if (verdict.file)
    for (const drive::Finding& finding : verdict.file->findings) gravest = std::max(gravest, finding.severity);
  const QString title = tr("Against each other");
  pages_->setTabText(pages_->indexOf(words_),
                     gravest == drive::Severity::Note ? title : severity_sign(gravest) + ' ' + title);
}

QString LidarsPanel::words_of(const VehicleVerdict& verdict) const {
  if (!verdict.file)
    return "<p>" + tr("Tick the LiDARs and calibrate: each is calibrated alone, then all of them together.") + "</p>";
  QString html;
  if (!verdict.up_to_date)
    html += "<p><b>" +
            tr("▲ Something has changed since they were solved together. Solve them together again.").toHtmlEscaped() +
            "</b></p>";
  QStringList heights, agreements, surfaces;
  for (const Message& height : verdict.heights) heights << model_text(height);
  for (const results::AgreementRecord& two : verdict.file->agreements)
    if (two.most_sigmas > 0.0)
      agreements << tr("%1 and %2: within %3 sigma")
                        .arg(QString::fromStdString(two.lidar_a), QString::fromStdString(two.lidar_b))
                        .arg(two.most_sigmas, 0, 'f', 1);
  for (const SurfacesOfTwo& two : verdict.surfaces)
    surfaces << tr("%1 and %2: %3 mm together, %4 mm alone")
                    .arg(two.lidar_a, two.lidar_b)
                    .arg(1e3 * two.together_m, 0, 'f', 1)
                    .arg(1e3 * two.alone_m, 0, 'f', 1);
  html += findings_of(*verdict.file) + html_list(tr("Heights"), heights) +
          html_list(tr("Distance of surfaces that two of them see (noise of the ranges is in it)"), surfaces) +
          html_list(tr("What they see of each other against what the INS says"), agreements);
  return html;
}

void LidarsPanel::show_cross_pairs(std::vector<calibration::CrossPair> pairs, const QStringList& names) {
  std::vector<std::pair<motion::LidarIndex, motion::LidarIndex>> twos;
  for (const calibration::CrossPair& cross : pairs)
    if (std::ranges::find(twos, std::pair(cross.lidar_a, cross.lidar_b)) == twos.end())
      twos.emplace_back(cross.lidar_a, cross.lidar_b);
  cross_model_->show_pairs(std::move(pairs), names);
  const QSignalBlocker quiet(cross_of_);
  cross_of_->clear();
  cross_of_->addItem(tr("All pairs across LiDARs"));
  for (qsizetype lidar = 0; lidar < names.size(); ++lidar)
    cross_of_->addItem(tr("Of %1").arg(names[lidar]), QPoint(static_cast<int>(lidar), -1));
  for (const auto& [a, b] : twos)
    cross_of_->addItem(tr("Of %1 and %2").arg(names.value(qt_row(a)), names.value(qt_row(b))),
                       QPoint(qt_row(a), qt_row(b)));
  filter_cross_pairs();
  cross_table_->resizeColumnsToContents();
}

void LidarsPanel::filter_cross_pairs() {
  const QVariant chosen = cross_of_->currentData();
  const QPoint of = chosen.isValid() ? chosen.toPoint() : QPoint(-1, -1);
  static_cast<CrossPairOrder*>(cross_order_)
      ->choose(at_row<motion::LidarIndex>(of.x()), at_row<motion::LidarIndex>(of.y()));
}

void LidarsPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange) return;
  show_words(verdict_);
  model_->set_palette(palette());
  cross_model_->set_palette(palette());
}

}  // namespace remount::widgets

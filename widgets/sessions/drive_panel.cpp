#include "widgets/sessions/drive_panel.h"

#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <cmath>

#include "widgets/basics/rows.h"
#include "widgets/sessions/drive_map.h"
#include "widgets/sessions/drive_timeline.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

QString stream_figures(const QString& name, const overview::StreamReport& stream) {
  if (stream.count == 0) return DrivePanel::tr("%1: none").arg(name);
  const QString gaps = stream.gaps == 0
                           ? DrivePanel::tr("no gaps")
                           : DrivePanel::tr("%n gaps, the longest %1 s", nullptr, static_cast<int>(stream.gaps))
                                 .arg(stream.longest_gap_s, 0, 'f', 2);
  return DrivePanel::tr("%1: %2 at %3 Hz, %4").arg(name).arg(stream.count).arg(stream.rate_hz, 0, 'f', 1).arg(gaps);
}

}  // namespace

QString drive_figures(const overview::DriveOverview& drive) {
  QStringList lines{
      stream_figures(DrivePanel::tr("LiDAR"), drive.lidar), stream_figures(DrivePanel::tr("INS"), drive.ins),
      DrivePanel::tr("%1 s, %2 m travelled").arg(drive.duration_s, 0, 'f', 1).arg(drive.travelled_m, 0, 'f', 0)};
  const QString told = shown_parameter_names(drive.outlook.determinable),
                untold = shown_parameter_names(~drive.outlook.determinable);
  if (drive.outlook.judged && untold.isEmpty()) lines << DrivePanel::tr("Its motion can tell all of X");
  if (drive.outlook.judged && !untold.isEmpty())
    lines << (told.isEmpty() ? DrivePanel::tr("Its motion can tell nothing of X")
              : drive.outlook.needs_nominal
                  ? DrivePanel::tr("Given a nominal mounting, its motion can tell %1; not %2. Without one, nothing")
                        .arg(told, untold)
                  : DrivePanel::tr("Its motion can tell %1; not %2").arg(told, untold));
  if (const QString open = shown_parameter_names(drive.outlook.open); drive.outlook.judged && !open.isEmpty())
    lines << DrivePanel::tr("Close to the limit, the calibration may find otherwise: %1").arg(open);
  return lines.join('\n');
}

DrivePanel::DrivePanel(QWidget* parent)
    : QWidget(parent),
      session_(new QComboBox(this)),
      figures_(new QLabel(this)),
      map_(new DriveMap(this)),
      timeline_(new DriveTimeline(this)) {
  session_->setAccessibleName(tr("Drive that is shown"));
  session_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  figures_->setWordWrap(true);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  figures_->setAccessibleName(tr("Streams of the drive"));
  map_->setToolTip(tr("Click selects a pair, the wheel zooms, dragging pans, Home shows all"));
  connect(session_, &QComboBox::currentIndexChanged, this, &DrivePanel::show_drive);
  connect(map_, &DriveMap::pair_clicked, this, &DrivePanel::pair_selected);
  connect(timeline_, &DriveTimeline::time_clicked, this, &DrivePanel::select_at);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(map_);
  splitter->addWidget(timeline_);
  splitter->setStretchFactor(0, 3);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  splitter->setSizes({400, 190});
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 4, 6, 4);
  column->addWidget(session_);
  column->addWidget(figures_);
  column->addWidget(splitter, 1);
  show_drive();
}

std::optional<motion::SessionIndex> DrivePanel::shown_session() const {
  return at_row<motion::SessionIndex>(session_->currentIndex());
}

std::shared_ptr<const overview::DriveOverview> DrivePanel::drive() const {
  const std::optional<motion::SessionIndex> session = shown_session();
  return session && *session < drives_.size() ? drives_[*session] : nullptr;
}

void DrivePanel::show_drives(const QStringList& names,
                             std::vector<std::shared_ptr<const overview::DriveOverview>> drives) {
  drives_ = std::move(drives);
  {
    const QSignalBlocker quiet(session_);
    const int before = session_->currentIndex();
    session_->clear();
    session_->addItems(names);
    session_->setCurrentIndex(std::clamp(before, names.isEmpty() ? -1 : 0, qt_count(names.size()) - 1));
  }
  show_drive();
}

void DrivePanel::show_drive() {
  session_->setVisible(session_->count() > 1);
  const auto shown = drive();
  figures_->setText(shown ? drive_figures(*shown) : QString());
  map_->show_drive(shown, shown_session().value_or(motion::SessionIndex{0}));
  timeline_->show_drive(shown);
  map_->show_selected(selected_);
  const bool here = shown && selected_ && session_of(*selected_) == shown_session();
  if (!here) return timeline_->show_times(std::nullopt);
  const motion::Pair& pair = output_->pairs[*selected_];
  timeline_->show_times(std::pair{time_s(pair.keyframe_a), time_s(pair.keyframe_b)});
}

void DrivePanel::show_output(std::shared_ptr<const pipeline::PipelineOutput> output) {
  output_ = std::move(output);
  map_->show_output(output_);
  if (!output_ || (selected_ && *selected_ >= output_->pairs.size())) selected_.reset();
}

motion::SessionIndex DrivePanel::session_of(motion::PairIndex pair) const {
  return output_->keyframes[output_->pairs[pair].keyframe_a].session;
}

double DrivePanel::time_s(motion::KeyframeIndex keyframe) const {
  return drive()->time_s(output_->keyframes[keyframe].stamp_ns);
}

void DrivePanel::show_selected(std::optional<motion::PairIndex> pair) {
  selected_ = output_ && pair && *pair < output_->pairs.size() ? pair : std::nullopt;
  if (selected_ && qt_row(session_of(*selected_)) < session_->count()) {
    const QSignalBlocker quiet(session_);
    session_->setCurrentIndex(qt_row(session_of(*selected_)));
  }
  show_drive();
}

void DrivePanel::select_at(double wanted_s) {
  if (!output_ || !drive()) return;
  std::optional<motion::PairIndex> nearest;
  double least_s = std::numeric_limits<double>::infinity();
  for (motion::PairIndex index; index < output_->pairs.size(); ++index) {
    if (session_of(index) != shown_session()) continue;
    const motion::Pair& pair = output_->pairs[index];
    const double off_s = std::abs(0.5 * (time_s(pair.keyframe_a) + time_s(pair.keyframe_b)) - wanted_s);
    if (off_s >= least_s) continue;
    least_s = off_s;
    nearest = index;
  }
  if (nearest) emit pair_selected(*nearest);
}

}  // namespace remount::widgets

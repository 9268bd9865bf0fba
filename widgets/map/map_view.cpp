#include "widgets/map/map_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QToolButton>

#include "algorithms/core/index.h"
#include "widgets/basics/color_bar.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/swatch.h"
#include "widgets/scene/distance_scale.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {

MapView::MapView(QWidget* parent)
    : SceneView(tr("3-D view of the accumulated map"), parent),
      caption_(new QLabel(this)),
      drawn_(new QLabel(this)),
      legend_(new QWidget(this)),
      work_(new QWidget(this)),
      low_(new QLabel(this)),
      high_(new QLabel(this)),
      heights_(new ColorBar([](double share) { return to_qt(scene::DistanceScale::at(share)); }, this)),
      progress_(new QProgressBar(this)),
      again_(new QPushButton(tr("Make the map"), this)),
      finer_(new QTimer(this)) {
  make_buttons();
  auto* legend = new QHBoxLayout(legend_);
  legend->setContentsMargins(0, 0, 0, 0);
  legend->addWidget(low_);
  legend->addWidget(heights_, 1);
  legend->addWidget(high_);
  legend->addSpacing(8);
  legend->addWidget(drawn_);
  auto* work = new QHBoxLayout(work_);
  work->setContentsMargins(0, 0, 0, 0);
  auto* cancel = new QPushButton(tr("Cancel"), work_);
  progress_->setAccessibleName(tr("Progress of the map"));
  work->addWidget(progress_, 1);
  work->addWidget(cancel);
  connect(cancel, &QPushButton::clicked, this, &MapView::cancel_clicked);
  connect(again_, &QPushButton::clicked, this, &MapView::map_wanted);
  caption_->setWordWrap(true);
  for (QWidget* widget : std::initializer_list<QWidget*>{legend_, work_, again_, caption_}) add_below(widget);
  work_->hide();
  again_->hide();
  finer_->setSingleShot(true);
  finer_->setInterval(0);  // between two pieces the window attends to the user
  connect(finer_, &QTimer::timeout, this, &MapView::draw_more);
  set_stage(scene_.stage());
  palette_changed();
  pixel_ratio_changed(devicePixelRatioF());
  show_message(tr("The scans of a session, put together under one mounting, are shown here after a calibration."));
}

MapView::~MapView() = default;

void MapView::make_buttons() {
  QHBoxLayout* row = add_row();
  const std::array<std::pair<QString, QString>, 3> names{{
      {tr("Nominal"), tr("The scans put together under the mounting that the calibration started from")},
      {tr("Candidate"), tr("… under the candidate that is selected in the table of candidates")},
      {tr("Result"), tr("… under the present result")},
  }};
  for (std::size_t i = 0; i < names.size(); ++i) {
    xs_[i] = add_button(row, names[i].first, names[i].second, true);
    xs_[i]->setChecked(i == index_of(x_));
    connect(xs_[i], &QToolButton::clicked, this, [this, i] { choose(static_cast<MapX>(i)); });
  }
  session_ = new QComboBox(this);
  session_->setAccessibleName(tr("Session of the map"));
  session_->setToolTip(tr("The session whose scans are put together"));
  session_->hide();
  connect(session_, &QComboBox::currentIndexChanged, this, &MapView::map_wanted);
  row->addWidget(session_);
  row->addStretch();
  add_shading_button(row);
  add_common_buttons(row);
}

void MapView::show_choices(const QStringList& sessions, const QString& nominal, const QString& candidate) {
  const QSignalBlocker quiet(session_);
  const int before = std::max(0, session_->currentIndex());
  session_->clear();
  session_->addItems(sessions);
  session_->setCurrentIndex(before < sessions.size() ? before : sessions.isEmpty() ? -1 : 0);
  session_->setVisible(sessions.size() > 1);
  xs_[0]->setText(nominal);
  xs_[0]->setAccessibleName(nominal);
  xs_[1]->setEnabled(has_gl() && !candidate.isEmpty());
  xs_[1]->setText(candidate.isEmpty() ? tr("Candidate") : candidate);
  xs_[1]->setAccessibleName(xs_[1]->text());
  if (candidate.isEmpty() && x_ == MapX::Candidate) choose(MapX::Result);
}

motion::SessionIndex MapView::chosen_session() const {
  return at_row<motion::SessionIndex>(session_->currentIndex()).value_or(motion::SessionIndex{0});
}

void MapView::choose(MapX x) {
  x_ = x;
  for (std::size_t i = 0; i < xs_.size(); ++i) xs_[i]->setChecked(i == index_of(x));
  emit map_wanted();
}

void MapView::show_progress(const Message& stage, qulonglong done, qulonglong total) {
  if (!data_ && !work_->isVisible()) {
    show_message(tr("The map is being made…"));
    allow_choice();
  }
  work_->show();
  again_->hide();
  progress_->setRange(0, static_cast<int>(total));
  progress_->setValue(static_cast<int>(done));
  progress_->setFormat(total > 0 ? tr("%1: %2 of %3").arg(model_text(stage)).arg(done).arg(total) : model_text(stage));
}

void MapView::show_map(const QString& caption, scene::MapSceneDataPtr scene_data) {
  work_->hide();
  again_->hide();
  caption_->setText(caption);
  if (!has_gl()) return;
  clear_marks();
  data_ = std::move(scene_data);
  show_scene();
  legend_->show();
  const scene::MapFacts facts = scene::facts_of(*data_);
  low_->setText(tr("Height: %1 m").arg(facts.low_m, 0, 'f', 1));
  high_->setText(tr("%1 m").arg(facts.high_m, 0, 'f', 1));
  for (QWidget* of_heights : std::initializer_list<QWidget*>{low_, heights_, high_})
    of_heights->setVisible(facts.by_height);
  scene_.set_map(data_);
  if (!framed_) scene_.stage().look(scene::StandardView::Isometric);
  framed_ = true;  // afterwards the view stays, so that one mounting is compared with the other
  begin();
  render();
}

void MapView::show_message(const QString& text) {
  SceneView::show_message(text);
  finer_->stop();
  data_ = nullptr;
  scene_.clear();
  work_->hide();
  again_->hide();
  legend_->hide();
  caption_->clear();
  framed_ = false;
}

void MapView::allow_choice() { enable_buttons(has_gl()); }

void MapView::offer_again() { again_->setVisible(has_gl()); }

void MapView::begin() {
  scene_.begin();
  if (data_) finer_->start();
}

void MapView::draw_more() {
  if (!shows_scene() || !isVisible()) return;
  if (scene_.refine()) {
    render();
    finer_->start();
  }
  update_caption();
}

bool MapView::rests() const { return !finer_->isActive() && !scene_.moving(); }

void MapView::update_caption() {
  if (!data_) return;
  const QLocale locale;
  const std::size_t shown = scene_.points_shown(), all = scene::facts_of(*data_).points;
  drawn_->setText(shown >= all ? tr("%1 points").arg(locale.toString(static_cast<qulonglong>(all)))
                               : tr("%1 of %2 points")
                                     .arg(locale.toString(static_cast<qulonglong>(shown)),
                                          locale.toString(static_cast<qulonglong>(all))));
}

std::optional<SceneView::Pick> MapView::pick(const scene::PickRay& ray) const {
  const auto point = scene_.pick(ray);
  if (!point) return std::nullopt;
  return Pick{*point, tr("x %1, y %2, z %3 m in %4.")
                          .arg(rounded_text(point->x(), 3))
                          .arg(rounded_text(point->y(), 3))
                          .arg(rounded_text(point->z(), 3))
                          .arg(axes_in_words())};
}

QString MapView::axes_in_words() const { return tr("axes of the INS data, origin at the first keyframe"); }

void MapView::pixel_ratio_changed(double ratio) { scene_.set_pixel_ratio(ratio); }

void MapView::motion_changed(bool moving) {
  scene_.set_moving(moving);
  if (moving) {
    finer_->stop();
    return;
  }
  render();  // with the mouse at rest
  if (data_) finer_->start();
}

void MapView::showEvent(QShowEvent* event) {
  SceneView::showEvent(event);
  begin();
  emit map_wanted();
}

}  // namespace remount::widgets

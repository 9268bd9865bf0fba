#include "widgets/pairs/pair_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <cmath>

#include "algorithms/core/index.h"
#include "algorithms/quality/surface_distance.h"
#include "widgets/basics/distance_legend.h"
#include "widgets/basics/rows.h"
#include "widgets/basics/swatch.h"
#include "widgets/basics/theme.h"
#include "widgets/basics/value_legend.h"
#include "widgets/scene/pair_colors.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {
constexpr int kBlinkPeriod_ms = 500, kSliderSteps = 100;
constexpr std::size_t kKnown = 6;

bool same(const RigidTransform& first, const RigidTransform& second) { return difference(first, second).norm() < 1e-9; }
}  // namespace

PairView::PairView(QWidget* parent)
    : SceneView(tr("3-D view of the pair"), parent),
      caption_(new QLabel(this)),
      legend_(new DistanceLegend(this)),
      values_(new ValueLegend(this)),
      timer_(new QTimer(this)) {
  make_buttons();
  caption_->setWordWrap(true);
  caption_->setTextFormat(Qt::RichText);
  // Of one line as of two, or the picture would jump from pair to pair.
  caption_->setFixedHeight(2 * caption_->fontMetrics().lineSpacing() + 2);
  caption_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  add_below(legend_);
  add_below(values_);
  values_->hide();
  add_below(caption_);
  legend_->hide();
  connect(legend_, &DistanceLegend::limit_edited, this, &PairView::set_scale);
  timer_->setInterval(kBlinkPeriod_ms);
  connect(timer_, &QTimer::timeout, this, &PairView::flip);
  set_stage(scene_.stage());
  palette_changed();
  pixel_ratio_changed(devicePixelRatioF());
  show_message(tr("Select a pair to see its two scans."));
}

PairView::~PairView() = default;

void PairView::make_buttons() {
  QHBoxLayout* first = add_row();
  add_alignment_buttons(first);
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setRange(0, kSliderSteps);
  slider_->setValue(kSliderSteps);
  slider_->setMinimumWidth(60);
  slider_->setEnabled(has_gl());
  slider_->setAccessibleName(tr("From before to after"));
  slider_->setToolTip(tr("Moves scan a from where it was before (left) to where the chosen alignment puts it (right)"));
  connect(slider_, &QSlider::valueChanged, this, [this](int value) { show_share(value / double(kSliderSteps)); });
  first->addWidget(slider_, 1);
  blink_ = add_button(first, tr("Blink"), tr("Shows before and after in turn (B); Space flips once"), true);
  connect(blink_, &QToolButton::toggled, this, &PairView::set_blinking);
  side_by_side_ = add_button(first, tr("Side by side"),
                             tr("Before on the left, after on the right; both are turned together"), true);
  connect(side_by_side_, &QToolButton::toggled, this, &PairView::set_side_by_side);
  QHBoxLayout* second = add_row();
  add_coloring(second);
  second->addStretch();
  objects_ = add_button(
      second, tr("Objects"),
      tr("Boxes of the objects that both scans contain, joined by lines; moving ones are red and crossed out"), true);
  objects_->setChecked(true);
  connect(objects_, &QToolButton::toggled, this, [this](bool on) {
    scene_.show_objects(on);
    update_caption();
    render();
  });
  ground_ = add_button(second, tr("Ground"), tr("Shows the points of the ground (G)"), true);
  ground_->setChecked(true);
  connect(ground_, &QToolButton::toggled, this, &PairView::show_ground);
  add_shading_button(second);
  add_common_buttons(second);
}

void PairView::add_alignment_buttons(QHBoxLayout* row) {
  const std::array<std::pair<QString, QString>, 3> names{{
      {tr("Before"), tr("As predicted by the INS and the mounting the calibration started from")},
      {tr("Aligned"), tr("As the two scans were aligned with each other")},
      {tr("With result"), tr("As predicted by the INS and the present result")},
  }};
  for (std::size_t i = 0; i < names.size(); ++i) {
    alignments_[i] = add_button(row, names[i].first, names[i].second, true);
    connect(alignments_[i], &QToolButton::clicked, this,
            [this, i] { show_alignment(static_cast<scene::PairAlignment>(i)); });
  }
}

void PairView::add_coloring(QHBoxLayout* row) {
  auto* label = new QLabel(tr("Colour:"), this);
  coloring_ = new QComboBox(this);
  coloring_->addItems({tr("Scan a orange"), tr("Scan a blue"), tr("Distance"), tr("Distance, with side"), tr("Height"),
                       tr("Intensity"), tr("Ring"), tr("Time in the scan")});
  coloring_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  coloring_->setMinimumContentsLength(10);
  coloring_->setAccessibleName(tr("Colour of the points"));
  coloring_->setToolTip(
      tr("Scan a in one colour, or by the distance of each point to the surfaces of scan b; or both "
         "scans by what was measured of each point"));
  coloring_->setEnabled(has_gl());
  label->setBuddy(coloring_);
  connect(coloring_, &QComboBox::currentIndexChanged, this,
          [this](int index) { set_coloring(static_cast<scene::PairColoring>(index)); });
  row->addWidget(label);
  row->addWidget(coloring_);
}

void PairView::show_message(const QString& text) {
  SceneView::show_message(text);
  pair_caption_.clear();
  data_ = nullptr;
  known_.clear();
  legend_->show_medians({});
  update_caption();
}

void PairView::show_pair(const QString& caption, scene::PairSceneDataPtr scene_data,
                         const scene::PairTransforms& transforms) {
  pair_caption_ = caption;
  if (!has_gl()) return update_caption();
  clear_marks();
  data_ = std::move(scene_data);
  known_.clear();
  show_scene();
  scene_.set_pair(data_, transforms);
  view_from_lidar_b_ = transforms.view_from_lidar_b;
  show_legend();
  offer_current(transforms.current_known);
  if (!framed_) scene_.stage().look(scene::StandardView::Isometric);
  draw_quickly();
  framed_ = true;  // afterwards the view stays where the user has put it, from pair to pair
  apply();
}

void PairView::show_transforms(const QString& caption, const scene::PairTransforms& transforms) {
  if (pair_caption_.isEmpty()) return;
  pair_caption_ = caption;
  if (!shows_scene()) return update_caption();
  clear_marks();
  scene_.set_transforms(transforms);
  offer_current(transforms.current_known);
  apply();
}

void PairView::name_current(const QString& candidate) {
  QToolButton& button = *alignments_[index_of(scene::PairAlignment::CurrentX)];
  button.setText(candidate.isEmpty() ? tr("With result") : tr("With %1").arg(candidate));
  button.setToolTip(candidate.isEmpty() ? tr("As predicted by the INS and the present result")
                                        : tr("As predicted by the INS and this candidate: %1").arg(candidate));
  button.setAccessibleName(button.text());
}

void PairView::show_alignment(scene::PairAlignment alignment) {
  if (alignment != scene::PairAlignment::Before) chosen_ = alignment;
  show_share(alignment == scene::PairAlignment::Before ? 0.0 : 1.0);
}

scene::PairAlignment PairView::alignment() const { return share_ > 0.0 ? after() : scene::PairAlignment::Before; }

void PairView::show_share(double share) {
  share_ = std::clamp(share, 0.0, 1.0);
  const QSignalBlocker quiet(slider_);
  slider_->setValue(static_cast<int>(std::lround(share_ * kSliderSteps)));
  apply();
}

void PairView::flip() { show_share(share_ > 0.0 ? 0.0 : 1.0); }

void PairView::set_blinking(bool on) {
  blink_->setChecked(on);
  on ? timer_->start() : timer_->stop();
}

bool PairView::blinking() const { return timer_->isActive(); }

void PairView::set_side_by_side(bool on) {
  side_by_side_->setChecked(on);
  if (on && share_ == 0.0) return show_share(1.0);  // or both would show the same
  apply();
}

/// What the present result says cannot be shown where there is none: it would be the start under another name.
void PairView::offer_current(bool known) {
  alignments_[index_of(scene::PairAlignment::CurrentX)]->setEnabled(has_gl() && known);
  current_known_ = known;
}

/// The alignment that was chosen, which comes back with a result to show.
scene::PairAlignment PairView::after() const {
  return chosen_ == scene::PairAlignment::CurrentX && !current_known_ ? scene::PairAlignment::Registered : chosen_;
}

void PairView::apply() {
  const bool side_by_side = side_by_side_->isChecked();
  for (std::size_t i = 0; i < alignments_.size(); ++i) {
    const auto alignment = static_cast<scene::PairAlignment>(i);
    const bool is_shown =
        alignment == scene::PairAlignment::Before ? share_ == 0.0 : alignment == after() && share_ == 1.0;
    alignments_[i]->setChecked(is_shown);
  }
  scene_.show(after(), share_, side_by_side);
  color_by_distance();
  update_caption();
  render();
}

void PairView::set_coloring(scene::PairColoring coloring) {
  const QSignalBlocker quiet(coloring_);
  coloring_->setCurrentIndex(static_cast<int>(coloring));
  scene_.set_coloring(coloring);
  show_legend();
  color_by_distance();
  update_caption();
  render();
}

scene::PairColoring PairView::coloring() const { return static_cast<scene::PairColoring>(coloring_->currentIndex()); }

void PairView::show_legend() {
  legend_->setVisible(is_by_distance(coloring()));
  legend_->show_sides(coloring() == scene::PairColoring::SignedDistance);
  const bool by_value = coloring() >= scene::PairColoring::Height;
  values_->setVisible(by_value);
  if (!by_value) return;
  const auto range = scene_.value_range();
  const QString unit = coloring() == scene::PairColoring::Height ? tr("m")
                       : coloring() == scene::PairColoring::Time ? tr("s")
                                                                 : QString();
  if (range)
    values_->show_range(coloring_->currentText(), range->first, range->second, unit);
  else
    values_->show_message(tr("These scans have no such values."));
}

void PairView::show_ground(bool visible) {
  const QSignalBlocker quiet(ground_);
  ground_->setChecked(visible);
  emit ground_shown(visible);
  scene_.show_ground(visible);
  render();
}

bool PairView::shows_ground() const { return ground_->isChecked(); }

void PairView::fill_menu(QMenu& menu, const std::optional<Pick>& picked) {
  if (!picked || !data_) return;
  menu.addAction(tr("Section through this point"), this,
                 [this, point = picked->point_in_view] { emit section_wanted(view_from_lidar_b_.inverse() * point); });
}

void PairView::set_scale(double limit_m) {
  legend_->set_limit(limit_m);
  scene_.set_scale(legend_->limit_m());
  emit scale_changed(legend_->limit_m());
  render();
}

double PairView::scale_m() const { return legend_->limit_m(); }

bool PairView::use_known_distances() {
  const int panes = scene_.stage().shown_panes();
  std::vector<float> medians_m;
  std::vector<const std::vector<float>*> found;
  for (int pane = 0; pane < panes; ++pane)
    for (const auto& [transform, distances_m] : known_)
      if (same(transform, scene_.lidar_b_from_lidar_a(pane))) {
        found.push_back(&distances_m);
        medians_m.push_back(quality::median_distance_m(distances_m));
        break;
      }
  if (qt_count(found.size()) < panes) return false;
  for (int pane = 0; pane < panes; ++pane) scene_.set_distances(pane, *found[index_at(pane)]);
  legend_->show_medians(medians_m);
  return true;
}

void PairView::color_by_distance() {
  ++request_;
  if (!is_by_distance(coloring()) || !data_ || use_known_distances()) return;
  legend_->show_medians({});
  DistanceRequest request{request_, data_, {}};
  for (int pane = 0; pane < scene_.stage().shown_panes(); ++pane)
    request.lidar_b_from_lidar_a.push_back(scene_.lidar_b_from_lidar_a(pane));
  emit distances_wanted(request);
}

void PairView::show_distances(const DistanceRequest& request, std::vector<std::vector<float>> distances_m) {
  if (request.data != data_ || distances_m.size() != request.lidar_b_from_lidar_a.size()) return;
  for (std::size_t i = 0; i < distances_m.size(); ++i) {
    if (known_.size() >= kKnown) known_.erase(known_.begin());
    known_.emplace_back(request.lidar_b_from_lidar_a[i], std::move(distances_m[i]));
  }
  if (request.number != request_) return;  // scan a has moved since
  use_known_distances();
  render();
}

std::optional<SceneView::Pick> PairView::pick(const scene::PickRay& ray) const {
  const auto picked = scene_.pick(ray);
  if (!picked) return std::nullopt;
  const auto text = [](const Eigen::Vector3d& point) {
    return tr("x %1, y %2, z %3 m")
        .arg(rounded_text(point.x(), 3))
        .arg(rounded_text(point.y(), 3))
        .arg(rounded_text(point.z(), 3));
  };
  const QString own = picked->in_scan_a ? tr("scan a") : tr("scan b"),
                other = picked->in_scan_a ? tr("scan b") : tr("scan a");
  QString words = tr("Point of %1: %2 in LiDAR axes of %1; %3 in %4. ")
                      .arg(own, text(picked->point_in_lidar), text(picked->point_in_view), axes_in_words());
  words += std::isnan(picked->distance_m) ? tr("Nothing of %1 within %2 m as shown.")
                                                .arg(other)
                                                .arg(static_cast<double>(quality::SurfaceDistance::kReach_m))
                                          : tr("%1 m from the surfaces of %2 as shown.")
                                                .arg(static_cast<double>(picked->distance_m), 0, 'f', 3)
                                                .arg(other);
  return Pick{picked->point_in_view, words};
}

QString PairView::axes_in_words() const { return tr("INS axes at scan b"); }

void PairView::pixel_ratio_changed(double ratio) { scene_.set_pixel_ratio(ratio); }

void PairView::motion_changed(bool moving) {
  scene_.set_moving(moving);
  if (!moving) render();
}

void PairView::palette_changed() {
  scene_.set_dark(is_dark(palette()));
  update_caption();
}

void PairView::update_caption() {
  if (pair_caption_.isEmpty()) {
    caption_->clear();
    return;
  }
  const scene::ScanColors scans = scene::scan_colors(is_dark(palette()));
  const QString box = QStringLiteral("□");
  QStringList parts{pair_caption_.toHtmlEscaped()};
  const auto coloring = static_cast<scene::PairColoring>(coloring_->currentIndex());
  if (coloring == scene::PairColoring::Orange || coloring == scene::PairColoring::Blue)
    parts << swatch(coloring == scene::PairColoring::Orange ? scans.orange : scans.blue, tr("scan a"));
  if (coloring < scene::PairColoring::Height) parts << swatch(scans.target, tr("scan b"));
  if (objects_->isChecked() && scene_.has_objects(false))
    parts << swatch(scene::kObjectA, tr("objects a"), box) << swatch(scene::kObjectB, tr("b"), box);
  if (objects_->isChecked() && scene_.has_objects(true))
    parts << swatch(scene::kMoving, tr("moving"), QStringLiteral("☒"));
  if (side_by_side_->isChecked())
    parts << tr("left: before, right: %1")
                 .arg(share_ == 1.0 ? alignments_[index_of(after())]->text()
                                    : tr("%1 % of the way").arg(std::lround(100 * share_)));
  caption_->setText(parts.join(QStringLiteral(" &nbsp; ")));
  caption_->setToolTip(caption_->text());
}

}  // namespace remount::widgets

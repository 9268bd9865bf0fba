#include "widgets/map/path_view.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <algorithm>
#include <array>

#include "algorithms/core/index.h"
#include "algorithms/geometry/rotation.h"
#include "model/report/plot_chart.h"
#include "widgets/basics/theme.h"
#include "widgets/text/model_text.h"
#include "widgets/text/parameter_text.h"

namespace remount::widgets {
namespace {

bool in_space(const calibration::Curve& curve) { return !curve.z.empty() && curve.z.size() == curve.y.size(); }

QColor color_of(std::size_t curve, const QPalette& palette) {
  const QColor color(QString::fromLatin1(report::curve_color(curve)));
  return is_dark(palette) ? color.lighter(150) : color;
}

scene::ScenePath path_of(const calibration::Curve& curve, const QColor& color) {
  scene::ScenePath path;
  path.dots = curve.dots;
  path.color = {static_cast<unsigned char>(color.red()), static_cast<unsigned char>(color.green()),
                static_cast<unsigned char>(color.blue())};
  if (!in_space(curve)) return path;
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.z.size()); ++i)
    path.points_m.emplace_back(curve.x[i], curve.y[i], curve.z[i]);
  return path;
}

}  // namespace

PathView::PathView(QWidget* parent) : SceneView(tr("3-D view of the method"), parent), legend_(new QLabel(this)) {
  make_buttons();
  legend_->setTextFormat(Qt::RichText);
  legend_->setWordWrap(true);
  legend_->setAccessibleName(tr("Colours of the ways"));
  add_below(legend_);
  set_stage(scene_.stage());
  set_forward(0.5 * kPi);  // from above x runs to the right and y up, as in the flat plot
  palette_changed();
  pixel_ratio_changed(devicePixelRatioF());
  show_plots({}, {});
}

void PathView::make_buttons() {
  QHBoxLayout* row = add_row();
  choice_ = new QComboBox(this);
  choice_->setAccessibleName(tr("Plot in three dimensions"));
  connect(choice_, &QComboBox::currentIndexChanged, this, &PathView::show_chosen);
  row->addWidget(choice_);
  row->addStretch();
  add_common_buttons(row);
  const std::array<std::pair<QString, scene::StandardView>, 5> views{
      {{tr("Fit"), scene::StandardView::Fit},
       {tr("Top"), scene::StandardView::Top},
       {tr("Along y"), scene::StandardView::Front},
       {tr("Along x"), scene::StandardView::Left},
       {tr("Isometric"), scene::StandardView::Isometric}}};
  QList<QAction*> actions;
  for (const auto& [text, view] : views) {
    actions << new QAction(text, this);
    connect(actions.back(), &QAction::triggered, this, [this, chosen = view] { look(chosen); });
  }
  set_view_actions(actions);
}

void PathView::show_plots(const std::vector<calibration::Plot>& plots, const QString& otherwise) {
  plots_.clear();
  const QSignalBlocker quiet(choice_);
  choice_->clear();
  for (const calibration::Plot& plot : plots) {
    if (std::none_of(plot.curves.begin(), plot.curves.end(), in_space)) continue;
    plots_.push_back(plot);
    choice_->addItem(model_text(plot.title));
  }
  legend_->setVisible(has_gl() && !plots_.empty());
  choice_->setVisible(has_gl() && plots_.size() > 1);
  if (!has_gl() || plots_.empty()) {
    scene_.show({});
    return show_message(otherwise);
  }
  choice_->setCurrentIndex(0);
  show_chosen();
}

void PathView::show_chosen() {
  clear_marks();
  draw();
  show_scene();
  scene_.stage().look(scene::StandardView::Isometric);
  if (isVisible()) render();
}

const calibration::Plot* PathView::chosen() const {
  const int index = choice_->currentIndex();
  return index >= 0 && index < plot_count() ? &plots_[index_at(index)] : nullptr;
}

void PathView::draw() {
  const calibration::Plot* const plot = chosen();
  if (!plot) return;
  std::vector<scene::ScenePath> paths;
  QStringList names;
  for (std::size_t i = 0; i < plot->curves.size(); ++i) {
    const QColor color = color_of(i, palette());
    paths.push_back(path_of(plot->curves[i], color));
    if (in_space(plot->curves[i]))
      names << QStringLiteral("<span style='color:%1'>■</span>&nbsp;%2")
                   .arg(color.name(), model_text(plot->curves[i].name).toHtmlEscaped());
  }
  legend_->setText(names.join(QStringLiteral("&ensp; ")));
  scene_.show(paths);
}

std::optional<SceneView::Pick> PathView::pick(const scene::PickRay& ray) const {
  const auto picked = scene_.pick(ray);
  const calibration::Plot* const plot = chosen();
  if (!picked || !plot) return std::nullopt;
  const QString name = model_text(plot->curves[picked->path].name);
  return Pick{picked->point_in_view, tr("%1: x %2, y %3, z %4 m in %5.")
                                         .arg(name)
                                         .arg(rounded_text(picked->point_m.x(), 3))
                                         .arg(rounded_text(picked->point_m.y(), 3))
                                         .arg(rounded_text(picked->point_m.z(), 3))
                                         .arg(axes_in_words())};
}

QString PathView::axes_in_words() const {
  const calibration::Plot* const plot = chosen();
  if (!plot) return {};
  return tr("the axes of the plot (%1; %2; up)").arg(model_text(plot->x_label), model_text(plot->y_label));
}

void PathView::pixel_ratio_changed(double ratio) { scene_.set_pixel_ratio(ratio); }

void PathView::palette_changed() {
  SceneView::palette_changed();
  draw();
}

void PathView::showEvent(QShowEvent* event) {
  SceneView::showEvent(event);
  render();
}

}  // namespace remount::widgets

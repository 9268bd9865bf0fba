#include "widgets/basics/scene_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QStackedLayout>
#include <QTimer>
#include <QToolButton>

#include "model/formats/files/number_text.h"
#include "widgets/basics/file_dialogs.h"
#include "widgets/basics/gl_support.h"
#include "widgets/basics/scale_bar.h"
#include "widgets/basics/theme.h"

namespace remount::widgets {
namespace {
constexpr int kClick_px = 4;   // a press that moves farther is a drag
constexpr int kRest_ms = 150;  // between notches of the wheel the whole is not drawn
}  // namespace

SceneView::SceneView(const QString& accessible_name, QWidget* parent)
    : QWidget(parent),
      column_(new QVBoxLayout(this)),
      rows_layout_(new QVBoxLayout),
      rows_(new QWidget(this)),
      message_(new QLabel(this)),
      readout_(new QLabel(this)),
      stack_(new QStackedLayout),
      scale_(new ScaleBar(this)),
      rest_(new QTimer(this)),
      gl_reason_(missing_gl_reason()) {
  if (gl_reason_.isEmpty()) {
    canvas_ = new QVTKOpenGLNativeWidget(this);
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    canvas_->setRenderWindow(window.Get());
    canvas_->setFocusPolicy(Qt::StrongFocus);
    canvas_->setAccessibleName(accessible_name);
    canvas_->installEventFilter(this);
    stack_->addWidget(canvas_);
  }
  message_->setAlignment(Qt::AlignCenter);
  message_->setWordWrap(true);
  message_->setMargin(24);
  readout_->setWordWrap(true);
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  readout_->setAccessibleName(tr("Picked point"));
  readout_->setAutoFillBackground(true);
  readout_->setMargin(5);
  readout_->hide();
  scale_->hide();
  stack_->addWidget(message_);
  column_->setContentsMargins(6, 2, 6, 2);
  column_->setSpacing(2);
  rows_->setLayout(rows_layout_);
  rows_layout_->setContentsMargins(0, 0, 0, 0);
  rows_layout_->setSpacing(2);
  column_->addWidget(rows_);
  column_->addLayout(stack_, 1);
}

SceneView::~SceneView() = default;

void SceneView::set_stage(scene::SceneStage& stage) {
  stage_ = &stage;
  rest_->setSingleShot(true);
  rest_->setInterval(kRest_ms);
  connect(rest_, &QTimer::timeout, this, [this] { motion_changed(false); });
  stage.on_motion([this](bool moving) {
    moving ? rest_->stop() : rest_->start();
    if (moving) motion_changed(true);
  });
  stage.on_drawn([this] { scale_->show_scale(stage_->metres_per_pixel() * devicePixelRatioF(), stage_->parallel()); });
  if (canvas_) stage.attach(*canvas_->renderWindow());
  // What is pressed must be seen in every style; some dark ones hardly shade it.
  set_style(*rows_, [](const QPalette& palette) {
    return QStringLiteral(
               "QToolButton { padding: 4px 9px; } QToolButton:checked:enabled { background: %1; color: %2; }"
               "QToolButton::menu-indicator { image: none; }")
        .arg(palette.color(QPalette::Highlight).name(), palette.color(QPalette::HighlightedText).name());
  });
}

QWidget* SceneView::canvas() const { return canvas_; }

QHBoxLayout* SceneView::add_row() {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  rows_layout_->addLayout(row);
  return row;
}

QToolButton* SceneView::add_button(QHBoxLayout* row, const QString& text, const QString& help, bool checkable) {
  auto* button = new QToolButton(rows_);
  button->setText(text);
  button->setToolTip(help);
  button->setAccessibleName(text);
  button->setCheckable(checkable);
  button->setEnabled(has_gl());
  button->setFocusPolicy(Qt::TabFocus);  // after a click the keys of the review work as before it
  row->addWidget(button);
  return button;
}

void SceneView::add_shading_button(QHBoxLayout* row) {
  eye_dome_ = add_button(row, tr("Shading"),
                         tr("Eye-dome lighting: darkens edges of depth, which makes shapes easier to see"), true);
  connect(eye_dome_, &QToolButton::toggled, this, &SceneView::set_eye_dome);
}

void SceneView::add_common_buttons(QHBoxLayout* row) {
  measure_ = add_button(row, tr("Measure"),
                        tr("Click two points for the distance between them, in m. Esc ends it. "
                           "Without it a click tells the coordinates of a point."),
                        true);
  measure_->setObjectName(QStringLiteral("measure"));
  connect(measure_, &QToolButton::toggled, this, &SceneView::set_measuring);
  views_ = add_button(row, tr("View"), tr("Standard views. Drag orbits, Shift drag pans, the wheel zooms."), false);
  views_->setPopupMode(QToolButton::InstantPopup);
}

void SceneView::set_view_actions(const QList<QAction*>& actions) {
  view_actions_ = actions;
  auto* menu = new QMenu(views_);
  menu->addActions(actions);
  views_->setMenu(menu);
}

void SceneView::add_below(QWidget* widget) { column_->addWidget(widget); }

void SceneView::show_message(const QString& text) {
  message_->setText(
      gl_reason_.isEmpty() ? text : tr("The 3-D view is not available: %1.\nEverything else works.").arg(gl_reason_));
  stack_->setCurrentWidget(message_);
  rows_->setEnabled(false);  // there is nothing to turn or to flip
  scale_->hide();
  clear_marks();
}

void SceneView::enable_buttons(bool enable) { rows_->setEnabled(enable); }

void SceneView::show_scene() {
  if (!canvas_) return;
  rows_->setEnabled(true);
  stack_->setCurrentWidget(canvas_);
  scale_->name_axes(axes_in_words());
  place_scale();
  scale_->show();
  scale_->raise();
}

bool SceneView::shows_scene() const { return canvas_ && stack_->currentWidget() == canvas_; }

void SceneView::look(scene::StandardView view) {
  if (!stage_) return;
  stage_->look(view);
  view_changed();
  render();
}

void SceneView::set_parallel(bool on) {
  if (!stage_) return;
  stage_->set_parallel(on);
  view_changed();
  render();
}

void SceneView::draw_quickly() {
  motion_changed(true);
  rest_->start();
}

bool SceneView::parallel() const { return stage_ && stage_->parallel(); }

QImage SceneView::picture() const { return canvas_ ? canvas_->grabFramebuffer() : QImage(); }

void SceneView::set_eye_dome(bool on) {
  if (!eye_dome_) return;
  eye_dome_->setChecked(on);
  stage_->set_eye_dome(on);
  pixel_ratio_changed(devicePixelRatioF());
  view_changed();
  render();
}

void SceneView::set_forward(double azimuth_rad) {
  if (stage_) stage_->set_forward(azimuth_rad);
}

bool SceneView::eye_dome() const { return stage_ && stage_->eye_dome(); }

void SceneView::set_measuring(bool on) {
  measure_->setChecked(on);
  clear_marks();
  if (on && canvas_) {
    canvas_->setFocus();  // Esc is to end it
    say(tr("Click the first of two points. Esc ends measuring."));
  }
  if (canvas_) canvas_->setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
  render();
}

bool SceneView::measuring() const { return measure_ && measure_->isChecked(); }

QString SceneView::readout() const { return readout_->text(); }

std::optional<SceneView::Pick> SceneView::pick_at(const QPointF& place_in_canvas) const {
  const double ratio = devicePixelRatioF();
  const auto ray = stage_->ray_at(place_in_canvas.x() * ratio, (canvas_->height() - 1 - place_in_canvas.y()) * ratio);
  return ray ? pick(*ray) : std::nullopt;
}

void SceneView::click(const QPointF& place_in_canvas) {
  if (!shows_scene()) return;
  const auto picked = pick_at(place_in_canvas);
  if (!picked) {
    if (!measuring()) clear_marks();
    say(tr("There is no point here."));
  } else {
    if (!measuring() || picked_.size() == 2) picked_.clear();
    picked_.push_back(*picked);
    show_picked();
  }
  render();
}

void SceneView::show_picked() {
  scene::SceneMarks marks;
  for (const Pick& pick : picked_) marks.points_in_view.push_back(pick.point_in_view);
  QString text = picked_.back().words;
  if (measuring() && picked_.size() == 1) text += QLatin1Char('\n') + tr("Click the second point.");
  if (picked_.size() == 2) {
    const Eigen::Vector3d apart = picked_[1].point_in_view - picked_[0].point_in_view;
    const auto rounded = [](double value_m) { return QString::fromStdString(formats::rounded_text(value_m, 3)); };
    const QString distance = tr("%1 m").arg(rounded(apart.norm()));
    marks.label = distance.toStdString();
    text = tr("Distance %1 (x %2, y %3, z %4 m in %5). Esc ends measuring.")
               .arg(distance)
               .arg(rounded(apart.x()))
               .arg(rounded(apart.y()))
               .arg(rounded(apart.z()))
               .arg(axes_in_words());
  }
  stage_->show_marks(marks);
  view_changed();
  say(text);
}

void SceneView::clear_marks() {
  if (picked_.empty() && readout_->isHidden()) return;
  picked_.clear();
  readout_->clear();
  readout_->hide();
  if (stage_) stage_->show_marks({});
  view_changed();
}

void SceneView::say(const QString& text) {
  readout_->setText(text);
  place_readout();
  readout_->show();
  readout_->raise();
}

/// Over the scene, not beside it: a click must not move what was clicked on.
void SceneView::place_readout() {
  if (!canvas_) return;
  const QRect scene = canvas_->geometry();
  const int width = std::min(scene.width() - 12, readout_->fontMetrics().height() * 34);
  readout_->setGeometry(scene.left() + 6, scene.top() + 6, width, readout_->heightForWidth(width));
}

void SceneView::place_scale() {
  if (!canvas_) return;
  const QSize size = scale_->sizeHint();
  scale_->setGeometry(QRect(canvas_->geometry().bottomRight() - QPoint(size.width() + 6, size.height() + 4), size));
}

void SceneView::show_menu(const QPoint& place_in_canvas) {
  if (!shows_scene()) return;
  const std::optional<Pick> picked = pick_at(place_in_canvas);
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (picked)
    menu->addAction(tr("Turn about this point"), this, [this, point = picked->point_in_view] {
      stage_->centre_on(point);
      render();
    });
  fill_menu(*menu, picked);
  if (!menu->isEmpty()) menu->addSeparator();
  menu->addActions(view_actions_);
  QAction* parallel_view = menu->addAction(tr("Parallel, without perspective"), this, &SceneView::set_parallel);
  parallel_view->setCheckable(true);
  parallel_view->setChecked(parallel());
  menu->addSeparator();
  menu->addAction(tr("Copy picture"), this, [this] { QApplication::clipboard()->setImage(picture()); });
  menu->addAction(tr("Save picture…"), this, &SceneView::save_picture);
  menu->popup(canvas_->mapToGlobal(place_in_canvas));
}

void SceneView::save_picture() {
  const QImage shown = picture();
  const QString path =
      ask_where_to_save(this, tr("Save picture"), FileKind::Pictures, tr("view.png"), tr("Pictures (*.png)"));
  if (!path.isEmpty() && !shown.save(path)) say(tr("The picture cannot be written: %1").arg(path));
}

QPointF SceneView::place_of(const Eigen::Vector3d& point_in_view) const {
  const Eigen::Vector2d pixel = stage_->pixel_of(point_in_view) / devicePixelRatioF();
  return {pixel.x(), canvas_->height() - 1 - pixel.y()};
}

void SceneView::render() {
  if (shows_scene()) canvas_->renderWindow()->Render();
}

bool SceneView::handle_canvas(QEvent* event) {
  const auto is_escape = [event] { return static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape; };
  switch (event->type()) {
    case QEvent::MouseButtonPress: {
      const auto* mouse = static_cast<QMouseEvent*>(event);
      pressed_ = mouse->button() == Qt::LeftButton && mouse->modifiers() == Qt::NoModifier;
      pressed_right_ = mouse->button() == Qt::RightButton;
      pressed_at_ = mouse->pos();
      return false;
    }
    case QEvent::MouseButtonRelease: {
      const QPoint at = static_cast<QMouseEvent*>(event)->pos();
      const bool in_place = (at - pressed_at_).manhattanLength() < kClick_px;
      if (std::exchange(pressed_, false) && in_place) click(at);
      // After VTK has heard that the button is up again.
      if (std::exchange(pressed_right_, false) && in_place) QTimer::singleShot(0, this, [this, at] { show_menu(at); });
      return false;
    }
    case QEvent::MouseButtonDblClick:
      if (const auto picked =
              shows_scene() && !measuring() ? pick_at(static_cast<QMouseEvent*>(event)->position()) : std::nullopt) {
        stage_->centre_on(picked->point_in_view);
        render();
      }
      return true;
    case QEvent::ShortcutOverride:  // or the window's Esc, which cancels work, would take it
      if (is_escape() && !readout_->isHidden()) event->accept();
      return false;
    case QEvent::KeyPress:
      if (!is_escape() || readout_->isHidden()) return false;
      if (measuring())
        set_measuring(false);
      else
        clear_marks(), render();
      return true;
    case QEvent::Resize:
      place_readout();
      place_scale();
      size_changed();
      return false;
    default:
      return false;
  }
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == canvas_ && handle_canvas(event)) return true;
  return QWidget::eventFilter(watched, event);
}

void SceneView::palette_changed() { stage_->set_dark(is_dark(palette())); }

/// The rows of buttons stand beside each other where that leaves the picture more room.
void SceneView::resizeEvent(QResizeEvent* event) {
  int together_px = 0;
  for (int row = 0; row < rows_layout_->count(); ++row) together_px += rows_layout_->itemAt(row)->minimumSize().width();
  rows_layout_->setDirection(together_px + 20 < width() ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  QWidget::resizeEvent(event);
}

void SceneView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && stage_) {
    palette_changed();
    view_changed();
    render();
  }
  QWidget::changeEvent(event);
}

}  // namespace remount::widgets

#include "widgets/panels/pair_view.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QStackedLayout>
#include <QTimer>
#include <QToolButton>

#include "widgets/gl_support.h"
#include "widgets/theme.h"

namespace remount {
namespace {
constexpr int kBlinkPeriod_ms = 500;
}

PairView::PairView(QWidget* parent)
    : QWidget(parent),
      message_(new QLabel(this)),
      caption_(new QLabel(this)),
      stack_(new QStackedLayout),
      alignments_(new QButtonGroup(this)),
      timer_(new QTimer(this)),
      gl_reason_(missing_gl_reason()) {
  if (gl_reason_.isEmpty()) {
    canvas_ = new QVTKOpenGLNativeWidget(this);
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    canvas_->setRenderWindow(window.Get());
    canvas_->setFocusPolicy(Qt::StrongFocus);
    canvas_->setAccessibleName(tr("3-D view of the pair"));
    scene_.attach(*window);
    scene_.set_dark(is_dark(palette()));
    stack_->addWidget(canvas_);
  }
  message_->setAlignment(Qt::AlignCenter);
  message_->setWordWrap(true);
  message_->setMargin(24);
  caption_->setWordWrap(true);
  caption_->setTextFormat(Qt::RichText);
  stack_->addWidget(message_);
  timer_->setInterval(kBlinkPeriod_ms);
  connect(timer_, &QTimer::timeout, this, &PairView::flip);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 2, 6, 2);
  column->setSpacing(2);
  column->addWidget(make_buttons());
  column->addLayout(stack_, 1);
  column->addWidget(caption_);
  restyle();
  show_message(tr("Select a pair to see its two scans."));
}

void PairView::restyle() {
  scene_.set_dark(is_dark(palette()));
  // What is pressed must be seen in every style; some dark ones hardly shade it.
  buttons_->setStyleSheet(
      QStringLiteral("QToolButton { padding: 4px 9px; } QToolButton:checked:enabled { background: %1; color: %2; }")
          .arg(palette().color(QPalette::Highlight).name(), palette().color(QPalette::HighlightedText).name()));
  update_caption();
}

PairView::~PairView() = default;

QWidget* PairView::canvas() const { return canvas_; }

QWidget* PairView::make_buttons() {
  buttons_ = new QWidget(this);
  auto* layout = new QHBoxLayout(buttons_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  add_alignment_buttons();
  blink_ = add_button(tr("Blink"), tr("Shows before and aligned in turn (B); Space flips once"));
  blink_->setCheckable(true);
  connect(blink_, &QToolButton::toggled, this, &PairView::set_blinking);
  layout->addStretch();
  auto* objects = add_button(tr("Objects"),
                             tr("Boxes of the objects that both scans contain; moving ones are red and crossed out"));
  objects->setCheckable(true);
  objects->setChecked(true);
  connect(objects, &QToolButton::toggled, this, [this](bool on) {
    scene_.show_objects(on);
    render();
  });
  layout->addSpacing(8);
  add_view_buttons();
  return buttons_;
}

QToolButton* PairView::add_button(const QString& text, const QString& help) {
  auto* button = new QToolButton(buttons_);
  button->setText(text);
  button->setToolTip(help);
  button->setAccessibleName(text);
  button->setEnabled(has_gl());
  buttons_->layout()->addWidget(button);
  return button;
}

void PairView::add_alignment_buttons() {
  const std::array<std::pair<QString, QString>, 3> names{{
      {tr("Before"), tr("As predicted by the INS and the mounting the calibration started from")},
      {tr("Aligned"), tr("As the two scans were aligned with each other")},
      {tr("With result"), tr("As predicted by the INS and the present result")},
  }};
  for (int i = 0; i < 3; ++i) {
    auto* button = add_button(names[static_cast<std::size_t>(i)].first, names[static_cast<std::size_t>(i)].second);
    button->setCheckable(true);
    button->setChecked(i == static_cast<int>(alignment_));
    alignments_->addButton(button, i);
  }
  connect(alignments_, &QButtonGroup::idClicked, this,
          [this](int id) { show_alignment(static_cast<PairAlignment>(id)); });
}

void PairView::add_view_buttons() {
  const std::array<std::pair<QString, StandardView>, 4> views{{{tr("Fit"), StandardView::Fit},
                                                               {tr("Top"), StandardView::Top},
                                                               {tr("Side"), StandardView::Side},
                                                               {tr("Front"), StandardView::Front}}};
  for (const auto& [text, view] : views) {
    connect(add_button(text, tr("View: %1. Drag orbits, Shift drag pans, the wheel zooms.").arg(text)),
            &QToolButton::clicked, this, [this, view = view] { look(view); });
  }
}

void PairView::show_message(const QString& text) {
  message_->setText(
      gl_reason_.isEmpty() ? text : tr("The 3-D view is not available: %1.\nEverything else works.").arg(gl_reason_));
  stack_->setCurrentWidget(message_);
  buttons_->setEnabled(false);  // there is nothing to turn or to flip
  pair_caption_.clear();
  update_caption();
}

void PairView::show_pair(const QString& caption, std::shared_ptr<const PairClouds> clouds,
                         const PairTransforms& transforms) {
  pair_caption_ = caption;
  update_caption();
  if (!has_gl()) return;
  buttons_->setEnabled(true);
  stack_->setCurrentWidget(canvas_);
  scene_.set_pair(*clouds, transforms);
  if (!framed_) scene_.look(StandardView::Fit);
  framed_ = true;  // afterwards the view stays where the user has put it, from pair to pair
  render();
}

void PairView::show_transforms(const QString& caption, const PairTransforms& transforms) {
  if (pair_caption_.isEmpty()) return;
  pair_caption_ = caption;
  update_caption();
  if (!has_gl() || stack_->currentWidget() != canvas_) return;
  scene_.set_transforms(transforms);
  render();
}

void PairView::show_alignment(PairAlignment alignment) {
  alignment_ = alignment;
  alignments_->button(static_cast<int>(alignment))->setChecked(true);
  scene_.show_alignment(alignment);
  update_caption();
  render();
}

void PairView::flip() {
  show_alignment(alignment_ == PairAlignment::Before ? PairAlignment::Registered : PairAlignment::Before);
}

void PairView::set_blinking(bool on) {
  blink_->setChecked(on);
  on ? timer_->start() : timer_->stop();
}

bool PairView::blinking() const { return timer_->isActive(); }

void PairView::look(StandardView view) {
  scene_.look(view);
  render();
}

void PairView::render() {
  if (canvas_ && stack_->currentWidget() == canvas_) canvas_->renderWindow()->Render();
}

void PairView::update_caption() {
  if (pair_caption_.isEmpty()) {
    caption_->clear();
    return;
  }
  const bool dark = is_dark(palette());
  caption_->setText(
      QStringLiteral("%1 &nbsp; <span style='color:%2'>■</span> %3 &nbsp; <span style='color:%4'>■</span> %5")
          .arg(pair_caption_.toHtmlEscaped(), dark ? "#ff9e33" : "#d94a05", tr("scan a"), dark ? "#9ea6b0" : "#757a85",
               tr("scan b")));
}

void PairView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && buttons_) {
    restyle();
    render();
  }
  QWidget::changeEvent(event);
}

}  // namespace remount

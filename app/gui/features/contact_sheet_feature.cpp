#include "app/gui/features/contact_sheet_feature.h"

#include <cmath>

#include "app/gui/features/pairs_feature.h"
#include "app/gui/shell/main_window.h"
#include "model/drive/session_frames.h"
#include "widgets/basics/swatch.h"
#include "widgets/basics/theme.h"
#include "widgets/pairs/contact_sheet.h"
#include "widgets/scene/pair_colors.h"
#include "widgets/scene/signed_scale.h"

namespace remount::gui {
namespace {
constexpr std::size_t kTogether = 2, kRecent = 6;
}  // namespace

ContactSheetFeature::ContactSheetFeature(MainWindow& window) : Feature(window), scans_(scene::make_scan_scenes()) {
  auto* pairs = window.feature<PairsFeature>();
  if (!pairs) return;
  sheet_ = new widgets::ContactSheet(pairs->filter(), pairs->marked(), &window);
  window.add_view(
      {sheet_, tr("All pairs"), "contact-sheet", "show-contact-sheet", tr("&All pairs"), tr("Ctrl+Shift+A")});
  connect(sheet_, &widgets::ContactSheet::wanted, this, &ContactSheetFeature::start_missing);
  connect(sheet_, &widgets::ContactSheet::alignment_changed, this, &ContactSheetFeature::forget);
  connect(sheet_, &widgets::ContactSheet::opened, this, [this](motion::PairIndex pair) {
    workbench_.selection().select(pair);
    window_.show_first_view();
  });
  show_palette(window.palette());
}

std::vector<TurnQueue::Piece> ContactSheetFeature::show_output_later() {
  if (!sheet_) return {};
  return {[this] { show_output_now(); }};
}

/// A decision changes no scan: the pictures stay, but for those under a result that moved.
void ContactSheetFeature::show_output_now() {
  const OutputPtr output = workbench_.outcome().output();
  const auto source = output ? workbench_.pair_scenes().source() : nullptr;
  const bool moved = sheet_->with_result() && solution_ != workbench_.outcome().solution();
  solution_ = workbench_.outcome().solution();
  if (source == source_ && !moved) return start_missing();
  source_ = source;
  style_.limit_m = output ? widgets::thumbnail_limit_m(output->pairs) : style_.limit_m;
  forget();
}

void ContactSheetFeature::show_palette(const QPalette& palette) {
  if (!sheet_) return;
  if (style_.dark != widgets::is_dark(palette)) {
    style_.dark = widgets::is_dark(palette);
    forget();
  }
  show_legend();
}

void ContactSheetFeature::show_legend() {
  const scene::ScanColors colors = scene::scan_colors(style_.dark);
  const auto millimetres = [this](double sign) { return QString::number(1000.0 * sign * style_.limit_m, 'f', 0); };
  sheet_->show_legend(
      tr("From above: %1, scan a by its distance to scan b: %2, %3, %4. Below: the best wall, cut, ± %5 mm")
          .arg(widgets::swatch(colors.target, tr("scan b")),
               widgets::swatch(scene::SignedScale::at(-1.0), tr("%1 mm behind").arg(millimetres(1.0))),
               widgets::swatch(scene::SignedScale::at(0.0), tr("on it")),
               widgets::swatch(scene::SignedScale::at(1.0), tr("%1 mm before").arg(millimetres(1.0))),
               millimetres(2.0)));
}

void ContactSheetFeature::forget() {
  for (const auto& [pair, job] : running_) jobs_.cancel(job);
  running_.clear();
  failed_.clear();
  recent_.clear();
  show_legend();
  sheet_->forget_thumbnails();
}

void ContactSheetFeature::start_missing() {
  if (!sheet_->isVisible() || !source_) return;
  for (const motion::PairIndex pair : sheet_->missing()) {
    if (running_.size() >= kTogether) return;
    if (!running_.contains(pair) && !failed_.contains(pair)) start(pair);
  }
}

void ContactSheetFeature::start(motion::PairIndex pair) {
  const OutputPtr output = workbench_.outcome().output();
  if (!output || pair >= output->pairs.size()) return;
  const auto alignment = sheet_->with_result() ? scene::PairAlignment::CurrentX : scene::PairAlignment::Registered;
  auto job = std::make_shared<int>(0);
  const auto is_wanted = [this, job, pair] {
    const auto found = running_.find(pair);
    return found != running_.end() && found->second == *job;
  };
  *job = jobs_.start(
      [this, pair, alignment, is_wanted, source = source_, scans = scans_, style = style_,
       transforms = scene::pair_transforms(*output, pair),
       vehicle_from_ins =
           drive::vehicle_from_ins(workbench_.sessions().all())](Progress& progress) -> JobRunner::Deliver {
        const auto clouds = std::make_shared<const pipeline::PairClouds>(source->load(pair, progress));
        if (!clouds->has_points())
          return [this, pair, is_wanted] {
            if (is_wanted()) take(pair, {}, nullptr);
          };
        const scene::PairSceneDataPtr data = scene::prepare_pair_scene(clouds, *scans, progress);
        if (!data) return {};
        const widgets::PairThumbnail thumbnail =
            widgets::paint_thumbnail(*data, transforms, alignment, vehicle_from_ins, style, progress);
        return [this, pair, is_wanted, thumbnail, data] {
          if (is_wanted()) take(pair, thumbnail, data);
        };
      },
      [this, pair, is_wanted](const JobFailure&) {
        if (is_wanted()) take(pair, {}, nullptr);
      });
  running_[pair] = *job;
}

/// The scans of a pair that has none cannot be read; why is said where the pair itself is shown.
void ContactSheetFeature::take(motion::PairIndex pair, const widgets::PairThumbnail& thumbnail,
                               const scene::PairSceneDataPtr& data) {
  running_.erase(pair);
  if (thumbnail.picture.isNull()) {
    failed_.insert(pair);
  } else {
    QStringList words;
    if (std::isfinite(thumbnail.median_m)) words << tr("%1 mm").arg(1000.0 * thumbnail.median_m, 0, 'f', 0);
    if (std::isfinite(thumbnail.thickness_m)) words << tr("wall %1 mm").arg(1000.0 * thumbnail.thickness_m, 0, 'f', 0);
    sheet_->show_thumbnail(pair, thumbnail.picture, words.join(QStringLiteral(", ")));
    recent_.push_back(data);
    if (recent_.size() > kRecent) recent_.pop_front();
  }
  start_missing();
}

}  // namespace remount::gui

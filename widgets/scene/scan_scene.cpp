#include "widgets/scene/scan_scene.h"

#include "algorithms/cloud/objects.h"

namespace remount::scene {
namespace {
// Of a point: as it was read, in the order of its level with its index and place in VTK's list, and in the buffer that
// is drawn from.
constexpr std::size_t kBytesPerPoint = 22 + 20 + 12;
// Of a point of a cloud that is prepared to be asked for distances, thinned to voxels: measured on streets.
constexpr std::size_t kSurfaceBytesPerPoint = 40;
}  // namespace

ScanScene::ScanScene(pipeline::KeyframeScanPtr scan, const Progress& progress)
    : scan_(std::move(scan)), geometry_(make_geometry(order_by_levels(scan_->cloud.points, progress))) {}

std::shared_ptr<const quality::SurfaceDistance> ScanScene::surfaces(const Progress& progress) const {
  const std::scoped_lock guard(mutex_);
  if (surfaces_) return surfaces_;
  auto found = std::make_shared<const quality::SurfaceDistance>(scan_->cloud, progress);
  if (!progress.cancelled()) surfaces_ = found;
  return found;
}

std::shared_ptr<const std::vector<std::uint32_t>> ScanScene::above_ground() const {
  const std::scoped_lock guard(mutex_);
  if (above_ground_) return above_ground_;
  const std::vector<bool> is_ground = cloud::ground_mask(scan_->cloud, scan_->up_in_lidar, cloud::ObjectOptions{});
  const std::vector<std::uint32_t>& original = geometry_->cloud->original;
  auto above = std::make_shared<std::vector<std::uint32_t>>();
  for (std::uint32_t place = 0; place < original.size(); ++place)
    if (!is_ground[original[place]]) above->push_back(place);
  return above_ground_ = above;
}

std::size_t ScanScene::bytes() const {
  const std::scoped_lock guard(mutex_);
  return scan_->cloud.size() * (kBytesPerPoint + (surfaces_ ? kSurfaceBytesPerPoint : 0));
}

ScanScenePtr ScanScenes::prepare(const pipeline::KeyframeScanPtr& scan, const Progress& progress) {
  ScanScenePtr scene = scene_of(scan, progress);
  if (scene && ground_apart_) (void)scene->above_ground();
  return scene;
}

ScanScenePtr ScanScenes::scene_of(const pipeline::KeyframeScanPtr& scan, const Progress& progress) {
  {
    const std::scoped_lock guard(mutex_);
    if (ScanScenePtr held = prepared_[scan.get()].lock()) return held;
  }
  auto scene = std::make_shared<const ScanScene>(scan, progress);
  if (progress.cancelled()) return nullptr;
  const std::scoped_lock guard(mutex_);
  std::erase_if(prepared_, [](const auto& one) { return one.second.expired(); });
  if (ScanScenePtr held = prepared_[scan.get()].lock()) return held;
  prepared_[scan.get()] = scene;
  return scene;
}

}  // namespace remount::scene

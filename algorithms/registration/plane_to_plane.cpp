// Own engine: plane-to-plane alignment (generalized ICP, Segal 2009) with normals only. With covariances
// I - (1 - e) n n' the combined inverse has a closed form in the two normals, so no 3x3 inverse is taken.
// docs/maths/registration.md (R2) to (R5)
#include <Eigen/Cholesky>
#include <cmath>

#include "algorithms/registration/matcher.h"
#include "algorithms/registration/registration.h"
#include "algorithms/registration/robust_scale.h"

namespace remount::registration {
namespace {

constexpr double kFewestInliers = 50;
// Far from the minimum one block in four shows the way as well.
constexpr std::int32_t kCoarseStep = 4;
constexpr std::size_t kFewestCoarseBlocks = 64;
constexpr double kCoarseUntil_m = 0.02, kCoarseUntil_rad = 0.002;

class Aligner {
 public:
  Aligner(const PreparedCloud& source, const PreparedCloud& target, const RegistrationOptions& options,
          const Progress& progress)
      : source_(source.tree().blocks()),
        matcher_(source_, target, static_cast<float>(options.max_correspondence_m), options.instructions),
        kernels_(kernels(options.instructions)),
        progress_(progress),
        largest_kernel_m_(0.5f * matcher_.radius_m()),
        kernel_m_(largest_kernel_m_),
        residuals_(source_.size()) {
    if (source_.size() / kCoarseStep >= kFewestCoarseBlocks) step_ = kCoarseStep;
  }

  RegistrationResult run(const RigidTransform& start, int max_iterations);

 private:
  AlignmentSums sums_at(const RigidTransform& target_from_source);
  float next_kernel_m();

  const std::vector<PointBlock>& source_;
  Matcher matcher_;
  const Kernels& kernels_;
  const Progress& progress_;
  float largest_kernel_m_;
  float kernel_m_;  // residuals along the normal much larger than this hardly count: moving objects, occlusions
  std::int32_t step_ = 1;
  std::vector<ResidualBlock> residuals_;
  std::vector<float> sample_;
};

AlignmentSums Aligner::sums_at(const RigidTransform& target_from_source) {
  matcher_.update(target_from_source, step_, progress_);
  SumsTask task;
  task.source = source_.data();
  task.matches = matcher_.matches().data();
  task.step = step_;
  task.target_from_source = float_transform(target_from_source);
  task.radius_m = matcher_.radius_m();
  task.kernel_m = kernel_m_;
  task.residuals = residuals_.data();
  const auto count = static_cast<std::int32_t>(source_.size());
  AlignmentSums sums;
  for (task.first = 0; task.first < count && !progress_.cancelled(); task.first += kBlocksAtOnce * step_) {
    task.last = std::min(task.first + kBlocksAtOnce * step_, count);
    kernels_.accumulate(task, sums);
  }
  return sums;
}

// From a quarter of the points: the scale need not be known better than to a few percent.
float Aligner::next_kernel_m() {
  constexpr int kEvery = 4;
  const int stride = step_ == 1 ? kEvery : 1;
  sample_.clear();
  for (std::size_t b = 0; b < source_.size(); b += static_cast<std::size_t>(step_))
    for (int i = 0; i < kBlockSize; i += stride)
      if (residuals_[b].squared_m2[i] >= 0.0f) sample_.push_back(residuals_[b].squared_m2[i]);
  return robust_kernel_m(sample_, kSmallestKernel_m, largest_kernel_m_);
}

Vector6d newton_step(const AlignmentSums& sums) {
  Matrix6d hessian;
  Vector6d gradient;
  for (int row = 0, k = 0; row < 6; ++row) {
    gradient[row] = sums.gradient[row];
    for (int column = row; column < 6; ++column) hessian(row, column) = hessian(column, row) = sums.hessian[k++];
  }
  // A trace of damping keeps a direction without information (open field, corridor) where it is.
  const double largest = hessian.diagonal().maxCoeff();
  hessian.diagonal() *= 1.0 + 1e-9;
  hessian.diagonal().array() += 1e-9 * largest;
  return hessian.ldlt().solve(-gradient);
}

RegistrationResult Aligner::run(const RigidTransform& start, int max_iterations) {
  RegistrationResult result;
  RigidTransform current = start;
  for (int iteration = 0; iteration < max_iterations && !progress_.cancelled(); ++iteration) {
    const AlignmentSums sums = sums_at(current);
    result.quality.iterations = iteration + 1;
    if (progress_.cancelled() || sums.inliers * step_ < kFewestInliers) break;
    const Vector6d step = newton_step(sums);
    if (!step.allFinite()) break;
    current = perturb(current, step);
    const double moved_m = step.head<3>().norm(), turned_rad = step.tail<3>().norm();
    const float previous_kernel_m = kernel_m_;
    kernel_m_ = next_kernel_m();
    if (step_ > 1) {
      if (moved_m < kCoarseUntil_m && turned_rad < kCoarseUntil_rad) step_ = 1;
      continue;
    }
    const bool kernel_settled = std::abs(kernel_m_ - previous_kernel_m) < 0.02f * previous_kernel_m;
    if (kernel_settled && moved_m < 2e-5 && turned_rad < 1e-6) {
      result.quality.converged = true;
      break;
    }
    // The last steps may swing between two equal sets of neighbours; that far below the noise is converged as well.
    if (iteration + 1 == max_iterations) result.quality.converged = moved_m < 2e-3 && turned_rad < 2e-4;
  }
  current.linear() = nearest_rotation(current.linear());
  result.target_from_source = current;
  return result;
}

}  // namespace

RegistrationResult align_plane_to_plane(const PreparedCloud& source, const PreparedCloud& target,
                                        const RigidTransform& target_from_source_start,
                                        const RegistrationOptions& options, const Progress& progress) {
  return Aligner(source, target, options, progress).run(target_from_source_start, options.max_iterations);
}

}  // namespace remount::registration

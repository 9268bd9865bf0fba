// A drive on a ramp that is described from tables, and compared with what it is.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string_view>

#include "model/formats/documents/document.h"
#include "model/guesses/description.h"
#include "model/guesses/manifest.h"
#include "tests/model/guesses/written_layouts.h"

namespace remount::guesses {

/// Degrees and radians are turned into each other for the text and back: the last digit of a longitude is a nanometre.
inline constexpr double kTextPrecision = 3e-9;

/// A drive on a ramp, as a native session and as tables.
class DescribedDrive : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    native_ = new formats::TemporaryFolder;
    simulator::SimulationOptions options = simulator::parking_ramp();
    options.duration_s = 25.0;
    Progress progress;
    simulator::write_drive(simulator::simulate_drive(options), native_->path() / "drive", "native", 1, progress);
    session_ = new drive::Session(formats::open_session(native_->path() / "drive", progress));
    samples_ = new std::vector<WrittenSample>(written_samples(*session_));
  }
  static void TearDownTestSuite() {
    delete samples_;
    delete session_;
    delete native_;
  }

  static std::filesystem::path native_drive() { return native_->path() / "drive"; }

  /// Writes the manifest and opens it.
  static drive::Session opened(const Description& described, const std::filesystem::path& folder) {
    std::ofstream(folder / "session.yaml") << formats::to_yaml(manifest_of(described, folder, Language::English));
    Progress progress;
    return formats::open_session(folder / "session.yaml", progress);
  }

  static Description described(const std::vector<std::filesystem::path>& paths) {
    Progress progress;
    return describe_data(paths, progress);
  }

  static inline formats::TemporaryFolder* native_ = nullptr;
  static inline drive::Session* session_ = nullptr;
  static inline std::vector<WrittenSample>* samples_ = nullptr;
};

/// Largest difference of motions over ten samples, m + rad.
inline double motions_apart(const drive::Session& a, const drive::Session& b) {
  const std::vector<motion::StampedPose> poses_a = drive::metric_poses(a), poses_b = drive::metric_poses(b);
  EXPECT_EQ(poses_a.size(), poses_b.size());
  double worst = poses_a.empty() ? 1.0 : 0.0;
  for (std::size_t i = 0; i + 10 < std::min(poses_a.size(), poses_b.size()); ++i) {
    EXPECT_EQ(poses_a[i].stamp_ns, poses_b[i].stamp_ns) << i;
    if (poses_a[i].stamp_ns != poses_b[i].stamp_ns) return 1.0;
    const RigidTransform motion_a = poses_a[i].pose.inverse() * poses_a[i + 10].pose,
                         motion_b = poses_b[i].pose.inverse() * poses_b[i + 10].pose;
    worst = simulator::worse_of(worst, (motion_a.matrix() - motion_b.matrix()).norm());
  }
  return worst;
}

inline bool says(const std::vector<Message>& messages, std::string_view code) {
  return std::ranges::any_of(messages, [&](const Message& one) { return one.code() == code; });
}

inline const Guess* find_guess(const std::vector<Guess>& guesses, GuessKind kind) {
  const auto found = std::ranges::find(guesses, kind, &Guess::kind);
  return found == guesses.end() ? nullptr : &*found;
}

}  // namespace remount::guesses

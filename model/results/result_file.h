// The file "remount-result/2": what a calibration found, how sure it is, and what it came from.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "algorithms/calibration/method_details.h"
#include "algorithms/quality/map_sharpness.h"
#include "model/drive/session.h"
#include "model/drive/topic_choice.h"
#include "model/formats/documents/document.h"
#include "model/results/input_files.h"
#include "model/settings/settings.h"

namespace remount::results {

/// Sentences are messages in this one and plain texts in the former, which is read as well.
inline constexpr std::string_view kResultFormat = "remount-result/2", kFormerResultFormat = "remount-result/1";

/// A pair as it is listed in a result or a project: named by its session and its scans' stamps, which stay the same
/// when keyframes change.
struct PairRecord {
  motion::SessionIndex session;
  std::int64_t stamp_a_ns = 0, stamp_b_ns = 0;
  motion::PairState state = motion::PairState::Proposed;
  motion::DecidedBy decided_by = motion::DecidedBy::Nobody;
  Message reason;
  double rotation_rad = 0.0;
  double baseline_m = 0.0;
  double rmse_m = 0.0;
  double overlap = 0.0;
  double screw_score = 0.0;
  double residual_rotation_rad = 0.0;
  double residual_translation_m = 0.0;
  double weight = 0.0;
  int shared_objects = 0;
};
std::vector<PairRecord> pair_records(const std::vector<motion::Keyframe>& keyframes,
                                     const std::vector<motion::Pair>& pairs);

/// As files have them, in the order of the enumerations.
inline constexpr std::array<std::string_view, 3> kPairStates{"proposed", "accepted", "rejected"},
    kDeciders{"nobody", "program", "user"};
std::string_view to_string(motion::PairState state);
std::string_view to_string(motion::DecidedBy decided_by);

/// Which topics of a bag a session was made of: by role, "none" where the bag has some for a role and none served.
struct UsedTopics {
  std::string session;
  drive::TopicChoice topics;
  drive::TopicChoice asked;  ///< those of them that were asked for; the others were suggested
};
/// Of those of the sessions that are bags, in their order.
std::vector<UsedTopics> used_topics(const std::vector<std::shared_ptr<const drive::Session>>& sessions);

struct ResultFile {
  std::string method{calibration::kPairwise};  ///< id of the CalibrationMethod
  calibration::CalibrationResult result;
  std::vector<calibration::NamedQuantity> quantities;    ///< what the method determined beside X
  std::vector<calibration::Plot> plots;                  ///< of the method, thinned
  std::optional<drive::InsAxes> ins_axes;                ///< of the frame that X is expressed in; nothing: not known
  std::optional<RigidTransform> nominal_ins_from_lidar;  ///< what the search started from
  std::vector<PairRecord> pairs;
  std::vector<quality::NamedSharpness> sharpness;  ///< the map check; empty where there was none
  std::vector<drive::Finding> findings;            ///< warnings and problems met on the way
  std::string version;                             ///< of the program that wrote it
  settings::Settings settings;
  std::vector<InputFile> inputs;
  std::vector<UsedTopics> topics;  ///< of bags; empty as well where a former version wrote the file
};

/// Whether X stands on pairs of keyframes; other methods have neither pairs nor residuals of them.
bool is_from_pairs(const ResultFile& file);

formats::DocumentNode result_document(const ResultFile& file);
/// Throws Error(Format) where the schema is not kept, a number is not finite, the rotation is not orthonormal, or
/// the parts of the transform contradict each other.
ResultFile result_from_document(const formats::DocumentView& view);

/// JSON where the name ends in ".json", YAML otherwise. Saved atomically; throws Error(Io).
void save_result(const ResultFile& file, const std::filesystem::path& path);
/// Throws Error(Io) where it cannot be read, Error(Format) as above.
ResultFile load_result(const std::filesystem::path& path);

}  // namespace remount::results

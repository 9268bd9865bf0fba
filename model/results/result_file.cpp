#include "model/results/result_file.h"

#include "algorithms/core/index.h"
#include "model/drive/topic_offer.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/files/atomic_save.h"

namespace remount::results {

std::string_view to_string(motion::PairState state) { return kPairStates.at(index_of(state)); }

std::string_view to_string(motion::DecidedBy decided_by) { return kDeciders.at(index_of(decided_by)); }

std::vector<PairRecord> pair_records(const std::vector<motion::Keyframe>& keyframes,
                                     const std::vector<motion::Pair>& pairs) {
  std::vector<PairRecord> records;
  for (const motion::Pair& pair : pairs) {
    const motion::Keyframe& a = keyframes.at(pair.keyframe_a);
    const motion::Keyframe& b = keyframes.at(pair.keyframe_b);
    records.push_back({a.session, a.stamp_ns, b.stamp_ns, pair.state, pair.decided_by, pair.reason, pair.rotation_rad,
                       pair.baseline_m, pair.registration.rmse_m, pair.registration.overlap, pair.screw.score,
                       pair.residual_rotation_rad, pair.residual_translation_m, pair.weight, pair.shared_objects});
  }
  return records;
}

std::vector<UsedTopics> used_topics(const std::vector<std::shared_ptr<const drive::Session>>& sessions) {
  std::vector<UsedTopics> used;
  for (const auto& session : sessions)
    if (!session->topics.empty())
      used.push_back({session->name, drive::choice_in_use(session->topics), session->topic_choice});
  return used;
}

bool is_from_pairs(const ResultFile& file) { return file.method == calibration::kPairwise || !file.pairs.empty(); }

void save_result(const ResultFile& file, const std::filesystem::path& path) {
  const formats::DocumentNode document = result_document(file);
  formats::save_atomically(path, path.extension() == ".json" ? formats::to_json(document) : formats::to_yaml(document));
}

ResultFile load_result(const std::filesystem::path& path) {
  const formats::DocumentLimits limits{64U << 20U, 2000000, 32};
  const formats::DocumentNode document = formats::read_document(path, limits);
  return result_from_document(formats::DocumentView(document, path.string()));
}

}  // namespace remount::results

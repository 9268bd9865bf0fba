// A drive that is described by tables, imported and checked.
#pragma once

#include "algorithms/messages/render.h"
#include "model/guesses/table_import.h"
#include "tests/model/guesses/described_rows.h"

namespace remount::guesses {

class ImportedTable : public DescribedRows {
 protected:
  static ImportData look(const std::filesystem::path& folder) {
    Progress progress;
    return look_for_import({folder}, progress);
  }
  static std::string manifest(const Description& description, const std::filesystem::path& folder) {
    return formats::to_yaml(manifest_of(description, folder, Language::English));
  }
  static ImportChoice untouched(const ImportData& data) { return {data.table, data.table->preset, {}}; }
  static ImportChecks checked(const ImportData& data, const ImportChoice& choice) {
    return check_choice(data.description, choice, Progress());
  }
  static Verdict verdict(const ImportChecks& checks, CheckKind kind) {
    const ImportCheck* check = checks.find(kind);
    EXPECT_TRUE(check) << english(words(kind));
    return check ? check->verdict : Verdict::NotTold;
  }
  static std::string said(const ImportChecks& checks) {
    std::string text;
    for (const ImportCheck& check : checks.checks)
      for (const Message& evidence : check.evidence)
        text += english(words(check.kind)) + ": " + english(evidence) + "\n";
    return text;
  }
  static std::size_t column(const ImportData& data, const std::string& title) {
    const auto& columns = data.table->table.columns;
    const auto found = std::ranges::find(columns, title, &SampledColumn::title);
    EXPECT_NE(found, columns.end()) << title;
    return static_cast<std::size_t>(found - columns.begin());
  }
  /// Metric, with a yaw of which nobody says from where it counts.
  static void write_metric(const std::filesystem::path& file) {
    write_rows(file, "t,x,y,z,roll,pitch,yaw\n", [](std::size_t, const WrittenSample& sample) {
      const Eigen::Vector3d place = sample.world_from_ins.translation();
      const drive::AttitudeAngles angles = yaw_angles(sample);
      return Fields{seconds_text(sample.ins.stamp_ns),
                    number(place.x()),
                    number(place.y()),
                    number(place.z()),
                    degrees_text(angles.roll_rad),
                    degrees_text(angles.pitch_rad),
                    degrees_text(angles.yaw_rad)};
    });
  }
};

}  // namespace remount::guesses

#include "model/formats/bags/correction_status.h"

#include <algorithm>
#include <array>

#include "algorithms/core/index.h"
#include "messages/bags.h"
#include "model/drive/bad_items.h"

namespace remount::bags {
namespace {

constexpr int kNone = 0, kPosition = 1, kFloat = 2, kFixed = 3;

/// OEM6 and OEM7 manuals, "Position or Velocity Type". Those that do not stand here are positions of less.
struct PositionType {
  std::string_view number, name;
  int level = kPosition;
};
constexpr PositionType kPositionTypes[] = {
    {"0", "NONE", kNone},
    {"16", "SINGLE", kPosition},
    {"17", "PSRDIFF", kPosition},
    {"18", "WAAS", kPosition},
    {"32", "L1_FLOAT", kFloat},
    {"33", "IONOFREE_FLOAT", kFloat},
    {"34", "NARROW_FLOAT", kFloat},
    {"48", "L1_INT", kFixed},
    {"49", "WIDE_INT", kFixed},
    {"50", "NARROW_INT", kFixed},
    {"51", "RTK_DIRECT_INS", kFixed},
    {"52", "INS_SBAS", kPosition},
    {"53", "INS_PSRSP", kPosition},
    {"54", "INS_PSRDIFF", kPosition},
    {"55", "INS_RTKFLOAT", kFloat},
    {"56", "INS_RTKFIXED", kFixed},
    {"69", "PPP", kFloat},
    {"73", "INS_PPP_CONVERGING", kPosition},
    {"74", "INS_PPP", kFloat},
};

CorrectionStatus status_of_type(const std::string& position_type) {
  for (const PositionType& type : kPositionTypes)
    if (type.number == position_type || type.name == position_type) return {type.level, std::string(type.name)};
  return {kPosition, position_type};
}

}  // namespace

CorrectionStatus correction_status(const FixMessage& fix) {
  if (!fix.position_type.empty()) return status_of_type(fix.position_type);
  switch (fix.status) {
    case 0:
      return {kPosition, "STATUS_FIX"};
    case 1:
      return {kPosition, "STATUS_SBAS_FIX"};
    case 2:
      return {kFixed, "STATUS_GBAS_FIX"};
    default:
      return {fix.status < 0 ? kNone : kPosition, std::to_string(fix.status)};
  }
}

CorrectionStatus correction_status(const InspvaxMessage& message) { return status_of_type(message.position_type); }

void report_lost_corrections(std::vector<CorrectionStatus> positions, const std::string& where,
                             std::vector<drive::Finding>& findings) {
  std::erase_if(positions, [](const CorrectionStatus& position) { return position.level == kNone; });
  if (positions.size() < 10) return;
  std::array<std::size_t, 4> count{};
  for (const CorrectionStatus& position : positions) ++count[index_at(position.level)];
  int usual = kFixed;
  while (usual >= kFloat && count[index_at(usual)] * 10 < positions.size()) --usual;
  if (usual < kFloat) return;
  // What comes before the first that is as good was never lost.
  const auto best = std::find_if(positions.begin(), positions.end(),
                                 [usual](const CorrectionStatus& position) { return position.level >= usual; });
  auto worst = best;
  std::size_t lost = 0, stretches = 0;
  bool within = false;
  for (auto position = best; position != positions.end(); ++position) {
    const bool bad = position->level < usual;
    stretches += bad && !within;
    lost += bad;
    within = bad;
    if (position->level < worst->level) worst = position;
  }
  if (lost == 0) return;
  constexpr std::size_t kLongestName = 40;
  const Share share{static_cast<double>(lost) / static_cast<double>(positions.size())};
  findings.push_back(drive::make_finding(
      drive::Severity::Warning, "rtk-lost", where,
      say::bag_rtk_lost(best->name.substr(0, kLongestName), worst->name.substr(0, kLongestName), stretches, share)));
}

}  // namespace remount::bags

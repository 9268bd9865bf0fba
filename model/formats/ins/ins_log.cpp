#include "model/formats/ins/ins_log.h"

#include <algorithm>
#include <utility>

#include "model/formats/ins/ncom_file.h"
#include "model/formats/ins/sbet_file.h"
#include "model/formats/ins/sbf_file.h"
#include "model/formats/ins/trajectory_text.h"

namespace remount::formats {

const std::vector<InsLogKind>& ins_log_kinds() {
  static const std::vector<InsLogKind> kinds{
      {"sbet", recognise_sbet, recognise_sbet, read_sbet},
      {"ncom", recognise_ncom, nullptr, read_ncom},
      {"sbf", recognise_sbf, nullptr, read_sbf},
      {"trajectory-text", recognise_trajectory_text, is_post_processed_text, read_trajectory_text}};
  return kinds;
}

const InsLogKind* ins_log_kind(const std::filesystem::path& path) {
  const std::vector<InsLogKind>& kinds = ins_log_kinds();
  const auto kind = std::ranges::find_if(kinds, [&](const InsLogKind& one) { return one.recognise(path); });
  return kind == kinds.end() ? nullptr : &*kind;
}

void take_ins_log(const InsLogKind& kind, const std::filesystem::path& path, drive::Session& session) {
  InsLog log = kind.read(path, session.findings);
  session.ins = std::move(log.ins);
  session.ins_axes = log.axes;
  session.ins_stamps_from_gps = log.stamps_from_gps;
  session.ins_week_open = log.week_open;
  session.files.insert(session.files.end(), log.files.begin(), log.files.end());
}

}  // namespace remount::formats

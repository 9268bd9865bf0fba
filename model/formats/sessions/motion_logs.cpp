#include "model/formats/sessions/motion_logs.h"

#include <string>
#include <utility>

#include "messages/ins_logs.h"
#include "model/drive/attitude_convention.h"
#include "model/drive/bad_items.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/rtklib_solution.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

bool is_post_processed(const fs::path& log) {
  const InsLogKind* kind = ins_log_kind(log);
  return kind && kind->post_processed && kind->post_processed(log);
}

}  // namespace

bool is_motion_log(const fs::path& file) {
  return recognise_novatel(file) || ins_log_kind(file) || recognise_nmea(file) || recognise_rtklib(file) ||
         recognise_gpx(file);
}

const fs::path* only_post_processed(const std::vector<fs::path>& whole) {
  if (whole.size() != 1) return nullptr;
  return is_post_processed(whole.front()) ? &whole.front() : nullptr;
}

void tell_passed_over(const fs::path& taken, const std::vector<fs::path>& others, drive::Session& session) {
  if (others.empty()) return;
  std::vector<std::string> names;
  bool beside_novatel = false;
  for (const fs::path& other : others) {
    names.push_back(other.filename().string());
    beside_novatel = beside_novatel || recognise_novatel(other);
  }
  const drive::InsAxes novatel_axes = drive::axes_of(drive::AttitudeConvention::NovAtel);
  const bool preferred = beside_novatel && is_post_processed(taken);
  const bool axes_change = preferred && session.ins_axes && session.ins_axes != novatel_axes;
  Message why = !preferred    ? say::ins_log_passed_over(std::move(names))
                : axes_change ? say::ins_log_other_axes(std::move(names), drive::axes_words(*session.ins_axes),
                                                        drive::axes_words(novatel_axes))
                              : say::ins_log_post_processed(std::move(names));
  session.findings.push_back(drive::make_finding(axes_change ? drive::Severity::Warning : drive::Severity::Note,
                                                 "ins-log-chosen", taken.string(), std::move(why)));
}

}  // namespace remount::formats

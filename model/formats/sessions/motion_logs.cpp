#include "model/formats/sessions/motion_logs.h"

#include <string>
#include <utility>

#include "messages/ins_logs.h"
#include "model/drive/bad_items.h"
#include "model/formats/ins/ins_log.h"
#include "model/formats/ins/nmea_log.h"
#include "model/formats/ins/novatel_log.h"
#include "model/formats/poses/gpx_track.h"
#include "model/formats/poses/rtklib_solution.h"

namespace remount::formats {

namespace fs = std::filesystem;

bool is_motion_log(const fs::path& file) {
  return recognise_novatel(file) || ins_log_kind(file) || recognise_nmea(file) || recognise_rtklib(file) ||
         recognise_gpx(file);
}

const fs::path* only_post_processed(const std::vector<fs::path>& whole) {
  if (whole.size() != 1) return nullptr;
  const InsLogKind* kind = ins_log_kind(whole.front());
  return kind && kind->post_processed ? &whole.front() : nullptr;
}

void tell_passed_over(const fs::path& taken, const std::vector<fs::path>& others,
                      std::vector<drive::Finding>& findings) {
  if (others.empty()) return;
  std::vector<std::string> names;
  bool beside_novatel = false;
  for (const fs::path& other : others) {
    names.push_back(other.filename().string());
    beside_novatel = beside_novatel || recognise_novatel(other);
  }
  const InsLogKind* kind = beside_novatel ? ins_log_kind(taken) : nullptr;
  findings.push_back(drive::make_finding(drive::Severity::Note, "ins-log-chosen", taken.string(),
                                         kind && kind->post_processed ? say::ins_log_post_processed(std::move(names))
                                                                      : say::ins_log_passed_over(std::move(names))));
}

}  // namespace remount::formats

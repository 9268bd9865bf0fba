#include "model/formats/sessions/native_two_tables.h"

#include "messages/sessions.h"
#include "model/formats/ins/two_tables.h"
#include "model/formats/sessions/native_columns.h"

namespace remount::formats {

namespace fs = std::filesystem;

void read_two_tables(const DocumentView& node, const fs::path& folder, SessionSource& source, drive::Session& session) {
  const DocumentView attitude = node.at("attitude");
  attitude.allow_only({"file", "table", "columns"});
  InsTableLayout places = read_position_layout(node.at("columns")),
                 turns = read_attitude_layout(attitude.at("columns"));
  places.text = read_table_text(node);
  turns.text = read_table_text(attitude);
  if ((places.time_scale == TimeScale::GpsWeek) != (turns.time_scale == TimeScale::GpsWeek))
    attitude.at("columns").at("time").fail(say::native_two_weeks());
  if (!turns.quaternion) session.ins_axes = drive::axes_of(turns.attitude);
  session.ins_stamps_from_gps = places.time_scale != TimeScale::Unix;
  session.ins_week_open = places.time_scale == TimeScale::GpsWeek;
  const fs::path place_file = folder / node.at("file").string(), turn_file = folder / attitude.at("file").string();
  session.files.push_back(place_file);
  if (turn_file != place_file) session.files.push_back(turn_file);
  std::vector<motion::InsSample> positions =
      parse_ins_table(source.table(place_file), place_file, places, session.findings);
  const std::vector<StampedAttitude> attitudes =
      parse_attitude_table(source.table(turn_file), turn_file, turns, session.findings);
  JoinedMotion joined = join_tables(std::move(positions), attitudes, turn_file.string(), session.findings);
  session.ins = std::move(joined.ins);
  session.ins_fix_stamps_ns = std::move(joined.fix_stamps_ns);
  session.ins_position_lag_sigma_s = joined.position_lag_sigma_s;
}

}  // namespace remount::formats

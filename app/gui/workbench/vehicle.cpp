#include "app/gui/workbench/vehicle.h"

#include <algorithm>

#include "app/gui/workbench/vehicle_command.h"

namespace remount::gui {
Vehicle::Vehicle(const Desk& desk, const Parts& parts) : WorkbenchPart(desk), parts_(parts) {
  connect(&parts_.sessions, &SessionList::changed, this, &Vehicle::follow_sessions);
  connect(&parts_.outcome, &Outcome::changed, this, &Vehicle::changed);
}

std::optional<motion::LidarIndex> Vehicle::shown() const { return lidar_of_sessions(parts_.sessions.all()); }

std::optional<motion::LidarIndex> Vehicle::lidar_of_sessions(const std::vector<SessionPtr>& open) const {
  if (open.empty()) return {};
  const std::string name = lidar_of(*open.front());
  if (!std::ranges::all_of(open, [&](const SessionPtr& session) { return lidar_of(*session) == name; })) return {};
  for (motion::LidarIndex l; l < lidars_.size(); ++l)
    if (lidars_[l].name() == name) return l;
  return {};
}

std::vector<std::filesystem::path> Vehicle::paths_of(const VehicleLidar& lidar) const {
  std::vector<std::filesystem::path> paths;
  for (const auto& recording : lidar.recorded.recordings) paths.push_back(recordings_.at(recording.place).path);
  return paths;
}

std::vector<drive::TopicChoice> Vehicle::topics_of(const VehicleLidar& lidar) const {
  std::vector<drive::TopicChoice> topics;
  for (const auto& recording : lidar.recorded.recordings) {
    drive::TopicChoice choice = recordings_.at(recording.place).topics;
    for (const auto& [role, topic] : recording.topics) choice[role] = topic;
    topics.push_back(std::move(choice));
  }
  return topics;
}

OutputPtr Vehicle::output_of(motion::LidarIndex lidar) const {
  if (shown() == lidar) return parts_.outcome.output();
  if (const auto& saved = lidars_.at(lidar).saved) return saved->output;
  const CalibratedPtr& calibrated = lidars_.at(lidar).calibrated;
  return calibrated ? calibrated->result.output : nullptr;
}

const std::optional<RigidTransform>& Vehicle::nominal_of(motion::LidarIndex lidar) const {
  return shown() == lidar ? parts_.setup.nominal_ins_from_lidar() : lidars_.at(lidar).nominal_ins_from_lidar;
}

bool Vehicle::is_as_solved(motion::LidarIndex lidar) const {
  if (!common_) return false;
  const auto solved =
      std::ranges::find(common_->lidars, lidars_.at(lidar).name(), [](const SolvedLidar& of) { return of.job.name; });
  const OutputPtr now = output_of(lidar);
  if (solved == common_->lidars.end() || !now) return false;
  const VehicleLidar& kept = lidars_[lidar];
  if (!is_same_nominal(nominal_of(lidar), solved->job.input.nominal_ins_from_lidar)) return false;
  const bool as_decided = shown() == lidar ? parts_.decisions.made() == solved->decisions
                                           : kept.saved || kept.calibrated->decisions == solved->decisions;
  return as_decided && now->result.status == solved->output->result.status &&
         now->result.mounting.reference_from_sensor.isApprox(solved->output->result.mounting.reference_from_sensor,
                                                             1e-12);
}

bool Vehicle::up_to_date() const {
  if (!common_) return false;
  return std::ranges::all_of(common_->lidars, [&](const SolvedLidar& solved) {
    const auto lidar = std::ranges::find(lidars_, solved.job.name, &VehicleLidar::name);
    return lidar != lidars_.end() && is_as_solved(index_at<motion::LidarIndex>(lidar - lidars_.begin()));
  });
}

void Vehicle::tick(motion::LidarIndex lidar, bool on) {
  if (lidars_.at(lidar).ticked == on) return;
  lidars_[lidar].ticked = on;
  emit changed();
  emit edited();
}

Bench Vehicle::bench() const {
  const CalibratedPtr now = parts_.calibrations.calibrated();
  const bool empty = !now->result.output && now->decisions.empty();
  return {parts_.sessions.all(), parts_.setup.nominal_ins_from_lidar(), empty ? nullptr : now};
}

VehicleState Vehicle::state() const {
  VehicleState state{recordings_, lidars_, common_, bench()};
  const std::optional<motion::LidarIndex> on_bench = shown();
  if (!on_bench) {  // sessions of several are open: what was calibrated before they were is still of one
    if (const auto of_result = lidar_of_sessions(parts_.outcome.input().sessions); of_result && parts_.outcome.output())
      state.lidars[*of_result].calibrated = state.bench.calibrated;
    return state;
  }
  VehicleLidar& lidar = state.lidars[*on_bench];
  const std::vector<std::filesystem::path> paths = paths_of(lidar);
  lidar.sessions.assign(paths.size(), nullptr);
  for (const SessionPtr& session : state.bench.sessions)
    if (const auto at = std::ranges::find(paths, session->path); at != paths.end())
      lidar.sessions[static_cast<std::size_t>(at - paths.begin())] = session;
  lidar.nominal_ins_from_lidar = state.bench.nominal_ins_from_lidar;
  lidar.calibrated = state.bench.calibrated;
  lidar.saved = nullptr;
  return state;
}

void Vehicle::show(motion::LidarIndex lidar) {
  if (shown() == lidar || lidar >= lidars_.size()) return;
  if (desk_.activity.opening() || desk_.activity.calibrating() || desk_.activity.solving())
    return desk_.notices.say(drive::Severity::Warning, {},
                             tr("Wait until the present work is done, or cancel it, before showing another LiDAR."));
  const auto put_instead = [this, lidar](const VehicleLidar& opened) {
    const VehicleState before = state();
    VehicleState after = before;
    after.lidars.at(lidar) = opened;
    after.bench = {opened.sessions, opened.nominal_ins_from_lidar, opened.calibrated};
    desk_.history.push(new VehicleCommand(*this, {VehicleStep::Kind::Shown, opened.name()}, before, after));
  };
  VehicleLidar asked = lidars_[lidar];
  const std::vector<std::filesystem::path> paths = paths_of(asked);
  const std::vector<drive::TopicChoice> topics = topics_of(asked);
  if (keep_read_with(topics, asked.sessions) && !asked.saved) return put_instead(asked);
  desk_.activity.start(
      Activity::Kind::Opening,
      [this, asked, paths, topics, put_instead, engine = desk_.engine,
       known = known_](Progress& progress) mutable -> JobRunner::Deliver {
        open_lidar(engine, paths, topics, asked, progress);
        if (progress.cancelled()) return {};
        return [this, asked, put_instead, known] {
          if (known == known_) put_instead(asked);
        };
      },
      desk_.notices.report_failure());
}

bool Vehicle::show_chosen(motion::SessionIndex session, const drive::TopicChoice& choice) {
  const std::optional<motion::LidarIndex> now = shown();
  if (!now || !parts_.sessions.holds(session)) return false;
  const drive::Session& open = *parts_.sessions.all()[session];
  if (without_lidar(choice) != without_lidar(drive::choice_in_use(open.topics))) return false;
  for (motion::LidarIndex l; l < lidars_.size(); ++l)
    for (const auto& recording : lidars_[l].recorded.recordings) {
      const auto wanted = choice.find("lidar"), has = recording.topics.find("lidar");
      if (l == *now || wanted == choice.end() || has == recording.topics.end() || wanted->second != has->second ||
          recordings_.at(recording.place).path != open.path)
        continue;
      show(l);
      return true;
    }
  return false;
}

void Vehicle::edit_nominals(const std::map<std::string, RigidTransform>& ins_from_lidars) {
  if (desk_.activity.opening() || desk_.activity.calibrating() || desk_.activity.solving())
    return desk_.notices.say(drive::Severity::Warning, tr("Nominal mountings"),
                             tr("Wait until the present work is done, or cancel it, before giving others."));
  const VehicleState before = state();
  VehicleState after = before;
  const std::optional<motion::LidarIndex> on_bench = shown();
  for (const auto& [name, ins_from_lidar] : ins_from_lidars) {
    const auto lidar = std::ranges::find(after.lidars, name, &VehicleLidar::name);
    if (lidar == after.lidars.end()) continue;
    lidar->nominal_ins_from_lidar = ins_from_lidar;
    if (on_bench && after.lidars[*on_bench].name() == name) after.bench.nominal_ins_from_lidar = ins_from_lidar;
  }
  desk_.history.push(new VehicleCommand(*this, {VehicleStep::Kind::Nominals}, before, after));
  desk_.notices.say(drive::Severity::Note, tr("Nominal mountings"),
                    tr("%1 LiDARs have theirs from the file, by their names.").arg(ins_from_lidars.size()));
}

void Vehicle::mark_written(const std::vector<std::string>& names) {
  const std::optional<motion::LidarIndex> on_bench = shown();
  for (const std::string& name : names) {
    const auto lidar = std::ranges::find(lidars_, name, &VehicleLidar::name);
    if (lidar == lidars_.end()) continue;
    if (on_bench && lidars_[*on_bench].name() == name) {
      parts_.outcome.mark_exported(Exported::Written);
    } else if (lidar->calibrated) {
      auto written = std::make_shared<Calibrated>(*lidar->calibrated);
      written->result.exported = Exported::Written;
      lidar->calibrated = std::move(written);
    }
  }
  emit edited();
}

void Vehicle::apply(const VehicleState& state, const QString& step) {
  recordings_ = state.recordings;
  lidars_ = state.lidars;
  common_ = state.common;
  put(state.bench);
  desk_.notices.log(drive::Severity::Note, {}, step);
  emit changed();
  emit edited();
}

void Vehicle::put(const Bench& bench) {
  swapping_ = true;  // what is open is of the same vehicle
  parts_.calibrations.stop_for_other_sessions();
  parts_.sessions.put(bench.sessions);
  known_ = bench.sessions;
  if (bench.calibrated)
    parts_.calibrations.put_back(*bench.calibrated);
  else
    parts_.decisions.put({});
  parts_.setup.put(parts_.setup.settings(), bench.nominal_ins_from_lidar);
  parts_.outcome.count_as_other();
  parts_.sessions.announce();
  parts_.setup.announce_nominal();
  parts_.calibrations.announce(bench.calibrated);
  swapping_ = false;
}

}  // namespace remount::gui

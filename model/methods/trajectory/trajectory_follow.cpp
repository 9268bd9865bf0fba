#include <chrono>
#include <optional>
#include <thread>

#include "algorithms/core/error.h"
#include "messages/results.h"
#include "model/formats/growing_session.h"
#include "model/formats/session_readers.h"
#include "model/methods/calibrate.h"
#include "model/methods/trajectory/trajectory_method.h"
#include "model/pipeline/beam_report.h"
#include "model/pipeline/mended_scans.h"
#include "model/results/beam_file.h"
#include "model/sweeps/sweep_trial.h"

namespace remount::methods {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

// Sleeps in small pieces, so that Ctrl-C is obeyed soon.
void wait(double time_s, const Progress& progress) {
  const Clock::time_point start = Clock::now();
  while (!progress.cancelled() && seconds_since(start) < time_s)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

std::size_t items_of(const drive::Session& session) {
  return session.ins.size() + session.world_from_ins.size() + session.odometry_from_lidar.size() + session.gnss.size() +
         (session.scans ? session.scans->size() : 0);
}

bool can_begin(const drive::Session& session) { return kTrajectoryMethod.lack(session, {}).empty(); }

}  // namespace

FollowedSession follow_trajectory(const std::filesystem::path& path, const pipeline::PipelineInput& input,
                                  const FollowOptions& options, const TrajectoryFeed::Tell& tell, Progress& following,
                                  Progress& finishing) {
  settings::require_valid(input.settings);
  pipeline::PipelineInput with_session = input;
  if (!input.settings.beams.file.empty()) with_session.known_beams = results::load_beams(input.settings.beams.file);
  std::optional<TrajectoryFeed> feed;
  const auto begin = [&](const drive::Session& session) {
    if (!with_session.known_beams.empty() && !session.scans)
      throw Error(ErrorCode::Contract, input.settings.beams.file, say::beams_without_scans());
    if (options.declared_nominal && !with_session.nominal_ins_from_lidar)
      with_session.nominal_ins_from_lidar = session.nominal_ins_from_lidar;
    check_nominal(with_session);
    feed.emplace(input.settings, with_session.nominal_ins_from_lidar, input.threads);
    feed->begin(session);
  };
  formats::GrowingSession growing(path, options.topics);
  std::size_t items = 0;
  Clock::time_point grown = Clock::now();
  while (!following.cancelled() && seconds_since(grown) < options.settled_s) {
    const drive::Session* written = growing.look();
    if (written && items_of(*written) != items) {
      // Not copied where nothing is known: a look costs in proportion to what has been added.
      const std::shared_ptr<const drive::Session> now =
          pipeline::mended_session({std::shared_ptr<const drive::Session>(), written}, with_session.known_beams);
      // The recording was begun again: what is known of the one before says nothing of this one.
      if (items_of(*now) < items) feed.reset();
      items = items_of(*now);
      grown = Clock::now();
      if (!feed && can_begin(*now)) begin(*now);
      if (feed) feed->offer(*now, false, 0.0, tell, following);
      // What was worked on meanwhile took time in which the session may have stood still or grown: look again first.
      grown = std::max(grown, Clock::now());
      continue;
    }
    wait(options.poll_s, following);
  }
  FollowedSession followed;
  Progress quiet;
  followed.session = std::make_shared<const drive::Session>(
      formats::open_session(path, options.topics, quiet, checks::LookAt::Streams));
  with_session.sessions = {followed.session};
  if (!feed) begin(*followed.session);
  with_session.settings.run.method = method_registry::MethodChoice(kTrajectoryMethod.id);
  if (sweeps::needs_sweep_trial(*followed.session, input.settings.run.deskew)) {
    // What was told on the way took the scans as they are: how they were swept is tried on the whole recording.
    followed.output = calibrate(with_session, finishing);
  } else {
    with_session.sessions = {pipeline::mended_session(followed.session, with_session.known_beams)};
    feed->offer(*with_session.sessions.front(), true, 0.0, tell, finishing);
    followed.output = trajectory_output(with_session, *feed, feed->finish(with_session.sessions, finishing));
    complete_output(with_session, followed.output);
    pipeline::add_known_beams(with_session.known_beams, followed.output);
  }
  followed.nominal_ins_from_lidar = with_session.nominal_ins_from_lidar;
  return followed;
}

}  // namespace remount::methods

// The session formats that are built in, and how a session of any of them is opened.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/core/progress.h"
#include "model/checks/data_check.h"
#include "model/drive/lidar_offer.h"
#include "model/drive/session.h"
#include "model/drive/topic_offer.h"
#include "model/formats/sessions/session_reader.h"

namespace remount::formats {

/// The built-in readers. Adding one: a file in sessions/ and a line in session_readers.cpp.
const std::vector<std::unique_ptr<SessionReader>>& session_readers();

/// The reader that is surest of what lies there; null where none recognises it. Throws Error(Io) as probes do.
const SessionReader* recognise_session(const std::filesystem::path& path);

/// Opens with the reader that is surest, and looks at what it read (model/checks): what is suspicious is among the
/// session's findings. Throws Error that names what each reader looks for where none recognises it.
drive::Session open_session(const std::filesystem::path& path, Progress& progress,
                            checks::LookAt look_at = checks::LookAt::StreamsAndScans);
/// As above with topics of a bag that were chosen; none: all are suggested.
drive::Session open_session(const std::filesystem::path& path, const drive::TopicChoice& topics, Progress& progress,
                            checks::LookAt look_at = checks::LookAt::StreamsAndScans);

/// What open_session does with a session that some other reader made: what no reader can judge line by line is settled
/// (ADR 17), and it is looked at.
drive::Session settled_session(drive::Session session, const Progress& progress,
                               checks::LookAt look_at = checks::LookAt::StreamsAndScans);

/// What there is to choose from before a session is opened; nothing where its format has no topics. Throws Error as
/// open_session does.
std::optional<drive::TopicOffer> offer_topics(const std::filesystem::path& path, Progress& progress);

/// Which LiDARs a recording has, in its order; at least one. Each is a session of its own:
/// `open_session(path, offer.choice, progress)`, all with the same streams of the INS. Throws Error as open_session
/// does.
std::vector<drive::LidarOffer> offer_lidars(const std::filesystem::path& path, Progress& progress);

}  // namespace remount::formats

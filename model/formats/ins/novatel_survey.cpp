#include "model/formats/ins/novatel_survey.h"

#include <algorithm>

#include "algorithms/core/error.h"
#include "messages/general.h"
#include "model/formats/files/input_file.h"
#include "model/formats/files/number_bytes.h"
#include "model/formats/files/text_file.h"

namespace remount::formats {
namespace {

std::string recorded_bytes(const std::filesystem::path& path) {
  std::string bytes = read_regular_file(path);
  if (holds_binary_sync(bytes)) return bytes;
  return utf8_text(std::move(bytes));
}

/// Whether there is something to take. Throws Error where its content is not possible.
bool has_content(const NovatelFrame& frame, NovatelBodies& bodies, const std::string& where, NovatelImuTypes& imus) {
  switch (frame.type->use) {
    case NovatelUse::Inspvax:
    case NovatelUse::Inspva:
      return bodies.solution(frame, where).has_value();
    case NovatelUse::Insstdev:
      bodies.errors(frame, where);
      return true;
    case NovatelUse::Bestpos:
      return bodies.fix(frame, where).has_value();
    case NovatelUse::RawImu: {
      const auto imu = bodies.raw_imu(frame, where);
      if (imu) imus.add(imu->type);
      return imu.has_value();
    }
    default:
      return false;
  }
}

/// The first field of INSCONFIG.
void add_configured_imu(const NovatelFrame& frame, NovatelImuTypes& imus) {
  if (!frame.binary)
    imus.add(frame.body.substr(0, frame.body.find(',')));
  else if (frame.body.size() >= sizeof(std::uint32_t))
    imus.add(static_cast<int>(std::min<std::uint32_t>(little_number<std::uint32_t>(frame.body, 0), 255)));
}

/// Whoever made a file may have made up a name for each of its logs.
constexpr std::size_t kMostNames = 200;

}  // namespace

NovatelRecording::NovatelRecording(const std::filesystem::path& path) : path_(path), bytes_(recorded_bytes(path)) {
  is_text_ = !holds_binary_sync(bytes_);
}

RecordingPlaces::RecordingPlaces(const NovatelRecording& recording) : recording_(recording) {
  if (recording.bytes().find('\n') == std::string_view::npos) line_end_ = '\r';
}

std::string RecordingPlaces::of(std::size_t at) {
  if (!recording_.is_text()) return recording_.path().string() + ", byte " + std::to_string(at);
  const std::string_view between = recording_.bytes().substr(counted_, at - counted_);
  line_ += static_cast<std::size_t>(std::ranges::count(between, line_end_));
  counted_ = at;
  return at_line(recording_.path(), line_);
}

std::string novatel_name(const NovatelFrame& frame) {
  if (!frame.binary) {
    std::string name(frame.name);
    if (name.ends_with("A_1")) name.erase(name.size() - 3, 1);
    return name;
  }
  const NovatelLogType* type = novatel_log_type(frame.id);
  std::string name = type == nullptr ? "ID " + std::to_string(frame.id) : std::string(type->name);
  return frame.source == 0 ? name : name + "_" + std::to_string(frame.source);
}

NovatelSurvey survey_novatel(const NovatelRecording& recording) {
  NovatelSurvey survey;
  NovatelScanner scanner(recording.bytes());
  RecordingPlaces places(recording);
  NovatelBodies bodies;
  std::size_t in_logs = 0;
  for (NovatelFrame frame; scanner.next(frame);) {
    in_logs += frame.bytes;
    const bool counts = frame.type != nullptr && frame.type->use != NovatelUse::None;
    if (!frame.problem.empty()) {
      if (counts) survey.bad.add(say::of_file(places.of(frame.at), frame.problem));
      continue;
    }
    const std::string name = novatel_name(frame);
    auto count = survey.logs.find(name);
    if (count == survey.logs.end()) {
      if (survey.logs.size() == kMostNames && !counts) {
        ++survey.unnamed;
        continue;
      }
      count = survey.logs.emplace(name, NovatelCount{counts ? frame.type->use : NovatelUse::None}).first;
    }
    ++count->second.whole;
    if (name == "INSCONFIG") add_configured_imu(frame, survey.imu_types);
    if (!counts) continue;
    try {
      count->second.usable += has_content(frame, bodies, places.of(frame.at), survey.imu_types);
    } catch (const Error& error) {
      survey.bad.add(error);
    }
  }
  survey.stray_bytes = recording.bytes().size() - in_logs;
  return survey;
}

std::string NovatelSurvey::most_of(std::initializer_list<NovatelUse> uses) const {
  std::string best;
  std::size_t most = 0;
  for (const NovatelUse use : uses)
    for (const auto& [name, count] : logs)
      if (count.use == use && count.usable > most) best = name, most = count.usable;
  return best;
}

std::vector<std::string> NovatelSurvey::others(const std::vector<std::string>& taken) const {
  std::vector<std::pair<std::size_t, std::string>> counted;
  for (const auto& [name, count] : logs)
    if (std::ranges::find(taken, name) == taken.end()) counted.emplace_back(count.whole, name);
  std::ranges::stable_sort(counted, std::greater<>{}, &std::pair<std::size_t, std::string>::first);
  constexpr std::size_t kMostListed = 20;
  std::vector<std::string> listed;
  std::size_t more = unnamed;
  for (const auto& [whole, name] : counted)
    if (listed.size() < kMostListed)
      listed.push_back(name + " (" + std::to_string(whole) + ")");
    else
      more += whole;
  if (more > 0) listed.push_back("... (" + std::to_string(more) + ")");
  return listed;
}

}  // namespace remount::formats

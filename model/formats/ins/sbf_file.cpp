#include "model/formats/ins/sbf_file.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "algorithms/core/error.h"
#include "messages/ins_logs.h"
#include "messages/sessions.h"
#include "model/conventions/assumed_tilt.h"
#include "model/drive/bad_items.h"
#include "model/drive/stamped_streams.h"
#include "model/formats/files/input_file.h"
#include "model/formats/ins/sbf_blocks.h"

namespace remount::formats {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kSbfHeadBytes = 64 * 1024;

/// Of an INS, as one kind of block has it.
struct SbfStream {
  std::vector<motion::InsSample> ins;
  std::size_t without_solution = 0;
};

class SbfCollector {
 public:
  explicit SbfCollector(const fs::path& path) : path_(path) {}

  void read(std::string_view bytes) {
    SbfScanner scanner(bytes);
    std::size_t in_blocks = 0;
    for (SbfBlock block; scanner.next(block);) {
      ++counts[block.id];
      in_blocks += block.bytes.size();
      try {
        take(block);
      } catch (const Error& error) {
        bad.add(error);
      }
    }
    broken = scanner.broken();
    stray_bytes = bytes.size() - in_blocks;
  }

  SbfStream geodetic, cartesian;
  std::vector<SbfFix> fixes;
  std::vector<SbfCovariance> covariances;
  std::vector<SbfAttitude> attitudes, attitude_sigmas;
  std::map<std::uint16_t, std::size_t> counts;  // thirteen bits
  std::size_t broken = 0, stray_bytes = 0, without_fix = 0;
  drive::BadItems bad;

 private:
  void take(const SbfBlock& block) {
    const std::string where = path_.string() + ", byte " + std::to_string(block.at);
    switch (static_cast<SbfId>(block.id)) {
      case SbfId::InsNavGeod:
        return take_ins(block, where, geodetic);
      case SbfId::InsNavCart:
        return take_ins(block, where, cartesian);
      case SbfId::PvtGeodetic:
        if (const SbfFix fix = sbf_fix(block, where); fix.solved)
          fixes.push_back(fix);
        else
          ++without_fix;
        return;
      case SbfId::PosCovGeodetic:
        return covariances.push_back(sbf_covariance(block, where));
      case SbfId::AttEuler:
        return attitudes.push_back(sbf_attitude(block, where));
      case SbfId::AttCovEuler:
        return attitude_sigmas.push_back(sbf_attitude(block, where));
    }
  }
  void take_ins(const SbfBlock& block, const std::string& where, SbfStream& stream) {
    const InsNavValues values = ins_nav_values(block, where);
    if (is_without_solution(values)) {
      ++stream.without_solution;
      return;
    }
    motion::InsSample sample = ins_nav_sample(values, where);
    sample.stamp_ns = sbf_stamp_ns(block, where);
    stream.ins.push_back(sample);
  }

  const fs::path& path_;
};

/// The item of exactly that time; null where there is none. `items` ascend.
template <class Item>
const Item* at_time(const std::vector<Item>& items, std::int64_t stamp_ns) {
  const auto found = std::ranges::lower_bound(items, stamp_ns, {}, &Item::stamp_ns);
  return found != items.end() && found->stamp_ns == stamp_ns ? &*found : nullptr;
}

bool is_covariance(const Eigen::Matrix3d& covariance) {
  return covariance.allFinite() && covariance.diagonal().minCoeff() > 0.0 &&
         Eigen::LLT<Eigen::Matrix3d>(covariance).info() == Eigen::Success;
}

/// Errors of PosCovGeodetic go before those that the fixes state themselves.
void give_covariances(SbfCollector& found) {
  std::ranges::stable_sort(found.covariances, {}, &SbfCovariance::stamp_ns);
  for (SbfFix& fix : found.fixes)
    if (const SbfCovariance* stated = at_time(found.covariances, fix.fix.stamp_ns);
        stated && is_covariance(stated->enu_m2))
      fix.fix.covariance_enu_m2 = stated->enu_m2;
}

/// Attitudes of the antennas at the positions of their times. @return how many have no roll
std::size_t join_antennas(SbfCollector& found, std::vector<motion::InsSample>& ins) {
  std::ranges::stable_sort(found.attitudes, {}, &SbfAttitude::stamp_ns);
  std::ranges::stable_sort(found.attitude_sigmas, {}, &SbfAttitude::stamp_ns);
  std::size_t without_roll = 0;
  for (const SbfFix& fix : found.fixes) {
    const SbfAttitude* attitude = at_time(found.attitudes, fix.fix.stamp_ns);
    if (!attitude || !std::isfinite(attitude->heading_deg + attitude->pitch_deg)) continue;
    InsNavValues values;
    values.mode = 1;
    values.latitude_rad = fix.fix.latitude_rad, values.longitude_rad = fix.fix.longitude_rad;
    values.height_m = fix.fix.height_m;
    values.position_sigma_enu_m = fix.fix.covariance_enu_m2.diagonal().cwiseSqrt();
    values.heading_deg = attitude->heading_deg, values.pitch_deg = attitude->pitch_deg;
    const bool rolls = std::isfinite(attitude->roll_deg);
    values.roll_deg = rolls ? attitude->roll_deg : 0.0;
    if (const SbfAttitude* sigma = at_time(found.attitude_sigmas, fix.fix.stamp_ns)) {
      values.heading_sigma_deg = sigma->heading_deg, values.pitch_sigma_deg = sigma->pitch_deg;
      values.roll_sigma_deg = sigma->roll_deg;
    }
    try {
      motion::InsSample sample = ins_nav_sample(values, {});
      sample.stamp_ns = fix.fix.stamp_ns;
      sample.quality =
          fix.quality == motion::InsQuality::Good && !attitude->fixed ? motion::InsQuality::Degraded : fix.quality;
      if (!rolls) conventions::assume_roll(sample.sigma.attitude_rad);
      without_roll += !rolls;
      ins.push_back(sample);
    } catch (const Error& error) {
      found.bad.add(error.message());
    }
  }
  return without_roll;
}

/// "PVTGeodetic (300)", the most frequent first, without those in `taken`.
std::vector<std::string> other_blocks(const SbfCollector& found, std::initializer_list<SbfId> taken) {
  constexpr std::size_t kMostListed = 12;
  std::vector<std::pair<std::size_t, std::uint16_t>> counted;
  for (const auto& [id, count] : found.counts)
    if (std::ranges::find(taken, static_cast<SbfId>(id)) == taken.end()) counted.emplace_back(count, id);
  std::ranges::stable_sort(counted, std::greater<>{}, &std::pair<std::size_t, std::uint16_t>::first);
  std::vector<std::string> listed;
  std::size_t more = 0;
  for (const auto& [count, id] : counted)
    if (listed.size() < kMostListed)
      listed.push_back(sbf_name(id) + " (" + std::to_string(count) + ")");
    else
      more += count;
  if (more > 0) listed.push_back("... (" + std::to_string(more) + ")");
  return listed;
}

/// Tells nothing where fewer than so many sentences are to be told: there was nothing to choose.
void tell_sbf(const SbfCollector& found, const fs::path& path, std::vector<Message> told,
              std::vector<std::string> others, std::size_t least_told, std::vector<drive::Finding>& findings) {
  found.bad.report(findings, "bad-ins", path.string(), say::left_out_records);
  if (!others.empty()) told.push_back(say::novatel_not_used(std::move(others)));
  if (found.broken > 0) told.push_back(say::sbf_broken(found.broken));
  if (found.stray_bytes > 0) told.push_back(say::sbf_stray(Bytes{found.stray_bytes}));
  if (told.size() < least_told) return;
  findings.push_back(
      drive::make_finding(drive::Severity::Note, "ins-log-chosen", path.string(), Message::sequence(std::move(told))));
}

/// Why a log gives no motion of an INS.
Message without_attitude(const SbfCollector& found) {
  return found.fixes.empty() ? found.bad.after(say::sbf_none_usable(other_blocks(found, {})))
                             : found.bad.after(say::sbf_fixes_alone(found.fixes.size(), other_blocks(found, {})));
}

}  // namespace

bool recognise_sbf(const fs::path& path) {
  try {
    const std::string head = read_file_head(path, kSbfHeadBytes);
    SbfScanner scanner(head);
    std::size_t blocks = 0;
    for (SbfBlock block; scanner.next(block);) {
      if (block.at > kSbfHeadBytes / 8 && blocks == 0) return false;
      if (++blocks == 2 || !sbf_name(block.id).starts_with("block")) return true;
    }
  } catch (const Error&) {
    // not readable: not recognised
  }
  return false;
}

InsLog read_sbf(const fs::path& path, std::vector<drive::Finding>& findings) {
  InsLog log;
  log.stamps_from_gps = true;
  log.files = {path};
  SbfCollector found(path);
  found.read(read_regular_file(path));
  std::vector<Message> told;
  std::vector<std::string> others;
  std::size_t least_told = 1;
  const bool cartesian = found.cartesian.ins.size() > found.geodetic.ins.size();
  SbfStream& solution = cartesian ? found.cartesian : found.geodetic;
  if (!solution.ins.empty()) {
    const SbfId id = cartesian ? SbfId::InsNavCart : SbfId::InsNavGeod;
    log.ins = std::move(solution.ins);
    told.push_back(say::novatel_taken(sbf_name(static_cast<std::uint16_t>(id)), log.ins.size()));
    if (solution.without_solution > 0) told.push_back(say::novatel_without_solution(solution.without_solution));
    others = other_blocks(found, {id});
    least_told = cartesian ? 1 : 2;
  } else {
    give_covariances(found);
    const std::size_t without_roll = join_antennas(found, log.ins);
    if (log.ins.empty()) throw Error(ErrorCode::Format, path.string(), without_attitude(found));
    told.push_back(say::novatel_taken("PVTGeodetic, AttEuler", log.ins.size()));
    others = other_blocks(found, {SbfId::PvtGeodetic, SbfId::PosCovGeodetic, SbfId::AttEuler, SbfId::AttCovEuler});
    if (without_roll > 0)
      findings.push_back(drive::make_finding(drive::Severity::Warning, "roll-assumed", path.string(),
                                             say::nmea_roll_assumed("AttEuler", Angle{conventions::kAssumedTilt_rad})));
  }
  tell_sbf(found, path, std::move(told), std::move(others), least_told, findings);
  drive::keep_near(log.ins, path.string(), findings);
  drive::keep_ascending(log.ins, "ins", path.string(), findings);
  return log;
}

std::vector<motion::GnssFix> read_sbf_fixes(const fs::path& path, std::vector<drive::Finding>& findings) {
  SbfCollector found(path);
  found.read(read_regular_file(path));
  give_covariances(found);
  std::vector<motion::GnssFix> fixes;
  for (const SbfFix& fix : found.fixes)
    if (is_covariance(fix.fix.covariance_enu_m2)) fixes.push_back(fix.fix);
  if (fixes.empty()) throw Error(ErrorCode::Format, path.string(), found.bad.after(say::sbf_no_fixes()));
  std::vector<Message> told{say::novatel_fixes_taken(fixes.size(), "PVTGeodetic")};
  if (found.without_fix > 0) told.push_back(say::novatel_without_fix(found.without_fix));
  if (const std::size_t unstated = found.fixes.size() - fixes.size(); unstated > 0)
    told.push_back(say::sbf_without_errors(unstated));
  tell_sbf(found, path, std::move(told), {}, 1, findings);
  drive::keep_near(fixes, path.string(), findings);
  drive::keep_ascending(fixes, "gnss", path.string(), findings);
  return fixes;
}

}  // namespace remount::formats

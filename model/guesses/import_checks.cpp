#include "model/guesses/import_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algorithms/core/error.h"
#include "algorithms/geometry/rotation.h"
#include "messages/guesses.h"
#include "messages/table_import.h"
#include "model/drive/bad_items.h"
#include "model/drive/session_frames.h"
#include "model/formats/files/text_file.h"
#include "model/formats/poses/pose_file.h"
#include "model/guesses/clock_guess.h"
#include "model/guesses/fastest_speed.h"
#include "model/guesses/position_readings.h"
#include "model/guesses/table_guess.h"
#include "model/guesses/travel_fit.h"

namespace remount::guesses {
namespace {

using motion::StampedPose;

/// Of the samples, those that tell as much as all of them.
std::vector<StampedPose> thinned(std::vector<StampedPose> poses) {
  constexpr std::size_t kMostPoses = 60'000;
  const std::size_t stride = 1 + poses.size() / kMostPoses;
  if (stride == 1) return poses;
  std::vector<StampedPose> some;
  for (std::size_t i = 0; i < poses.size(); i += stride) some.push_back(poses[i]);
  return some;
}

class ImportChecker {
 public:
  ImportChecker(const InsGuess& ins, std::size_t rows, const std::vector<std::int64_t>& stamps_ns,
                const Progress& progress)
      : ins_(ins), layout_(ins.layout), rows_(rows), stamps_ns_(stamps_ns), progress_(progress) {}

  ImportChecks check() {
    try {
      read();
    } catch (const Error& error) {
      if (progress_.cancelled()) return {};
      return unreadable({drive::message_of(error)});
    }
    if (progress_.cancelled() || poses_.empty()) return {};
    const std::vector<StampedPose> some = thinned(std::move(poses_));
    fit_ = travel_fit(some);
    check_rows();
    check_rate();
    check_position(some);
    check_heading();
    check_pitch();
    check_clock();
    draw(some);
    return std::move(out_);
  }

 private:
  ImportCheck& add(CheckKind kind, Verdict verdict) {
    return out_.checks.emplace_back(ImportCheck{.kind = kind, .verdict = verdict});
  }

  void read() {
    drive::Session session;
    read_into(session);
    poses_ = drive::metric_poses(session);
    for (const motion::InsSample& sample : session.ins) heights_m_.push_back(sample.height_m);
    for (const StampedPose& pose : session.world_from_ins) heights_m_.push_back(pose.pose.translation().z());
    findings_ = std::move(session.findings);
    if (poses_.empty()) return;
    out_.samples = poses_.size();
    InsGuess ins;
    put_times_of(poses_, ins);
    ins.week_open = out_.week_open = layout_.time_scale == formats::TimeScale::GpsWeek;
    place_in_week(ins, stamps_ns_);
    out_.span = ins.span;
    out_.stretches = std::move(ins.stretches);
    std::vector<std::int64_t> stamps_ns;
    for (const StampedPose& pose : poses_) stamps_ns.push_back(pose.stamp_ns);
    out_.drive.ins = overview::report_stream(stamps_ns);
    out_.drive.lidar = overview::report_stream(stamps_ns_);
  }

  void read_into(drive::Session& session) const {
    const std::filesystem::path& file = ins_.file;
    const auto format = ins_.pose_format ? formats::pose_format_from_string(*ins_.pose_format) : std::nullopt;
    if (format) {
      session.world_from_ins = formats::read_pose_file(file, *format, session.findings);
      return;
    }
    const std::string text = formats::read_text_file(file);
    if (layout_.metric_position)
      session.world_from_ins = formats::parse_pose_table(text, file, layout_, session.findings, progress_);
    else
      session.ins = formats::parse_ins_table(text, file, layout_, session.findings, progress_);
  }

  void check_rows() {
    ImportCheck& check = add(CheckKind::Rows, findings_.empty() ? Verdict::Good : Verdict::Doubtful);
    const std::size_t rejected = rows_ > out_.samples ? rows_ - out_.samples : 0;
    check.evidence.push_back(say::import_rows(out_.samples, std::max(rows_, out_.samples), rejected));
    for (const drive::Finding& finding : findings_) check.evidence.push_back(finding.explanation);
    if (2 * out_.samples < rows_) check.verdict = Verdict::Bad;
  }

  void check_rate() {
    constexpr double kSlowest_hz = 5.0, kFastest_hz = 2500.0, kLongest_s = 86'400.0;
    const overview::StreamReport& ins = out_.drive.ins;
    ImportCheck& check = add(CheckKind::Rate, Verdict::Good);
    check.evidence.push_back(say::import_rate(Frequency{ins.rate_hz}, Duration{ins.span_s()}));
    if (ins.gaps > 0) {
      check.verdict = Verdict::Doubtful;
      check.evidence.push_back(say::import_gaps(ins.gaps, Duration{ins.longest_gap_s}));
    }
    if (ins.rate_hz > kFastest_hz || ins.span_s() > kLongest_s || ins.span_s() < 1.0) {
      check.verdict = Verdict::Bad;
      check.evidence.push_back(say::import_rate_unlikely());
    } else if (ins.rate_hz < kSlowest_hz) {
      check.verdict = Verdict::Doubtful;
      check.evidence.push_back(say::import_rate_slow());
    }
  }

  void check_position(const std::vector<StampedPose>& poses) {
    constexpr double kFastestVehicle_mps = 80.0, kLeastWay_m = 5.0;
    std::vector<Eigen::Vector3d> places_m;
    std::vector<double> times_s;
    double way_m = 0.0;
    for (const StampedPose& pose : poses) {
      if (!places_m.empty()) way_m += (pose.pose.translation() - places_m.back()).head<2>().norm();
      places_m.emplace_back(pose.pose.translation());
      times_s.push_back(seconds(pose.stamp_ns - poses.front().stamp_ns));
    }
    out_.drive.travelled_m = way_m;
    const double fastest_mps = fastest_speed_mps(places_m, times_s, distinct_fixes(places_m, times_s));
    ImportCheck& check = add(CheckKind::Position, Verdict::Good);
    check.evidence.push_back(say::import_position(Length{way_m}, Speed{fastest_mps}));
    if (fastest_mps > kFastestVehicle_mps) {
      check.verdict = Verdict::Bad;
      check.evidence.push_back(say::import_position_fast());
    } else if (way_m < kLeastWay_m) {
      check.verdict = Verdict::Doubtful;
      check.evidence.push_back(say::import_position_still());
    }
    check_height();
  }

  void check_height() {
    constexpr double kLowest_m = -500.0, kHighest_m = 9000.0, kSteepest_rad = 15.0 * kDegree_rad;
    const auto [low, high] = std::ranges::minmax_element(heights_m_);
    ImportCheck& check = add(CheckKind::Height, Verdict::Good);
    check.evidence.push_back(say::import_height(Length{*low}, Length{*high}));
    if (*low < kLowest_m || *high > kHighest_m) {
      check.verdict = Verdict::Bad;
      check.evidence.push_back(say::import_height_off_earth());
    } else if (fit_.slope_sigma_rad > kSteepest_rad) {
      check.verdict = Verdict::Bad;
      check.evidence.push_back(say::import_height_steep(Angle{fit_.slope_sigma_rad}));
    } else if (*low == *high) {
      check.verdict = Verdict::Doubtful;
      check.evidence.push_back(say::import_height_constant());
    }
  }

  /// From the axis that points forward.
  double offset_rad() const {
    const bool right_forward = !layout_.quaternion && layout_.attitude == drive::AttitudeConvention::NovAtel;
    return wrap_angle_rad(fit_.offset_rad - (right_forward ? 0.5 * kPi : 0.0));
  }

  void check_heading() {
    constexpr double kKeepsTo_rad = 10.0 * kDegree_rad, kAhead_rad = 15.0 * kDegree_rad;
    ImportCheck& check = add(CheckKind::Heading, Verdict::Good);
    if (fit_.steps < kFewestTravelSteps) {
      check.verdict = Verdict::NotTold;
      check.evidence.push_back(say::guess_hardly_moves(fit_.steps));
      return;
    }
    check.evidence.push_back(say::import_heading(Angle{offset_rad()}, Angle{fit_.residual_rad}, fit_.steps));
    if (fit_.residual_rad > kKeepsTo_rad) {
      check.verdict = Verdict::Bad;
      check.evidence.push_back(say::import_heading_unrelated());
    } else if (std::abs(offset_rad()) > kAhead_rad) {
      check.verdict = Verdict::Doubtful;
      check.evidence.push_back(say::import_heading_offset());
    } else if (fit_.turned_rad < kLeastTurned_rad) {
      check.verdict = Verdict::NotTold;
      check.evidence.push_back(say::import_heading_straight(Angle{fit_.turned_rad}));
    }
    constexpr double kUpright = 0.5;
    if (fit_.upright < kUpright) {
      check.verdict = Verdict::Bad;
      check.evidence.push_back(say::import_not_upright());
    }
  }

  void check_pitch() {
    if (fit_.steps < kFewestTravelSteps) return;
    ImportCheck& check = add(CheckKind::Pitch, Verdict::Good);
    switch (fit_.slope) {
      case SlopeFit::Agrees:
        check.evidence.push_back(say::guess_pitch_fits(Angle{fit_.slope_sigma_rad}));
        break;
      case SlopeFit::Opposite:
        check.verdict = Verdict::Bad;
        check.evidence.push_back(say::guess_pitch_opposite());
        break;
      case SlopeFit::Unrelated:
        check.verdict = Verdict::Doubtful;
        check.evidence.push_back(say::guess_pitch_unrelated());
        break;
      case SlopeFit::NotTold:
        check.verdict = Verdict::NotTold;
        check.evidence.push_back(say::import_pitch_not_told());
    }
  }

  void check_clock() {
    InsGuess ins;
    ins.span = out_.span;
    ins.stretches = out_.stretches;
    ins.week_open = out_.week_open;
    ScansGuess scans;
    scans.stamps_ns = stamps_ns_;
    const std::optional<Guess> guess = guess_clock(ins, {scans});
    if (!guess) {
      add(CheckKind::Clock, Verdict::NotTold).evidence.push_back(say::import_no_scan_times());
      return;
    }
    const auto [first, last] = std::ranges::minmax_element(stamps_ns_);
    const double common_s = seconds(std::min(*last, ins.span.last_ns) - std::max(*first, ins.span.first_ns));
    ImportCheck& check = add(CheckKind::Clock, Verdict::Good);
    if (common_s > 0.0)
      check.evidence.push_back(say::import_common(Duration{common_s}, Duration{seconds(*last - *first)}));
    check.evidence.insert(check.evidence.end(), guess->evidence.begin(), guess->evidence.end());
    check.evidence.insert(check.evidence.end(), guess->alternatives.begin(), guess->alternatives.end());
    check.added_ns = guess->added_ns;
    if (guess->sureness == Sureness::Open) check.verdict = common_s > 0.0 ? Verdict::Doubtful : Verdict::Bad;
    if (guess->sureness == Sureness::Likely) check.verdict = Verdict::Doubtful;
  }

  void draw(const std::vector<StampedPose>& poses) {
    constexpr std::size_t kMostPlaces = 4000;
    overview::DriveOverview& drive = out_.drive;
    drive.north_up = true;
    drive.start_ns = poses.front().stamp_ns;
    drive.duration_s = seconds(poses.back().stamp_ns - poses.front().stamp_ns);
    const std::size_t stride = 1 + poses.size() / kMostPlaces;
    for (std::size_t i = 0; i < poses.size(); i += stride)
      drive.track_m.emplace_back(poses[i].pose.translation().head<2>());
  }

  const InsGuess& ins_;
  const formats::InsTableLayout& layout_;
  std::size_t rows_;
  const std::vector<std::int64_t>& stamps_ns_;
  const Progress& progress_;
  std::vector<StampedPose> poses_;
  std::vector<double> heights_m_;
  std::vector<drive::Finding> findings_;
  TravelFit fit_;
  ImportChecks out_;
};

}  // namespace

Message words(CheckKind kind) {
  static constexpr std::array<Message (*)(), kCheckKindCount> kWords{
      say::import_check_rows,    say::import_check_rate,  say::import_check_position, say::import_check_height,
      say::import_check_heading, say::import_check_pitch, say::import_check_clock};
  return kWords[static_cast<std::size_t>(kind)]();
}

const ImportCheck* ImportChecks::find(CheckKind kind) const {
  const auto found = std::ranges::find(checks, kind, &ImportCheck::kind);
  return found == checks.end() ? nullptr : &*found;
}

ImportChecks unreadable(std::vector<Message> why) {
  ImportChecks checks;
  checks.checks.push_back({CheckKind::Rows, Verdict::Bad, std::move(why)});
  return checks;
}

ImportChecks check_import(const InsGuess& ins, std::size_t rows, const std::vector<std::int64_t>& stamps_ns,
                          const Progress& progress) {
  return ImportChecker(ins, rows, stamps_ns, progress).check();
}

}  // namespace remount::guesses

// The result of a calibration: values only, the same for every method.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/calibration/mounting.h"
#include "algorithms/calibration/mounting_source.h"
#include "algorithms/calibration/noise_model.h"
#include "algorithms/calibration/parameter.h"
#include "algorithms/cloud/beam_errors.h"
#include "algorithms/geometry/rigid_transform.h"
#include "algorithms/messages/message.h"
#include "algorithms/motion/pair.h"

namespace remount::calibration {

enum class Status {
  Ok,             ///< every component is observed
  Degenerate,     ///< solved, but some components are not observed (named in `observed` and `advice`)
  TooFewPairs,    ///< not enough accepted pairs for any usable answer
  TooLittleData,  ///< of a method that rests on something else than pairs: `message` says what there is too little of
  NoUsableData,   ///< nothing of what was recorded could be used, however long it is: `message` says why
  NotConverged,   ///< no solution was found
  OutOfRange,     ///< no candidate lies within the search range
  Inconsistent,   ///< what the result would rest on contradicts itself; `message` says what contradicts what
  Cancelled,
};

/// Whether it comes with an X, of which some may not be observed.
constexpr bool is_solved(Status status) { return status == Status::Ok || status == Status::Degenerate; }

/// "ok", "degenerate", "too_few_pairs", "too_little_data", "no_usable_data", "not_converged", "out_of_range",
/// "inconsistent", "cancelled".
std::string_view to_string(Status status);
std::optional<Status> status_from_string(std::string_view text);

struct Candidate {
  MountingSource source;
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  double frobenius_sum =
      0.0;  ///< E(X) = sum over accepted pairs of ||P X - X Q||_F, translation over characteristic length
  bool in_range = true;
  Message out_of_range;  ///< which parameters, as outside_range says; empty where in_range
  /// How much less than this one the best X of the range can have for its sum of squares at most, as a share; NaN where
  /// nothing was proved.
  double certified_gap = std::numeric_limits<double>::quiet_NaN();
};
using CandidateIndex = Index<Candidate>;  ///< in the list of the result

/// One direction of the six-dimensional parameter space, from the eigen-decomposition of the information.
struct ObservabilityDirection {
  Vector6d direction = Vector6d::Zero();  ///< unit length after scaling; translation first, rotation about INS axes
  double sigma = 0.0;  ///< along it, in units of the limits of what counts as observed; infinite: unknown
  bool observed = true;
  Message words;  ///< "height z: not observable, flat driving"
};

/// What a calibration found out about one parameter, beside the numbers that mounting and covariance hold.
struct Knowledge {
  bool observed = false;                  ///< with the help of what was measured
  bool measured = false;                  ///< held near a value measured by hand
  std::optional<double> bootstrap_sigma;  ///< 1-sigma from blocks of time, m or rad; nothing where not computed
  Message why_not_observed;               ///< empty: as the result's own message says
};

/// One parameter of a result. What is not observed has no sigma, and says why.
struct Estimate {
  double value = 0.0;                            ///< m, rad; where not observed, what was given, or nothing to rely on
  std::optional<double> sigma, bootstrap_sigma;  ///< m, rad; nothing where not observed, or not computed
  bool observed = false;
  bool measured = false;
  Message why_not_observed;
};

/// A part of what the sigmas are made of.
struct SigmaPart {
  Message source;              ///< "noise of the registrations"
  PerParameter<double> sigma;  ///< m, rad: the root of what it adds to the variance
};

struct TimeOffset {
  double offset_s = std::numeric_limits<double>::quiet_NaN();  ///< t_ins = t_lidar + offset; NaN where not estimated
  double sigma_s = std::numeric_limits<double>::quiet_NaN();
  bool applied = false;
  bool in_sigma = false;  ///< not applied, for it does not stand out, but an unknown of the solution
};

/// Sessions whose answers scatter more than so many times what their errors explain contradict one another: it is said.
inline constexpr double kSessionsContradict = 2.0;

struct CalibrationResult {
  Status status = Status::TooFewPairs;  ///< none is set without its reason: `conclude`; a test looks
  Message message;                      ///< one sentence for the user: what happened and why
  std::vector<Message> advice;          ///< what to drive or to add, one sentence each

  /// X. One, for there is one LiDAR; `known` and `covariance` are of it.
  Mounting mounting;
  PerParameter<Knowledge> known;
  /// Covariance of the parameters (row_of), m and rad. Rows and columns of those that are not observed mean nothing,
  /// and are not a number: ask `known`, not them.
  Matrix6d covariance = Matrix6d::Constant(std::numeric_limits<double>::quiet_NaN());
  std::vector<ObservabilityDirection> directions;
  /// In the order in which they came in. Their squares add up to the variance of each parameter that is observed
  /// (sigma_parts_add_up); empty where the method does not tell them.
  std::vector<SigmaPart> sigma_parts;

  cloud::BeamEstimate beams;  ///< errors of the LiDAR's beams, to be added to what it measured

  NoiseModel noise;  ///< as estimated from the residuals: what the sigmas rest on
  /// How much more the sessions' own answers scatter than their errors explain; where above 1, every sigma is larger,
  /// by the more the less it may be chance. NaN where it cannot be told (one session).
  double session_disagreement = std::numeric_limits<double>::quiet_NaN();
  int pairs_proposed = 0, pairs_accepted = 0, pairs_rejected = 0;
  double frobenius_sum = 0.0;
  double rotation_rms_rad = 0.0;
  double translation_rms_m = 0.0;
  TimeOffset time_offset;                           ///< mean over the sessions (mean_time_offset)
  std::vector<double> session_time_offset_s;        ///< of each session, same sign; empty where not estimated
  std::vector<double> session_time_offset_sigma_s;  ///< 1-sigma of each; empty where not known
  /// How much older the INS positions of each session are than its attitudes, and 1-sigma; empty where not estimated.
  std::vector<double> session_position_lag_s, session_position_lag_sigma_s;
  bool position_lag_applied = false;  ///< X is solved with these lags taken out
  std::vector<Candidate> candidates;  ///< best first; those out of range last

  /// Says what became of the calibration, and why. What was said before is taken back; advice stays.
  void conclude(Status what, Message why);

  Estimate estimate(Parameter parameter) const;
  ParameterSet observed() const;
  ParameterSet measured() const;
  /// Exactly these are observed; the others are withdrawn.
  void set_observed(ParameterSet parameters, const Message& why_not);
  /// Says that a parameter is not observed, takes its sigmas, and keeps its value. @param why for people, as the end of
  /// a sentence
  void withdraw(Parameter parameter, Message why);
  void set_measured(ParameterSet parameters);
};

/// The offsets of several sessions as one number: each counts by its information, so that a session that hardly tells
/// its own does not move what the others tell. Where the sigmas are not known (`sigmas_s` empty), each alike and
/// without a sigma. NaN where none tells anything.
TimeOffset mean_time_offset(const std::vector<double>& offsets_s, const std::vector<double>& sigmas_s);

/// Whether what was estimated stands out of its error: by four sigma, and `least` at that.
bool stands_out(double value, double sigma, double least);

/// Whether positions of a session that are older than its attitudes, or younger, stand out of the error of the
/// estimate.
bool position_lag_stands_out(double lag_s, double sigma_s);
/// Likewise of any session.
bool position_lag_differs(const CalibrationResult& result);

/// Whether the parts are all that the sigmas are made of: what changed a covariance without telling why, as a solution
/// together with other LiDARs does, leaves parts that do not.
bool sigma_parts_add_up(const CalibrationResult& result);

/// Whether X may be used at all: the status is ok or degenerate and something is observed.
bool is_usable(const CalibrationResult& result);

}  // namespace remount::calibration

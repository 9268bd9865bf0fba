// What methods find out about data while they run.
#include "messages/checks.h"
#include "model/checks/builtin.h"

namespace remount::checks {

DataCheck method_run_check() {
  return {.kinds = {{"odometry-lost", say::odometry_lost_meaning, say::odometry_lost_remedy},
                    {"odometry-scans", say::odometry_scans_meaning, say::odometry_lost_remedy},
                    {"turn-scans", say::odometry_scans_meaning, say::odometry_lost_remedy},
                    {"odometry-unsettled", say::odometry_unsettled_meaning, say::odometry_unsettled_remedy},
                    {"odometry-restarted", say::odometry_restarted_meaning, say::odometry_restarted_remedy},
                    {"odometry-point-times", say::odometry_point_times_meaning, say::odometry_point_times_remedy},
                    {"odometry-drifts", say::odometry_drifts_meaning, say::odometry_drifts_remedy},
                    {"clock-open", say::clock_open_meaning, say::clock_open_remedy},
                    {"odometry-without-ins", say::odometry_without_ins_meaning, say::odometry_without_ins_remedy},
                    {"trajectory-outliers", say::trajectory_outliers_meaning, say::trajectory_outliers_remedy},
                    {"nominal-unused", say::nominal_unused_meaning, say::nominal_unused_remedy},
                    {"registration-sigma", say::registration_sigma_meaning, say::registration_sigma_remedy},
                    {"wheel-scale", say::wheel_scale_meaning, say::wheel_scale_remedy},
                    {"drive-gap", say::drive_gap_meaning, say::ins_gaps_remedy},
                    {"first-session-only", say::first_session_only_meaning, say::first_session_only_remedy},
                    {"ground-tilted", say::ground_tilted_meaning, say::ground_tilted_remedy},
                    {"ground-not-seen", say::ground_not_seen_meaning, say::ground_not_seen_remedy}}};
}

}  // namespace remount::checks

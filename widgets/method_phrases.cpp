// What the methods say beside the mounting and about it, and the comparison of results.
#include "widgets/method_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& method_phrases() {
  static const std::vector<const char*> phrases{
      // methods and what they need
      QT_TRANSLATE_NOOP("remount::model", "Pairs of keyframes"),
      QT_TRANSLATE_NOOP("remount::model", "Trajectory alignment"),
      QT_TRANSLATE_NOOP("remount::model", "Vehicle frame"),
      QT_TRANSLATE_NOOP("remount::model", "Multi-sensor odometry"),
      QT_TRANSLATE_NOOP("remount::model", "Slewing machine"),
      QT_TRANSLATE_NOOP("remount::model", "scans or LiDAR poses, and an INS with attitude"),
      QT_TRANSLATE_NOOP("remount::model", "scans or LiDAR poses, and an INS or GNSS fixes"),
      QT_TRANSLATE_NOOP("remount::model", "wheel speeds, an IMU or INS, and scans or poses of the sensor"),
      QT_TRANSLATE_NOOP("remount::model", "scans, and an INS with attitude"),
      QT_TRANSLATE_NOOP("remount::model", "three recordings of a LiDAR: ground, swept arm, full turn"),
      QT_TRANSLATE_NOOP("remount::model", "the antenna's lever arm alone"),
      QT_TRANSLATE_NOOP("remount::model", "the antenna's place alone"),
      QT_TRANSLATE_NOOP("remount::model", "if it is a recording of an excavator"),
      // results, advice, findings, comparisons, stages; words within them
      QT_TRANSLATE_NOOP("remount::model", ", "),
      QT_TRANSLATE_NOOP("remount::model", "x"),
      QT_TRANSLATE_NOOP("remount::model", "y"),
      QT_TRANSLATE_NOOP("remount::model", "z"),
      QT_TRANSLATE_NOOP("remount::model", "yaw"),
      QT_TRANSLATE_NOOP("remount::model", "pitch"),
      QT_TRANSLATE_NOOP("remount::model", "roll"),
      QT_TRANSLATE_NOOP("remount::model", "m"),
      QT_TRANSLATE_NOOP("remount::model", "deg"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Too little data: at least %1 poses of the LiDAR with INS poses or GNSS fixes over a few metres are needed."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Look at the odometry: is it of this drive, and do its stamps agree with those of the INS or the GNSS?"),
      QT_TRANSLATE_NOOP("remount::model", "The trajectory could not be aligned: its equations have no solution."),
      QT_TRANSLATE_NOOP("remount::model", "rotation: not observable, the positions of an antenna have no axes"),
      QT_TRANSLATE_NOOP("remount::model", "The lever arm's x and y need turns: drive a figure of eight."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The lever arm's z needs pitch or roll: drive over a ramp or a bumpy road, or measure it by tape."),
      QT_TRANSLATE_NOOP("remount::model",
                        "GNSS positions show where the antenna is from the LiDAR and nothing about attitude: for all "
                        "six parameters record an INS with attitude or a GNSS with two antennas."),
      QT_TRANSLATE_NOOP("remount::model", "%1 of %2 scans cannot be read and are left out. First: %3"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans could not be aligned with the local map; their poses are predicted from the "
                        "motion before. First: %3: %4."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 of %2 scans do not determine every direction of motion; what they leave open counts as hardly known."),
      QT_TRANSLATE_NOOP("remount::model",
                        "No pose of the LiDAR lies within the data of the INS or between GNSS fixes. Give data of the "
                        "same time, on one clock."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 positions and attitudes contradict the motion of the LiDAR and have no weight."),
      QT_TRANSLATE_NOOP("remount::model", "X had converged after %1 s of data."),
      QT_TRANSLATE_NOOP("remount::model",
                        "X has not converged to the sigmas that trajectory.converged_translation_m and "
                        "trajectory.converged_rotation_deg ask for."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The odometry is complete, but no session has an INS with attitude to calibrate against."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Write the poses with \"remount-cli odometry\", or add a session with an INS."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The format does not say whether its scans are compensated for motion: the odometry uses them "
                        "as they are. Set run.deskew=on to compensate them."),
      QT_TRANSLATE_NOOP("remount::model", "%1 Its pose is the prediction of the odometry."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans have points whose times are not finite or more than 5 s from the stamp: they "
                        "are used without compensation of motion."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The session has %1, but no scan could use them. Check that their stamps are on the scans' "
                        "clock and their samples less than 0.25 s apart."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "fusion.ins_x_m to fusion.ins_roll_deg are all zero: the INS is taken to sit on the ground under the rear "
          "axle. Set where it sits, or the wheels pull the odometry the wrong way in turns."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The scans did not fit the map any more, as after a gap: %1 times it was begun anew at the "
                        "predicted pose, and poses before and after do not fit together."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 of %2 scans do not tell of every direction of the motion, nor does another sensor carry the "
          "odometry on; no pair spans them. Drive where there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans do not tell of every direction of the motion: hardly any pair is left to "
                        "compare with the INS."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nor do wheel speeds and gyroscope cover these scans: look at their stamps, or drive where "
                        "there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give a nominal mounting and record wheel speeds and an IMU, which carry the odometry through "
                        "such places; or drive where there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The mounting still changed when the odometry was repeated with it; its sigmas contain the "
                        "last change."),
      QT_TRANSLATE_NOOP("remount::model", "the sensor's poses and the wheels are of different scales"),
      QT_TRANSLATE_NOOP("remount::model", "The odometry was made with another mounting than the one it leads to."),
      QT_TRANSLATE_NOOP("remount::model", "Give a better nominal, or drive where there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The session has no INS with attitude: its odometry takes no part in the calibration."),
      QT_TRANSLATE_NOOP("remount::model", "The session has no %1: the odometry does without."),
      QT_TRANSLATE_NOOP("remount::model", "wheel speeds"),
      QT_TRANSLATE_NOOP("remount::model", "angular rates"),
      QT_TRANSLATE_NOOP("remount::model", "accelerations"),
      QT_TRANSLATE_NOOP("remount::model", "a barometer"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 of %2 scans do not tell of every direction of the motion; there it rests on wheels and gyroscope."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans do not tell of every direction of the motion; there it rests on wheels and "
                        "gyroscope, and says nothing of the mounting."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 of %2 scans do not tell of every direction of the motion, nor do wheels: there a steady motion was "
          "assumed, and poses may be far off. Record wheel speeds, or drive where there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Without a nominal mounting the odometry uses the scans alone. Give --nominal to use wheels, "
                        "IMU and barometer as well."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The solution did not converge: wheels, IMU and the sensor's poses do not fit together. Check "
                        "their time stamps and units."),
      QT_TRANSLATE_NOOP("remount::model", "the solution did not converge"),
      QT_TRANSLATE_NOOP("remount::model", "the solution was cancelled"),
      QT_TRANSLATE_NOOP("remount::model", "Vehicle from sensor by %1 intervals of wheels and IMU; %2."),
      QT_TRANSLATE_NOOP("remount::model", "all six parameters are observed"),
      QT_TRANSLATE_NOOP("remount::model", "some parameters are not observed"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Only %1 intervals of the drive have poses of the sensor, wheel speeds and IMU rates at the "
                        "same time; at least %2 are needed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Check that the streams overlap in time (one clock) and that the vehicle moves; drive at least "
                        "100 m with turns."),
      QT_TRANSLATE_NOOP("remount::model", "%1 of %2 scans could not be aligned: %3: %4."),
      QT_TRANSLATE_NOOP("remount::model", "There is no IMU: turns are taken from the attitude of the INS."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The way of the wheels is %1 times as long as that by the sensor's poses: one of the two is not "
          "in metres."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The way by the sensor's poses is %1 times as long as that of the wheels: one of the two is not "
          "in metres."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Look at the units of the wheel speeds and of the sensor's poses. Where the poses have no scale, "
          "as those of one camera, let it be estimated (vehicle_frame.scale)."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The way of the wheels and that of the sensor differ by %1%; the sensor's is taken for metres."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The way of the %1 is %2 times as long as that of the %3: poses of the LiDAR are not in metres, "
          "or are of another drive."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the units of the LiDAR's poses, and at how points of scans are scaled."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The way of the %1 is %2 times as long as that of the %3: the odometry over the scans slipped, or one "
          "of the two is not in metres."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the units of the positions and of the points of the scans. Where these are metres, "
                        "the surroundings hold no scan along the way: record where there is structure, or use another "
                        "method."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "places %1 in %2, and the method '%3' finds %4 in %5: the numbers of one are wrong in the other. "
          "Give a nominal mounting in that frame, or none."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The nominal mounting of the session places %1 in %2, and the method '%3' finds %4 in %5: it is "
          "not used. Give a nominal mounting in that frame, or none."),
      QT_TRANSLATE_NOOP("remount::model",
                        "places %1 in %2, and %3 in %4 is asked for: the numbers of one are wrong in the other."),
      QT_TRANSLATE_NOOP("remount::model", "the LiDAR"),
      QT_TRANSLATE_NOOP("remount::model", "the antenna"),
      QT_TRANSLATE_NOOP("remount::model", "the sensor"),
      QT_TRANSLATE_NOOP("remount::model", "the INS frame"),
      QT_TRANSLATE_NOOP("remount::model", "the vehicle's frame (middle of the rear axle, on the ground)"),
      QT_TRANSLATE_NOOP("remount::model", "the machine's frame (on the slew axis)"),
      QT_TRANSLATE_NOOP("remount::model", "the LiDAR's own axes about the antenna"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 is for comparison: errors may be several times the sigma that is stated."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The height of the sensor is not observed: the ground was too flat. Drive over ramps or "
                        "slopes, or measure it."),
      QT_TRANSLATE_NOOP("remount::model", "There is no turn to compare."),
      QT_TRANSLATE_NOOP("remount::model", "The turns are too small to show the rotation between the two sensors."),
      QT_TRANSLATE_NOOP("remount::model",
                        "All turns are about %1: the rotation about it is not observed, the other two angles are."),
      QT_TRANSLATE_NOOP("remount::model", "a slanted axis"),
      QT_TRANSLATE_NOOP("remount::model", "the vertical (yaw)"),
      QT_TRANSLATE_NOOP("remount::model", "the transverse axis (pitch)"),
      QT_TRANSLATE_NOOP("remount::model", "the long axis (roll)"),
      QT_TRANSLATE_NOOP("remount::model", "All three angles are observed: %1 deg of turn across the main axis."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions of an antenna show no attitude; of its place %1 observed. End error of wheels and "
                        "yaw rate: %2 m in %3 m (%4%)."),
      QT_TRANSLATE_NOOP("remount::model", "x and y are"),
      QT_TRANSLATE_NOOP("remount::model", "x is"),
      QT_TRANSLATE_NOOP("remount::model", "y is"),
      QT_TRANSLATE_NOOP("remount::model", "nothing is"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give poses of a sensor (odometry of a LiDAR or a camera) to calibrate all six parameters."),
      QT_TRANSLATE_NOOP("remount::model", "x and y of the antenna need turns: drive tight turns in both directions."),
      QT_TRANSLATE_NOOP("remount::model", "Without poses of a sensor only the first session is used."),
      QT_TRANSLATE_NOOP("remount::model", "The drive cannot be integrated: %1."),
      QT_TRANSLATE_NOOP("remount::model", "only %1 positions lie within the wheel speeds and yaw rates"),
      QT_TRANSLATE_NOOP("remount::model", "the recordings were refused"),
      QT_TRANSLATE_NOOP("remount::model", "Taken for the recording: %1."),
      QT_TRANSLATE_NOOP("remount::model", "ground"),
      QT_TRANSLATE_NOOP("remount::model", "arm"),
      QT_TRANSLATE_NOOP("remount::model", "turn"),
      QT_TRANSLATE_NOOP("remount::model", "%1 of %2 scans of the turn could not be aligned: %3."),
      QT_TRANSLATE_NOOP("remount::model", "it moved far from where the scan before it leads"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The ground is not square to the slew axis; the plane of the turn was used instead."),
      QT_TRANSLATE_NOOP("remount::model", "Machine from LiDAR by %1, the arm's plane and a turn of %2 deg."),
      QT_TRANSLATE_NOOP("remount::model", "the ground"),
      QT_TRANSLATE_NOOP("remount::model", "the plane of the turn"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The plane of the arm is missing: %1. Without it the machine's yaw is unknown."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Record the arm while it is swept up and down over its whole range with the slew angle held, "
                        "in view of the LiDAR."),
      QT_TRANSLATE_NOOP("remount::model", "only %1 moving points lie in one upright plane"),
      QT_TRANSLATE_NOOP("remount::model", "what moved spans only %1 by %2 m (root mean square)"),
      QT_TRANSLATE_NOOP("remount::model", "The turn gives no circle: %1."),
      QT_TRANSLATE_NOOP("remount::model", "only %1 poses"),
      QT_TRANSLATE_NOOP("remount::model", "the positions lie on a line or in one place"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Record one full turn of the machine at an even, slow rate, and stay clear of it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The turn covers an arc of %1 deg and at least %2 deg are needed: centre and plane of a short "
                        "arc hang on its noise."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The LiDAR runs on a circle of %1 m radius with residuals of %2 m: it sits too near the slew "
                        "axis for its circle to have a plane."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Mount the LiDAR farther from the slew axis, or use a registration with smaller errors (finer voxels)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The ground is tilted by %1 deg (sigma %2) against the plane in which the LiDAR turned, and %3 "
                        "deg are allowed: it is not square to the slew axis."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Repeat on level, even ground, or take the plane of the turn (slew.first_plane = turn)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The plane of the arm leans by %1 deg from square to the first plane, and %2 deg are allowed: "
                        "the slew angle moved, or what moved is not the arm."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Record the arm again with the slew angle held, and nobody moving near the machine."),
      QT_TRANSLATE_NOOP("remount::model", "The plane of the ground is missing: %1."),
      QT_TRANSLATE_NOOP("remount::model", "the ground that is seen is a strip: its tilt is a guess"),
      QT_TRANSLATE_NOOP("remount::model", "only %1 points"),
      QT_TRANSLATE_NOOP("remount::model", "no plane of the expected direction"),
      QT_TRANSLATE_NOOP("remount::model", "only %1 points lie in one plane"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Record the ground around the machine, or take the plane of the turn (slew.first_plane = turn)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 is not known well enough: record longer, and move the LiDAR away from the slew axis."),
      QT_TRANSLATE_NOOP("remount::model", "Start again."),
      QT_TRANSLATE_NOOP("remount::model", "Not compared: %1."),
      QT_TRANSLATE_NOOP("remount::model", "%1 has nothing to use"),
      QT_TRANSLATE_NOOP("remount::model", "%1 is in the frame \"%2\" and %3 in \"%4\""),
      QT_TRANSLATE_NOOP("remount::model", "%1 and %2 have other INS axes"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 and %2 contradict each other: %3 differs by %4 %5, %6 times the sigma of both together. At least one of "
          "them claims too much; look at its residuals, its clock and its nominal mounting."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 and %2 contradict each other: %3 differs by %4 %5, %6 times the sigma of both together. Either the LiDAR "
          "was moved in between, or one of them claims too much: look at its residuals, its clock and its nominal "
          "mounting."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 and %2 agree within what they claim: at most, %3 differs by %4 %5, %6 times the sigma of both together."),
      QT_TRANSLATE_NOOP("remount::model", "%1 and %2 observe no component in common."),
      QT_TRANSLATE_NOOP("remount::model", "LiDAR odometry"),
      QT_TRANSLATE_NOOP("remount::model", "odometry"),
      QT_TRANSLATE_NOOP("remount::model", "aligning trajectories"),
      QT_TRANSLATE_NOOP("remount::model", "solving every session alone"),
      QT_TRANSLATE_NOOP("remount::model", "integrating wheels and IMU"),
      QT_TRANSLATE_NOOP("remount::model", "integrating wheels and yaw rate"),
      QT_TRANSLATE_NOOP("remount::model", "solving vehicle frame"),
      QT_TRANSLATE_NOOP("remount::model", "comparing integrations"),
      QT_TRANSLATE_NOOP("remount::model", "reading the ground"),
      QT_TRANSLATE_NOOP("remount::model", "reading the arm"),
      QT_TRANSLATE_NOOP("remount::model", "aligning the turn"),
      QT_TRANSLATE_NOOP("remount::model", "fitting planes and circle"),
      // errors
      QT_TRANSLATE_NOOP("remount::model", "there is no session to calibrate"),
      QT_TRANSLATE_NOOP("remount::model", "has no scans; the multi-sensor odometry needs them"),
      QT_TRANSLATE_NOOP("remount::model",
                        "holds neither an INS nor GNSS fixes to align the trajectory of the LiDAR with"),
      QT_TRANSLATE_NOOP("remount::model", "has no wheel speeds, by which the vehicle's frame is found"),
      QT_TRANSLATE_NOOP("remount::model", "has neither scans nor poses of the sensor"),
      QT_TRANSLATE_NOOP("remount::model", "has neither an IMU nor an INS: nothing tells how it turns"),
      QT_TRANSLATE_NOOP("remount::model", "there is no recording of the turn with scans or LiDAR poses"),
      QT_TRANSLATE_NOOP("remount::model", "is %1, but there are %2 sessions"),
      QT_TRANSLATE_NOOP("remount::model", "is not one of: %1"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "the scale of the sensor and that of the wheels cannot both be estimated: one of them says what a metre is"),
      QT_TRANSLATE_NOOP("remount::model", "the stamps of scans must ascend"),
      QT_TRANSLATE_NOOP("remount::model", "a scan is not later than the one before"),
      QT_TRANSLATE_NOOP("remount::model", "epochs must ascend in time"),
      QT_TRANSLATE_NOOP("remount::model", "was not opened"),
  };
  return phrases;
}

}  // namespace remount

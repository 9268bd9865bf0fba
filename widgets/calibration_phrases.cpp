// What calibrations say of their data, pairs and results.
#include "widgets/calibration_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& calibration_phrases() {
  static const std::vector<const char*> phrases{
      QT_TRANSLATE_NOOP("remount::model", "Nothing is known: hardly any pairs go together."),
      QT_TRANSLATE_NOOP("remount::model", "too few of the pairs go together"),
      QT_TRANSLATE_NOOP("remount::model", "the clocks are apart"),
      QT_TRANSLATE_NOOP("remount::model", "the INS contradicts itself"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Without a nominal mounting, what so few pairs agree on may be chance: give one (some 10 "
                        "degrees are enough)."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "x, y and z count from where the positions are: that may be an antenna, and not the INS (see the findings)."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Between the pairs of scans that were registered the LiDAR turned as the INS did %1 s later. %2"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Between the pairs of scans that were registered the LiDAR turned as the INS did %1 s earlier. %2"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing is known: without a nominal mounting yaw is open, and everything else depends on it."),
      QT_TRANSLATE_NOOP("remount::model", "without a nominal yaw is open"),
      QT_TRANSLATE_NOOP("remount::model", "the sessions say different mountings"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "LiDAR and INS contradict each other under every mounting: their motions differ by %1 m on ways "
          "of %2 m."),
      QT_TRANSLATE_NOOP("remount::model", "the motions of LiDAR and INS contradict each other"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The motions of the LiDAR are %1 times as long as those of the INS: one of the two is not in "
                        "metres."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The motions of the INS are %1 times as long as those of the LiDAR: one of the two is not in "
                        "metres."),
      QT_TRANSLATE_NOOP("remount::model", "LiDAR and INS are of different scales"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the units of the LiDAR's poses, or of the points of its scans, and of the INS's "
                        "positions: centimetres for metres are 100 times as long, millimetres 1000 times, feet 3.28 "
                        "times."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 pairs hardly show how large their own errors are: sigma is %2 times as large for that. "
                        "More pairs make it smaller."),
      QT_TRANSLATE_NOOP("remount::model", "the distances of LiDAR and INS differ"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The LiDAR moves %1 times as far as the INS: one of them measures distances wrongly, which "
                        "biases X; the sigmas include it. Correct the scale, or use the method trajectory, which "
                        "estimates it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "its session contradicts all others, which agree (with it they scatter %1 times their errors)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 contradicts the drive by %2 sigma (%3 %4 are left): check the measurement and its sigma."),
      QT_TRANSLATE_NOOP("remount::model", "The ground in the scans with the height of the INS"),
      QT_TRANSLATE_NOOP("remount::model", "The tilt of the ground in the scans"),
      QT_TRANSLATE_NOOP("remount::model", "The measured %1"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Whether the ground is square to the slew axis cannot be told: the angle between ground and "
                        "turn has a sigma of %1 deg, and %2 deg are allowed."),
      QT_TRANSLATE_NOOP("remount::model", "the LiDAR moves, but its attitude does not turn"),
      QT_TRANSLATE_NOOP("remount::model", "what was measured contradicts the drive"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The sessions contradict one another %1 times as much as their errors explain; what the pairs "
                        "say counts the less. Look for one whose INS or clock is worse, and calibrate without it."),
      QT_TRANSLATE_NOOP("remount::model", "ambiguous: another alignment %1 m, %2 deg away fits as well (%3 and %4)"),
      QT_TRANSLATE_NOOP("remount::model", "%1 (gap %2 of %3, %4 regions)."),
      QT_TRANSLATE_NOOP("remount::model", "%1 (gap %2 of %3, %4 regions); others score the same."),
      QT_TRANSLATE_NOOP("remount::model", "Nothing in the search range scores better than this"),
      QT_TRANSLATE_NOOP("remount::model", "Not proved to be the best of the search range: too many regions"),
      QT_TRANSLATE_NOOP("remount::model", "Cancelled before the search range was covered"),
      QT_TRANSLATE_NOOP("remount::model", "The pairs or the search range hold numbers that are not finite."),
      QT_TRANSLATE_NOOP("remount::model", "The search range is empty: a lower limit lies above its upper limit."),
      QT_TRANSLATE_NOOP("remount::model", "the inverse rotation"),
      QT_TRANSLATE_NOOP("remount::model", "a quaternion whose scalar part stands at the other end"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS contradicts itself: its heading follows its travel only under another convention."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Before anything else correct the convention of the INS attitude: its heading does not follow "
                        "the direction of travel, and would under another one (see the findings)."),
      QT_TRANSLATE_NOOP("remount::model", "the INS data do not cover the scans' times: %1"),
      QT_TRANSLATE_NOOP("remount::model", "the LiDAR's times end %1 before the INS data begin, and %2"),
      QT_TRANSLATE_NOOP("remount::model", "the LiDAR's times begin %1 after the INS data end, and %2"),
      QT_TRANSLATE_NOOP("remount::model", "the beginnings are %1 apart. %2"),
      QT_TRANSLATE_NOOP("remount::model", "%1 hours"),
      QT_TRANSLATE_NOOP("remount::model", "%1 days"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "That is the time between the epochs of Unix and GPS: one of them counts from 1980; declare its time scale."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "GPS time is 18 s ahead of UTC since 2017 (17 s before): likely leap seconds; declare the time scale."),
      QT_TRANSLATE_NOOP("remount::model",
                        "GPS time is 18 s ahead of UTC since 2017 (17 s before), and TAI 19 s ahead of GPS time: "
                        "likely leap seconds, or a clock that PTP sets to TAI; declare the time scale."),
      QT_TRANSLATE_NOOP("remount::model", "That is about %1 hours: likely a time zone; both must be in UTC."),
      QT_TRANSLATE_NOOP("remount::model", "They belong to different drives, or a clock or its unit is wrong."),
      QT_TRANSLATE_NOOP("remount::model", "They belong to different drives, or one clock is not synchronised."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Wheel speeds or yaw rates have a gap after %1 s: the end error is that of the %2 m before it, "
                        "of %3 m driven."),
      QT_TRANSLATE_NOOP("remount::model",
                        "values measured by hand are of the LiDAR in the INS frame, and the method '%1' finds it in "
                        "that of the %2; leave them out"),
      QT_TRANSLATE_NOOP("remount::model",
                        "is used with the ground in the scans, which the method 'trajectory' does not look for; "
                        "measure z, pitch and roll, or choose the method 'pairwise'"),
      QT_TRANSLATE_NOOP("remount::model", "the session began with scans and has none any more"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The values measured by hand are of the LiDAR in the INS frame; there is no INS, and they are not used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "neighbouring scans could not be registered (%1 of %2 failed), or the vehicle hardly moved"),
      QT_TRANSLATE_NOOP("remount::model", "the session has no INS poses: X needs the motion of the INS"),
      QT_TRANSLATE_NOOP("remount::model",
                        "has INS axes %1, but %2 has %3: they have no common X. Calibrate them one by one, or declare "
                        "the same attitude convention."),
      QT_TRANSLATE_NOOP("remount::model", "holds no motion of an INS with attitude"),
      QT_TRANSLATE_NOOP("remount::model", "holds neither scans nor LiDAR poses"),
      QT_TRANSLATE_NOOP("remount::model", "%1; it can be calibrated with --method %2"),
      QT_TRANSLATE_NOOP("remount::model", "%1; name a folder or a session.yaml that has it, too"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1; name a folder or a session.yaml that has it, too, or choose --method slew for an "
                        "excavator"),
      QT_TRANSLATE_NOOP("remount::model",
                        "is the same recording as %1: its pairs would count as evidence twice. Give it once."),
      QT_TRANSLATE_NOOP("remount::model", "they lie in gaps of the INS data."),
      QT_TRANSLATE_NOOP("remount::model", "No scan lies within the INS data: %1"),
      QT_TRANSLATE_NOOP("remount::model", "Of %1 keyframes no pair is within %2 and has moved by %3 or turned by %4."),
      QT_TRANSLATE_NOOP("remount::model", "One keyframe only: lower keyframes.interval_s, or give a longer drive."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "At the spacing that is set, %1, the drive has %2 keyframes, fewer than keyframes.minimum: they "
          "were taken closer together, %3 in all. Lower keyframes.minimum to keep the spacing."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "One keyframe only: lower keyframes.distance_m and keyframes.rotation_deg, or give a longer drive."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The vehicle stands still while the LiDAR records: drive turns within sight of buildings and poles."),
      QT_TRANSLATE_NOOP("remount::model", "Widen these settings of pairing, or take keyframes closer together."),
      QT_TRANSLATE_NOOP("remount::model", "None of the %1 scans that are needed can be read. First: %2"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Copy or export the scans again: they are incomplete, or of another type than declared."),
      QT_TRANSLATE_NOOP("remount::model",
                        "was cancelled when %1 of %2 pairs were aligned: the result is from these, without the last "
                        "steps (aligning all clouds, the given height of the INS). Calibrate again for the rest."),
      QT_TRANSLATE_NOOP("remount::model", "motion pairs have no scans that show the ground; give z instead"),
      QT_TRANSLATE_NOOP("remount::model", "scan cannot be read: %1"),
      QT_TRANSLATE_NOOP("remount::model", "no scan can be read: %1"),
      QT_TRANSLATE_NOOP("remount::model", "only %1 shared static objects, %2 needed"),
      QT_TRANSLATE_NOOP("remount::model", "the session has lidar poses and no scans"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Of %1 keyframes no pair is within %2 or %3 and has moved by %4 or turned by %5."),
      QT_TRANSLATE_NOOP("remount::model", "%1 (axes of the lidar)"),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1]"),
      QT_TRANSLATE_NOOP("remount::model", "the turn about [%1]"),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1], the turn about [%2]"),
      QT_TRANSLATE_NOOP("remount::model", "a turn about an axis beside the sensor"),
      QT_TRANSLATE_NOOP("remount::model", "the time of a point is not finite"),
      QT_TRANSLATE_NOOP("remount::model", "the times of the points spread over %1 s"),
      QT_TRANSLATE_NOOP("remount::model", "the origin is not on the globe"),
      QT_TRANSLATE_NOOP("remount::model", "%1: known by what was measured"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The sessions scatter %1 times as much as their errors explain; the sigmas include it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 was given as measured, %2, without a sigma and is not used: give its sigma, too."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 was given as measured, %2, and is not used: this method takes no height of the INS. Leave it out."),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1], the shift along [%2]"),
      QT_TRANSLATE_NOOP("remount::model", "the turn about [%1], the turn about [%2]"),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1], the turn about [%2], the turn about [%3]"),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1], the shift along [%2], the turn about [%3]"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the shift along [%1], the shift along [%2], the turn about [%3], the turn about [%4]"),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1], %2"),
      QT_TRANSLATE_NOOP("remount::model", "the shift along [%1], the shift along [%2], %3"),
      QT_TRANSLATE_NOOP("remount::model", "%1, the turn about [%2]"),
      QT_TRANSLATE_NOOP("remount::model", "%1, the turn about [%2], the turn about [%3]"),
      QT_TRANSLATE_NOOP("remount::model", "The poses contradict the travel of the vehicle: their inverses follow it."),
      QT_TRANSLATE_NOOP("remount::model", "the poses are inverted"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Before anything else invert the poses that the findings name: they are from the world to the "
                        "body, expected from the body to the world."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans of the turn could not be aligned with the first one: what is left covers an "
                        "arc of %3 deg, and at least %4 deg are needed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Turn more slowly, where the LiDAR sees walls or objects all around, so that every scan "
                        "overlaps the first one."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The ground leans by %1 deg (sigma %2) against the plane in which the LiDAR turned. Pitch, "
                        "roll and z may be off by that much, and their sigma allows for it. Repeat on level, even "
                        "ground, or take the plane of the turn (slew.first_plane = turn)."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The IMU turns %1 times as far as the sensor by its poses: its rates mix up degrees and radians."),
      QT_TRANSLATE_NOOP("remount::model", "the rates of the IMU are of another unit"),
      QT_TRANSLATE_NOOP("remount::model", "Declare the unit of the angular rate as the log of the IMU has it."),
      QT_TRANSLATE_NOOP("remount::model", "wheels and the other sensors contradict each other"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The wheels turn backwards where the vehicle goes forwards by its INS: the yaw of the sensor "
                        "may be half a turn off."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Check the sign of the wheel speeds (forwards is positive), and which axis of the INS looks forward."),
      QT_TRANSLATE_NOOP("remount::model",
                        "In turns the IMU is pressed to the other side than the speed of the wheels says: the yaw of "
                        "the sensor may be half a turn off."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Check the sign of the wheel speeds (forwards is positive), and whether the IMU is built in "
                        "facing backwards (vehicle_frame.imu_yaw_deg)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The rates of the IMU about its %1 axis are %2% (sigma %3) too large by the turns of the "
                        "sensor's poses. The result allows for it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The rates of the IMU about its %1 axis are %2% (sigma %3) too small by the turns of the "
                        "sensor's poses. The result allows for it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The right rear wheel is %1% (sigma %2) faster than the left one where the vehicle goes "
                        "straight. The result allows for it; check the tyres and their stated sizes."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The right rear wheel is %1% (sigma %2) slower than the left one where the vehicle goes "
                        "straight. The result allows for it; check the tyres and their stated sizes."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans do not tell of every direction of the motion; no pair spans them. Wheels and "
                        "IMU could carry the odometry on, but reach the LiDAR through its mounting, of which no "
                        "nominal is given. Give one, or drive where there is more to see."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Give a nominal mounting: wheel speeds and IMU carry the odometry through such places, but reach the "
          "LiDAR through its mounting, and were not used; or drive where there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The rates of the IMU are %1% (sigma %2) too large by the turns of the sensor's poses. The "
                        "result allows for it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The rates of the IMU are %1% (sigma %2) too small by the turns of the sensor's poses. The "
                        "result allows for it."),
  };
  return phrases;
}

}  // namespace remount

#include "widgets/check_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& check_phrases() {
  static const std::vector<const char*> phrases{
      QT_TRANSLATE_NOOP("remount::model",
                        "The positions of the INS are %1 ms older than its attitudes (sigma %2 ms). X is solved with "
                        "that taken out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The positions of the INS are %1 ms younger than its attitudes (sigma %2 ms). X is solved with "
                        "that taken out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The positions of the INS are %1 ms older than its attitudes (sigma %2 ms). X is off by the way that is "
          "driven meanwhile, which is in the sigmas: set solve.apply_time_offset to auto or yes to take it out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The positions of the INS are %1 ms younger than its attitudes (sigma %2 ms). X is off by the way that is "
          "driven meanwhile, which is in the sigmas: set solve.apply_time_offset to auto or yes to take it out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Positions and attitudes of the INS come in messages of different times, and the drive does not show how "
          "well they go together: that one is %1 ms older than the other (1 sigma) is in the sigmas."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The motion of the LiDAR leaves its way to one side, by %1 % of it: it rises, sinks or drifts "
                        "where INS and GNSS do not. X is solved with that taken out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions alone hardly show how far the clocks of LiDAR and GNSS are apart: %1 ms (1 sigma) "
                        "are in the sigmas."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 rows repeat the motions of an earlier one to the last digit and do not count: what "
                        "is given twice is no second measurement."),
      QT_TRANSLATE_NOOP("remount::model", "the same motions as in row %1"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Unless it is taken out, X is off by the way that is driven in that time, along the direction "
                        "of travel mostly: 20 ms at 36 km/h are 0.2 m."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Log position and attitude of one moment, in one message of one device; look which of the two "
                        "is filtered, sent later, or stamped when it arrives."),
      QT_TRANSLATE_NOOP("remount::model",
                        "X is uncertain by the way that is driven in that time, along the direction of travel mostly."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Log position and attitude in one message, or with stamps that agree; or brake and accelerate "
                        "while recording, which shows how well they go together."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "An odometry that leans adds to the way what the vehicle did not drive; pitch or yaw takes it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether the poses are of one frame throughout and in metres; make them with an odometry "
                        "that closes loops, or calibrate from the scans."),
      QT_TRANSLATE_NOOP("remount::model", "X is uncertain by the way that is driven in that time."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Synchronise the clocks, or record an INS with attitude, whose turns show the offset."),
      // what the checks of data find
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Scans of a moving sensor are bent by the motion within a sweep, unless somebody has compensated them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Record points with their times: set the driver to write them (in a field called time, t or "
                        "timestamp). A calibration tries sweeps in both directions and takes what the scans prove; "
                        "without proof the sigmas include the others, and no clock offset is estimated."),
      QT_TRANSLATE_NOOP("remount::model", "How the scans are bent by motion is a guess."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Record points with their times, or declare in a native session how the sensor turns (timing: sweep)."),
      QT_TRANSLATE_NOOP("remount::model", "The sensor turns the other way than those that the format was made for."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Nothing, where the LiDAR is another one; otherwise check that axes of the points are right-handed."),
      QT_TRANSLATE_NOOP("remount::model", "Scans and INS samples were taken out or renumbered apart from each other."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing, where the stamps of both are right; otherwise copy the drive again, whole."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1 of %2 samples are degraded and %3 invalid by the INS's own status, in %4, the longest of %5 s."),
      QT_TRANSLATE_NOOP("remount::model", "%1 stretch"),
      QT_TRANSLATE_NOOP("remount::model", "%1 stretches"),
      QT_TRANSLATE_NOOP("remount::model", "The position jumps %1 times, the farthest by %2 m at %3."),
      QT_TRANSLATE_NOOP("remount::model", "The position jumps once, by %1 m at %2."),
      QT_TRANSLATE_NOOP("remount::model", "The attitude jumps %1 times, the farthest by %2 degrees at %3."),
      QT_TRANSLATE_NOOP("remount::model", "The attitude jumps once, by %1 degrees at %2."),
      QT_TRANSLATE_NOOP("remount::model",
                        "A pair across a jump tells of a turn that never was; it is rejected where that shows."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether the heading was aligned anew there or a sample is damaged; reject the pairs "
                        "across it, or use a log that was processed afterwards (PPK)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing is missing but the index; yet a file that lacks its end was not copied whole."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Copy the bag again, whole; close the recorder before copying. mcap recover writes a new index."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The stated error of the position grows from %1 m to %2 m in %3, %4 % of the drive: "
                        "corrections (RTK) were lost."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The drive would lie in the sea at latitude %1, longitude %2 degrees: these are radians that "
                        "are taken for degrees."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The IMU turns %1 times as fast as the INS: degrees and radians are mixed up."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The IMU reads a specific force of %1, where gravity alone is 9.8 m/s^2: these are units of g, "
                        "or gravity was taken out."),
      QT_TRANSLATE_NOOP("remount::model", "its times do not meet those of the INS or the LiDAR: %1"),
      QT_TRANSLATE_NOOP("remount::model", "The scan has %1 points only; the usual one has %2."),
      QT_TRANSLATE_NOOP("remount::model", "%1 % of the points have no place (NaN, or no range) and are left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "In all %1 pairs that were looked at, the scans turn the other way round than the INS, with "
                        "the ground below: the points are mirrored, one of their axes has the wrong sign."),
      QT_TRANSLATE_NOOP("remount::model",
                        "NED instead of ENU (or the other way round), or a heading from north instead of a yaw from "
                        "east (this looks like a compass heading)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "a heading from north instead of a yaw from east (this looks like a compass heading)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS repeats one attitude for %1 s, while its positions run through a turn."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS repeats one position for %1 s, while its attitude changes and the vehicle drives on."),
      // parts that stand still, columns and clocks that are others than declared
      QT_TRANSLATE_NOOP("remount::model",
                        "The attitude stands still for %1 s at a time (%2 samples) and then jumps, by %3 degrees where "
                        "the vehicle turns: it is logged more often than it is computed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The position stands still for %1 s at a time (%2 samples) and then jumps, by %3 m where the "
                        "vehicle drives: it is logged more often than it is computed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The position stands still for %1 s at a time (%2 samples) and then jumps, by %3 m where the "
                        "vehicle drives. Only the first of each is used; positions between these are interpolated."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Position and attitude stand still for %1 s at a time (%2 samples) and then jump, by %3 m "
                        "where the vehicle drives. Only the first sample of each is used; the motion between these is "
                        "interpolated."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The heading alone stands still for %1 s at a time (%2 samples) and then jumps, by %3 degrees "
                        "where the vehicle turns: it is logged more often than it is computed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "One number of the position, %1, stands still for %2 s at a time (%3 samples) and then jumps, "
                        "by %4 m where the vehicle drives: it is logged more often than it is computed."),
      QT_TRANSLATE_NOOP("remount::model", "latitude"),
      QT_TRANSLATE_NOOP("remount::model", "longitude"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Pitch and roll of the INS contradict %1; with %2 they would agree: look which columns they "
                        "are, and which way they count."),
      QT_TRANSLATE_NOOP("remount::model", "the slope of its path"),
      QT_TRANSLATE_NOOP("remount::model", "the forces that the IMU feels"),
      QT_TRANSLATE_NOOP("remount::model", "the turns of the LiDAR"),
      QT_TRANSLATE_NOOP("remount::model", "pitch counted the other way"),
      QT_TRANSLATE_NOOP("remount::model", "roll counted the other way"),
      QT_TRANSLATE_NOOP("remount::model", "one of them counted the other way, or both exchanged"),
      QT_TRANSLATE_NOOP("remount::model", "pitch and roll exchanged"),
      QT_TRANSLATE_NOOP("remount::model", "pitch and roll both counted the other way"),
      QT_TRANSLATE_NOOP("remount::model", "pitch and roll exchanged, and one of them counted the other way"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The heading of the INS does not follow the direction of travel, but it would with %1: correct "
                        "the columns of the attitude. No mounting can be right with these."),
      QT_TRANSLATE_NOOP("remount::model", "yaw and pitch exchanged"),
      QT_TRANSLATE_NOOP("remount::model", "yaw and roll exchanged"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The heading of the INS does not follow the direction of travel, but it would if its angles "
                        "were 57.3 times larger: these are radians that were taken for degrees."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The direction of travel does not follow the heading of the INS, but it would with latitude "
                        "and longitude exchanged."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The scans turn as the INS did about %1 s later (correlation %2): the LiDAR's stamps are "
                        "early by as much."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The scans turn as the INS did about %1 s later (correlation %2): the LiDAR's stamps are "
                        "early by as much. %3"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The scans turn as the INS did about %1 s earlier (correlation %2): the LiDAR's stamps "
                        "are late by as much."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The scans turn as the INS did about %1 s earlier (correlation %2): the LiDAR's stamps "
                        "are late by as much. %3"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The LiDAR's times begin %1 s after those of the INS, and end %2 s after them. %3"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The LiDAR's times begin %1 s before those of the INS, and end %2 s before them. %3"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "TAI is 37 s ahead of UTC since 2017: likely a clock that PTP sets to TAI; declare the time scale."),
      QT_TRANSLATE_NOOP("remount::model",
                        "TAI is 19 s ahead of GPS time: likely a clock that PTP sets to TAI; declare the time scale."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Attitudes are late by half such a step on average, and jump: X is off by as much where the "
                        "vehicle turns, and no sigma says so."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Log the attitude as it is computed, with all digits; or keep only the first sample of each "
                        "that repeats: between those the motion is interpolated."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions are late by half such a step on average, and jump: X is off by the way that is "
                        "driven meanwhile, and no sigma says so."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Log the position as it is computed, with all digits; or keep only the first sample of each "
                        "that repeats: between those the motion is interpolated."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Repeats of a position are no measurements. Between those that were measured the way is "
                        "interpolated, which is right where each is logged as soon as it is computed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Log the position as it is computed, with all digits. Where each comes later than its stamp "
                        "says, take the delay out of the stamps."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Relative motions of the INS turn about the wrong axes; no result stands on them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Correct the columns or the signs that the finding names; of the path's slope only pitch can "
                        "be told, look at the sign of roll as well."),
      QT_TRANSLATE_NOOP("remount::model", "To the calibration the vehicle hardly turns; no result stands on that."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Give the unit of the angles as the log has it, or have the driver convert them to radians once."),
      QT_TRANSLATE_NOOP("remount::model", "The path is mirrored, and goes its own way; no result stands on it."),
      QT_TRANSLATE_NOOP("remount::model", "Exchange the columns of latitude and longitude."),
      QT_TRANSLATE_NOOP("remount::model", "Scans are compared with the motion of another instant: no pair fits."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Declare the time scale (UTC, GPS, TAI) of each log, or subtract the difference from the stamps of one."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Scans are compared with the motion of another instant: no pair fits, or X is off."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Move the stamps of the LiDAR by that much, and see why the clocks differ: one that is not "
          "synchronised, another time scale, stamps of arrival. The next calibration estimates what is left."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Before anything else bring the clocks of LiDAR and INS together: their rates of rotation meet "
                        "at another offset (see the findings)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Before anything else correct columns, signs and units of the INS log (see the findings)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS contradicts itself: a column of its log is not what it is taken for."),
      QT_TRANSLATE_NOOP("remount::model",
                        "the angles are declared as unit: %1, but the heading then goes against the direction of "
                        "travel; it follows it where they are %2 times larger: they were converted once too often. "
                        "Write them in the unit that is declared"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the angles are declared as unit: %1, but the heading then goes against the direction of "
                        "travel; it follows it where they are %2 times smaller: they were converted once too often. "
                        "Write them in the unit that is declared"),
      QT_TRANSLATE_NOOP("remount::model",
                        "a latitude beyond 90 degrees is not possible: are latitude and longitude exchanged?"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The clocks of LiDAR and INS are apart: scans were compared with the motion of another instant."),
      QT_TRANSLATE_NOOP("remount::model",
                        "roll, pitch or yaw reaches %1, more than a turn in radians, which KITTI has. Convert the "
                        "angles from degrees"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Times that are of another unit, or shares of a turn, bend the scans instead of mending them; "
                        "they count as scans whose times are not known."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Have the driver write the times of points in seconds, or name the unit in the column "
                        "(time_ms, time_us, time_ns)."),
      QT_TRANSLATE_NOOP("remount::model", "Taken forwards, such times bend the scans twice."),
      QT_TRANSLATE_NOOP("remount::model", "Have the driver write the times of points from the stamp on."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The poses of the INS seem to be inverted, from the world to the body: as they are they keep "
                        "to no axis of a vehicle that travels, their inverses do. Invert each of them (rotation R "
                        "transposed, position -R transposed times p)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The poses of the LiDAR seem to be inverted, from the world to the body: as they are they keep "
                        "to no axis of a vehicle that travels, their inverses do. Invert each of them (rotation R "
                        "transposed, position -R transposed times p)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The inverse of a motion is another motion, about another place; no result stands on it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Export the poses as those of the body in the world, or invert each of them; check those of "
                        "the other sensor as well."),
      QT_TRANSLATE_NOOP("remount::model", "Exports that turn axes cannot know what the axes of the INS are."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Nothing, where the INS has z down; otherwise check the convention of the attitude (ENU or NED)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the clock offset of the result; where it has none, record a drive with several turns, "
                        "on one clock."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The z axis of the INS points down, as in axes x forward, y right, z down. The result is in the axes of the "
          "log; they are not called by a name, and an export that would turn them is refused."),
  };
  return phrases;
}

}  // namespace remount

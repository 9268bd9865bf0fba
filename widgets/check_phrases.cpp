#include "widgets/check_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& check_phrases() {
  static const std::vector<const char*> phrases{
      // what the checks of data find
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 samples are degraded and %3 invalid by the INS's own status, in %4 stretches, the "
                        "longest of %5 s."),
      QT_TRANSLATE_NOOP("remount::model", "The position jumps %1 times, the farthest by %2 m at %3."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The stated error of the position grows from %1 m to %2 m in %3 stretches, %4 % of the drive: "
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
      // what each code means, and what to do about it
      QT_TRANSLATE_NOOP("remount::model", "Every relative motion of the INS is wrong; no result stands on it."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Declare the convention that the finding names; in session.yaml it is ins.columns.attitude.convention."),
      QT_TRANSLATE_NOOP("remount::model", "Heading and direction of travel have nothing to do with each other."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Look which column is the heading, and how it counts; set the mounting of the INS in the INS itself."),
      QT_TRANSLATE_NOOP("remount::model", "Roll of the INS is off by half a turn, and that of the result with it."),
      QT_TRANSLATE_NOOP("remount::model", "Declare the convention of the attitude (ENU or NED) as the INS has it."),
      QT_TRANSLATE_NOOP("remount::model", "Scans and INS have no instant in common: there is nothing to compare."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give data of the same drive, on one clock; declare the time scale (UTC, GPS) of each."),
      QT_TRANSLATE_NOOP("remount::model", "The stream cannot be used: no sample of it belongs to the drive."),
      QT_TRANSLATE_NOOP("remount::model", "Declare its time scale (UTC, GPS) and unit, or leave it out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Whatever else is stamped by the host's clock is off by as much against the INS."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Synchronise the host with GPS (PTP, NTP, chrony); stamp scans by GPS time (PPS) where the LiDAR can."),
      QT_TRANSLATE_NOOP("remount::model", "The result does not contain the value that was measured by hand."),
      QT_TRANSLATE_NOOP("remount::model", "Give its sigma, use a method that takes measured values, or leave it out."),
      QT_TRANSLATE_NOOP("remount::model", "The host's clock cannot be judged."),
      QT_TRANSLATE_NOOP("remount::model", "Export the log again with all digits."),
      QT_TRANSLATE_NOOP("remount::model", "Poses and INS may belong to different instants."),
      QT_TRANSLATE_NOOP("remount::model", "Record a drive with several turns, on one clock."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The clocks were brought together by the turns of the drive, to some milliseconds."),
      QT_TRANSLATE_NOOP("remount::model", "Synchronise the clocks before the next drive."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Only turns tell where the LiDAR sits: straight driving tells how it is turned, no more."),
      QT_TRANSLATE_NOOP("remount::model", "Drive at least one full turn to each side, a figure of eight for instance."),
      QT_TRANSLATE_NOOP("remount::model", "Only tilting tells the height: on level ground it keeps the nominal value."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Drive over a ramp or a kerb, or measure the height and give it with --measured."),
      QT_TRANSLATE_NOOP("remount::model", "No mounting turns a mirrored cloud into the world: no result can be right."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give x forward, y left, z up or any other right-handed axes: turn the sign of y where the "
                        "driver has y to the right."),
      QT_TRANSLATE_NOOP("remount::model",
                        "A pair across a jump tells of a motion that never was; it is rejected where that shows."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether RTK was lost there or the filter was reset; reject the pairs across it, or use a "
                        "log that was processed afterwards (PPK)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Scans that fall into a gap of the INS have no motion to be compared with, and are not used."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Look for messages that the recorder drops (disk, network, buffers); record again where much is missing."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS doubts its own solution there: it may be off by more than it claims."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Record under open sky after the INS has finished aligning, or leave that part of the drive out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "A solution that stands still while the vehicle moves makes pairs that contradict all others."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Wait until the INS has aligned before you drive, and see whether the log or its driver stalled."),
      QT_TRANSLATE_NOOP("remount::model", "Scans that are listed are not there, and take no part."),
      QT_TRANSLATE_NOOP("remount::model", "Copy the recording again, whole."),
      QT_TRANSLATE_NOOP("remount::model", "Scans without a time cannot be used."),
      QT_TRANSLATE_NOOP("remount::model", "Copy the file of stamps again, as it was recorded."),
      QT_TRANSLATE_NOOP("remount::model", "Positions far from all others are glitches of the receiver, and left out."),
      QT_TRANSLATE_NOOP("remount::model", "Nothing, where they are few; otherwise the log holds more than one drive."),
      QT_TRANSLATE_NOOP("remount::model", "Files whose names are no stamps are left out."),
      QT_TRANSLATE_NOOP("remount::model", "Name scans by their time, or give a table of stamps."),
      QT_TRANSLATE_NOOP("remount::model", "What lies in the damaged part of the bag takes no part."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Copy the bag again, whole; close the recorder before copying. rosbag reindex (.bag) or mcap recover "
          "(.mcap) restore an index, sqlite3's .recover what is whole of a .db3."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The clocks were brought together by the recorder's, as well as it took messages down."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Synchronise the clocks before the next drive; look at the clock offset of the result."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Within a scan, points may be compensated for the motion of another instant."),
      QT_TRANSLATE_NOOP("remount::model", "Have the driver stamp scans and points by one clock."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Either the LiDAR sits otherwise than assumed, or the nominal is given in other terms."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the vehicle; check axes, signs, order of angles and direction of the nominal."),
      QT_TRANSLATE_NOOP("remount::model", "The accumulated scans contradict the result, whatever its residuals say."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the pairs that were accepted and at the clock offset; do not use the result before "
                        "that."),
      QT_TRANSLATE_NOOP("remount::model", "Lines that are damaged are left out."),
      QT_TRANSLATE_NOOP("remount::model", "Export the log again where they are many."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Positions drift while corrections are missing, and jump when they come back."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Check the link to the corrections; record under open sky, or process the log afterwards (PPK)."),
      QT_TRANSLATE_NOOP("remount::model", "Few points do not hold a scan in place: its pairs are rejected or loose."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether the sensor was blocked, or packets were lost; record sweeps whole."),
      QT_TRANSLATE_NOOP("remount::model", "Points without a place are left out, nothing else is."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing, where they are beams without a return; otherwise check the driver of the sensor."),
      QT_TRANSLATE_NOOP("remount::model", "A scan that cannot be read takes no part."),
      QT_TRANSLATE_NOOP("remount::model", "Copy or export the scan again."),
      QT_TRANSLATE_NOOP("remount::model", "Of entries with one stamp only the first is used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether two recorders write into one log, or whether stamps are rounded."),
      QT_TRANSLATE_NOOP("remount::model", "Entries that go back in time are left out; where they belong is not known."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Check the clock of the recorder: it was set while it recorded, or messages were put in order of arrival."),
      QT_TRANSLATE_NOOP("remount::model", "Entries without a possible time are left out."),
      QT_TRANSLATE_NOOP("remount::model", "Declare the unit of the stamps (s, ms, us, ns) as the log has it."),
      QT_TRANSLATE_NOOP("remount::model", "Angles in the wrong unit make every attitude wrong."),
      QT_TRANSLATE_NOOP("remount::model", "Declare attitude: {unit: deg} or {unit: rad} as the log has it."),
      QT_TRANSLATE_NOOP("remount::model", "The whole drive shrinks to centimetres, and nothing agrees with the LiDAR."),
      QT_TRANSLATE_NOOP("remount::model", "Declare the unit of latitude and longitude as the log has it."),
      QT_TRANSLATE_NOOP("remount::model", "Odometry that lives on the IMU turns dozens of times too far, or hardly."),
      QT_TRANSLATE_NOOP("remount::model", "Declare the unit of the angular rate as the log has it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The direction of gravity is found, but forces are taken for a tenth of what they are."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Declare the unit of the specific force; record raw values, with gravity in them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Roll and pitch are guesses: of the mounting only yaw, and x and y, can be relied on."),
      QT_TRANSLATE_NOOP("remount::model", "Log PASHR as well, or use an INS."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Yaw of the result is off by as much as the grid turns against true north there."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give latitude and longitude where you have them, or turn the poses by the grid convergence."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Pairs take the vehicle to have moved without turning; those in turns contradict all others."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether the attitude had aligned and whether its log or driver stalled; leave that part "
                        "of the drive out, or record it again."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Pairs take the vehicle to have turned in its place, and what is found for its position is wrong."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether GNSS or its driver stalled; leave that part of the drive out, or use a log that "
                        "was processed afterwards (PPK)."),
      QT_TRANSLATE_NOOP("remount::model", "Where the INS has no orientation there is no motion to be compared with."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Nothing, where they are at the beginning: the INS was aligning; otherwise see what the driver reports."),
      QT_TRANSLATE_NOOP("remount::model", "The rates are used, though the driver says that there are none."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Compare them with the turns of the drive; where they mean nothing leave them out: --topic imu=none."),
      QT_TRANSLATE_NOOP("remount::model", "Methods that need turn rates have none there."),
      QT_TRANSLATE_NOOP("remount::model",
                        "See whether the driver of the IMU stalled, or say with --topic which topic is the IMU."),
      QT_TRANSLATE_NOOP("remount::model", "The receiver has no position there."),
      QT_TRANSLATE_NOOP("remount::model", "Record under open sky; wait for a fix before you drive."),
      QT_TRANSLATE_NOOP("remount::model", "Good fixes count as little as bad ones."),
      QT_TRANSLATE_NOOP("remount::model", "Have the driver state the covariance of its fixes."),
  };
  return phrases;
}

}  // namespace remount

#include "widgets/check_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& check_phrases() {
  static const std::vector<const char*> phrases{
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
      // what each code means, and what to do about it
      QT_TRANSLATE_NOOP("remount::model", "Every relative motion of the INS is wrong; no result stands on it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Declare the convention that the finding names (CSV: ins.columns.attitude.convention), or set "
                        "it in the INS."),
      QT_TRANSLATE_NOOP("remount::model", "Heading and direction of travel have nothing to do with each other."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Look what the log has for a heading, and how it counts; set the mounting of the INS in the INS itself."),
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
      QT_TRANSLATE_NOOP("remount::model", "Give its sigma, or leave it out."),
      QT_TRANSLATE_NOOP("remount::model", "Leave it out, or record an INS with attitude."),
      QT_TRANSLATE_NOOP("remount::model", "The host's clock cannot be judged."),
      QT_TRANSLATE_NOOP("remount::model", "Export the log again with all digits."),
      QT_TRANSLATE_NOOP("remount::model", "Poses and INS may belong to different instants."),
      QT_TRANSLATE_NOOP("remount::model", "Record a drive with several turns, on one clock."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The clocks were brought together by the turns of the drive, to some milliseconds."),
      QT_TRANSLATE_NOOP("remount::model", "Synchronise the clocks before the next drive."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Only turns tell where the LiDAR sits: straight driving tells how it is turned, no more."),
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
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Log PASHR as well, or use an INS; or give what you measured, or the height of the INS above ground."),
      QT_TRANSLATE_NOOP("remount::model", "The recording was stopped, or copied, before it was complete."),
      QT_TRANSLATE_NOOP("remount::model", "Copy the log again, whole. What lies before the cut is used."),
      QT_TRANSLATE_NOOP("remount::model", "In turns, headings may be those of the next position."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Begin the log with a heading (HDT) and end it with a position, or log PASHR, which has a time."),
      QT_TRANSLATE_NOOP("remount::model", "Between attitudes that are far apart in time the motion is not known."),
      QT_TRANSLATE_NOOP("remount::model", "Log attitude (PASHR or HDT) at the rate of the positions, at 5 Hz or more."),
      QT_TRANSLATE_NOOP("remount::model", "Messages without a fix or an orientation are no poses of the INS."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Let the INS get its fix and align before you drive; record position and orientation at one rate."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Where the vehicle turns, an interpolated motion is not the one that was driven."),
      QT_TRANSLATE_NOOP("remount::model", "Log the INS at 50 Hz or faster, or drive slowly and steadily."),
      QT_TRANSLATE_NOOP("remount::model",
                        "What the recorder is late by is a clock offset: X is off by it where the vehicle turns."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Have the driver stamp its messages; look at the clock offset of the result."),
      QT_TRANSLATE_NOOP("remount::model", "A height that falls to zero is taken for motion."),
      QT_TRANSLATE_NOOP("remount::model", "Export the track with its heights, or take out the points that have none."),
      QT_TRANSLATE_NOOP("remount::model", "The search begins without the mounting that lies beside the drive."),
      QT_TRANSLATE_NOOP("remount::model", "Mend the file, or give the nominal mounting yourself."),
      QT_TRANSLATE_NOOP("remount::model", "Digits were lost, or the numbers are in another order than was taken."),
      QT_TRANSLATE_NOOP("remount::model", "Export the poses again with all digits, and check their layout."),
      QT_TRANSLATE_NOOP("remount::model", "Scans without a motion of the INS cannot be compared with anything."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Record the INS from before the first scan until after the last, on one clock."),
      QT_TRANSLATE_NOOP("remount::model", "There is nothing that could be registered."),
      QT_TRANSLATE_NOOP("remount::model", "A motion lies between two scans."),
      QT_TRANSLATE_NOOP("remount::model", "Record a drive, and see whether the folder holds all of its scans."),
      QT_TRANSLATE_NOOP("remount::model", "Only motion tells where the LiDAR sits."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Poses that are predicted come from no scan: what the LiDAR did there is not known."),
      QT_TRANSLATE_NOOP("remount::model", "A place on the vehicle is another number in another frame."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Give the nominal mounting in the frame in which the method finds the sensor, or none."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Points that are matched with points, or with cells, are off by more than their number says, the "
          "same way in every pair."),
      QT_TRANSLATE_NOOP("remount::model", "Choose plane-to-plane or pcl-gicp where the sigma is to hold."),
      QT_TRANSLATE_NOOP("remount::model", "A tyre differs by a per cent or two: one of the two is not in metres."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look at the wheel radius or the units of the wheel speeds, and at the units of the sensor's "
                        "poses."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Drive more slowly, or where there is more to see; see whether the scans are whole and in order."),
      QT_TRANSLATE_NOOP("remount::model", "A scan that is not aligned has no pose, and takes no part."),
      QT_TRANSLATE_NOOP("remount::model", "What spans such a place rests on a prediction."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look for gaps of the scans there; drive more slowly, or where there is more to see."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Scans that are taken while the vehicle moves stay bent, and align the worse for it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Have the driver write the times of points from the stamp of the scan, in one unit."),
      QT_TRANSLATE_NOOP("remount::model", "There is nothing to compare its odometry with."),
      QT_TRANSLATE_NOOP("remount::model", "Record an INS with attitude, or leave the session out."),
      QT_TRANSLATE_NOOP("remount::model", "Either these positions and attitudes are wrong, or their clock is."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Look for lost corrections and reflected signals there; where they are many, look at clocks "
                        "and conventions."),
      QT_TRANSLATE_NOOP("remount::model", "Dead reckoning does not reach across a gap."),
      QT_TRANSLATE_NOOP("remount::model", "The other sessions take no part."),
      QT_TRANSLATE_NOOP("remount::model", "Give one session, or poses of a sensor."),
      QT_TRANSLATE_NOOP("remount::model", "The machine stood on a slope, or what was taken for the ground is none."),
      QT_TRANSLATE_NOOP("remount::model", "Record the ground where it is level and free around the machine."),
      QT_TRANSLATE_NOOP("remount::model", "z, pitch and roll rest on the motion of the drive alone."),
      QT_TRANSLATE_NOOP("remount::model", "Drive where the road around the vehicle is free, or measure z by hand."),
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
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The positions are of another device than the orientation by its topic: they may be those of an antenna."),
      QT_TRANSLATE_NOOP("remount::model",
                        "X is of the antenna then, turned as the IMU is: off by the lever arm between the two, and no "
                        "sigma says so."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Take the positions of the INS itself (--topic ins-position=TOPIC), or let the driver subtract "
                        "the lever arm."),
      // parts that stand still, columns and clocks that are others than declared
      QT_TRANSLATE_NOOP("remount::model",
                        "The attitude stands still for %1 s at a time (%2 samples) and then jumps, by %3 degrees where "
                        "the vehicle turns: it is logged more often than it is computed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The position stands still for %1 s at a time (%2 samples) and then jumps, by %3 m where the "
                        "vehicle drives: it is logged more often than it is computed."),
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

#include "widgets/file_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& file_phrases() {
  static const std::vector<const char*> phrases{
      // findings and errors of readers, and what the system says of files
      QT_TRANSLATE_NOOP("remount::model", "%1 gap, the longest %2 s; nothing is interpolated across them."),
      QT_TRANSLATE_NOOP("remount::model", "%1 gaps, the longest %2 s; nothing is interpolated across them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS moves at up to %1 m/s: its position jumps, or its stamps are wrong."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The vehicle turns by %1 degrees in all: the position of the LiDAR will hardly be observable "
                        "from this drive alone. Drive a figure of eight."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The vehicle tilts by %1 degrees only: the height of the LiDAR will hardly be observable. "
                        "Drive over a ramp."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS repeats one solution for %1 s; was it still aligning, or did the log stall?"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The heading of the INS does not follow the direction of travel, but it would as %1: correct "
                        "the convention of the attitude. No mounting can be right with this one."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The heading of the INS does not follow the direction of travel: check the convention of the "
                        "attitude, and whether what is taken for yaw is it. A vehicle that moves sideways at will may "
                        "look so too."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The z axis of the INS points down, where its axes are declared with z up: is it mounted so? "
                        "Otherwise check the convention of the attitude (ENU or NED, roll by 180 degrees)."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans lie outside the INS data or in a gap of it and are not used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 of %2 scans lie outside the INS data or in a gap of it and are not used: %3"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Too few scans show the ground near the vehicle; the height of the INS is not used."),
      QT_TRANSLATE_NOOP("remount::model", "%1 The scan is skipped."),
      QT_TRANSLATE_NOOP("remount::model",
                        "was there when it was opened and is gone now: nothing is made of the part that could be read"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The format does not say how its scans are bent by motion; told by the scans themselves they "
                        "are %1. That leaves %2 % less between scans than the next of what was tried."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The sensor turns clockwise, not as is usual in this format: the scans are %1. That leaves %2 "
                        "% less between scans than the next of what was tried."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The sensor turns counter-clockwise, not as is usual in this format: the scans are %1. That "
                        "leaves %2 % less between scans than the next of what was tried."),
      QT_TRANSLATE_NOOP("remount::model",
                        "How the scans are bent by motion is not known, and they do not tell clearly: they are %1. The "
                        "sigmas include what another way would make of the mounting; no clock offset is estimated."),
      QT_TRANSLATE_NOOP("remount::model", "used as they are"),
      QT_TRANSLATE_NOOP("remount::model", "compensated by the order of their points, over %1 s"),
      QT_TRANSLATE_NOOP("remount::model", "compensated as turns of %1 s, clockwise"),
      QT_TRANSLATE_NOOP("remount::model", "compensated as turns of %1 s, counter-clockwise"),
      QT_TRANSLATE_NOOP("remount::model", "When the points were measured is not known: %1."),
      QT_TRANSLATE_NOOP("remount::model", "the points have no times (columns: %1)"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "per-point is declared, but %1 in %2. Columns of times that are known: %3, also behind scalar_. Or "
          "declare timing: sweep for a sensor that spins, instant for scans that are compensated, unknown "
          "otherwise"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "per-point is declared, but %1 in %2. Columns of times that are known: %3, also behind scalar_. Or "
          "declare timing: sweep for a sensor that spins, instant for scans that are compensated, unknown "
          "otherwise. Besides, the stamps of %4 are turns of the GPS week (1024 weeks each) off, which is mended once "
          "the session can be read"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "its points have no times, or all the same, while those of other scans have: it would be used as "
          "if it had been measured at once"),
      QT_TRANSLATE_NOOP("remount::model", "%1 gps_time (one value for all points)"),
      QT_TRANSLATE_NOOP("remount::model", "x y z reflectance and one more"),
      QT_TRANSLATE_NOOP("remount::model", "x y z reflectance and two more"),
      QT_TRANSLATE_NOOP("remount::model", "is LAS %1, expected 1.0 to 1.4"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "expected 32-bit floats, 3 to 6 a point: x, y, z, then reflectance (KITTI), ring (nuScenes) and "
          "one more"),
      QT_TRANSLATE_NOOP("remount::model",
                        "looks like NCLT's records of 8 bytes (16-bit coordinates, intensity, laser), %1. Convert the "
                        "scans, to PCD for instance"),
      QT_TRANSLATE_NOOP("remount::model",
                        "holds %1 bytes that are no points, %2. Convert the scans to one of these, or to PCD, whose "
                        "header says what is in it"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the times of the points are all the same, or few for all points (columns: %1)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "There are %1 stamps of scans and %2 of the INS: scans and INS samples of one number do not "
                        "belong together, and go by their own stamps."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The stamps of %1 of %2 scans are further than half a scan from those of the INS of their number: scans and "
          "INS samples of one number do not belong together, and go by their own stamps."),
      QT_TRANSLATE_NOOP("remount::model",
                        "How the scans are bent by motion is not known, which biases X; the sigmas include it. Record "
                        "scans with the times of their points, or declare how they were swept."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Nothing is known: how the scans are bent by motion makes more of a difference than X can bear."),
      QT_TRANSLATE_NOOP("remount::model", "%1: not known, how the scans are bent by motion is not known"),
      QT_TRANSLATE_NOOP("remount::model", "%1: not known, it still changes when the odometry is repeated with it"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Nothing is known: the mounting changes whenever the odometry is repeated with it."),
      QT_TRANSLATE_NOOP("remount::model", "trying how scans were swept"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "holds coordinates of a map (up to %1 m), expected metres in the frame of the sensor, one scan a file"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The lidar's stamps are early by %1 ms (sigma %2 ms) against the INS. X is solved with that "
                        "taken out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The lidar's stamps are late by %1 ms (sigma %2 ms) against the INS. X is solved with that "
                        "taken out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The lidar's stamps are early by %1 ms (sigma %2 ms) against the INS. X is biased by it while "
                        "the vehicle turns: set solve.apply_time_offset to auto or yes to correct it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The lidar's stamps are late by %1 ms (sigma %2 ms) against the INS. X is biased by it while "
                        "the vehicle turns: set solve.apply_time_offset to auto or yes to correct it."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Surfaces in the accumulated scans are %1 mm thick under the result and %2 mm under the nominal: the map "
          "contradicts the result. Look at the pairs and at the clock offset before using it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The result lies %1 deg and %2 m from the nominal mounting. The LiDAR sits otherwise than "
                        "assumed, or the nominal has other axes or signs."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The result lies %1 deg and %2 m from the nominal mounting. The inverse of the nominal is "
                        "near: was lidar_from_ins given for ins_from_lidar?"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Of several topics this one serves as %1; not used: %2. --topic %3=TOPIC takes another."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The bag has no usable index (%1). It was read from the beginning: %2 messages in %3 chunks were found. %4"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The bag has no usable index (%1). It was read from the beginning: %2 messages were found; %3 "
                        "bytes at the end are not readable.%4"),
      QT_TRANSLATE_NOOP("remount::model", "Parts of the bag are missing: %1."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The stamps are of another clock than the LiDAR's; by the recorder's clock they are %1 s apart, beside what "
          "a scan lasts. They are moved by that; what is left, the delays of the recording, shows as time offset."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The stamps are of another clock than the LiDAR's; by the recorder's clock they are %1 s apart, beside what "
          "a scan lasts. They are moved by that; what is left, the delays of the recording, shows as time offset. %2"),
      QT_TRANSLATE_NOOP("remount::model", "The LiDAR's clock counts from when it was switched on, not from 1970."),
      QT_TRANSLATE_NOOP("remount::model", "That clock counts from when it was switched on, not from 1970."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The messages have no stamps; the times at which they were recorded are used. They are late by "
                        "the delay of the recorder."),
      QT_TRANSLATE_NOOP("remount::model", "The static transforms lead from %1 to %2; that serves as the nominal."),
      QT_TRANSLATE_NOOP("remount::model", "The static transforms do not lead from %1 to %2."),
      QT_TRANSLATE_NOOP("remount::model", "%1 message has no fix and %2 no orientation beside: left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 messages have no fix and %2 no orientation beside: left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The column 'time' was rounded, as a spreadsheet does; GPS time is used, nothing is lost."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The column 'time' (clock of the host, or of a replay) is %1 s off UTC by GPS; GPS time is used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The LiDAR poses cannot be brought to INS time: %1. Their stamps stay as they are; record a "
                        "drive with several turns."),
      QT_TRANSLATE_NOOP("remount::model", "The two clocks agree; by the rates of rotation, %1. Nothing was moved."),
      QT_TRANSLATE_NOOP("remount::model", "The LiDAR poses were moved to INS time by the rates of rotation: %1."),
      QT_TRANSLATE_NOOP("remount::model", "is no session itself; open those of one vehicle below it:%1"),
      QT_TRANSLATE_NOOP("remount::model", "%1 cannot be used and is left out. First: %2"),
      QT_TRANSLATE_NOOP("remount::model", "%1 cannot be used and are left out. First: %2"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 sample lies more than 2 degrees of latitude or longitude from the rest: left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 samples lie more than 2 degrees of latitude or longitude from the rest: left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entry has no possible time (expected nanoseconds since 1970): left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 entries have no possible time (expected nanoseconds since 1970): left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entry repeats the stamp before it; the first of each is used."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entries repeat the stamp before them; the first of each is used."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entry goes back in time: left out. Check the clock of the recorder."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entries go back in time: left out. Check the clock of the recorder."),
      QT_TRANSLATE_NOOP("remount::model", "%1 files have no time stamp and are left out."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "Scans and INS samples of one number are taken together; their own stamps differ by %1 ms (median)."),
      QT_TRANSLATE_NOOP("remount::model", "A mounting is given beside the drive; it serves as the nominal."),
      QT_TRANSLATE_NOOP("remount::model", "There are scans and LiDAR poses; the scans are used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "One pose file is half a session: put it into a folder with the poses of the other sensor."),
      QT_TRANSLATE_NOOP("remount::model", "Rotations were off by up to %1 in an entry; the nearest rotation is used."),
      QT_TRANSLATE_NOOP("remount::model", "does not exist"),
      QT_TRANSLATE_NOOP("remount::model", "is a symbolic link that leads nowhere"),
      QT_TRANSLATE_NOOP("remount::model", "is empty"),
      QT_TRANSLATE_NOOP("remount::model", "is empty (0 bytes), expected the log or manifest of a session"),
      QT_TRANSLATE_NOOP("remount::model", "is no session that Remount knows. It looks for:%1"),
      QT_TRANSLATE_NOOP("remount::model",
                        "gnss-log: an NMEA log (GGA, with PASHR or HDT for attitude) or a GPX track, and a file of "
                        "LiDAR poses"),
      QT_TRANSLATE_NOOP("remount::model",
                        "KITTI raw drive: a folder <date>_drive_XXXX_sync or _extract with oxts/ and velodyne_points/"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Remount session: a folder with session.yaml (or that file) that declares scans or LiDAR poses "
                        "and an INS table"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "NovAtel INSPVAX: an ASCII log (#INSPVAXA) or a CSV exported from a bag, in a folder with LiDAR "
          "poses (A-LOAM CSV, TUM, ETH CSV)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "OpenCalib: a folder with pose lines (stamp and 12 numbers) of the INS, and PCD files named by "
                        "their stamps or LiDAR poses"),
      QT_TRANSLATE_NOOP("remount::model",
                        "Pose files: a folder with two (TUM, ETH CSV, A-LOAM CSV, pose lines), one named "
                        "ins/imu/hand/vicon/body, one lidar/camera/cam/odom/laser; or a single one to inspect"),
      QT_TRANSLATE_NOOP("remount::model",
                        "smartLoc: NAME_Input.txt with odom3 lines (wheel speed, turn rate), or a folder with one, and "
                        "NAME_GT.txt beside it"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "ROS bag: .bag (ROS 1), .mcap or .db3 (ROS 2), or a folder that holds one; PointCloud2 or Livox "
          "scans, and INSPVAX, Odometry, poses, or NavSatFix with Imu"),
      QT_TRANSLATE_NOOP("remount::model", "lies outside the search range: %1. Correct it, or widen the search range."),
      QT_TRANSLATE_NOOP("remount::model", "cannot be opened: %1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be read: %1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be examined: %1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be made: %1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be saved: %1; nothing was replaced"),
      QT_TRANSLATE_NOOP("remount::model",
                        "cannot be saved, no temporary file can be made beside it: %1; nothing was replaced"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be saved, there is no folder %1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be saved, the link leads nowhere: %1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be saved, its folder cannot be opened: %1; nothing was replaced"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be saved, the link cannot be read: %1; nothing was replaced"),
      QT_TRANSLATE_NOOP("remount::model",
                        "is saved, but the disk does not confirm it: %1; save it again, or elsewhere"),
      QT_TRANSLATE_NOOP("remount::model", "cannot be listed: %1"),
      QT_TRANSLATE_NOOP("remount::model", "is no PCD, PLY, KITTI .bin or .txt scan"),
      QT_TRANSLATE_NOOP("remount::model", "holds no points"),
      QT_TRANSLATE_NOOP("remount::model", "holds no scan with a time stamp"),
      QT_TRANSLATE_NOOP("remount::model", "holds no INSPVAX log"),
      QT_TRANSLATE_NOOP("remount::model", "is no pose file"),
      QT_TRANSLATE_NOOP("remount::model", "latitude, longitude or height is not possible"),
      QT_TRANSLATE_NOOP("remount::model", "the checksum does not agree with the line"),
      QT_TRANSLATE_NOOP("remount::model", "the positions lie all over the Earth: is that one drive?"),
      QT_TRANSLATE_NOOP("remount::model", "No such file or directory"),
      QT_TRANSLATE_NOOP("remount::model", "Permission denied"),
      QT_TRANSLATE_NOOP("remount::model", "No space left on device"),
      QT_TRANSLATE_NOOP("remount::model", "Input/output error"),
      QT_TRANSLATE_NOOP("remount::model", "Read-only file system"),
      QT_TRANSLATE_NOOP("remount::model", "Is a directory"),
      QT_TRANSLATE_NOOP("remount::model", "File name too long"),
      QT_TRANSLATE_NOOP("remount::model", "Stale file handle"),
      QT_TRANSLATE_NOOP("remount::model", "ok"),
      QT_TRANSLATE_NOOP("remount::model", "degenerate"),
      QT_TRANSLATE_NOOP("remount::model", "too_few_pairs"),
      QT_TRANSLATE_NOOP("remount::model", "not_converged"),
      QT_TRANSLATE_NOOP("remount::model", "out_of_range"),
      QT_TRANSLATE_NOOP("remount::model", "inconsistent"),
      QT_TRANSLATE_NOOP("remount::model", "cancelled"),
      // formats of exports, which way their numbers go, and why a result cannot be written in one
      QT_TRANSLATE_NOOP("remount::model", "Remount result as YAML, with sigma, pairs and provenance"),
      QT_TRANSLATE_NOOP("remount::model", "Remount result as JSON, with sigma, pairs and provenance"),
      QT_TRANSLATE_NOOP("remount::model", "4x4 matrix as text"),
      QT_TRANSLATE_NOOP("remount::model", "ROS 1 launch file with a static_transform_publisher"),
      QT_TRANSLATE_NOOP("remount::model", "ROS 2 launch file (XML) with a static_transform_publisher"),
      QT_TRANSLATE_NOOP("remount::model", "Autoware sensor_kit_calibration.yaml (kit base = the INS frame)"),
      QT_TRANSLATE_NOOP("remount::model", "Apollo *_novatel_extrinsics.yaml, INS axes as in the result"),
      QT_TRANSLATE_NOOP("remount::model", "Apollo *_novatel_extrinsics.yaml, INS axes right-forward-up"),
      QT_TRANSLATE_NOOP("remount::model", "KITTI calib_imu_to_velo.txt"),
      QT_TRANSLATE_NOOP("remount::model", "OpenCalib extrinsic JSON"),
      QT_TRANSLATE_NOOP("remount::model", "URDF fixed joint"),
      QT_TRANSLATE_NOOP("remount::model", "lidar to ins: point_in_ins = ins_from_lidar * point_in_lidar"),
      QT_TRANSLATE_NOOP("remount::model", "lidar to ins: point_in_ins = matrix * point_in_lidar"),
      QT_TRANSLATE_NOOP("remount::model", "lidar to ins (pose of the lidar frame in the ins frame)"),
      QT_TRANSLATE_NOOP("remount::model", "lidar to ins (pose of the lidar frame in the kit's base, in radians)"),
      QT_TRANSLATE_NOOP("remount::model", "lidar to ins (header.frame_id from child_frame_id)"),
      QT_TRANSLATE_NOOP("remount::model",
                        "lidar to ins, the INS axes turned from x forward, y left to x right, y forward"),
      QT_TRANSLATE_NOOP("remount::model", "ins to lidar, the inverse of X: point_in_lidar = R point_in_ins + T"),
      QT_TRANSLATE_NOOP("remount::model", "ins to lidar, the inverse of X: point_in_lidar = matrix * point_in_ins"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the INS axes of this result are x right, y forward, z up already and must not be turned "
                        "again: export it as apollo"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the result does not say which axes its INS has, so that they cannot be turned: export it as "
                        "apollo, which leaves them as they are"),
      QT_TRANSLATE_NOOP("remount::model", "the mounting is given in INS axes %1; it is turned to those of the log, %2"),
      // what has changed since a calibration, and what settings contradict each other; shapes of objects
      QT_TRANSLATE_NOOP("remount::model", "%1 session, now %2"),
      QT_TRANSLATE_NOOP("remount::model", "%1 sessions, now %2"),
      QT_TRANSLATE_NOOP("remount::model", "nominal mounting unknown, now given"),
      QT_TRANSLATE_NOOP("remount::model", "nominal mounting given, now unknown"),
      QT_TRANSLATE_NOOP("remount::model", "another nominal mounting"),
      QT_TRANSLATE_NOOP("remount::model", "%1, now %2"),
      QT_TRANSLATE_NOOP("remount::model", "range.%1: the minimum %2 exceeds the maximum %3"),
      QT_TRANSLATE_NOOP("remount::model", "%1 = %2 exceeds %3 = %4"),
      QT_TRANSLATE_NOOP("remount::model",
                        "vehicle_frame.scale and vehicle_frame.estimate_wheel_scale: one of the two must be known"),
      QT_TRANSLATE_NOOP("remount::model", "pole"),
      QT_TRANSLATE_NOOP("remount::model", "facade"),
      QT_TRANSLATE_NOOP("remount::model", "vehicle-sized"),
      QT_TRANSLATE_NOOP("remount::model", "small"),
      QT_TRANSLATE_NOOP("remount::model", "large"),
      QT_TRANSLATE_NOOP("remount::model", "the outline's rear end is not behind its front end"),
      QT_TRANSLATE_NOOP("remount::model", "the outline's right side is not right of its left side"),
      QT_TRANSLATE_NOOP("remount::model", "The times of the points are of no sweep and are not used: %1."),
      QT_TRANSLATE_NOOP("remount::model", "column %1 spans %2 s in a scan, while scans are %3 s apart"),
      QT_TRANSLATE_NOOP("remount::model",
                        "column %1 comes in steps of %2 s: 32-bit floats cannot hold seconds of the day or the week"),
      QT_TRANSLATE_NOOP("remount::model", "compensated by the times of their points, counted backwards"),
      QT_TRANSLATE_NOOP("remount::model", "compensated by the times of their points as they are"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The times of the points count backwards, as the time since a point was measured does; told by the scans "
          "themselves. They are taken so. That leaves %1 % less between scans than the next of what was tried."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Rates of rotation alone do not tell by how much the clocks of the LiDAR poses and the INS "
                        "differ: %1. The stamps stay as they are; a small offset is estimated with the mounting."),
      QT_TRANSLATE_NOOP("remount::model", "its columns are separated by semicolons, expected commas"),
      QT_TRANSLATE_NOOP("remount::model", "its columns are separated by tabs, expected commas"),
  };
  return phrases;
}

}  // namespace remount

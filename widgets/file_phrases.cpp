#include "widgets/file_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& file_phrases() {
  static const std::vector<const char*> phrases{
      // findings and errors of readers, and what the system says of files
      QT_TRANSLATE_NOOP("remount::model", "%1 gaps, the longest %2 s; nothing is interpolated across them."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS moves at up to %1 m/s: its position jumps, or its stamps are wrong."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The vehicle turns by %1 degrees in all: the position of the LiDAR will not be observable from "
                        "this drive alone. Drive a figure of eight."),
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
                        "attitude, and which column is yaw. A vehicle that moves sideways at will may look so too."),
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
                        "The format does not say whether its scans are compensated for motion. Compensating them "
                        "changes the registration residual by %1: scans are compensated."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The format does not say whether its scans are compensated for motion. Compensating them "
                        "changes the registration residual by %1: scans are used as they are."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The lidar's stamps are early by %1 ms (sigma %2 ms) against the INS. X is biased by it while "
                        "the vehicle turns: set solve.apply_time_offset to correct it."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The lidar's stamps are late by %1 ms (sigma %2 ms) against the INS. X is biased by it while "
                        "the vehicle turns: set solve.apply_time_offset to correct it."),
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
      QT_TRANSLATE_NOOP("remount::model",
                        "The database is damaged (%1): %2 messages were found, %3 belong to no topic."),
      QT_TRANSLATE_NOOP("remount::model", "Parts of the bag are missing: %1."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The points have no times of their own: scans are taken to be compensated for motion already."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The stamps are of another clock than the LiDAR's; by the recorder's clock they are %1 s apart. "
          "They are moved by that; what is left, the delays of the recording, shows as time offset."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The messages have no stamps; the times at which they were recorded are used. They are late by "
                        "the delay of the recorder."),
      QT_TRANSLATE_NOOP("remount::model", "The static transforms lead from %1 to %2; that serves as the nominal."),
      QT_TRANSLATE_NOOP("remount::model", "The static transforms do not lead from %1 to %2."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 messages have no fix and %2 no orientation beside them; they are left out."),
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
      QT_TRANSLATE_NOOP("remount::model", "%1 cannot be used and is left out. First: %2"),
      QT_TRANSLATE_NOOP("remount::model", "%1 cannot be used and are left out. First: %2"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 samples lie more than 2 degrees of latitude or longitude from the rest and are left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 entries have no possible time (expected nanoseconds since 1970) and are left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 entries repeat the stamp before them; the first of each is used."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 entries go back in time and are left out. Check the clock of the recorder."),
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
      QT_TRANSLATE_NOOP("remount::model", "is empty"),
      QT_TRANSLATE_NOOP("remount::model", "is empty (0 bytes), expected the log or manifest of a session"),
      QT_TRANSLATE_NOOP("remount::model", "is no session that Remount knows. It looks for:%1"),
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
  };
  return phrases;
}

}  // namespace remount

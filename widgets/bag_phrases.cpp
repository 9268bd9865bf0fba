#include "widgets/bag_phrases.h"

#include <QtGlobal>

namespace remount {

const std::vector<const char*>& bag_phrases() {
  static const std::vector<const char*> phrases{
      QT_TRANSLATE_NOOP("remount::model",
                        "The bag has no usable index (%1). It was read from the beginning: %2 messages were found; the "
                        "last record is cut, %3 of its %4 bytes are there."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The bag has no usable index (%1). It was read from the beginning: %2 messages were found; the "
                        "last record is cut, %3 of its %4 bytes are there. First that cannot be read: %5."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The database is damaged: %1 messages were found, %2 belong to no topic. What lies behind the "
                        "damage may be saved by the database's own tool: sqlite3 FILE .recover"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The database is damaged (%1): %2 messages were found, %3 belong to no topic. What lies behind "
                        "the damage may be saved by the database's own tool: sqlite3 FILE .recover"),
      // bags as a whole, and their topics
      QT_TRANSLATE_NOOP("remount::model", "holds no bag"),
      QT_TRANSLATE_NOOP("remount::model", "holds %1 bags and no metadata.yaml; open them one by one:%2"),
      QT_TRANSLATE_NOOP("remount::model", "the index names more than %1 messages, too many for a file of %2 bytes"),
      QT_TRANSLATE_NOOP("remount::model",
                        "is no bag that is known: expected one of ROS 1, an MCAP or an SQLite database of ROS 2"),
      QT_TRANSLATE_NOOP("remount::model", "the files that metadata.yaml names are not here: %1"),
      QT_TRANSLATE_NOOP("remount::model",
                        "goes with an IMU whose orientation serves as ins; give --topic ins=TOPIC of that IMU"),
      QT_TRANSLATE_NOOP("remount::model", "is no topic of this bag. It has:%1"),
      QT_TRANSLATE_NOOP("remount::model", "cannot serve as %1; what it can be: %2"),
      QT_TRANSLATE_NOOP("remount::model", "cannot serve as %1, nor as anything else"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The recording is cut or damaged behind its data, where its index stands (%1). All data before "
                        "that are whole; messages that were found by reading them: %2."),
      QT_TRANSLATE_NOOP("remount::model", "no scan of this topic can be read"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The times of the points are of another clock than the scan's stamp (more than a second apart): the first "
          "point is taken to be of the stamp. A time offset of up to one turn may remain."),
      QT_TRANSLATE_NOOP("remount::model",
                        "By the recorder's clock the stamps are %1 s apart from the LiDAR's, more than the delays of a "
                        "recording: one of the two seems to be stamped by a clock that is off, as a host's is. They "
                        "are not moved; it shows as time offset."),
      QT_TRANSLATE_NOOP("remount::model", "%1 message has no fix: left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 messages have no fix: left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 fix does not state its covariance; a sigma of 1 m is assumed."),
      QT_TRANSLATE_NOOP("remount::model", "%1 fixes do not state their covariance; a sigma of 1 m is assumed."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS has a position every %1 s only; between them the motion is interpolated. No other "
                        "topic has it much more often: set its output to 10 Hz or more."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The INS has a position every %1 s only; between them the motion is interpolated. %2 has %3 "
                        "Hz: --topic %4=%5 takes it, where it is of the same INS."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 message has no orientation, %2 of them before the first that has one: left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 messages have no orientation, %2 of them before the first that has one: left out."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 message says that turn rates or accelerations are not measured (covariance -1), all the "
                        "same they are there; they are taken."),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 messages say that turn rates or accelerations are not measured (covariance -1), all the "
                        "same they are there; they are taken."),
      QT_TRANSLATE_NOOP("remount::model", "%1 message has no turn rates: left out."),
      QT_TRANSLATE_NOOP("remount::model", "%1 messages have no turn rates: left out."),
      QT_TRANSLATE_NOOP("remount::model", "no message of this topic has turn rates"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The status of the position falls from %1 to %2 in %3, %4 % of the drive: "
                        "corrections (RTK) were lost."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The static transforms are not used: INSPVAX has axes of its own (x right, y forward, z up), "
                        "which no frame of ROS stands for. Give the nominal mounting yourself."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The static transforms are not used: the messages of the INS name no frame of their own."),
      QT_TRANSLATE_NOOP("remount::model", "The static transforms are not used: the scans name no frame."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The static transforms are not used: LiDAR and INS name one and the same frame, %1."),
      QT_TRANSLATE_NOOP("remount::model", "no usable INS is in this topic"),
      QT_TRANSLATE_NOOP("remount::model", "no usable INS is in this topic%1"),
      QT_TRANSLATE_NOOP("remount::model",
                        "no usable INS is in this topic: its orientations have no NavSatFix with them"),
      QT_TRANSLATE_NOOP("remount::model",
                        "no usable INS is in this topic: its orientations have no NavSatFix with them%1"),
      QT_TRANSLATE_NOOP("remount::model", "no usable INS is in this topic: none of its messages has an orientation"),
      QT_TRANSLATE_NOOP("remount::model", "no usable INS is in this topic: none of its messages has an orientation%1"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "no usable INS is in this topic: its orientation is never filled in, it is the identity throughout"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "no usable INS is in this topic: its orientation is never filled in, it is the identity throughout%1"),
      // messages
      QT_TRANSLATE_NOOP("remount::model", "messages of this topic are neither of ROS 1 nor in CDR"),
      QT_TRANSLATE_NOOP("remount::model",
                        "the message is serialised with representation %1, expected plain CDR: 0 or 1"),
      QT_TRANSLATE_NOOP("remount::model", "the message has %1 bytes, expected %2 more than it has after byte %3"),
      QT_TRANSLATE_NOOP("remount::model", "a sequence promises %1 items, the message has only %2 bytes left"),
      QT_TRANSLATE_NOOP("remount::model", "a field of the cloud has type %1, expected 1 to 8"),
      QT_TRANSLATE_NOOP("remount::model", "the cloud has %1 fields, at most 512 are read"),
      QT_TRANSLATE_NOOP("remount::model", "field %1 lies at byte %2 of a point of %3 bytes"),
      QT_TRANSLATE_NOOP("remount::model", "fields %1 and %2 lie on the same bytes of a point"),
      QT_TRANSLATE_NOOP("remount::model", "the coordinate %1 has one byte, expected two or more"),
      QT_TRANSLATE_NOOP("remount::model", "a row has %1 bytes, expected %2 for %3 points"),
      QT_TRANSLATE_NOOP("remount::model", "the cloud promises %1 rows of %2 bytes, %3 bytes are there"),
      QT_TRANSLATE_NOOP("remount::model", "the orientation is no quaternion of length 1"),
      QT_TRANSLATE_NOOP("remount::model", "the position is not finite"),
      QT_TRANSLATE_NOOP("remount::model", "the GPS time of week is not possible"),
      QT_TRANSLATE_NOOP("remount::model", "GPS week and time of week are no GPS time"),
      // chunks and records
      QT_TRANSLATE_NOOP("remount::model", "%1 bytes are promised, %2 are there"),
      QT_TRANSLATE_NOOP("remount::model", "%1: byte %2: %3 bytes are promised, %4 are there"),
      QT_TRANSLATE_NOOP("remount::model", "%1, field '%2': %3 bytes are promised, %4 are there"),
      QT_TRANSLATE_NOOP("remount::model", "%1 (unpacked chunk: byte %2): %3 bytes are promised, %4 are there"),
      QT_TRANSLATE_NOOP("remount::model", "a chunk is compressed with '%1', expected none, bz2, lz4 or zstd"),
      QT_TRANSLATE_NOOP("remount::model", "the compressed chunk is damaged: %1 of %2 bytes can be unpacked"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 bytes are expected here, the part of the file that holds them has %2 bytes in all"),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "%1: byte %2: %3 bytes are expected here, the part of the file that holds them has %4 bytes in all"),
      QT_TRANSLATE_NOOP("remount::model",
                        "%1 (unpacked chunk: byte %2): %3 bytes are expected here, the chunk holds %4 bytes in all"),
      QT_TRANSLATE_NOOP("remount::model", "%1 bytes are expected here, the chunk holds %2 bytes in all"),
      QT_TRANSLATE_NOOP("remount::model", "the checksum of the chunk does not agree with its bytes: it is damaged"),
      QT_TRANSLATE_NOOP("remount::model", "a chunk of %1 bytes does not fit a file of %2"),
      QT_TRANSLATE_NOOP("remount::model", "a chunk that is not compressed promises %1 bytes and has %2"),
      QT_TRANSLATE_NOOP("remount::model", "a chunk promises %1 bytes, at most %2 are taken from a file of this size"),
      QT_TRANSLATE_NOOP("remount::model", "the bag has too many chunks"),
      QT_TRANSLATE_NOOP("remount::model", "a record promises %1 bytes, at most %2 are read of its kind"),
      QT_TRANSLATE_NOOP("remount::model", "a record promises %1 bytes, %2 are there"),
      QT_TRANSLATE_NOOP("remount::model", "a record header promises %1 bytes, at most %2 are read"),
      QT_TRANSLATE_NOOP("remount::model", "no record begins with 0"),
      QT_TRANSLATE_NOOP("remount::model", "a record is too short"),
      QT_TRANSLATE_NOOP("remount::model", "a field of a record header has no '=', expected NAME=VALUE"),
      QT_TRANSLATE_NOOP("remount::model", "the record has no field '%1'"),
      QT_TRANSLATE_NOOP("remount::model", "a record is expected behind the end"),
      QT_TRANSLATE_NOOP("remount::model", "the index says a chunk begins here"),
      QT_TRANSLATE_NOOP("remount::model", "the index says a message begins here"),
      QT_TRANSLATE_NOOP("remount::model", "the index names a chunk twice"),
      QT_TRANSLATE_NOOP("remount::model", "the index names %1 of %2 chunks"),
      QT_TRANSLATE_NOOP("remount::model", "the index has another version than 1"),
      // MCAP
      QT_TRANSLATE_NOOP("remount::model", "is an MCAP of another version than 0"),
      QT_TRANSLATE_NOOP("remount::model", "is no MCAP"),
      QT_TRANSLATE_NOOP("remount::model", "it has no summary"),
      QT_TRANSLATE_NOOP("remount::model", "channel %1 is not described"),
      QT_TRANSLATE_NOOP("remount::model", "a chunk is longer than its record"),
      QT_TRANSLATE_NOOP("remount::model", "the file was not closed"),
      QT_TRANSLATE_NOOP("remount::model", "expected the footer of the file"),
      QT_TRANSLATE_NOOP("remount::model", "the checksum of the summary does not agree with its bytes"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The checksum of the data does not agree with the file. What is read of it may be wrong where "
                        "it has no checksum of its own."),
      QT_TRANSLATE_NOOP("remount::model",
                        "Attachments that do not agree with their checksums: %1. They are not used. First: %2."),
      QT_TRANSLATE_NOOP("remount::model", "a chunk reaches behind the end of the file"),
      QT_TRANSLATE_NOOP("remount::model", "the indexes of a chunk lie behind the end of the file"),
      QT_TRANSLATE_NOOP("remount::model",
                        "The bag has no usable index (%1). It was read from the beginning: %2 messages were found; %3 "
                        "bytes at the end are not readable."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The bag has no usable index (%1). It was read from the beginning: %2 messages were found; %3 "
                        "bytes at the end are not readable. First that cannot be read: %4."),
      QT_TRANSLATE_NOOP("remount::model", "the bag holds no readable message (%1)."),
      QT_TRANSLATE_NOOP("remount::model", "the bag holds no readable message (%1). First that cannot be read: %2."),
      // bags of ROS 1
      QT_TRANSLATE_NOOP("remount::model", "is a bag of an older version; 'rosbag fix' makes one of version 2.0"),
      QT_TRANSLATE_NOOP("remount::model", "is no bag of ROS 1"),
      QT_TRANSLATE_NOOP("remount::model", "expected the header of the bag"),
      QT_TRANSLATE_NOOP("remount::model", "the bag is encrypted"),
      QT_TRANSLATE_NOOP("remount::model", "it was not closed"),
      QT_TRANSLATE_NOOP("remount::model", "its index is damaged: %1"),
      QT_TRANSLATE_NOOP("remount::model", "a connection has no type"),
      QT_TRANSLATE_NOOP("remount::model", "connection %1 is not described"),
      QT_TRANSLATE_NOOP("remount::model", "It is readable to its end."),
      QT_TRANSLATE_NOOP("remount::model", "It is readable to its end. %1 chunks are damaged. First: %2"),
      QT_TRANSLATE_NOOP("remount::model", "It ends in the middle of a record."),
      QT_TRANSLATE_NOOP("remount::model", "It ends in the middle of a record. %1 chunks are damaged. First: %2"),
      QT_TRANSLATE_NOOP("remount::model", "The last %1 bytes are not readable: %2."),
      QT_TRANSLATE_NOOP(
          "remount::model",
          "The last %1 bytes are not readable: %2: byte %3: %4 bytes are expected here, but the file ends at byte %5."),
      QT_TRANSLATE_NOOP("remount::model",
                        "The last %1 bytes are not readable: %2: byte %3: %4 bytes are expected here, but the file "
                        "ends at byte %5. %6 chunks are damaged. First: %7"),
      QT_TRANSLATE_NOOP("remount::model", "The last %1 bytes are not readable: %2. %3 chunks are damaged. First: %4"),
      QT_TRANSLATE_NOOP("remount::model", "the bag holds no readable message (%1). %2"),
      // bags that are databases, and compressed ones
      QT_TRANSLATE_NOOP("remount::model",
                        "holds neither an MCAP nor an SQLite database when it is unpacked; unpack it with 'zstd -d' "
                        "and open what comes out"),
      QT_TRANSLATE_NOOP("remount::model",
                        "a compressed message becomes larger than %1 bytes, the most that is taken from a file of this "
                        "size"),
      QT_TRANSLATE_NOOP("remount::model", "the compressed message is damaged after %1 bytes"),
      QT_TRANSLATE_NOOP("remount::model", "the bag was not opened"),
      QT_TRANSLATE_NOOP("remount::model", "the database cannot be opened: %1"),
      QT_TRANSLATE_NOOP("remount::model", "is no bag of ROS 2: expected a table 'topics': %1"),
      QT_TRANSLATE_NOOP("remount::model", "is no bag of ROS 2: expected a table 'messages': %1"),
      QT_TRANSLATE_NOOP("remount::model", "database disk image is malformed"),
      QT_TRANSLATE_NOOP("remount::model", "file is not a database"),
      QT_TRANSLATE_NOOP("remount::model", "database is locked"),
      QT_TRANSLATE_NOOP("remount::model", "unable to open database file"),
      QT_TRANSLATE_NOOP("remount::model", "disk I/O error"),
      QT_TRANSLATE_NOOP("remount::model", "no such table: %1"),
      QT_TRANSLATE_NOOP("remount::model", "out of memory"),
      QT_TRANSLATE_NOOP("remount::model", "the file is shorter than the database"),
      QT_TRANSLATE_NOOP("remount::model", "the bag holds no readable message"),
      QT_TRANSLATE_NOOP("remount::model", "the bag holds no readable message: %1"),
      QT_TRANSLATE_NOOP("remount::model", "promises %1 bytes, more than the file has"),
      QT_TRANSLATE_NOOP("remount::model", "the compressed file is damaged here"),
      QT_TRANSLATE_NOOP("remount::model", "unpacks to more than %1, which no bag of this size does"),
      QT_TRANSLATE_NOOP("remount::model", "the compressed file was cut: its end is missing"),
  };
  return phrases;
}

}  // namespace remount

// What every export format offers, and the list of those that are built in.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/core/error.h"
#include "model/results/mounting_frames.h"
#include "model/results/result_file.h"
#include "model/results/vehicle_file.h"

namespace remount::results {

/// Names of frames, for formats that carry names; empty: the format's usual ones.
struct ExportNames {
  std::string ins_frame;
  std::string lidar_frame;                            ///< of the one LiDAR
  std::map<std::string, std::string> lidar_frames{};  ///< of several, by their names; the others': see usual_frame()
  std::string relative_to{};  ///< LiDAR in whose frame all others are (relative_to()); empty: in that of the INS
};

/// A transform of a file that holds several, by the name of its frame; empty where the file names none.
struct NamedTransform {
  std::string name;
  RigidTransform ins_from_lidar = RigidTransform::Identity();
};

class Exporter {
 public:
  virtual ~Exporter() = default;
  virtual std::string_view id() const = 0;  ///< "apollo": what the command line and the window call it
  virtual Message description() const = 0;  ///< one line for help
  /// Which way the numbers in the file go ("lidar to ins: point_in_ins = R point_in_lidar + t").
  virtual Message direction() const = 0;
  virtual std::string_view file_name() const = 0;  ///< the name under which the format's users look for it
  /// How surely a text that read() takes is of this format and means what read() returns, in per cent: where the format
  /// of a file is not given, the strictest reader is asked first. 0: never, for another format reads the same texts.
  virtual int strictness() const = 0;
  /// The whole file. States its direction, and what of X is not observed, where the format allows comments. Throws
  /// Error(Contract) that names the right format where this one would be wrong for the result's axes, or says that the
  /// result holds nothing for it.
  virtual std::string write(const ResultFile& result, const ExportNames& names) const = 0;
  /// Whether one file holds the LiDARs of a vehicle (SeveralExporter); of other formats each has a file of its own.
  virtual bool holds_several() const { return false; }
  /// Whether its files say in which frame the LiDARs are, which may then be that of one of them.
  virtual bool names_frames() const { return false; }
  /// The whole file of all LiDARs of a vehicle, as write(). Throws Error(Contract) as well where the format does not
  /// hold several, and where two frames are called alike.
  virtual std::string write_all(const VehicleFile& vehicle, const ExportNames& names) const;
  /// All that a text of this format holds. Throws Error(Format).
  virtual std::vector<NamedTransform> read_all(std::string_view text, const std::string& where) const {
    return {{"", read(text, where)}};
  }
  /// False where the format holds something else of a result; read() says then what it is.
  virtual bool holds_mounting() const { return true; }
  /// Throws Error(Format) for a text that is not of this format.
  virtual void require_own(std::string_view text, const std::string& where) const { (void)read(text, where); }
  /// ins_from_lidar of a text that write() made, or that other programs made in the same format. `where` is named in
  /// errors. Throws Error(Format).
  virtual RigidTransform read(std::string_view text, const std::string& where) const = 0;
  /// INS axes of what read() returns; nothing where the text does not say and read() did not turn it.
  virtual std::optional<drive::InsAxes> axes(std::string_view /*text*/) const { return {}; }
  /// What a text of this format leaves open and read() had to suppose, with what to do about it; usually nothing.
  virtual Message doubt(std::string_view /*text*/) const { return {}; }
};

/// The built-in exporters. Adding one: a file in this folder, and its maker in the list of exporters.cpp.
const std::vector<std::unique_ptr<Exporter>>& exporters();

/// Throws Error(Contract) that lists the known ids where there is none of that name.
const Exporter& exporter(std::string_view id);

/// A slip of the hand must not cost a recording or a calibration: throws Error(Contract) where `path` is a file that
/// holds something and is no export in this format. One of several mountings has to say that Remount wrote it.
void check_replaces_export(const std::filesystem::path& path, const Exporter& format);

/// Sentences that a user must read before using an export: the status, and each parameter that is not observed and
/// therefore holds the nominal value, not a measurement. Empty for a result that is observed in full.
std::vector<Message> export_warnings(const calibration::CalibrationResult& result);

/// The transform of x, y, z (m), yaw, pitch, roll (degrees) as people type them. Throws Error(`code`) at `where` for an
/// angle beyond a whole turn, which is a typing error or another unit.
RigidTransform rigid_from_typed(const std::array<double, 6>& six, const std::string& where, ErrorCode code);

/// A mounting from outside, in INS axes that are known or not.
struct ReadMounting {
  RigidTransform ins_from_lidar = RigidTransform::Identity();
  std::optional<drive::InsAxes> axes;
  calibration::MountingFrames frames;  ///< as far as the file says; of most formats: of the LiDAR in the INS frame
};

/// What the text of an export says of its frames, where its format has room for remarks. Throws Error(Format) at
/// `where` for a frame that is none.
calibration::MountingFrames frames_told_in(const std::string& text, const std::string& where);

/// The mounting of a file in any of the formats (a result, an export, or six numbers x,y,z,yaw,pitch,roll in m and
/// degrees), recognised by its content. What the file leaves open is added to `doubts`. Throws Error that says what was
/// tried.
ReadMounting read_any_mounting(const std::filesystem::path& path, std::vector<Message>* doubts = nullptr);

/// A mounting of a file that may hold several, by the name of its frame or its LiDAR; empty: the only one.
struct NamedMounting {
  std::string name;
  ReadMounting mounting;
};

/// All mountings of a file in any of the formats, recognised by its content. Of the LiDARs of a vehicle those that have
/// a usable result. Throws Error as read_any_mounting.
std::vector<NamedMounting> read_any_mountings(const std::filesystem::path& path,
                                              std::vector<Message>* doubts = nullptr);

/// The same of a file in a format that is known.
ReadMounting read_mounting_as(const Exporter& format, const std::filesystem::path& path,
                              std::vector<Message>* doubts = nullptr);
std::vector<NamedMounting> read_mountings_as(const Exporter& format, const std::filesystem::path& path);

/// The mounting in the axes of sessions, turned where both are known and differ; then a sentence is added to `doubts`.
/// One that is not in the INS frame has nothing to turn.
RigidTransform in_axes_of(const ReadMounting& mounting, const std::optional<drive::InsAxes>& axes,
                          std::vector<Message>& doubts);

}  // namespace remount::results

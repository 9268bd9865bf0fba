// NMEA 0183 logs of a GNSS receiver: positions (GGA, GST), time (RMC, ZDA), attitude where there is any (PASHR; of two
// antennas PTNL,AVR, PSAT,HPR, PSSN,HRP; headings HDT and THS), and sentences that have all of it (KSXT, FPD, CHC).
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "model/drive/session.h"

namespace remount::formats {

struct NmeaLog {
  std::vector<motion::GnssFix> fixes;  ///< of every GGA with a fix
  std::vector<motion::InsSample> ins;  ///< the same positions with attitude; empty where the log has no heading
  double position_lag_sigma_s = 0.0;   ///< see Session::ins_position_lag_sigma_s
};

/// From the first lines. Never throws.
bool recognise_nmea(const std::filesystem::path& path);

/// Of several fixes of one time the best by its quality, whoever wrote it, and in whatever order. Where the INS writes
/// its own position beside the attitude (FPD, CHC), that one alone.
/// Heading from true north clockwise, pitch positive nose up, roll positive right side down; INS axes forward-left-up.
/// Attitudes are interpolated to the times of the positions; nothing is where neither is near, with a warning. With HDT
/// alone, whose times HeadingPlaces finds, roll and pitch are taken to be zero, with a warning. Sentences whose
/// checksum is wrong and lines that cannot be read become a finding. Errors of positions are those of GST; without it
/// what the quality of a fix usually means. Throws Error(Io), Error(Format) where there is no usable fix or no date.
NmeaLog read_nmea(const std::filesystem::path& path, std::vector<drive::Finding>& findings);
/// The same of a text that was read already; `path` is for messages.
NmeaLog parse_nmea_log(std::string_view text, const std::filesystem::path& path, std::vector<drive::Finding>& findings);

}  // namespace remount::formats

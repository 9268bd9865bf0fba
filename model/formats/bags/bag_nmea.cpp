#include "model/formats/bags/bag_nmea.h"

#include <utility>

#include "algorithms/core/error.h"
#include "model/drive/bad_items.h"
#include "model/formats/ins/nmea_log.h"

namespace remount::bags {
namespace {

formats::NmeaLog read_sentences(const std::string& sentences, const std::string& where,
                                std::vector<drive::Finding>& findings) {
  try {
    return formats::parse_nmea_log(sentences, where, findings);
  } catch (const Error& error) {
    findings.push_back(drive::make_finding(drive::Severity::Warning, "bad-nmea", where, error.what_happened()));
    return {};
  }
}

}  // namespace

void add_nmea_ins(const std::string& sentences, const std::string& where, drive::Session& session) {
  formats::NmeaLog log = read_sentences(sentences, where, session.findings);
  session.ins = std::move(log.ins);
  session.ins_position_lag_sigma_s = log.position_lag_sigma_s;
}

void add_nmea_fixes(const std::string& sentences, const std::string& where, bool told, drive::Session& session) {
  std::vector<drive::Finding> told_already;
  session.gnss = read_sentences(sentences, where, told ? told_already : session.findings).fixes;
}

}  // namespace remount::bags

#include "model/formats/packets/receiver_fixes.h"

#include "algorithms/core/error.h"
#include "messages/captures.h"
#include "model/drive/bad_items.h"
#include "model/formats/ins/nmea_log.h"

namespace remount::formats {

void take_receiver(const SensorReceiver& receiver, const std::filesystem::path& where, drive::Session& session) {
  if (receiver.sentences.empty() || !session.gnss.empty()) return;
  try {
    std::vector<drive::Finding> findings;
    session.gnss = parse_nmea_log(receiver.sentences, where, findings).fixes;
    session.findings.insert(session.findings.end(), findings.begin(), findings.end());
  } catch (const Error& error) {
    if (!session.ins.empty() || !session.world_from_ins.empty()) return;  // the fixes are not missed
    session.findings.push_back(drive::make_finding(drive::Severity::Note, "capture-position", where.string(),
                                                   say::capture_position_packets(error.what_happened())));
  }
}

}  // namespace remount::formats

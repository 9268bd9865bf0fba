#include "model/formats/bags/bag_novatel.h"

#include <algorithm>

#include "messages/ins_logs.h"
#include "model/drive/bad_items.h"
#include "model/formats/bags/correction_status.h"

namespace remount::bags {
namespace {

/// Errors that the INS states beside INSPVA, ascending.
std::vector<formats::StampedSigma> stated_beside(const InspvaxStream& inspvax, const InsstdevStream& insstdev) {
  std::vector<formats::StampedSigma> errors = insstdev.messages;
  std::erase_if(errors, [](const formats::StampedSigma& stated) { return !formats::states_any(stated.sigma); });
  for (const InspvaxMessage& message : inspvax.messages)
    if (message.sample.quality != motion::InsQuality::Invalid)  // it states zeros then
      errors.push_back({message.sample.stamp_ns, message.sample.sigma});
  std::ranges::stable_sort(errors, {}, &formats::StampedSigma::stamp_ns);
  return errors;
}

/// What of INSPVA has errors, and whose.
void tell_errors_beside(std::size_t samples, std::size_t without, const InspvaxStream& inspvax,
                        const InsstdevStream& insstdev, const std::string& where,
                        std::vector<drive::Finding>& findings) {
  constexpr Duration kNear{static_cast<double>(formats::kNearErrors_ns) * 1e-9};
  std::vector<Message> told{say::novatel_taken("INSPVA", samples)};
  std::vector<std::string> logs;
  if (!inspvax.messages.empty()) logs.emplace_back("INSPVAX");
  if (!insstdev.messages.empty()) logs.emplace_back("INSSTDEV");
  told.push_back(without == samples ? say::novatel_no_errors(kNear) : say::novatel_errors_of(std::move(logs), kNear));
  if (without > 0 && without < samples) told.push_back(say::novatel_errors_missing(without));
  findings.push_back(
      drive::make_finding(drive::Severity::Note, "ins-log-chosen", where, Message::sequence(std::move(told))));
}

/// What of GSOF 49 has no errors, where that is so.
void tell_gsof_errors_missing(std::size_t samples, std::size_t without, const std::string& where,
                              std::vector<drive::Finding>& findings) {
  if (without == 0) return;
  constexpr Duration kNear{static_cast<double>(formats::kNearErrors_ns) * 1e-9};
  std::vector<Message> told{say::novatel_taken("GSOF 49", samples),
                            without == samples ? say::gsof_no_errors(kNear) : say::gsof_errors_of(kNear)};
  if (without < samples) told.push_back(say::novatel_errors_missing(without));
  findings.push_back(
      drive::make_finding(drive::Severity::Note, "ins-log-chosen", where, Message::sequence(std::move(told))));
}

}  // namespace

std::vector<motion::InsSample> ins_from_inspvax(const BagStreams& streams, MessageKind kind, const std::string& where,
                                                std::vector<drive::Finding>& findings) {
  const InspvaxStream &stream = streams.inspvax, &beside = streams.inspvax_beside;
  std::vector<motion::InsSample> ins;
  std::vector<CorrectionStatus> positions;
  std::size_t misnamed = 0;
  for (const InspvaxMessage& message : stream.messages) {
    ins.push_back(message.sample);
    misnamed += message.misnamed;
    if (beside.messages.empty()) positions.push_back(correction_status(message));
  }
  for (const InspvaxMessage& message : beside.messages) positions.push_back(correction_status(message));
  report_lost_corrections(positions, where, findings);
  formats::report_misnamed(misnamed, where, findings);
  if (kind == MessageKind::Gsof49) {
    const std::size_t missing = formats::give_errors(ins, stated_beside({}, streams.insstdev));
    tell_gsof_errors_missing(ins.size(), missing, where, findings);
  }
  if (kind != MessageKind::Inspva || ins.empty()) return ins;
  const std::size_t without = formats::give_errors(ins, stated_beside(beside, streams.insstdev));
  tell_errors_beside(ins.size(), without, beside, streams.insstdev, where, findings);
  return ins;
}

}  // namespace remount::bags

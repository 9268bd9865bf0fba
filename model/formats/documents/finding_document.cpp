#include "model/formats/documents/finding_document.h"

#include <string>

#include "model/formats/documents/notations.h"

namespace remount {
namespace {

/// By name; projects of earlier versions hold numbers.
struct SeverityNotation {
  DocumentNode write(Severity severity) const { return DocumentNode::string(to_string(severity)); }
  void read(const DocumentView& view, Severity& severity) const {
    const std::string& text = view.node().text;
    const bool is_number = !text.empty() && text.front() >= '0' && text.front() <= '9';
    if (is_number)
      Whole{0, 2}.read(view, severity);
    else
      OneOf{{to_string(Severity::Note), to_string(Severity::Warning), to_string(Severity::Problem)}}.read(view,
                                                                                                          severity);
  }
};

/// A part of the data by its code, beside its English words; a name as it is.
struct PlaceNotation {
  DocumentNode write(const Place& where) const {
    DocumentNode keys = DocumentNode::map();
    keys.add("where", DocumentNode::string(english(where)));
    const Message& words = where.words();
    if (!words.empty() && where.name() == nullptr) keys.add("place", DocumentNode::string(words.code()));
    return keys;
  }
  void read(const DocumentView& finding, Place& where) const {
    if (finding.has("place"))
      where = Message(finding.at("place").string(), {});
    else
      where = finding.at("where").string();
  }
};

}  // namespace

void describe(RecordOf<Finding> auto& finding, auto& fields) {
  fields("code", finding.code);
  fields("severity", finding.severity, SeverityNotation());
  fields.spread(finding.where, PlaceNotation());
  fields("explanation", finding.explanation);
}

namespace {

/// Results of the first version hold sentences alone.
Finding finding_from_document(const DocumentView& view) {
  Finding finding;
  if (view.is_map())
    read_fields(view, finding);
  else
    finding = {Severity::Warning, "", {}, message_from_document(view)};
  return finding;
}

constexpr ListOf kFindings{Through{written<Finding>, finding_from_document}};

}  // namespace

DocumentNode findings_document(const std::vector<Finding>& findings) { return kFindings.write(findings); }

std::vector<Finding> findings_from_document(const DocumentView& list) {
  std::vector<Finding> findings;
  kFindings.read(list, findings);
  return findings;
}

}  // namespace remount

#include "model/formats/documents/finding_document.h"

#include <string>

#include "model/formats/documents/notations.h"

namespace remount::formats {
namespace {

/// By name; projects of earlier versions hold numbers.
struct SeverityNotation {
  DocumentNode write(drive::Severity severity) const { return DocumentNode::string(to_string(severity)); }
  void read(const DocumentView& view, drive::Severity& severity) const {
    const std::string& text = view.node().text;
    const bool is_number = !text.empty() && text.front() >= '0' && text.front() <= '9';
    if (is_number)
      Whole{0, 2}.read(view, severity);
    else
      OneOf{
          {to_string(drive::Severity::Note), to_string(drive::Severity::Warning), to_string(drive::Severity::Problem)}}
          .read(view, severity);
  }
};

/// A part of the data by its code, beside its English words; a name as it is.
struct PlaceNotation {
  DocumentNode write(const drive::Place& where) const {
    DocumentNode keys = DocumentNode::map();
    keys.add("where", DocumentNode::string(drive::english(where)));
    const Message& words = where.words();
    if (!words.empty() && where.name() == nullptr) keys.add("place", DocumentNode::string(words.code()));
    return keys;
  }
  void read(const DocumentView& finding, drive::Place& where) const {
    if (finding.has("place"))
      where = Message(finding.at("place").string(), {});
    else
      where = finding.at("where").string();
  }
};

}  // namespace

void describe(RecordOf<drive::Finding> auto& finding, auto& fields) {
  fields("code", finding.code);
  fields("severity", finding.severity, SeverityNotation());
  fields.spread(finding.where, PlaceNotation());
  fields("explanation", finding.explanation);
}

namespace {

/// Results of the first version hold sentences alone.
drive::Finding finding_from_document(const DocumentView& view) {
  drive::Finding finding;
  if (view.is_map())
    read_fields(view, finding);
  else
    finding = {drive::Severity::Warning, "", {}, message_from_document(view)};
  return finding;
}

constexpr ListOf kFindings{Through{document_of<drive::Finding>, finding_from_document}};

}  // namespace

DocumentNode findings_document(const std::vector<drive::Finding>& findings) { return kFindings.write(findings); }

std::vector<drive::Finding> findings_from_document(const DocumentView& list) {
  std::vector<drive::Finding> findings;
  kFindings.read(list, findings);
  return findings;
}

}  // namespace remount::formats

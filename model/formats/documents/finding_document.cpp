#include "model/formats/documents/finding_document.h"

#include <string>
#include <string_view>

#include "algorithms/messages/catalogue.h"
#include "model/formats/documents/message_document.h"

namespace remount {
namespace {

Severity severity_from_document(const DocumentView& view) {
  std::vector<std::string_view> names;
  for (const Severity severity : {Severity::Note, Severity::Warning, Severity::Problem})
    names.push_back(to_string(severity));
  const std::string& text = view.node().text;
  const bool is_number = !text.empty() && text.front() >= '0' && text.front() <= '9';
  return static_cast<Severity>(is_number ? view.integer(0, 2) : static_cast<std::int64_t>(view.choice(names)));
}

/// A part of the data by its code; a name as it is.
Place place_from_document(const DocumentView& finding) {
  if (finding.has("place")) return Message(finding.at("place").string(), {});
  return finding.at("where").string();
}

}  // namespace

DocumentNode findings_document(const std::vector<Finding>& findings) {
  DocumentNode list = DocumentNode::sequence();
  for (const Finding& finding : findings) {
    DocumentNode& node = list.add(DocumentNode::map());
    node.add("code", DocumentNode::string(finding.code));
    node.add("severity", DocumentNode::string(to_string(finding.severity)));
    node.add("where", DocumentNode::string(english(finding.where)));
    const Message& words = finding.where.words();
    if (!words.empty() && finding.where.name() == nullptr) node.add("place", DocumentNode::string(words.code()));
    node.add("explanation", message_document(finding.explanation));
  }
  return list;
}

std::vector<Finding> findings_from_document(const DocumentView& list) {
  std::vector<Finding> findings;
  for (const DocumentView& item : list.items()) {
    if (item.is_map())
      findings.push_back({severity_from_document(item.at("severity")), item.at("code").string(),
                          place_from_document(item), message_from_document(item.at("explanation"))});
    else
      findings.push_back({Severity::Warning, "", {}, message_from_document(item)});
  }
  return findings;
}

}  // namespace remount

// Between the workbench and the methods: what that of the result tells, and how results compare.
#pragma once

#include <QObject>
#include <map>
#include <vector>

#include "app/gui/workbench/workbench.h"
#include "model/report/comparison.h"

namespace remount::widgets {
class ComparisonView;
class MethodView;
class PathView;
}  // namespace remount::widgets

namespace remount::gui {

/// Results that are compared, whatever is calibrated next.
struct KeptResults {
  using OfMethods = std::map<std::string, report::NamedResult>;
  OfMethods of_methods;  ///< the last usable result of each, by the method's id
  std::vector<report::NamedResult> of_files;
  /// Those of sessions that were open before, and are again where that is undone.
  struct OfSessions {
    std::vector<std::weak_ptr<const drive::Session>> sessions;
    OfMethods of_methods;
  };
  std::vector<OfSessions> before;
};

class MethodController : public QObject {
  Q_OBJECT
 public:
  MethodController(Workbench& workbench, widgets::MethodView& view, widgets::PathView& paths,
                   widgets::ComparisonView& comparison, QObject* parent = nullptr);
  /// Result files that are to stand beside the results of this window.
  void add_files(const QStringList& paths);
  void clear_files();
  const KeptResults& compared() const { return compared_; }
  /// Those of a window whose place this one takes; named in the language of this one.
  void take_over(KeptResults compared);

 private:
  void change_sessions();
  void show_output();
  void show_comparison();

  Workbench& workbench_;
  widgets::MethodView& view_;
  widgets::PathView& paths_;
  widgets::ComparisonView& comparison_;
  KeptResults compared_;                                         // its methods': of the sessions that are open
  std::vector<std::shared_ptr<const drive::Session>> sessions_;  // that these are of
  OutputPtr shown_;
};

}  // namespace remount::gui

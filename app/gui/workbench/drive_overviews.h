// How the sessions look from above and over time.
#pragma once

#include <map>
#include <vector>

#include "app/gui/workbench/session_list.h"
#include "model/overview/drive_overview.h"

namespace remount::gui {

/// Holds an overview of every session that is open; found out in the background, one look after the other.
class DriveOverviews : public WorkbenchPart {
  Q_OBJECT
 public:
  DriveOverviews(const Desk& desk, SessionList& sessions);
  /// Of each session; null where that is still being found out.
  std::vector<std::shared_ptr<const overview::DriveOverview>> all() const;

 signals:
  void changed();

 private:
  void look();
  SessionList& sessions_;
  std::map<SessionPtr, std::shared_ptr<const overview::DriveOverview>> known_;
  int job_ = 0;
};

}  // namespace remount::gui

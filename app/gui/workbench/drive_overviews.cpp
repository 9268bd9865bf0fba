#include "app/gui/workbench/drive_overviews.h"

#include "widgets/text/model_text.h"

namespace remount::gui {

DriveOverviews::DriveOverviews(const Desk& desk, SessionList& sessions) : WorkbenchPart(desk), sessions_(sessions) {
  connect(&sessions_, &SessionList::changed, this, &DriveOverviews::look);
}

std::vector<std::shared_ptr<const overview::DriveOverview>> DriveOverviews::all() const {
  std::vector<std::shared_ptr<const overview::DriveOverview>> found;
  for (const auto& session : sessions_.all()) {
    const auto known = known_.find(session);
    found.push_back(known == known_.end() ? nullptr : known->second);
  }
  return found;
}

void DriveOverviews::look() {
  std::erase_if(known_, [this](const auto& known) { return !sessions_.place_of(known.first); });
  emit changed();
  if (desk_.jobs.running(job_)) return;  // it looks again when it is done
  std::vector<SessionPtr> unknown;
  for (const auto& session : sessions_.all())
    if (!known_.contains(session)) unknown.push_back(session);
  if (unknown.empty()) return;
  job_ = desk_.jobs.start(
      [this, unknown](Progress& progress) -> JobRunner::Deliver {
        std::vector<std::shared_ptr<const overview::DriveOverview>> found;
        for (const auto& session : unknown)
          if (!progress.cancelled())
            found.push_back(std::make_shared<const overview::DriveOverview>(overview::drive_overview(*session)));
        return [this, unknown, found] {
          for (std::size_t i = 0; i < found.size(); ++i) {
            known_[unknown[i]] = found[i];
            for (const drive::Finding& finding : found[i]->findings)
              desk_.notices.log(finding.severity, widgets::model_text(finding.where.words()),
                                widgets::model_text(finding.explanation));
          }
          if (found.size() == unknown.size()) look();
        };
      },
      [this, unknown](const JobFailure& failure) {
        // Said once; the drive has no map then.
        for (const auto& session : unknown) known_[session] = nullptr;
        desk_.notices.log(drive::Severity::Warning, failure.where, failure.what);
      });
}

}  // namespace remount::gui

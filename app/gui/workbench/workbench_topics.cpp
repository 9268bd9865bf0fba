// Which topics of a bag a session is made of: asked before it is opened, and changed afterwards.
#include <algorithm>

#include "algorithms/core/error.h"
#include "app/gui/workbench/edit_commands.h"
#include "app/gui/workbench/workbench.h"

namespace remount {
namespace {

/// The topic of a role as the session has it; empty for none.
std::string topic_of(const Session& session, std::string_view role) {
  const TopicChoice used = choice_in_use(session.topics);
  const auto found = used.find(role);
  return found == used.end() ? std::string() : found->second;
}

}  // namespace

Workbench::Opened Workbench::open_or_ask(const Engine& engine, const std::filesystem::path& path, Progress& progress) {
  std::optional<TopicOffer> offer = engine.offer_topics ? engine.offer_topics(path, progress) : std::nullopt;
  if (offer && is_ambiguous(offer->topics)) return {nullptr, std::move(offer), {}, {}, {}};
  return {std::make_shared<const Session>(offer ? offer->open({}, progress) : engine.open(path, {}, progress)),
          {},
          {},
          {},
          {}};
}

void Workbench::open_chosen(const std::vector<ChosenOffer>& offers) {
  std::vector<ToOpen> wanted;
  for (const ChosenOffer& chosen : offers)
    wanted.push_back(
        {chosen.offer.path, [chosen](Progress& progress) {
           return Opened{std::make_shared<const Session>(chosen.offer.open(chosen.choice, progress)), {}, {}, {}, {}};
         }});
  open_all(std::move(wanted));
}

void Workbench::list_topics(int session) {
  if (session < 0 || static_cast<std::size_t>(session) >= sessions_.size() || !engine_.offer_topics) return;
  if (opening() || calibrating()) {
    emit message(Severity::Warning, {},
                 tr("Wait until the present work is done, or cancel it, before choosing other topics."));
    return;
  }
  open_job_ = jobs_.start(
      [this, asked = sessions_[static_cast<std::size_t>(session)],
       offer_topics = engine_.offer_topics](Progress& progress) -> JobRunner::Deliver {
        std::optional<TopicOffer> offer = offer_topics(asked->path, progress);
        if (progress.cancelled()) return {};
        if (!offer)
          throw Error(ErrorCode::Unsupported, asked->path.string(), tr("offers no topics any more").toStdString());
        for (OfferedTopic& offered : offer->topics) {
          offered.topic.used_as.clear();
          for (const SessionTopic& used : asked->topics)
            if (used.name == offered.topic.name && used.type == offered.topic.type)
              offered.topic.used_as = used.used_as;
        }
        return [this, asked, topics = offer->topics] {
          const auto place = std::find(sessions_.begin(), sessions_.end(), asked);
          if (place != sessions_.end()) emit topics_listed(static_cast<int>(place - sessions_.begin()), topics);
        };
      },
      report_failure());
  emit state_changed();
}

void Workbench::choose_topics(int session, const TopicChoice& choice) {
  if (session < 0 || static_cast<std::size_t>(session) >= sessions_.size()) return;
  if (opening() || calibrating()) {
    emit message(Severity::Warning, {},
                 tr("Wait until the present work is done, or cancel it, before choosing other topics."));
    return;
  }
  const std::shared_ptr<const Session> from = sessions_[static_cast<std::size_t>(session)];
  if (choice == choice_in_use(from->topics)) return;
  open_job_ = jobs_.start(
      [this, from, choice, open = engine_.open](Progress& progress) -> JobRunner::Deliver {
        const auto to = std::make_shared<const Session>(open(from->path, choice, progress));
        if (progress.cancelled()) return {};
        return [this, from, to] {
          if (std::find(sessions_.begin(), sessions_.end(), from) == sessions_.end()) return;
          const bool calibrated = output_ != nullptr;
          undo_.push(new TopicsCommand(*this, from, to));
          tell_findings(*to);
          emit message(Severity::Note, QString::fromStdString(to->path.string()),
                       calibrated ? tr("opened with other topics. Its result belonged to the former ones: calibrate "
                                       "(F5), or undo (Ctrl+Z) to have it back.")
                                  : tr("opened with other topics"));
        };
      },
      report_failure());
  emit state_changed();
}

void Workbench::leave_topics_of(const Session& from, const Session& to) {
  // Scans are known by their stamps, which those of another topic may have as well.
  if (topic_of(from, "lidar") != topic_of(to, "lidar"))
    std::erase_if(decisions_, [&](const auto& made) { return std::get<0>(made.first) == to.path.string(); });
  // A nominal that came from the transforms between the former frames is not one between these.
  if (nominal_ins_from_lidar_ && from.nominal_ins_from_lidar &&
      nominal_ins_from_lidar_->isApprox(*from.nominal_ins_from_lidar))
    nominal_ins_from_lidar_ = to.nominal_ins_from_lidar;
}

}  // namespace remount

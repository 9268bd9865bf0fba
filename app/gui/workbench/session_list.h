// The sessions that are open.
#pragma once

#include <QStringList>
#include <functional>
#include <optional>
#include <vector>

#include "app/gui/workbench/calibrated.h"
#include "app/gui/workbench/part.h"
#include "model/drive/session.h"
#include "model/drive/topic_offer.h"

namespace remount::gui {

class Setup;

/// A recording of topics, and which of them were chosen.
struct ChosenOffer {
  drive::TopicOffer offer;
  drive::TopicChoice choice;
};

/// Holds the sessions, and opens them: several at once, in the background, and not the same recording twice. Opening is
/// an edit that can be undone; sessions that a result may rest on come and go by SessionEdits.
class SessionList : public WorkbenchPart {
  Q_OBJECT
 public:
  SessionList(const Desk& desk, Setup& setup);

  const std::vector<SessionPtr>& all() const { return sessions_; }
  bool empty() const { return sessions_.empty(); }
  QStringList names() const;
  bool holds(motion::SessionIndex session) const { return session < sessions_.size(); }
  /// Its place now; nothing where it is not open any more.
  std::optional<motion::SessionIndex> place_of(const SessionPtr& session) const;

  /// Where topics have to be chosen first, topics_asked says so.
  void open(const QStringList& paths);
  /// The answer to topics_asked.
  void open_chosen(const std::vector<ChosenOffer>& offers);
  void forget_waiting() { waiting_.clear(); }  ///< those that are to be opened after the present ones
  void tell_findings(const drive::Session& session);

  // Steps of undo commands: sessions that nothing was calibrated from yet come and go.
  void apply_opening(const std::vector<SessionPtr>& sessions);
  void apply_closing(const std::vector<SessionPtr>& sessions);

  void put(std::vector<SessionPtr> sessions) { sessions_ = std::move(sessions); }
  void put_instead(motion::SessionIndex place, const SessionPtr& session) { sessions_.at(place) = session; }
  void put_back(const SessionPtr& session, motion::SessionIndex place);
  void take_away(const SessionPtr& session) { std::erase(sessions_, session); }
  void announce() { emit changed(); }
  /// Those beside what is calibrated, which stays, are others.
  void announce_beside_result();

 signals:
  void changed();
  void session_opened(const QString& path);
  /// These cannot be opened before somebody has said which of their topics are meant.
  void topics_asked(const std::vector<drive::TopicOffer>& offers);
  /// No reader knows what was to be opened; it was said so.
  void not_recognised(const QString& path);
  /// It was opened and is a log of the INS or of GNSS alone; it was said so.
  void half_opened(const QString& path);
  /// A folder that was to be opened is no session, but holds these: somebody has to say which are meant.
  void found_below(const QString& folder, const QStringList& paths);

 private:
  /// What became of a path that was to be opened: one of the first four.
  struct Opened {
    SessionPtr session;
    std::optional<drive::TopicOffer> question;
    JobFailure failure;
    bool unknown = false;  ///< the failure is that no reader knows it
    QStringList below;     ///< a folder of sessions: these
    QString copy_of;       ///< the session is the same recording as this one, which is open
  };
  struct ToOpen {
    std::filesystem::path path;
    std::function<Opened(Progress&)> open;
  };
  static void find_copies(const Engine& engine, const std::vector<SessionPtr>& open, std::vector<Opened>& opened,
                          const Progress& progress);
  static Opened open_or_ask(const Engine& engine, const std::filesystem::path& path, Progress& progress);
  void open_all(std::vector<ToOpen> wanted);  ///< or later, where others are being opened
  void take_opened(std::vector<Opened> opened);
  /// Says so where it is, or among those that are opened with it.
  bool is_open(const std::filesystem::path& path, const std::vector<SessionPtr>& opened_now);
  void add(const std::vector<SessionPtr>& opened);
  void say_several_failed(const std::vector<JobFailure>& failures);

  Setup& setup_;
  std::vector<SessionPtr> sessions_;
  std::vector<ToOpen> waiting_;
};

}  // namespace remount::gui

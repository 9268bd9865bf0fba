// The controller: owns sessions, settings, pairs and result; runs jobs; everything the window does goes through it.
#pragma once

#include <QObject>
#include <QStringList>
#include <QTimer>
#include <QUndoStack>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "app/gui/jobs/engine.h"
#include "app/gui/jobs/job_runner.h"
#include "app/gui/workbench/lock_keeper.h"
#include "model/drive/session.h"
#include "model/overview/drive_overview.h"
#include "model/project/holder_lock.h"
#include "model/project/project.h"
#include "model/results/result_file.h"

namespace remount {

using OutputPtr = std::shared_ptr<const PipelineOutput>;
using CloudsPtr = std::shared_ptr<const PairClouds>;

/// What became of the present result outside of the project: what was copied may be pasted nowhere.
enum class Exported { No, Copied, Written };

/// What is known of a pair's fate; enough to take a decision back.
struct PairDecision {
  int pair = 0;
  PairState state = PairState::Proposed;
  DecidedBy decided_by = DecidedBy::Nobody;
  Message reason;
};

/// What the user works on at a moment, as it is saved: a value that a worker may write to a file.
struct ProjectSnapshot {
  Project project;   ///< without its output
  OutputPtr output;  ///< null before the first calibration
  int revision = 0;  ///< of the workbench
};
/// Writes it; throws Error(Io). Nothing of it is copied on the thread that took the snapshot.
void write_snapshot(ProjectSnapshot snapshot, const QString& path);

/// A project that is to be opened, and how.
struct ProjectToOpen {
  enum class Access {
    Own,       ///< to be saved again: nobody else may have it open
    ReadOnly,  ///< saving asks for another name
    Copy,      ///< as work that has no file yet
    TakeOver,  ///< as Own, from a holder that is gone
  };
  QString path;
  bool recovered = false;  ///< an autosave: what is opened belongs to `belongs_to` and is not saved yet
  QString belongs_to;      ///< of an autosave: the project's own path; empty where it never had one
  std::map<std::string, std::filesystem::path> moved;  ///< sessions that lie elsewhere now, by the path in the file
  bool without_missing = false;                        ///< sessions that are nowhere are left out
  Access access = Access::Own;
};

/// A recording of topics, and which of them were chosen.
struct ChosenOffer {
  TopicOffer offer;
  TopicChoice choice;
};

class Workbench : public QObject {
  Q_OBJECT
 public:
  explicit Workbench(Engine engine, QObject* parent = nullptr);
  Workbench(Engine engine, std::unique_ptr<LockKeeper> locks, QObject* parent = nullptr);

  const std::vector<std::shared_ptr<const Session>>& sessions() const { return sessions_; }
  QStringList session_names() const;
  /// How each session looks from above and over time; null where that is still being found out.
  std::vector<std::shared_ptr<const DriveOverview>> overviews() const;
  const Settings& settings() const { return settings_; }
  const std::optional<RigidTransform>& nominal_ins_from_lidar() const { return nominal_ins_from_lidar_; }
  OutputPtr output() const { return output_; }  ///< null before the first calibration
  /// What the present result is compared with: the one before the edits `moved_by`, solved from pairs as it is itself.
  OutputPtr output_before() const { return output_before_; }
  const QString& moved_by() const { return moved_by_; }  ///< "reject pair 12"; empty after a calibration
  int selected_pair() const { return selected_; }        ///< -1 for none
  bool opening() const { return jobs_.running(open_job_); }
  bool calibrating() const { return jobs_.running(run_job_); }
  bool solving() const { return jobs_.running(solve_job_); }
  /// X of the output answers the last decision already; sigmas, candidates and the judgement of other pairs follow.
  bool refining() const { return solving() && refining_; }
  /// The result does not answer every decision in full, and nothing under way will: the solution was cancelled or
  /// failed.
  bool incomplete() const { return output_ != output_solved_ && !solving(); }
  /// What is set now and was not so for the result that is shown, in words, one for each: calibrate again. What a
  /// solution under way will take up is not among them.
  QStringList changes_since_output() const;
  bool out_of_date() const { return !changes_since_output().isEmpty(); }
  const Message& stage() const { return stage_; }  ///< of the running calibration
  Exported exported() const { return exported_; }
  bool confirmed() const { return confirmed_; }  ///< the user said that this result is good
  /// Goes up with every other X; what only another map check or other words change keeps it.
  int solution() const { return solution_; }
  /// The map check of a new X is under way, or begins soon.
  bool checking_map() const { return map_pause_.isActive() || jobs_.running(map_job_); }
  const QString& map_failure() const { return map_failure_; }  ///< why the last check came to nothing
  /// Hashes of what was read, for provenance; made in the background after a calibration, empty until then.
  const std::vector<InputFile>& input_files() const { return input_files_; }
  QUndoStack& undo_stack() { return undo_; }
  /// What the output was made from, whatever is set now.
  const PipelineInput& input_of_output() const { return run_input_; }
  PipelineInput input_of_next_run() const;

  /// Where topics have to be chosen first, topics_asked says so.
  void open(const QStringList& paths);
  /// Reads what a session's recording offers; topics_listed follows.
  void list_topics(int session);
  /// The answer to topics_asked.
  void open_chosen(const std::vector<ChosenOffer>& offers);
  /// Reads a session anew with other topics; an edit that can be undone. The result of its former topics goes with it.
  void choose_topics(int session, const TopicChoice& choice);
  /// An edit that can be undone. What was calibrated goes with it where it rests on a pair of the session.
  void remove_session(int session);
  void calibrate();
  void cancel();
  void select_pair(int pair);
  /// `reason`: why, as the pair's own words; empty: by whom. `step`: the name of the edit; empty: which pairs.
  void decide(const std::vector<int>& pairs, PairState state, const Message& reason = {}, const QString& step = {});
  void edit_option(const QString& section, const QString& name, const QVariant& value);
  void use_clock_offset(bool with_it);  ///< an edit of solve.apply_time_offset
  void reset_range();
  void reset_settings();
  void edit_nominal(const std::optional<RigidTransform>& ins_from_lidar);
  void use_result_as_nominal();
  void mark_exported(Exported how);
  void confirm(bool good);
  void say(Severity severity, const QString& where, const QString& what) { emit message(severity, where, what); }

  // Steps of undo commands; not undoable by themselves.
  void apply_settings(const Settings& settings, const QString& step);
  void apply_nominal(const std::optional<RigidTransform>& ins_from_lidar);
  void apply_decisions(const std::vector<PairDecision>& decisions, const QString& step);
  /// What was calibrated, with the decisions of then, to be put back.
  struct Calibrated;
  using CalibratedPtr = std::shared_ptr<const Calibrated>;
  CalibratedPtr calibrated() const;
  void apply_calibration(const CalibratedPtr& calibrated, const QString& step);
  /// Puts one session in the place of another; without `calibrated`, nothing is calibrated yet.
  void apply_session(const std::shared_ptr<const Session>& from, const std::shared_ptr<const Session>& to,
                     const CalibratedPtr& calibrated);
  /// Sessions that nothing was calibrated from yet come and go.
  void apply_opening(const std::vector<std::shared_ptr<const Session>>& sessions);
  void apply_closing(const std::vector<std::shared_ptr<const Session>>& sessions);
  bool is_of_output(const Session& session) const;  ///< whether what is calibrated was made with it
  void apply_removal(const std::shared_ptr<const Session>& session);
  /// `calibrated`: what apply_removal took away or made smaller; null where it did not.
  void apply_return(const std::shared_ptr<const Session>& session, std::ptrdiff_t place,
                    const CalibratedPtr& calibrated);

  /// Reads a project and its sessions in the background and replaces what is there. Where sessions are not where the
  /// file says, nothing is replaced and sessions_missing asks for them; where another window has the project open,
  /// project_held asks how to go on.
  void open_project(const QString& path) { open_project(ProjectToOpen{path, {}, {}, {}, {}, {}}); }
  void open_project(const ProjectToOpen& request);
  /// Saves what is there now, after the saves that were asked for before. `saved` is called once the file is whole, but
  /// not where another project took this one's place meanwhile; a failure becomes a message.
  void save_project(const QString& path, std::function<void()> saved = {});
  void begin_project();                                          ///< a new one, without anything in it
  const QString& project_path() const { return project_path_; }  ///< empty where it has not been saved
  /// Another window has the project: it is not saved under its path until that one has closed it.
  bool read_only() const { return read_only_; }
  void show_life();  ///< to other computers, by the lock of the project; now and then by itself
  bool has_unsaved_decisions() const { return unsaved() && !decisions_.empty(); }
  /// Edits, decisions or results that no project file has. Sessions that were merely opened are none.
  bool has_unsaved_work() const {
    return unsaved() && (output_ || !project_path_.isEmpty() || has_edits() || recovered_);
  }
  bool unsaved() const { return revision_ != saved_revision_; }
  int revision() const { return revision_; }  ///< goes up with every edit
  int decision_count() const { return static_cast<int>(verdicts().size()); }
  ProjectSnapshot snapshot() const;
  /// Replaces everything; the project's sessions are given opened, its paths are not used.
  void restore(std::vector<std::shared_ptr<const Session>> sessions, const Project& project, OutputPtr output);
  void name_edits_anew();  ///< in the language of now, before a window shows them
  void announce();         ///< everything once more, for a window that takes the place of another
  JobRunner& jobs() { return jobs_; }
  const Engine& engine() const { return engine_; }

 signals:
  void sessions_changed();
  void overviews_changed();
  void project_changed();   ///< its path, or whether it is saved
  void project_replaced();  ///< what was there belongs to another; what takes its place is told by the other signals
  void project_saved(const QString& path);
  void project_opened(const remount::ProjectToOpen& request, bool whole);  ///< whole: with all of its sessions
  /// Ask for them and open again, with `moved` or `without_missing` filled in.
  void sessions_missing(const remount::ProjectToOpen& request, const QStringList& paths);
  /// Another window has it open. Ask, and open again with another `access`.
  void project_held(const remount::ProjectToOpen& request, const remount::LockHolder& holder, bool on_another_computer);
  /// Another window took the project over: it is read-only here from now on.
  void project_lost(const QString& path, const remount::LockHolder& holder);
  void session_opened(const QString& path);
  /// What list_topics was asked for; `used_as` as the session has it.
  void topics_listed(int session, const std::vector<remount::OfferedTopic>& topics);
  /// These cannot be opened before somebody has said which of their topics are meant.
  void topics_asked(const std::vector<remount::TopicOffer>& offers);
  /// A folder that was to be opened is no session, but holds these: somebody has to say which are meant.
  void sessions_found(const QString& folder, const QStringList& paths);
  void settings_changed();
  void nominal_changed();
  void output_changed();
  void state_changed();  ///< jobs started or ended, stage of the calibration, out of date, exported
  void selection_changed(int pair);
  void clouds_loading(int pair);
  void clouds_loaded(int pair, remount::CloudsPtr clouds);
  void clouds_failed(int pair, const QString& why);
  void job_progressed(const Message& stage, qulonglong done, qulonglong total);
  /// For the user to read now: what they asked for failed, cannot be done, or is done.
  void message(remount::Severity severity, const QString& where, const QString& what);
  /// What was found in the data; shown where the data are listed.
  void logged(remount::Severity severity, const QString& where, const QString& what);

 private:
  using DecisionKey = std::tuple<std::string, std::int64_t, std::int64_t>;  // session path, stamps of scans a and b
  struct Verdict {
    PairState state = PairState::Proposed;
    Message reason;
    bool operator==(const Verdict&) const = default;
  };
  using Decisions = std::map<DecisionKey, Verdict>;

  static DecisionKey key_of(const PipelineInput& input, const PipelineOutput& output, const Pair& pair);
  /// Makes an output whose run began with the decisions `carried` obey those of now, which may have been undone while
  /// it ran. False where they are the same.
  bool catch_up(const Decisions& carried, PipelineOutput& output) const;
  /// What became of a path that was to be opened: one of the first four.
  struct Opened {
    std::shared_ptr<const Session> session;
    std::optional<TopicOffer> question;
    JobFailure failure;
    QStringList below;  ///< a folder of sessions: these
    QString copy_of;    ///< the session is the same recording as this one, which is open
  };
  struct ToOpen {
    std::filesystem::path path;
    std::function<Opened(Progress&)> open;
  };
  static void find_copies(const Engine& engine, const std::vector<std::shared_ptr<const Session>>& open,
                          std::vector<Opened>& opened, const Progress& progress);
  static Opened open_or_ask(const Engine& engine, const std::filesystem::path& path, Progress& progress);
  void open_all(std::vector<ToOpen> wanted);  ///< or later, where others are being opened
  void take_opened(std::vector<Opened> opened);
  /// Says so where it is, or among those that are opened with it.
  bool is_open(const std::filesystem::path& path, const std::vector<std::shared_ptr<const Session>>& opened_now);
  void add_sessions(const std::vector<std::shared_ptr<const Session>>& opened);
  void say_several_failed(const std::vector<JobFailure>& failures);
  void tell_findings(const Session& session);
  void put_back(const Calibrated& calibrated);
  void show_put_back(const CalibratedPtr& calibrated);  ///< null where nothing was
  void leave_topics_of(const Session& from, const Session& to);
  CalibratedPtr calibrated_without(const Session& session) const;  ///< null where the result rests on it
  void show_other_sessions();                                      ///< beside what is calibrated, which stays
  void stop_for_other_sessions();
  void forget_calibration();
  bool may_calibrate();    ///< says why not
  bool has_edits() const;  ///< that can be undone, beside sessions that were opened
  void take_run(const PipelineInput& input, OutputPtr output);
  /// The pair of the same scans in another output; the first where there is none, -1 where that has no pairs.
  static int same_pair(const PipelineInput& input_before, const PipelineOutput* before, int selected,
                       const PipelineInput& input, const PipelineOutput& output);
  /// A run of sessions that are no longer those that are open.
  void drop_run();
  void keep_what_was(const CalibratedPtr& before);
  std::vector<PairVerdict> verdicts() const;
  /// What is shown before the whole solution: how X moved by a decision, or the ranking in another search range.
  enum class FirstAnswer { None, Moved, Ranking };
  void start_solve(const QString& step, FirstAnswer first);
  /// Where all is decided and set as it was for the last whole calibration, its result is there again, the last steps
  /// included. False where it is not so.
  bool return_to_run(const QString& step);
  void take_ranking(OutputPtr answer);
  void take_first_answer(OutputPtr answer, OutputPtr before);
  void take_solution(OutputPtr solved, OutputPtr before, const Settings& settings);
  void take_cancelled_run(const PipelineInput& input, const std::shared_ptr<PipelineOutput>& output);
  /// What a calibration that came to nothing had stopped: the solution of the last decisions, or the map check.
  void resume_solving();
  void check_map_soon();
  void check_map_again();
  void load_clouds();
  void look_over_sessions();  ///< in the background
  void hash_input_files();
  void compare_input_files();
  /// The pairs as they are, with the present search range and solution options.
  PipelineInput input_of_next_solve() const;
  struct Save {
    QString path;
    ProjectSnapshot snapshot;
    std::function<void()> saved;
    int project = 0;
  };
  using LockPtr = std::shared_ptr<const HolderLock>;
  /// `of_last`: of the save before in the line, which holds its project; it is not in the way of the next to that path.
  void start_save(const LockPtr& of_last);
  void end_save(const LockPtr& lock);
  void hold(LockPtr lock, bool read_only);  ///< of the project that is there now
  void set_project(const QString& path, int saved_revision);
  void mark_edited();
  void take_project(const ProjectToOpen& request, struct OpenedProject& opened);
  JobRunner::Failed report_failure();

  Engine engine_;
  std::vector<std::shared_ptr<const Session>> sessions_;
  Settings settings_;
  std::optional<RigidTransform> nominal_ins_from_lidar_;
  std::map<std::shared_ptr<const Session>, std::shared_ptr<const DriveOverview>> overviews_;
  int overview_job_ = 0;
  PipelineInput run_input_;  // of output_: what it was made with, solutions since then included
  OutputPtr output_, output_before_, output_solved_;
  Decisions decisions_;
  struct WholeRun {
    PipelineInput input;
    OutputPtr output;
    Decisions decisions;
  };
  std::optional<WholeRun> whole_run_;  // the last calibration, before anything was decided or set since
  std::vector<InputFile> input_files_;
  int selected_ = -1;
  std::vector<ToOpen> waiting_;
  int open_job_ = 0, run_job_ = 0, solve_job_ = 0, cloud_job_ = 0, hash_job_ = 0, map_job_ = 0;
  int solution_ = 0;
  QString map_failure_;
  QTimer map_pause_;           // while the user goes on deciding, the map is not read
  bool data_changed_ = false;  // the files on disk are not those that output_ was made from
  bool refining_ = false;
  Exported exported_ = Exported::No;
  bool confirmed_ = false;
  bool recovered_ = false;  // from an autosave, and not saved since
  int revision_ = 0, saved_revision_ = 0;
  int project_ = 0;  // goes up where another project takes this one's place
  std::unique_ptr<LockKeeper> locks_;
  LockPtr lock_;  // of project_path_; null where there is none
  bool read_only_ = false;
  QTimer beats_;
  std::deque<Save> saves_;  // the first is being written: two at once could leave the older in the file
  Message stage_;
  QString project_path_;
  QString moved_by_, solving_for_;  // the edits of the last solution, and of the one under way
  QUndoStack undo_;
  JobRunner jobs_;  // last: its threads end before anything they report to is gone
};

}  // namespace remount

Q_DECLARE_METATYPE(remount::CloudsPtr)

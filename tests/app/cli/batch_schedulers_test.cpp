// Jobs of "batch" on schedulers that exist: GNU parallel, and Slurm on a cluster of one node that the test starts.
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>

#include "model/fleet/fleet.h"
#include "model/results/result_file.h"
#include "tests/app/cli/program_fixture.h"

namespace remount::cli {
namespace {

/// Where a program lies; empty where it is not installed. Daemons lie where a user's path may not lead.
std::string program(const std::string& name) {
  std::istringstream folders(std::string(std::getenv("PATH")) + ":/usr/sbin:/sbin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + name).c_str(), X_OK) == 0) return folder + "/" + name;
  return {};
}

/// A port of this machine that nobody listens at.
int free_port() {
  const int descriptor = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool bound = ::bind(descriptor, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
                     ::getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(descriptor);
  return bound ? ntohs(address.sin_port) : 0;
}

/// A daemon in the foreground, ended with the object.
class Daemon {
 public:
  Daemon(const std::vector<std::string>& words, const std::string& log) {
    process_ = ::fork();
    if (process_ != 0) return;
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::setpgid(0, 0);
    if (std::freopen(log.c_str(), "w", stderr) == nullptr || std::freopen("/dev/null", "w", stdout) == nullptr)
      ::_exit(99);
    ::execv(arguments[0], arguments.data());
    ::_exit(98);
  }
  ~Daemon() {
    if (process_ <= 0) return;
    ::kill(process_, SIGTERM);
    for (int i = 0; i < 500 && ::waitpid(process_, nullptr, WNOHANG) == 0; ++i) ::usleep(10000);
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, WNOHANG);
  }
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

 private:
  pid_t process_ = 0;
};

class cli_batch_schedulers : public ProgramFixture<cli_batch_schedulers> {
 protected:
  static void SetUpTestSuite() {
    make_folder_with_drive("--duration-s 3 --beams 16 --azimuth-steps 300 --scan-rate-hz 5");
    for (const char* copy : {"second", "third"})
      std::filesystem::copy(path("drive"), path(copy), std::filesystem::copy_options::recursive);
  }

  /// Three vehicles that can be calibrated, and one whose session is not there.
  static fleet::Fleet fleet(const std::string& name) {
    std::ofstream(path(name)) << "format: remount-fleet/1\nsettings: {run: {map_check: false}}\nvehicles:\n"
                                 "  - {name: a, sessions: [drive]}\n  - {name: b, sessions: [second]}\n"
                                 "  - {name: c, sessions: [third]}\n  - {name: d, sessions: [nowhere]}\n";
    return fleet::load_fleet(path(name));
  }
  static Outcome shell(const std::string& command) {
    std::ofstream(path("command.sh")) << command << "\n";
    const int status = std::system(("cd '" + folder_.string() + "' && sh command.sh > shell.out 2> shell.err").c_str());
    return {testing::exit_code_of(status), text_of(path("shell.out")), text_of(path("shell.err"))};
  }
  static void expect_all_done(const fleet::Fleet& fleet) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_TRUE(calibration::is_usable(results::load_result(fleet.jobs[i].result).result)) << fleet.jobs[i].result;
    EXPECT_NE(text_of(fleet.jobs[3].failure).find("does not exist"), std::string::npos);
  }
  static std::vector<ino_t> results_of(const fleet::Fleet& fleet) {
    std::vector<ino_t> files;
    for (std::size_t i = 0; i < 3; ++i) {
      struct stat status {};
      files.push_back(::stat(fleet.jobs[i].result.c_str(), &status) == 0 ? status.st_ino : 0);
    }
    return files;
  }
  inline static const std::string kProgram = std::string("'") + REMOUNT_CLI + "' batch ";
};

TEST_F(cli_batch_schedulers, gnu_parallel_runs_the_jobs_and_a_second_run_finds_them_done) {
  if (program("parallel").empty()) GTEST_SKIP() << "GNU parallel is not installed";
  const fleet::Fleet jobs = fleet("parallel.yaml");
  const std::string command = "seq \"$(" + kProgram + "parallel.yaml --count)\" | parallel --will-cite --jobs 2 " +
                              kProgram + "parallel.yaml --job {} -j 1 -q";
  const Outcome first = shell(command);
  EXPECT_EQ(first.code, 1) << "parallel says how many jobs failed: " << first.err;
  expect_all_done(jobs);
  const std::vector<ino_t> files = results_of(jobs);
  const Outcome second = shell(command);
  EXPECT_EQ(second.code, 1) << second.err;
  EXPECT_EQ(results_of(jobs), files);
  EXPECT_EQ(shell(kProgram + "parallel.yaml --table").code, 2) << "one of them failed";
  EXPECT_NE(text_of(jobs.results / "fleet.csv").find("d,4,nowhere,failed"), std::string::npos);
}

/// Slurm with everything in the folder of the test, for the user that runs it.
class SlurmCluster {
 public:
  explicit SlurmCluster(const std::filesystem::path& folder) : folder_(folder) {
    for (const char* name : {"state", "spool", "munge"}) {
      std::filesystem::create_directories(folder_ / name);
      ::chmod((folder_ / name).c_str(), 0755);
    }
    start_munge();
    write_configuration();
    ::setenv("SLURM_CONF", file("slurm.conf").c_str(), 1);
    daemons_.push_back(std::make_unique<Daemon>(
        std::vector{program("slurmctld"), std::string("-D"), std::string("-f"), file("slurm.conf")},
        file("slurmctld.err")));
    daemons_.push_back(std::make_unique<Daemon>(
        std::vector{program("slurmd"), std::string("-D"), std::string("-f"), file("slurm.conf")}, file("slurmd.err")));
  }
  ~SlurmCluster() {
    while (!daemons_.empty()) daemons_.pop_back();
    ::unsetenv("SLURM_CONF");
  }
  SlurmCluster(const SlurmCluster&) = delete;
  SlurmCluster& operator=(const SlurmCluster&) = delete;

  std::string logs() const {
    std::string text;
    for (const char* log : {"munge.err", "slurmctld.err", "slurmd.err"}) text += text_of(file(log));
    return text;
  }

 private:
  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  void start_munge() {
    std::ofstream(file("munge/key")) << std::string(128, 'k');
    ::chmod(file("munge/key").c_str(), 0600);
    daemons_.push_back(
        std::make_unique<Daemon>(std::vector{program("munged"), std::string("--foreground"), std::string("--force"),
                                             "--key-file=" + file("munge/key"), "--socket=" + file("munge/socket"),
                                             "--pid-file=" + file("munge/pid"), "--log-file=" + file("munge/log"),
                                             "--seed-file=" + file("munge/seed")},
                                 file("munge.err")));
    eventually([&] { return std::filesystem::exists(file("munge/socket")); });
  }

  void write_configuration() const {
    char host[256] = {};
    ::gethostname(host, sizeof host - 1);
    const std::string node = std::string(host).substr(0, std::string(host).find('.'));
    const passwd* user = ::getpwuid(::getuid());
    const std::string name = user != nullptr ? user->pw_name : "root";
    std::ofstream(file("slurm.conf"))
        << "ClusterName=test\nSlurmctldHost=" << node << "(127.0.0.1)\nSlurmUser=" << name << "\nSlurmdUser=" << name
        << "\nAuthType=auth/munge\nAuthInfo=socket=" << file("munge/socket") << "\nSlurmctldPort=" << free_port()
        << "\nSlurmdPort=" << free_port() << "\nStateSaveLocation=" << file("state")
        << "\nSlurmdSpoolDir=" << file("spool") << "\nSlurmctldPidFile=" << file("slurmctld.pid")
        << "\nSlurmdPidFile=" << file("slurmd.pid")
        << "\nProctrackType=proctrack/linuxproc\nTaskPlugin=task/none\nMpiDefault=none\nReturnToService=2\n"
           "SelectType=select/cons_tres\nSelectTypeParameters=CR_Core\nAccountingStorageType=accounting_storage/none\n"
           "JobAcctGatherType=jobacct_gather/none\nSchedulerParameters=sched_interval=1\n"
        << "NodeName=" << node << " NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN\nPartitionName=test Nodes=" << node
        << " Default=YES MaxTime=INFINITE State=UP\n";
  }

  std::filesystem::path folder_;
  std::vector<std::unique_ptr<Daemon>> daemons_;
};

TEST_F(cli_batch_schedulers, a_slurm_job_array_runs_the_jobs_and_a_job_after_it_makes_the_table) {
  for (const char* needed : {"slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "munged"})
    if (program(needed).empty()) GTEST_SKIP() << "Slurm is not installed: there is no " << needed;
  const fleet::Fleet jobs = fleet("slurm.yaml");
  const SlurmCluster cluster(folder_ / "cluster");
  ASSERT_TRUE(eventually([&] { return shell("sinfo --noheader -o %T").out.find("idle") != std::string::npos; }))
      << shell("sinfo").err << cluster.logs();
  const auto submit = [&] {
    const Outcome array = shell("sbatch --parsable --output=slurm-%A_%a.out --array=\"1-$(" + kProgram +
                                "slurm.yaml --count)\" --cpus-per-task=1 --wrap '" + std::string(REMOUNT_CLI) +
                                " batch slurm.yaml --job \"$SLURM_ARRAY_TASK_ID\" -j \"$SLURM_CPUS_PER_TASK\"'");
    EXPECT_EQ(array.code, 0) << array.err << cluster.logs();
    const std::string id = array.out.substr(0, array.out.find('\n'));
    const Outcome table = shell("sbatch --parsable --output=table.out --dependency=afterany:" + id + " --wrap '" +
                                std::string(REMOUNT_CLI) + " batch slurm.yaml --table'");
    EXPECT_EQ(table.code, 0) << table.err;
    EXPECT_TRUE(eventually([&] { return shell("squeue --noheader").out.empty(); })) << shell("squeue").out;
  };
  submit();
  expect_all_done(jobs);
  EXPECT_NE(text_of(path("table.out")).find("4 jobs: 3 solved, 1 failed"), std::string::npos)
      << text_of(path("table.out"));
  EXPECT_NE(text_of(jobs.results / "fleet.csv").find("d,4,nowhere,failed"), std::string::npos);
  const std::vector<ino_t> files = results_of(jobs);
  submit();
  EXPECT_EQ(results_of(jobs), files) << "submitted again, nothing is made again";
}

}  // namespace
}  // namespace remount::cli

// Proves, with real processes, that the end of a job does not wait for a slow or stopped host:
// scenarios it has not begun are returned and done once, elsewhere; scenarios it does not return
// get speculative copies, a bounded share of the job; and the digest is that of one process.
#include "tests/cluster/mortal_master.hpp"

#include <atomic>
#include <map>

namespace cd::tests {
namespace {

/// Lets a process run one tenth of the time while this object lives.
class Slowed {
  public:
    explicit Slowed(const Process& process)
        : process_(process), thread_([this] {
              while (!ends_.load()) {
                  process_.signal(SIGSTOP);
                  std::this_thread::sleep_for(std::chrono::milliseconds(45));
                  process_.signal(SIGCONT);
                  std::this_thread::sleep_for(std::chrono::milliseconds(5));
              }
          }) {}
    Slowed(const Slowed&) = delete;
    Slowed& operator=(const Slowed&) = delete;
    ~Slowed() {
        ends_.store(true);
        thread_.join();
    }

  private:
    const Process& process_;
    std::atomic<bool> ends_ = false;
    std::thread thread_;
};

struct Way {
    std::string strategy = "earliest-finish";
    AnalysisMode analysis = AnalysisMode::Always;
};

/// Never declares a worker lost, however long it is stopped.
class EndOfJob : public MortalCluster, public testing::WithParamInterface<Way> {
  protected:
    EndOfJob() : MortalCluster({"--lost-after", "600", "--return-within", "600"}) {}

    void SetUp() override {
        start_worker(1, {"--no-peers"});
        start_worker(1, {"--no-peers"});
        connection_ = connect();
    }
    void submit_job() {
        ClusterOptions options = many_blocks();
        options.strategy = GetParam().strategy;
        options.analysis = GetParam().analysis;
        id_ = submit(*connection_, job_, Query{}, options);
    }
    void progress(double share) {
        const auto merged = static_cast<double>(job_.scenarios.size()) * share;
        watch_until(*connection_, id_, static_cast<std::uint64_t>(merged));
    }
    JobStatus expect_right() {
        const JobStatus status = finish(*connection_, id_);
        EXPECT_EQ(status.state, JobState::Done) << status.failure;
        EXPECT_EQ(status.digest, job_.digest_in_one_process(Query{}));
        EXPECT_EQ(status.summary.failed, 0u);
        const auto cluster = connection_->status();
        EXPECT_TRUE(cluster);
        EXPECT_EQ(cluster.value().alarm_count, 0u);
        EXPECT_EQ(cluster.value().losses.workers_lost, 0u);
        std::uint64_t answered = 0;
        for (const WorkerStatus& worker : cluster.value().workers) {
            answered += worker.scenarios;
        }
        answered_ = answered - answered_before_;
        answered_before_ = answered;
        EXPECT_LE(static_cast<double>(status.copies),
                  0.05 * static_cast<double>(job_.scenarios.size()));
        std::printf("%.2f s, recalled %llu, copies %llu, won %llu, answers %llu of %llu\n",
                    status.seconds,
                    static_cast<unsigned long long>(status.recalled),
                    static_cast<unsigned long long>(status.copies),
                    static_cast<unsigned long long>(status.copies_won),
                    static_cast<unsigned long long>(answered_),
                    static_cast<unsigned long long>(status.summary.total));
        if (HasFailure()) {
            std::printf("%s\n", master_.log().c_str());
        }
        return status;
    }

    Job job_ = make_job(8000);
    std::unique_ptr<Connection> connection_;
    JobId id_;
    std::uint64_t answered_ = 0;        ///< Scenarios of the current job that workers answered.
    std::uint64_t answered_before_ = 0; ///< Value of `answered_` before the current job.
};

/// Timing affects how a job ends, so one of a few jobs must show the expected effects.
constexpr int jobs_tried = 6;

TEST_P(EndOfJob, ScenariosThatASlowHostHasNotBegunRunOnceElsewhere) {
    std::uint64_t recalled = 0;
    for (int i = 0; i < jobs_tried && recalled == 0; ++i) {
        submit_job();
        progress(0.7);
        const Slowed slowed(*workers_[1]);
        const JobStatus status = expect_right();
        EXPECT_LE(answered_ + status.answered_by_master, status.summary.total + status.copies);
        recalled = status.recalled;
    }
    EXPECT_GT(recalled, 0u);
}

TEST_P(EndOfJob, CopiesReplaceTheScenariosOfAStoppedHost) {
    std::uint64_t copies_won = 0;
    for (int i = 0; i < jobs_tried && copies_won == 0; ++i) {
        submit_job();
        // The master gives other workers copies of at most 5 % of a job's scenarios. If the stopped
        // worker held more scenarios than that, the job could not end without it.
        progress(0.96);
        workers_[1]->signal(SIGSTOP);
        copies_won = expect_right().copies_won;
        workers_[1]->signal(SIGCONT);
    }
    EXPECT_GT(copies_won, 0u);
}

INSTANTIATE_TEST_SUITE_P(Ways,
                         EndOfJob,
                         testing::Values(Way{"earliest-finish", AnalysisMode::Always},
                                         Way{"best-match", AnalysisMode::Never}),
                         [](const auto& way) {
                             return way.param.analysis == AnalysisMode::Never ? "Ranges" : "ByTime";
                         });

} // namespace
} // namespace cd::tests

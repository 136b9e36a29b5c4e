// Proves, with real processes and a faulty network between cdctl and its master, that cdctl either
// continues by itself or soon ends with a documented exit code and a reason; that it never reports
// a wrong result; and that the master loses nothing and keeps nothing half-finished.
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/faulty_proxy.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/support/comes_true.hpp"

#include <gmock/gmock.h>

#include <csignal>

namespace cd::tests {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

constexpr int unreachable = 4;
constexpr int refused = 5;

/// Puts cdctl behind the proxy; workers connect directly.
class ClientLink : public MortalCluster {
  protected:
    explicit ClientLink(Links links) : MortalCluster({}, links) {
        write_obj(folder_ / "a.obj", make_torus(1, 0.4, 60, 30));
        write_obj(folder_ / "b.obj", make_sphere(3));
        write_text(job_,
                   "name = \"fault\"\n[a]\nmesh = \"a.obj\"\n[b]\nmesh = \"b.obj\"\n"
                   "[poses]\nrandom = { n = 600, seed = 5, penetration = [0.01, 0.2] }\n");
        truth_ = tests::run({cdctl(), "run", job_, "-o", "csv"}).output;
        truth_digest_ = digest_of(tests::run({cdctl(), "run", job_}));
        EXPECT_EQ(truth_digest_.size(), 16u) << truth_digest_;
    }

    [[nodiscard]] std::vector<std::string> command(std::vector<std::string> words,
                                                   const std::string& address) const {
        words.insert(words.begin(), cdctl());
        const std::string credential = tls_ == nullptr ? "none" : admin().string();
        words.insert(words.end(), {"--master", address, "--credential", credential});
        return words;
    }
    [[nodiscard]] Ran run_near(const std::vector<std::string>& words) const {
        return tests::run(command(words, master_.address()));
    }
    [[nodiscard]] Process start_far(const std::vector<std::string>& words) {
        const std::string name = "cdctl" + std::to_string(++started_);
        return Process(command(words, proxy_.address()), folder_ / name);
    }
    [[nodiscard]] static Ran end_of(Process& process) {
        const std::optional<int> code = process.wait(patience * 2);
        EXPECT_TRUE(code) << "it hangs";
        return {code.value_or(-1), process.output(), process.errors()};
    }

    /// Runs cdctl over a slow line and causes a fault after so many pieces.
    Ran run_far(const std::vector<std::string>& words,
                std::uint64_t pieces,
                const std::function<void()>& happens) {
        proxy_.set(Weather::Paced);
        const std::uint64_t until = proxy_.delayed() + pieces;
        Process process = start_far(words);
        EXPECT_TRUE(comes_true([&] { return proxy_.delayed() >= until || !process.is_running(); }));
        happens();
        Ran ran = end_of(process);
        proxy_.set(Weather::Fair);
        return ran;
    }

    /// Runs `wait` on a running job and cuts its connection. If cdctl did not watch yet, it ends
    /// instead of reconnecting; then this tries again with a later cut.
    Process start_cut_wait(const std::string& id) {
        for (std::uint64_t pieces = 4;; ++pieces) {
            proxy_.set(Weather::Paced);
            const std::uint64_t until = proxy_.delayed() + pieces;
            Process waiting = start_far({"wait", id});
            EXPECT_TRUE(comes_true([&] { return proxy_.delayed() >= until; }));
            proxy_.cut();
            EXPECT_TRUE(comes_true([&] {
                return waiting.errors().find("come back") != std::string::npos ||
                       !waiting.is_running();
            }));
            if (waiting.is_running() || HasFailure()) {
                proxy_.set(Weather::Fair);
                return waiting;
            }
        }
    }

    std::string submit_near() {
        const Ran ran = run_near({"submit", job_, "-o", "name"});
        EXPECT_EQ(ran.exit_code, 0) << ran.errors;
        return ran.output.substr(0, ran.output.find('\n'));
    }
    void expect_right(const std::string& id) const {
        const Ran watched = run_near({"watch", id});
        EXPECT_EQ(watched.exit_code, 0) << watched.errors;
        EXPECT_EQ(digest_of(watched), truth_digest_);
        EXPECT_EQ(run_near({"results", id, "-o", "csv"}).output, truth_);
    }
    std::vector<std::string> job_ids() {
        const auto status = connect()->status();
        EXPECT_TRUE(status) << status.error().detail;
        std::vector<std::string> ids;
        for (const JobStatus& job : status.value().jobs) {
            ids.push_back(std::to_string(job.job.value));
        }
        return ids;
    }

    FaultyProxy proxy_{master_.port()};
    std::string job_ = folder_ / "job.toml";
    std::string truth_;
    std::string truth_digest_;
    int started_ = 0;
};

class AnyClientLink : public ClientLink, public testing::WithParamInterface<Links> {
  protected:
    AnyClientLink() : ClientLink(GetParam()) {}
};

INSTANTIATE_TEST_SUITE_P(Over,
                         AnyClientLink,
                         testing::Values(Links::Plain, Links::Secured),
                         [](const auto& links) {
                             return links.param == Links::Plain ? "Plain" : "Tls";
                         });

TEST_P(AnyClientLink, AWaitGoesOnByItself) {
    const std::string id = submit_near();
    Process waiting = start_cut_wait(id);
    for (int round = 0; round < 2; ++round) {
        const std::uint64_t before = proxy_.connections();
        proxy_.cut();
        EXPECT_TRUE(
            comes_true([&] { return proxy_.connections() > before || !waiting.is_running(); }));
    }
    for (const bool there : {true, false}) { // Until the master greets it again.
        const std::uint64_t before = proxy_.damaged();
        proxy_.damage_greeting(there);
        proxy_.cut();
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > before || !waiting.is_running(); }));
    }
    start_worker();
    const std::uint64_t before = proxy_.damaged();
    proxy_.damage(false);
    const Ran waited = end_of(waiting);
    EXPECT_EQ(waited.exit_code, 0) << waited.errors;
    EXPECT_THAT(waited.errors, HasSubstr("waiting for it to come back"));
    EXPECT_GT(proxy_.damaged(), before);
    expect_right(id);
}

TEST_P(AnyClientLink, ResultsOverASlowLineAreTheSame) {
    start_worker();
    const std::string id = submit_near();
    expect_right(id);
    const Ran delayed = run_far({"results", id, "-o", "csv"}, 0, [] {});
    EXPECT_EQ(delayed.exit_code, 0) << delayed.errors;
    EXPECT_EQ(delayed.output, truth_);
    const std::uint64_t before = proxy_.trickled();
    const Ran trickled = run_far({"results", id, "-o", "csv"}, 4, [&] {
        proxy_.set(Weather::Trickling);
        EXPECT_TRUE(comes_true([&] { return proxy_.trickled() > before + 100; }));
        proxy_.set(Weather::Fair);
    });
    EXPECT_EQ(trickled.exit_code, 0) << trickled.errors;
    EXPECT_EQ(trickled.output, truth_);
}

TEST_P(AnyClientLink, ResultsAreWholeOrTheExitCodeSaysThatTheyAreNot) {
    start_worker();
    const std::string id = submit_near();
    expect_right(id);
    int failures = 0;
    const auto fetch = [&](std::uint64_t pieces, const std::function<void()>& happens) {
        const Ran ran = run_far({"results", id, "-o", "csv"}, pieces, happens);
        if (ran.exit_code == 0) {
            EXPECT_EQ(ran.output, truth_);
        } else {
            ++failures;
            EXPECT_THAT(ran.exit_code, AnyOf(unreachable, refused)) << ran.errors;
            EXPECT_THAT(ran.errors, HasSubstr("cdctl: "));
        }
        return ran.exit_code;
    };
    for (std::uint64_t pieces = 0; pieces < 12; ++pieces) {
        EXPECT_THAT(fetch(pieces, [&] { proxy_.cut(); }), AnyOf(0, unreachable));
    }
    EXPECT_GE(failures, 5);
    for (std::uint64_t pieces = 0; pieces < 12; ++pieces) {
        fetch(pieces, [&] { proxy_.damage(pieces % 3 == 0); });
    }
    EXPECT_GE(failures, 10);
    EXPECT_GE(proxy_.damaged(), 5u);
    expect_right(id);
}

TEST_P(AnyClientLink, ASubmissionIsThereWholeOrNotAtAll) {
    std::set<std::string> promised;
    int failures = 0;
    for (std::uint64_t pieces = 0; pieces < 24; pieces += 2) {
        const bool cuts = pieces % 4 == 0;
        const Ran ran = run_far({"submit", job_, "-o", "name"}, pieces, [&] {
            cuts ? proxy_.cut() : proxy_.damage(pieces % 3 == 0);
        });
        if (ran.exit_code == 0) {
            promised.insert(ran.output);
            continue;
        }
        ++failures;
        EXPECT_THAT(ran.exit_code, AnyOf(unreachable, refused)) << ran.errors;
        EXPECT_THAT(ran.errors, HasSubstr("cdctl: "));
        EXPECT_TRUE(ran.output.empty()) << ran.output;
    }
    EXPECT_GE(failures, 6);
    const std::string id = submit_near();
    const std::vector<std::string> ids = job_ids();
    // A job whose id was lost in transit may exist, too.
    EXPECT_GE(ids.size(), promised.size() + 1);
    start_worker();
    for (const std::string& each : ids) {
        expect_right(each);
    }
}

TEST_P(AnyClientLink, OneSignalEndsAWaitForAMasterThatIsGone) {
    const std::string id = submit_near();
    Process waiting(command({"wait", id}, master_.address()), folder_ / "waiting");
    const auto says = [&](const char* text) {
        return comes_true([&] { return waiting.errors().find(text) != std::string::npos; });
    };
    ASSERT_TRUE(says("no worker is connected")) << waiting.errors();
    master_.kill();
    ASSERT_TRUE(says("waiting for it to come back")) << waiting.errors();
    waiting.signal(SIGTERM);
    // Without a signal it waits for a minute.
    EXPECT_EQ(waiting.wait(std::chrono::seconds(30)), 128 + SIGTERM) << waiting.errors();
    EXPECT_THAT(waiting.errors(), HasSubstr("interrupted"));
}

/// Uses the timeouts of users, so it takes a minute.
class HalfOpen : public ClientLink {
  protected:
    HalfOpen() : ClientLink(Links::Plain) {}
};

TEST_F(HalfOpen, AWaitGoesOnAndAQuestionEndsInTime) {
    const std::string id = submit_near();
    Process waiting = start_cut_wait(id);
    const auto are_through = [&](std::uint64_t pieces) {
        proxy_.set(Weather::Paced);
        const std::uint64_t until = proxy_.delayed() + pieces;
        return comes_true([&] { return proxy_.delayed() >= until; });
    };
    proxy_.cut();
    EXPECT_TRUE(are_through(4)); // The greeting and the first status.
    Process asking = start_far({"get", "jobs"});
    EXPECT_TRUE(are_through(2)); // The greeting.
    proxy_.set(Weather::Swallowed);
    Process greeting = start_far({"get", "jobs"});
    for (Process* const process : {&greeting, &asking}) {
        const Ran ran = end_of(*process);
        EXPECT_EQ(ran.exit_code, unreachable);
        EXPECT_THAT(ran.errors, HasSubstr("cdctl: "));
    }
    proxy_.set(Weather::Fair);
    start_worker();
    const Ran waited = end_of(waiting);
    EXPECT_EQ(waited.exit_code, 0) << waited.errors;
    EXPECT_THAT(waited.errors, HasSubstr("waiting for it to come back"));
    expect_right(id);
}

} // namespace
} // namespace cd::tests

// Proves how a worker joins, returns, falls silent, leaves and is lost: events and times in,
// reports out. The channels have no connection.
#include "master/workers/worker_directory.hpp"

#include <gtest/gtest.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;

constexpr FailureTimes times{2s, 15s, 15s, 600s};
constexpr std::uint64_t epoch = 77;

/// Writes down the reports: "joined 1, silent 1".
class Reports : public WorkerEvents {
  public:
    void worker_joined(WorkerId worker, const Hello& /*hello*/) override { add("joined", worker); }
    void worker_replaced(WorkerId worker) override { add("replaced", worker); }
    void worker_resumed(WorkerId worker) override { add("resumed", worker); }
    void worker_detached(WorkerId worker) override { add("detached", worker); }
    void worker_silent(WorkerId worker) override { add("silent", worker); }
    void worker_heard_again(WorkerId worker) override { add("heard", worker); }
    void worker_left(WorkerId worker) override { add("left", worker); }
    [[nodiscard]] WorkerStatus work_of(WorkerId /*worker*/) const override { return work; }

    std::string take() { return std::exchange(text_, ""); }

    WorkerStatus work; ///< Of every worker.

  private:
    void add(const std::string& what, WorkerId worker) {
        text_ += (text_.empty() ? "" : ", ") + what + " " + std::to_string(worker.value);
    }

    std::string text_;
};

class Directory : public testing::Test {
  protected:
    ~Directory() override { directory_.check_invariants(); }

    [[nodiscard]] std::shared_ptr<Channel> channel() {
        return Channel::make(std::make_unique<Stream>(asio::ip::tcp::socket(context_)));
    }
    [[nodiscard]] static Hello hello(std::uint64_t instance, const Reception& before = {}) {
        Hello hello;
        hello.name = "sim-" + std::to_string(instance);
        hello.threads = 4;
        hello.cache_bytes = 1000;
        hello.instance = instance;
        hello.resumed.id = before.worker.value;
        hello.resumed.epoch = epoch;
        return hello;
    }
    Reception join(const Hello& hello, const std::string& holder = "") {
        const Reception reception = directory_.receive(hello, holder);
        directory_.join(reception, hello, channel());
        return reception;
    }
    [[nodiscard]] Worker& at(const Reception& reception) {
        return *directory_.find(reception.worker);
    }
    void end_connection(const Reception& reception) {
        const auto ended = at(reception).channel;
        ended->close();
        directory_.connection_ended(reception.worker, *ended, "the test ends it");
    }
    [[nodiscard]] std::string after(std::chrono::milliseconds time) {
        now_ += time;
        directory_.check();
        return reports_.take();
    }

    asio::io_context context_;
    Reports reports_;
    WorkerDirectory::Time now_{};
    WorkerDirectory directory_{times, epoch, reports_, [this] { return now_; }};
};

TEST_F(Directory, ANewWorkerJoinsAndIsShown) {
    const Hello greeting = hello(5);
    const Reception reception = join(greeting);
    EXPECT_FALSE(reception.is_resumed);
    EXPECT_EQ(reports_.take(), "joined 1");
    EXPECT_TRUE(directory_.is_watching());
    EXPECT_EQ(at(reception).author->to_text(), "sim-5 (w-1)");
    EXPECT_EQ(at(reception).threads, 4u);
    now_ += 3s;
    reports_.work.scenarios = 9;
    const WorkerStatus status = directory_.statuses().at(0);
    EXPECT_EQ(status.worker, reception.worker);
    EXPECT_EQ(status.name, "sim-5");
    EXPECT_EQ(status.cache_bytes, 1000u);
    EXPECT_EQ(status.scenarios, 9u);
    EXPECT_EQ(status.state, WorkerState::Alive);
    EXPECT_DOUBLE_EQ(status.silent_seconds, 3);
}

TEST_F(Directory, ASessionGoesOnOverAnotherConnection) {
    const Reception first = join(hello(5));
    const auto before = at(first).channel;
    const Reception again = join(hello(5, first));
    EXPECT_EQ(reports_.take(), "joined 1, resumed 1");
    EXPECT_TRUE(again.is_resumed);
    EXPECT_EQ(again.worker, first.worker);
    EXPECT_EQ(again.key, first.key);
    EXPECT_FALSE(before->is_open());
    EXPECT_FALSE(at(first).is_settled);
    EXPECT_EQ(directory_.counts().resumed, 1u);
    // The old connection counts no more.
    EXPECT_FALSE(directory_.heard(first.worker, *before));
    directory_.connection_ended(first.worker, *before, "late");
    EXPECT_EQ(reports_.take(), "");
}

TEST_F(Directory, ASessionGoesOnOnlyForItsProcessAndHolderInThisLife) {
    const Reception first = join(hello(5), "anna");
    Hello of_another_life = hello(5, first);
    of_another_life.resumed.epoch = epoch + 1;
    EXPECT_FALSE(directory_.receive(of_another_life, "anna").is_resumed);
    EXPECT_FALSE(directory_.receive(hello(6, first), "anna").is_resumed);
    EXPECT_FALSE(directory_.receive(hello(5, first), "bert").is_resumed);
    EXPECT_TRUE(directory_.receive(hello(5, first), "anna").is_resumed);
    directory_.cut_off(first.worker, {ErrorCode::BadFrame, "nonsense"});
    EXPECT_FALSE(directory_.receive(hello(5, first), "anna").is_resumed);
}

TEST_F(Directory, AProcessHasOneSessionAndAHolderCannotPoseAsAnother) {
    join(hello(5), "anna");
    join(hello(5), "bert");
    join(hello(5));
    EXPECT_EQ(reports_.take(), "joined 1, joined 2, joined 3");
    join(hello(5), "anna");
    EXPECT_EQ(reports_.take(), "replaced 1, left 1, joined 4");
    EXPECT_EQ(directory_.statuses().size(), 3u) << "the lost session of a live process is not kept";
    join(hello(0));
    join(hello(0));
    EXPECT_EQ(reports_.take(), "joined 5, joined 6") << "processes without a number are others";
}

TEST_F(Directory, ASilentWorkerIsHeardAgainOrLostAndForgotten) {
    const Reception one = join(hello(1));
    const Reception two = join(hello(2));
    reports_.take();
    EXPECT_EQ(after(6s), "silent 1, silent 2");
    EXPECT_TRUE(directory_.heard(one.worker, *at(one).channel));
    EXPECT_EQ(reports_.take(), "heard 1");
    EXPECT_TRUE(directory_.heard(one.worker, *at(one).channel));
    EXPECT_EQ(reports_.take(), "");
    reports_.work.working = 3;
    EXPECT_EQ(after(9s), "silent 1, left 2");
    EXPECT_EQ(directory_.find(two.worker), nullptr);
    EXPECT_EQ(directory_.counts().lost, 1u);
    EXPECT_EQ(directory_.counts().given_back, 3u);
    EXPECT_EQ(directory_.statuses().at(1).state, WorkerState::Lost);
    EXPECT_EQ(directory_.statuses().at(1).name, "sim-2");
    EXPECT_DOUBLE_EQ(directory_.statuses().at(1).silent_seconds, 15);
    EXPECT_FALSE(directory_.receive(hello(2, two), "").is_resumed);
    EXPECT_EQ(after(6s), "left 1");
    EXPECT_EQ(after(600s), "");
    EXPECT_TRUE(directory_.statuses().empty());
    EXPECT_FALSE(directory_.is_watching());
}

TEST_F(Directory, ALeapInTimeLosesAWorkerAndForgetsIt) {
    const Reception reception = join(hello(1));
    EXPECT_EQ(after(700s), "joined 1, left 1");
    EXPECT_EQ(directory_.find(reception.worker), nullptr);
    EXPECT_EQ(directory_.counts().lost, 1u);
    EXPECT_TRUE(directory_.statuses().empty());
    EXPECT_FALSE(directory_.is_watching());
}

TEST_F(Directory, AWorkerFromWhichNothingIsReadIsNotSilent) {
    const Reception reception = join(hello(1));
    reports_.take();
    directory_.unheard(reception.worker, *at(reception).channel);
    EXPECT_EQ(after(100s), "");
}

TEST_F(Directory, ADetachedWorkerReturnsAndIsHeardAfterItsInventory) {
    const Reception first = join(hello(1));
    reports_.take();
    end_connection(first);
    EXPECT_EQ(reports_.take(), "detached 1");
    join(hello(1, first));
    EXPECT_EQ(after(7s), "resumed 1, silent 1");
    EXPECT_TRUE(directory_.heard(first.worker, *at(first).channel));
    EXPECT_EQ(reports_.take(), "") << "its inventory is unknown";
    EXPECT_EQ(after(7s), "silent 1");
    directory_.settle(first.worker);
    EXPECT_TRUE(directory_.heard(first.worker, *at(first).channel));
    EXPECT_EQ(reports_.take(), "heard 1");
}

TEST_F(Directory, WhoReturnsAfterItsLossIsTurnedAway) {
    const Reception first = join(hello(1));
    const Hello greeting = hello(1, first);
    const Reception again = directory_.receive(greeting, "");
    ASSERT_TRUE(again.is_resumed);
    (void)after(15s);
    const auto late = channel();
    directory_.join(again, greeting, late);
    EXPECT_FALSE(late->is_open());
    EXPECT_EQ(directory_.find(first.worker), nullptr);
}

TEST_F(Directory, ACutOffWorkerIsLostWhenItsConnectionHasEnded) {
    const Reception first = join(hello(1));
    reports_.work.draining = true;
    directory_.cut_off(first.worker, {ErrorCode::BadFrame, "nonsense"});
    EXPECT_FALSE(at(first).channel->is_open());
    EXPECT_EQ(reports_.take(), "joined 1");
    end_connection(first);
    EXPECT_EQ(reports_.take(), "left 1");
    EXPECT_EQ(directory_.counts().lost, 1u);
    reports_.work.draining = false;
    const Reception second = join(hello(2));
    end_connection(second);
    directory_.cut_off(second.worker, {ErrorCode::BadFrame, "nonsense"});
    EXPECT_EQ(reports_.take(), "joined 2, detached 2, left 2") << "it had no connection";
    EXPECT_EQ(directory_.counts().lost, 2u);
}

TEST_F(Directory, AWorkerThatWasToGoLeavesAndIsNotLost) {
    const Reception drained = join(hello(1));
    const Reception dismissed = join(hello(2));
    const Reception quarantined = join(hello(3));
    const Reception far = join(hello(4));
    end_connection(far);
    reports_.take();
    directory_.dismiss(far.worker);
    EXPECT_EQ(reports_.take(), "left 4") << "it had no connection";
    directory_.dismiss(dismissed.worker);
    EXPECT_EQ(reports_.take(), "");
    end_connection(dismissed);
    EXPECT_EQ(directory_.quarantine(at(quarantined).author->process),
              std::vector{quarantined.worker});
    EXPECT_TRUE(directory_.statuses().at(1).quarantined);
    end_connection(quarantined);
    reports_.work.draining = true;
    end_connection(drained);
    EXPECT_EQ(reports_.take(), "left 2, left 3, left 1");
    EXPECT_EQ(directory_.counts().lost, 0u);
    EXPECT_FALSE(directory_.is_watching());
}

TEST_F(Directory, ADrainingWorkerWithWorkMayComeBack) {
    const Reception first = join(hello(1));
    reports_.work.draining = true;
    reports_.work.working = 1;
    end_connection(first);
    EXPECT_EQ(reports_.take(), "joined 1, detached 1");
    EXPECT_TRUE(directory_.receive(hello(1, first), "").is_resumed);
}

TEST_F(Directory, AfterTheEndOfTheMasterNoConnectionIsMissed) {
    const Reception first = join(hello(1));
    reports_.take();
    directory_.close();
    end_connection(first);
    EXPECT_EQ(reports_.take(), "");
}

TEST_F(Directory, SessionsOfOneProcessShareTheirIntake) {
    const Reception first = join(hello(1));
    const auto intake = directory_.intake_of(first.worker);
    intake->messages = 3;
    const Reception second = join(hello(1));
    EXPECT_EQ(directory_.intake_of(second.worker), intake);
    EXPECT_NE(directory_.intake_of(join(hello(2)).worker), intake);
}

} // namespace
} // namespace cd::tests

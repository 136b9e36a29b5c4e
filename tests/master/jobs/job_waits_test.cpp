// Proves who is woken by a job's event.
#include "master/jobs/job_waits.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace cd::tests {
namespace {

class Waits : public testing::Test {
  protected:
    /// Begins to wait; the result is set when the wait ends.
    void
    begin(JobId job, std::optional<bool>& woken, JobWaits::Time until = JobWaits::Time::max()) {
        asio::co_spawn(context_, waits_.wait(job, until), [&woken](const auto&, bool result) {
            woken = result;
        });
        context_.poll();
    }

    asio::io_context context_;
    JobWaits waits_{context_.get_executor()};
};

TEST_F(Waits, AnEventEndsAllWaitsForItsJobAndNoOthers) {
    std::optional<bool> first;
    std::optional<bool> second;
    std::optional<bool> other;
    begin(JobId{1}, first);
    begin(JobId{1}, second);
    begin(JobId{2}, other);
    EXPECT_FALSE(first || second || other);
    waits_.wake(JobId{1});
    context_.poll();
    EXPECT_EQ(first, true);
    EXPECT_EQ(second, true);
    EXPECT_FALSE(other);
    waits_.wake(JobId{2});
    context_.poll();
    EXPECT_EQ(other, true);
}

TEST_F(Waits, AWaitEndsWithoutAnEventWhenItsTimeIsUp) {
    std::optional<bool> woken;
    begin(JobId{1}, woken, JobWaits::Time::min());
    EXPECT_EQ(woken, false);
}

TEST_F(Waits, ATimerMayBeGoneBeforeTheEvent) {
    const auto kept = std::make_shared<asio::steady_timer>(context_, JobWaits::Time::max());
    bool is_cancelled = false;
    kept->async_wait([&](const auto& error) { is_cancelled = bool(error); });
    waits_.notify(JobId{1}, kept);
    waits_.notify(JobId{1}, std::make_shared<asio::steady_timer>(context_));
    waits_.wake(JobId{1});
    context_.poll();
    EXPECT_TRUE(is_cancelled);
}

} // namespace
} // namespace cd::tests

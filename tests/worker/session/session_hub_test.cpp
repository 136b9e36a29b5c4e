// Proves that events which arrive together settle a session once, and that a session which is over
// runs nothing more.
#include "worker/session/session_hub.hpp"

#include "tests/worker/session/parts.hpp"

#include <latch>

namespace cd::tests {
namespace {

struct Hub : HubStage {};

TEST_F(Hub, SettlesOnceForEventsThatArriveTogether) {
    hub->settle_soon();
    hub->settle_soon();
    context.poll();
    EXPECT_EQ(hub->settled, 1u);
    hub->settle_soon();
    context.poll();
    EXPECT_EQ(hub->settled, 2u);
}

TEST_F(Hub, DoesNotSettleWhenItIsGone) {
    std::size_t settled = 0;
    hub->on_settle = [&] { ++settled; };
    hub->settle_soon();
    hub.reset();
    context.poll();
    EXPECT_EQ(settled, 0u);
}

TEST_F(Hub, ContinuesOnItsHomeWhatAThreadHasDone) {
    int done = 0;
    hub->run_on_thread([&] { return [&, made = 7] { done = made; }; });
    run_until([&] { return done != 0; });
    EXPECT_EQ(done, 7);
}

TEST_F(Hub, SkipsJobsAndContinuationsOnceItIsOver) {
    std::latch begun(1);
    std::latch is_over(1);
    int ran = 0;
    hub->run_on_thread([&] {
        begun.count_down();
        is_over.wait();
        return [&] { ran += 1; };
    });
    hub->run_on_thread([&] {
        ran += 2;
        return [&] { ran += 4; };
    });
    begun.wait();
    EXPECT_TRUE(hub->end_threads());
    EXPECT_FALSE(hub->end_threads()) << "it is over already";
    is_over.count_down();
    bool is_last = false;
    executor.submit([&] { return [&] { is_last = true; }; });
    run_until([&] { return is_last; });
    EXPECT_EQ(ran, 0);
}

} // namespace
} // namespace cd::tests

// Proves, with real processes, that a faulty network under TLS costs a worker only time: damaged
// data is refused before any program reads it.
#include "tests/cluster/broken_network.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

class SecuredNetwork : public BrokenNetwork {
  protected:
    SecuredNetwork() : BrokenNetwork(Links::Secured) {}
};

TEST_F(SecuredNetwork, ASessionGoesOnAfterItsConnectionIsCut) {
    start_job(2000);
    for (int cut = 0; cut < 5; ++cut) {
        progress(200);
        proxy_.cut();
    }
    expect_right();
    EXPECT_GE(resumed(), 3u);
    EXPECT_THAT(master_.log(), HasSubstr("tls=true"));
}

TEST_F(SecuredNetwork, AHalfOpenConnectionIsNoticedAtBothEndsAndTheSessionGoesOn) {
    start_job(1500);
    for (int round = 0; round < 2; ++round) {
        progress(250);
        const std::uint64_t before = proxy_.connections();
        proxy_.set(Weather::Swallowed);
        wait_for_state(WorkerState::Silent);
        EXPECT_TRUE(comes_true([&] { return proxy_.connections() > before; }))
            << "the worker noticed";
        proxy_.set(Weather::Fair);
        wait_for_state(WorkerState::Alive);
    }
    EXPECT_GT(proxy_.swallowed(), 0u);
    expect_right();
    EXPECT_GE(resumed(), 2u);
}

/// A heartbeat of 1 s, so that a peer counts as silent after 3 s: TLS delivers a record of up to
/// 16 KiB only once it is complete, which takes over a second while the proxy trickles.
class SlowSecuredNetwork : public BrokenNetwork {
  protected:
    SlowSecuredNetwork() : BrokenNetwork(Links::Secured, "1") {}
};

TEST_F(SlowSecuredNetwork, ATrickleOnlyCostsTime) {
    start_job(1500);
    progress(300);
    proxy_.set(Weather::Trickling);
    EXPECT_TRUE(comes_true([&] { return proxy_.trickled() > 0; }));
    progress(100);
    proxy_.set(Weather::Fair);
    expect_right();
}

TEST_F(SecuredNetwork, ADamagedRecordIsRefusedAndTheWorkerComesBack) {
    start_job(2500);
    for (std::uint64_t round = 0; round < 6; ++round) {
        progress(150);
        proxy_.damage(round % 2 == 0);
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > round; }));
        status_when([&](const ClusterStatus& now) { return now.losses.sessions_resumed > round; });
    }
    expect_right();
    EXPECT_THAT(master_.log(), HasSubstr("bad record mac"));
    EXPECT_THAT(workers_[0]->errors(), HasSubstr("bad record mac"));
}

TEST_F(SecuredNetwork, ADamagedHandshakeIsNoRefusal) {
    start_job(2500);
    for (std::uint64_t round = 0; round < 6; ++round) {
        progress(150);
        proxy_.damage_greeting(round % 2 == 0);
        proxy_.cut();
        EXPECT_TRUE(comes_true([&] { return proxy_.damaged() > round; }));
        status_when([&](const ClusterStatus& now) { return now.losses.sessions_resumed > round; });
        ASSERT_TRUE(workers_[0]->is_running()) << workers_[0]->errors();
    }
    expect_right();
    EXPECT_THAT(workers_[0]->errors(), HasSubstr("TLS handshake"));
}

} // namespace
} // namespace cd::tests

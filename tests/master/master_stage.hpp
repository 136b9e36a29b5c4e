// A whole master in the test's process, for `fake_worker.hpp` and `fake_client.hpp`.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/identity/identity.hpp"
#include "master/net/server.hpp"
#include "proto/channel/connection.hpp"
#include "proto/channel/endpoint.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <utility>

namespace cd::tests {

inline constexpr std::chrono::seconds patience{60};

/// Settings that differ from a default master's.
struct Stage {
    ClientLimits clients = {};
    bool is_secured = false; ///< With an identity, made if it does not exist.
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
};

/// A whole master on one context, which the test runs.
class Master {
  public:
    /// By default, a worker whose connection breaks does not return.
    explicit Master(
        const FailureTimes& failure_times = {.return_within = std::chrono::milliseconds(0)},
        const std::filesystem::path& state = {}, ///< Empty: a temporary folder.
        const Stage& stage = {})
        : directory(state.empty() ? folder.path() : state),
          times(failure_times),
          coordinator({context.get_executor(),
                       *store,
                       compute,
                       blocking,
                       *journal,
                       directory / "jobs",
                       Durability::Unsynced,
                       times,
                       stage.results_aside_bytes_max}),
          identity(stage.is_secured ? make_identity() : nullptr),
          server(std::move(Server::listen(context.get_executor(),
                                          {"127.0.0.1", 0},
                                          coordinator,
                                          identity.get(),
                                          stage.clients)
                               .value())) {
        EXPECT_TRUE(coordinator.restore(journal->take_recovered()));
        server->start();
    }
    ~Master() { end(); }

    /// Finishes handlers that have begun, and starts no more.
    void end() {
        server->close();
        context.run_for(patience);
    }

    /// Runs all handlers until the condition holds.
    template <class Condition>
    void run_until(Condition condition) {
        const auto deadline = std::chrono::steady_clock::now() + patience;
        while (!condition() && std::chrono::steady_clock::now() < deadline) {
            context.run_one_for(std::chrono::seconds(1));
        }
        ASSERT_TRUE(condition()) << "this took too long";
    }
    [[nodiscard]] Endpoint endpoint() const { return {"127.0.0.1", server->port()}; }
    /// Returns a target for a holder of that name and role; plain without an identity.
    [[nodiscard]] Target target(CertifiedRole role, const std::string& holder) const {
        if (identity == nullptr) {
            return endpoint();
        }
        const auto authority =
            CertificateAuthority::parse(read_text(directory / "identity/authority.pem"),
                                        read_text(directory / "identity/authority.key"));
        const WallTime now = identity->now();
        const std::chrono::hours hour(1);
        return {endpoint(),
                Tls::make(authority.value().issue({role, holder, now - hour, now + hour})).value()};
    }

    TemporaryFolder folder;
    std::filesystem::path directory;
    asio::io_context context{1};
    ThreadPool compute{2};
    std::unique_ptr<GeometryStore> store =
        std::move(GeometryStore::open(directory, compute).value());
    std::unique_ptr<Journal> journal =
        std::move(Journal::open({.directory = directory, .synced = false}).value());
    ThreadPool blocking{2};
    FailureTimes times;
    Coordinator coordinator;
    std::unique_ptr<MasterIdentity> identity;
    std::unique_ptr<Server> server;

  private:
    [[nodiscard]] std::unique_ptr<MasterIdentity> make_identity() const {
        const MasterIdentity::Options options{std::chrono::hours(1)};
        if (!std::filesystem::exists(directory / "identity")) {
            EXPECT_TRUE(MasterIdentity::init(directory, options));
        }
        return std::move(MasterIdentity::open(directory, options).value());
    }
};

/// The end of a peer's conversation with the master. It must come before the test ends.
struct Ending {
    bool& ended;
    ~Ending() { ended = true; }
};

inline void hang_up(Master& master, const std::shared_ptr<Channel>& channel, const bool& ended) {
    while (!ended) {
        if (channel != nullptr) {
            channel->close();
        }
        master.context.run_one_for(std::chrono::seconds(1));
    }
}

} // namespace cd::tests

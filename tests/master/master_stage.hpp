// A whole master in the test's process, for `fake_worker.hpp` and `fake_client.hpp`.
#pragma once

#include "common/core/files/disk_file.hpp"
#include "common/core/limits/master.hpp"
#include "master/coordinator/coordinator.hpp"
#include "master/identity/identity.hpp"
#include "master/net/server.hpp"
#include "tests/support/process.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <latch>
#include <memory>
#include <string>
#include <utility>

namespace cd::tests {

inline constexpr std::chrono::seconds patience{60};

/// A worker whose connection breaks does not return.
inline constexpr FailureTimes no_return{.return_within = std::chrono::milliseconds(0)};

[[nodiscard]] inline Hello hello_of_worker(const std::string& name, InstanceId process) {
    Hello hello;
    hello.role = Role::Worker;
    hello.name = name;
    hello.threads = 1;
    hello.cache_bytes = 1 << 20;
    hello.instance = process;
    return hello;
}

/// Appends a record as `Results` has it, before packing.
inline void put_record(ByteWriter& records, const Bytes& record) {
    records.put(static_cast<std::uint32_t>(record.size()));
    put_bytes(records, record);
}

/// Keeps the pool's threads busy until the latch is counted down.
inline std::shared_ptr<std::latch> occupy(ThreadPool& pool) {
    const auto released = std::make_shared<std::latch>(1);
    for (std::size_t thread = 0; thread < pool.size(); ++thread) {
        pool.post([released] { released->wait(); });
    }
    return released;
}

/// Returns when all work posted before has ended.
inline void wait_for_all(ThreadPool& pool) {
    const auto all = std::make_shared<std::latch>(pool.size() + 1);
    for (std::size_t thread = 0; thread < pool.size(); ++thread) {
        pool.post([all] { all->arrive_and_wait(); });
    }
    all->arrive_and_wait();
}

/// Runs all handlers until the condition holds.
template <class Condition>
void run_until(asio::io_context& context, const Condition& condition) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!condition() && std::chrono::steady_clock::now() < deadline) {
        context.run_one_for(std::chrono::seconds(1));
    }
    ASSERT_TRUE(condition()) << "this took too long";
}

/// Settings that differ from a default master's.
struct Stage {
    ClientLimits clients = {};
    bool is_secured = false; ///< With an identity, made if it does not exist.
    std::uint64_t results_aside_bytes_max = limits::results_aside_bytes_max;
};

/// A whole master on one context, which the test runs.
class Master {
  public:
    explicit Master(const FailureTimes& failure_times = no_return,
                    const std::filesystem::path& state = {}, ///< Empty: a temporary folder.
                    const Stage& stage = {})
        : directory(state.empty() ? folder.path() : state),
          times(failure_times),
          coordinator({context.get_executor(),
                       loop,
                       tcp_network(),
                       geometry,
                       store.get(),
                       compute,
                       blocking,
                       *journal,
                       directory / "jobs",
                       {.durability = Durability::Unsynced,
                        .times = times,
                        .results_aside_bytes_max = stage.results_aside_bytes_max}}),
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

    template <class Condition>
    void run_until(const Condition& condition) {
        tests::run_until(context, condition);
    }
    /// Runs until the job's geometry is loaded.
    void run_until_prepared(JobId job) {
        run_until([&] { return coordinator.jobs().explainer().input(job).has_value(); });
    }
    void run_until_quarantined() {
        run_until([&] { return quarantined() == 1; });
    }
    [[nodiscard]] JobStatus status(JobId job) { return coordinator.jobs().status(job).value(); }
    [[nodiscard]] ClusterStatus cluster() { return coordinator.jobs().cluster(); }
    [[nodiscard]] std::size_t quarantined() {
        const auto workers = cluster().workers;
        return static_cast<std::size_t>(
            std::ranges::count(workers, true, &WorkerStatus::quarantined));
    }
    [[nodiscard]] std::uint64_t alarms() { return coordinator.alarms().record().count; }
    [[nodiscard]] bool has_result(JobId job, std::uint64_t scenario) {
        return coordinator.jobs().find(job)->results->has(scenario);
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
    AsioLoop loop{context.get_executor()};
    ThreadPool compute{2};
    std::unique_ptr<GeometryStore> store =
        std::move(GeometryStore::open(directory, compute).value());
    StoredGeometry geometry{*store};
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

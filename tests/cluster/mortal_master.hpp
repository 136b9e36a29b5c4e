// A master process that tests kill and restart, with helpers.
#pragma once

#include "proto/access/credential_file.hpp"
#include "tests/cluster/cluster_fixture.hpp"

#include <chrono>
#include <csignal>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace cd::tests {

/// A wait beyond this limit fails the test. Only a hang takes so long, even under a sanitizer.
inline constexpr std::chrono::seconds patience{300};

/// A master that is killed and restarted, always on the port chosen by the system at first.
class MortalMaster {
  public:
    /// Every incarnation gets `options`, and listens at `host`.
    explicit MortalMaster(const TemporaryFolder& folder,
                          std::vector<std::string> options = {},
                          std::string host = "127.0.0.1")
        : folder_(folder), options_(std::move(options)), host_(std::move(host)) {
        start();
    }

    void start() {
        std::filesystem::remove(folder_ / "port");
        std::vector<std::string> command{program("cdmaster").string(),
                                         "--listen",
                                         address(),
                                         "--port-file",
                                         folder_ / "port",
                                         "--state",
                                         folder_ / "state"};
        command.insert(command.end(), options_.begin(), options_.end());
        ++lives;
        process_ = std::make_unique<Process>(command, folder_ / ("life" + std::to_string(lives)));
        while (!std::filesystem::exists(folder_ / "port") && process_->is_running()) {
            std::this_thread::yield();
        }
        ASSERT_TRUE(process_->is_running()) << process_->errors();
        port_ = static_cast<std::uint16_t>(std::stoi(read_text(folder_ / "port")));
    }

    /// Sets the options of later incarnations.
    void set_options(std::vector<std::string> options) { options_ = std::move(options); }

    void kill() {
        process_->signal(SIGKILL);
        EXPECT_EQ(process_->wait(), 128 + SIGKILL);
    }

    [[nodiscard]] std::string address() const { return host_ + ":" + std::to_string(port_); }
    [[nodiscard]] std::uint16_t port() const { return port_; }
    [[nodiscard]] Process& process() { return *process_; }
    /// Returns the log of the current incarnation.
    [[nodiscard]] std::string log() const { return process_->errors(); }

    int lives = 0;

  private:
    const TemporaryFolder& folder_;
    std::vector<std::string> options_;
    std::string host_;
    std::uint16_t port_ = 0;
    std::unique_ptr<Process> process_;
};

/// Security of a cluster's connections.
enum class Links { Plain, Secured };

/// A mortal master with workers and jobs.
class MortalCluster : public testing::Test {
  protected:
    explicit MortalCluster(std::vector<std::string> options = {}, Links links = Links::Plain)
        : tls_(links == Links::Secured ? make_identity() : nullptr),
          master_(folder_, std::move(options)) {}

    [[nodiscard]] std::unique_ptr<Connection> connect() {
        return connect_to(master_.address(), tls_);
    }
    /// Kills the master, starts it again on its state, and connects again.
    void restart_master(std::unique_ptr<Connection>& connection) {
        connection.reset();
        master_.kill();
        master_.start();
        connection = connect();
    }

    Process& start_worker(unsigned threads = 1, const std::vector<std::string>& options = {}) {
        return start_worker_at(master_.address(), threads, options);
    }
    Process& start_worker_at(const std::string& address,
                             unsigned threads = 1,
                             const std::vector<std::string>& options = {}) {
        const std::string name = "worker" + std::to_string(workers_.size());
        std::vector<std::string> command = worker_command(address, name, threads, options);
        if (tls_ != nullptr) {
            command.insert(command.end(), {"--state", give_credential(name, address)});
        }
        workers_.push_back(std::make_unique<Process>(std::move(command), folder_ / name));
        return *workers_.back();
    }

    static JobId submit(Connection& connection,
                        const Job& job,
                        const Query& query,
                        const ClusterOptions& options = many_blocks()) {
        return submit_job(connection, job, query, options);
    }

    /// Watches until so many scenarios are merged or the job has ended. Fails if it is long before
    /// another one is merged.
    static JobStatus watch_until(Connection& connection, JobId job, std::uint64_t merged) {
        JobStatus last;
        auto last_merged = std::chrono::steady_clock::now();
        for (;;) {
            if (std::chrono::steady_clock::now() > last_merged + patience) {
                ADD_FAILURE() << "stuck at " << last.summary.merged() << " scenarios";
                return last;
            }
            const auto status = connection.status();
            EXPECT_TRUE(status) << status.error().detail;
            if (!status) {
                return last;
            }
            for (const JobStatus& each : status.value().jobs) {
                if (each.job == job) {
                    if (each.summary.merged() > last.summary.merged()) {
                        last_merged = std::chrono::steady_clock::now();
                    }
                    last = each;
                }
            }
            if (last.summary.merged() >= merged || last.state != JobState::Running) {
                return last;
            }
        }
    }

    static JobStatus finish(Connection& connection, JobId job) {
        return finish_job(connection, job);
    }

    static std::uint64_t fetched(Connection& connection, const JobStatus& job) {
        ResultMerger merger(job.summary.total);
        const Status fetched =
            connection.fetch(job.job, 0, job.summary.total, [&](const ScenarioResult& result) {
                (void)merger.add(result);
                return Status(Done{});
            });
        EXPECT_TRUE(fetched) << fetched.error().detail;
        EXPECT_EQ(merger.digest(), job.digest);
        return merger.summary().merged();
    }

    /// Makes an identity that all later incarnations use.
    [[nodiscard]] std::shared_ptr<const Tls> make_identity() const {
        const std::vector<std::string> command{
            program("cdmaster").string(), "init", "--state", folder_ / "state"};
        const Ran made = tests::run(command);
        EXPECT_EQ(made.exit_code, 0) << made.errors;
        return Tls::make(read_credential(admin()).value()).value();
    }
    [[nodiscard]] std::filesystem::path admin() const {
        return folder_ / "state/identity/admin.pem";
    }
    /// Returns the state folder of a worker that may join the master at that address.
    [[nodiscard]] std::string give_credential(const std::string& worker,
                                              const std::string& address) const {
        const std::string state = folder_ / (worker + ".state");
        const auto authority =
            CertificateAuthority::parse(read_text(folder_ / "state/identity/authority.pem"),
                                        read_text(folder_ / "state/identity/authority.key"));
        const WallTime now = std::chrono::system_clock::now();
        const std::chrono::hours hour(1);
        EXPECT_TRUE(write_credential(
            credential_path(state, parse_endpoint(address).value()),
            authority.value().issue({CertifiedRole::Worker, worker, now - hour, now + hour})));
        return state;
    }

    TemporaryFolder folder_;
    std::shared_ptr<const Tls> tls_; ///< Null: plain.
    MortalMaster master_;
    std::vector<std::unique_ptr<Process>> workers_;
};

} // namespace cd::tests

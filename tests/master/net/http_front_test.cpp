// Proves that the HTTP endpoints report the master's state to authorised clients, and that
// connections without a complete request get nothing and do no harm.
#include "master/net/http_front.hpp"

#include "common/core/limits/wire.hpp"
#include "master/identity/identity.hpp"
#include "proto/channel/stream.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"
#include "tests/support/logged.hpp"
#include "web/status/job_id.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <vector>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Collects the response on one connection until the master closes it.
class Asking {
  public:
    Asking(Master& master, std::uint16_t port, std::shared_ptr<const Tls> tls, std::string text)
        : text_(std::move(text)) {
        asio::ip::tcp::socket socket(master.context);
        socket.connect({asio::ip::address_v4::loopback(), port});
        stream_ = std::make_unique<Stream>(std::move(socket));
        spawn(master.context.get_executor(), "asking", begin(std::move(tls)));
        master.run_until([&] { return is_over_; });
    }
    [[nodiscard]] const std::string& answer() const { return answer_; }

  private:
    asio::awaitable<void> begin(std::shared_ptr<const Tls> tls) {
        Status secured = Done{};
        if (tls != nullptr) {
            secured = co_await stream_->secure(std::move(tls), TlsEnd::Connecting, patience);
        }
        EXPECT_TRUE(secured) << secured.error().detail;
        stream_->write({asio::buffer(text_), asio::const_buffer()}, [](auto&&...) {});
        read();
    }
    void read() {
        stream_->read_some(asio::buffer(part_), [this](const auto& error, std::size_t bytes) {
            answer_.append(part_.data(), bytes);
            is_over_ = static_cast<bool>(error);
            if (!is_over_) {
                read();
            }
        });
    }

    std::string text_;
    std::unique_ptr<Stream> stream_;
    std::array<char, 1024> part_{};
    std::string answer_;
    bool is_over_ = false;
};

std::string request_for(const std::string& target) {
    return "GET " + target + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
}

/// Makes triangles in parallel planes across axis 0 or 1; each spans the whole fan of the other
/// axis.
Mesh make_fan(std::uint32_t count, int axis) {
    MeshArrays arrays;
    for (std::uint32_t i = 0; i < count; ++i) {
        for (const auto& [across, up] : {std::array{-9.0, -9.0}, {9.0, -9.0}, {0.0, 9.0}}) {
            Vec3 corner;
            corner[axis] = i / static_cast<double>(count) - 0.5;
            corner[1 - axis] = across;
            corner[2] = up;
            arrays.vertices.push_back(corner);
        }
        arrays.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return Mesh::create(std::move(arrays)).value();
}

std::unique_ptr<HttpFront> make_front(Master& master, MasterIdentity* identity = nullptr) {
    auto made = HttpFront::listen(
        master.context.get_executor(), {"127.0.0.1", 0}, master.coordinator, identity);
    made.value()->start();
    return std::move(made.value());
}

class HttpPages : public testing::Test {
  protected:
    std::string ask(const std::string& text) {
        return Asking(master_, front_->port(), nullptr, text).answer();
    }
    std::string get(const std::string& target) { return ask(request_for(target)); }

    Master master_;
    std::unique_ptr<HttpFront> front_ = make_front(master_);
};

TEST_F(HttpPages, HealthReadinessAndMetricsAreServed) {
    EXPECT_THAT(get("/healthz"), StartsWith("HTTP/1.1 200 OK\r\n"));
    EXPECT_THAT(get("/readyz"), HasSubstr("\r\n\r\nready\n"));
    FakeWorker worker(master_, {});
    Client client(master_);
    client.start(reference().submission());
    master_.run_until([&] { return client.done; });
    const std::string metrics = get("/metrics");
    EXPECT_THAT(metrics, HasSubstr("Content-Type: text/plain; version=0.0.4"));
    EXPECT_THAT(metrics, HasSubstr("\ncdcluster_jobs{state=\"done\"} 1\n"));
    EXPECT_THAT(metrics, HasSubstr("\ncdcluster_workers{state=\"alive\"} 1\n"));
    EXPECT_THAT(metrics, HasSubstr("Content-Length: "));
    const std::string scenarios = std::to_string(reference().scenarios.size());
    EXPECT_THAT(metrics, HasSubstr("\ncdcluster_scenarios_total " + scenarios + "\n"));
    EXPECT_THAT(metrics, Not(HasSubstr("\ncdcluster_results_bytes_total 0\n")));
    EXPECT_THAT(metrics, Not(HasSubstr("\ncdcluster_journal_commit_seconds_count 0\n")));
    EXPECT_THAT(metrics, HasSubstr("\ncdcluster_http_requests_total{code=\"200\"} 2\n"));
    EXPECT_THAT(get("/nowhere"), StartsWith("HTTP/1.1 404 "));
    EXPECT_THAT(get("/metrics"), HasSubstr("\ncdcluster_http_requests_total{code=\"404\"} 1\n"));
    std::string measured; // The disk is measured meanwhile.
    while (measured.find("\ncdcluster_state_free_bytes ") == std::string::npos) {
        measured = get("/metrics");
    }
    EXPECT_THAT(measured, HasSubstr("\ncdcluster_state_total_bytes "));
}

TEST(HttpPagesOfAPausedJob, ReadinessIsRefusedWithTheReasonOfThePause) {
    const TemporaryFolder state;
    const std::chrono::milliseconds at_once(0);
    {
        Master master({.return_within = at_once}, state.path());
        Client client(master);
        client.start_submitting(reference().submission());
        master.run_until([&] { return client.done; });
    }
    const auto mesh = state / "meshes" / (to_hex(reference().a.hash()) + ".mesh");
    const std::string whole = read_text(mesh);
    write_text(mesh, "rubbish");
    Master master({.return_within = at_once}, state.path());
    const auto front = make_front(master);
    const auto ready = [&] {
        return Asking(master, front->port(), nullptr, request_for("/readyz")).answer();
    };
    master.run_until(
        [&] { return !master.coordinator.jobs().cluster().jobs.at(0).paused.empty(); });
    const std::string answer = ready();
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 503 "));
    EXPECT_THAT(answer, HasSubstr("job 1 is paused: " + mesh.string()));
    const std::vector<JobId> ids{JobId{1}};
    const std::string scenario = "/api/v1/jobs/" + job_id_text(JobId{1}, ids) + "/scenarios/0";
    const auto run_again = [&] {
        return Asking(master, front->port(), nullptr, request_for(scenario)).answer();
    };
    EXPECT_THAT(run_again(), StartsWith("HTTP/1.1 503 "));
    EXPECT_THAT(run_again(), HasSubstr("no scenario is run again: job 1 is paused"));
    write_text(mesh, whole);
    master.run_until([&] { return master.coordinator.jobs().cluster().jobs.at(0).paused.empty(); });
    EXPECT_THAT(ready(), StartsWith("HTTP/1.1 200 "));
    EXPECT_THAT(run_again(), StartsWith("HTTP/1.1 200 "));
}

TEST_F(HttpPages, AScenarioThatTakesLongIsStopped) {
    // Each triangle of A crosses each of B: 144 million pairs take far longer than a second.
    const Mesh a = make_fan(12'000, 0);
    const Mesh b = make_fan(12'000, 1);
    for (const Mesh* const mesh : {&a, &b}) {
        const Bytes bytes = mesh->canonical_bytes();
        std::vector<Message> parts;
        for (std::size_t at = 0; at < bytes.size(); at += limits::mesh_answer_bytes) {
            const std::size_t end =
                std::min<std::size_t>(bytes.size(), at + limits::mesh_answer_bytes);
            parts.emplace_back(MeshPart{mesh->hash(),
                                        "fan",
                                        bytes.size(),
                                        at,
                                        Bytes(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                                              bytes.begin() + static_cast<std::ptrdiff_t>(end))});
        }
        ASSERT_TRUE(std::holds_alternative<MeshStored>(answer_to(master_, parts)));
    }
    Submit submit = submission(Grid{});
    submit.bodies = {{a.hash(), "a"}, {b.hash(), "b"}};
    const JobId job = std::get<Accepted>(answer_to(master_, {submit})).job;
    const std::vector<JobId> ids{job};
    // Without a worker there is no result, so the scenario is run for its contacts alone.
    const std::string pairs = get("/api/v1/jobs/" + job_id_text(job, ids) + "/scenarios/0/pairs");
    EXPECT_THAT(pairs, StartsWith("HTTP/1.1 200 "));
    EXPECT_THAT(pairs, HasSubstr("'shape': (0, 3)")) << "no pairs: the run did not end";
}

TEST_F(HttpPages, OtherRequestsAreRefusedWithAReason) {
    EXPECT_THAT(get("/jobs"), StartsWith("HTTP/1.1 404 "));
    EXPECT_THAT(ask("POST /metrics HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n"),
                StartsWith("HTTP/1.1 405 "));
    EXPECT_THAT(ask("what is this\r\n\r\n"), StartsWith("HTTP/1.1 400 "));
    EXPECT_THAT(ask(std::string(8, '\0')), StartsWith("HTTP/1.1 400 "));
    const std::string endless(2 * limits::http_request_bytes_max, 'x');
    // The answer may get lost, since the master does not read the rest.
    EXPECT_THAT(ask("GET /" + endless), Not(HasSubstr("200")));
    EXPECT_THAT(get("/healthz"), StartsWith("HTTP/1.1 200 "));
}

TEST(SecuredHttpPages, MetricsNeedARoleThatMaySeeTheCluster) {
    const TemporaryFolder folder;
    const MasterIdentity::Options options{std::chrono::hours(1)};
    ASSERT_TRUE(MasterIdentity::init(folder.path(), options));
    const auto identity = std::move(MasterIdentity::open(folder.path(), options).value());
    Master master;
    const auto front = make_front(master, identity.get());
    const auto get = [&](const std::shared_ptr<const Tls>& tls, const std::string& target) {
        return Asking(master, front->port(), tls, request_for(target)).answer();
    };
    const auto tls_of = [&](CertifiedRole role) {
        const CertificateRequest request = make_certificate_request();
        const Identity holder{role, "someone", {}, {}};
        const Certified certified = identity->renew({request.request}, holder).value();
        return Tls::make({request.key, certified.certificate, certified.authority}).value();
    };
    const auto nobody = Tls::make_joining(identity->fingerprint());
    EXPECT_THAT(get(nobody, "/healthz"), StartsWith("HTTP/1.1 200 "));
    {
        const Logged logged;
        EXPECT_THAT(get(nobody, "/metrics"), StartsWith("HTTP/1.1 403 "));
        EXPECT_THAT(logged.text(), HasSubstr("http request refused: peer=127.0.0.1:"));
        EXPECT_THAT(logged.text(), HasSubstr("certificate of a nobody"));
    }
    EXPECT_THAT(get(tls_of(CertifiedRole::Worker), "/metrics"), StartsWith("HTTP/1.1 403 "));
    EXPECT_THAT(get(tls_of(CertifiedRole::Metrics), "/metrics"), StartsWith("HTTP/1.1 200 "));
    const std::string metrics = get(tls_of(CertifiedRole::Admin), "/metrics");
    EXPECT_THAT(metrics, StartsWith("HTTP/1.1 200 "));
    const auto until = identity->tls()->now->identity()->until.time_since_epoch();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(until).count();
    EXPECT_THAT(
        metrics,
        HasSubstr("\ncdcluster_certificate_expires_timestamp_seconds " + std::to_string(seconds)));
    const auto other = make_front(master, identity.get());
    const Logged logged;
    EXPECT_THAT(Asking(master, other->port(), nullptr, request_for("/healthz")).answer(),
                Not(HasSubstr("200")));
    EXPECT_THAT(logged.text(), HasSubstr("http connection refused: peer=127.0.0.1:"));
}

} // namespace
} // namespace cd::tests

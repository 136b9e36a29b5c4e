// Proves, with real processes, that the page's data reach a browser: from `cdctl view` of a folder,
// a job and a cluster, and from cdmaster, plain and with an identity; and that Ctrl-C ends `view`.
#include "common/core/files/npy_header.hpp"
#include "common/job/result/record_file.hpp"
#include "proto/access/credential_file.hpp"
#include "tests/cluster/cdctl_runs.hpp"
#include "tests/cluster/mortal_master.hpp"
#include "tests/proto/http_ask.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/terminal.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <regex>

namespace cd::tests {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

/// A page that a program of this machine serves.
struct PageAddress {
    std::uint16_t port = 0;
    std::string key;

    [[nodiscard]] HttpReply get(const std::string& target) const {
        return http_ask(
            port,
            request_text("GET", "/api/v1/" + target, "Authorization: Bearer " + key + "\r\n"));
    }
};

/// Finds the address that a program printed on a line of its own.
std::optional<PageAddress> find_page(const std::string& text) {
    static const std::regex form("http://127.0.0.1:([0-9]+)/#key=([0-9a-f]{32})\r?\n");
    std::smatch found;
    if (!std::regex_search(text, found, form)) {
        return std::nullopt;
    }
    return PageAddress{static_cast<std::uint16_t>(std::stoi(found[1].str())), found[2].str()};
}

/// A running `cdctl view`.
class Viewing {
  public:
    Viewing(const TemporaryFolder& folder, std::vector<std::string> words)
        : process_(command(std::move(words)), folder_of(folder)) {
        EXPECT_TRUE(comes_true([&] {
            const auto page = find_page(process_.output());
            page_ = page.value_or(page_);
            return page || !process_.is_running();
        })) << process_.errors();
    }

    [[nodiscard]] HttpReply get(const std::string& target) const { return page_.get(target); }
    [[nodiscard]] std::uint16_t port() const { return page_.port; }
    [[nodiscard]] Process& process() { return process_; }

  private:
    static std::vector<std::string> command(std::vector<std::string> words) {
        words.insert(words.begin(), {cdctl(), "view", "--no-browser"});
        return words;
    }
    static fs::path folder_of(const TemporaryFolder& folder) {
        static int number = 0;
        return folder / ("view" + std::to_string(++number));
    }

    Process process_;
    PageAddress page_;
};

std::string first_job(const HttpReply& jobs) {
    std::smatch found;
    return std::regex_search(jobs.body, found, std::regex("\"job\":\"(j-[0-9a-f]+)\""))
               ? found[1].str()
               : "none in " + jobs.body;
}

/// The classes in an answer; empty if it is none.
std::vector<std::uint8_t> classes_in(const HttpReply& reply) {
    const auto header = parse_npy_header(reply.bytes());
    EXPECT_TRUE(header) << reply.status << reply.body;
    if (!header) {
        return {};
    }
    const auto data = reply.bytes().subspan(header.value().data_offset);
    std::vector<std::uint8_t> classes;
    for (const std::byte each : data) {
        classes.push_back(std::to_integer<std::uint8_t>(each));
    }
    return classes;
}

/// Checks all that the page asks of a job against its results in one process.
template <class Get>
void expect_job(const Get& get, const Job& job, const Query& query, const std::string& id) {
    const std::string base = "jobs/" + id;
    const HttpReply view = get(base);
    EXPECT_EQ(view.status, 200) << view.body;
    EXPECT_THAT(view.body, HasSubstr("\"digest\":\"" + to_hex(job.digest_in_one_process(query))));
    const std::string count = std::to_string(job.scenarios.size());
    const auto classes = classes_in(get(base + "/classes?first=0&count=" + count));
    const auto sample = classes_in(get(base + "/classes?sample=5"));
    ASSERT_EQ(classes.size(), job.scenarios.size());
    ASSERT_EQ(sample.size(), 5u);
    const ScenarioRunner runner(*job.a, *job.b, query);
    std::optional<std::uint64_t> contact;
    for (std::uint64_t i = 0; i < classes.size(); ++i) {
        const ScenarioResult result = runner.run(job.scenarios[i]).result;
        EXPECT_EQ(classes[i], static_cast<std::uint8_t>(result.kind));
        contact = !contact && result.pair_count > 0 && i > 0 ? std::optional(i) : contact;
    }
    EXPECT_EQ(sample[3], classes[3 * classes.size() / 5]);
    const auto large = classes_in(get(base + "/classes?sample=4096"));
    ASSERT_EQ(large.size(), 4096u);
    EXPECT_EQ(large[4000], classes[4000 * classes.size() / 4096]);
    const auto few = parse_npy_header(get(base + "/poses?sample=3").bytes());
    ASSERT_TRUE(few);
    EXPECT_THAT(few.value().shape, testing::ElementsAre(3, 12));
    ASSERT_TRUE(contact);
    const std::string one = base + "/scenarios/" + std::to_string(*contact);
    const HttpReply scenario = get(one);
    EXPECT_EQ(scenario.status, 200);
    EXPECT_THAT(scenario.body, HasSubstr("\"verified\":true"));
    const auto pairs = parse_npy_header(get(one + "/pairs").bytes());
    const auto points = parse_npy_header(get(one + "/points").bytes());
    ASSERT_TRUE(pairs && points);
    EXPECT_EQ(pairs.value().shape[0], runner.run(job.scenarios[*contact]).result.pair_count);
    EXPECT_GE(points.value().shape[0], pairs.value().shape[0]);
    const auto poses = parse_npy_header(get(base + "/poses?first=0&count=3").bytes());
    ASSERT_TRUE(poses);
    EXPECT_THAT(poses.value().shape, testing::ElementsAre(3, 12));
    EXPECT_THAT(get(base + "/scenarios/next?from=" + std::to_string(*contact - 1)).body,
                HasSubstr("\"index\":"));
    const Sha256 mesh = job.a->mesh().hash();
    EXPECT_EQ(to_hex(sha256(get("meshes/" + to_hex(mesh)).bytes())), to_hex(mesh));
    EXPECT_EQ(get("jobs/j-nosuch").status, 404);
    EXPECT_EQ(get(base + "/scenarios/" + count).status, 404);
}

std::uint16_t http_port_of(const MortalMaster& master) {
    std::smatch found;
    std::string log;
    EXPECT_TRUE(comes_true([&] {
        log = master.log();
        return std::regex_search(log, found, std::regex("http listening: host=.* port=([0-9]+)"));
    })) << log;
    return found.empty() ? std::uint16_t{0} : static_cast<std::uint16_t>(std::stoi(found[1].str()));
}

class PageOfAMaster : public MortalCluster {
  protected:
    explicit PageOfAMaster(Links links = Links::Plain)
        : MortalCluster({"--http", "127.0.0.1:0"}, links) {}

    static constexpr std::uint64_t scenarios_ = 300;
    const Job job_ = make_job(scenarios_);
    const Query query_{Level::Count, 0, {}, true};
};

class SecuredPageOfAMaster : public PageOfAMaster {
  protected:
    SecuredPageOfAMaster() : PageOfAMaster(Links::Secured) {}

    /// Writes a credential as the authority itself could have issued it.
    [[nodiscard]] fs::path credential_of(CertifiedRole role) const {
        const fs::path identity = folder_ / "state" / "identity";
        const auto authority = CertificateAuthority::parse(read_text(identity / "authority.pem"),
                                                           read_text(identity / "authority.key"));
        const std::chrono::hours hour(1);
        const WallTime now = std::chrono::system_clock::now();
        const fs::path path = folder_ / (std::string(to_text(role)) + ".pem");
        EXPECT_TRUE(write_credential(
            path, authority.value().issue({role, "someone", now - hour, now + hour})));
        return path;
    }
    [[nodiscard]] HttpReply
    get(std::uint16_t port, const std::string& target, CertifiedRole role) const {
        const auto tls = Tls::make(read_credential(credential_of(role)).value()).value();
        return http_ask(port, request_text("GET", target), tls);
    }
};

} // namespace

TEST_F(PageOfAMaster, TheMasterAndCdctlShowTheSameJob) {
    start_worker();
    const auto connection = connect();
    const JobId id = submit_job(*connection, job_, query_, many_blocks());
    ASSERT_EQ(finish_job(*connection, id).state, JobState::Done);
    const std::uint16_t port = http_port_of(master_);
    const auto ask_master = [&](const std::string& target) {
        return http_ask(port, request_text("GET", "/api/v1/" + target));
    };
    const std::string name = first_job(ask_master("jobs"));
    expect_job(ask_master, job_, query_, name);
    const Viewing viewing(folder_, {name, "--master", master_.address()});
    expect_job([&](const std::string& target) { return viewing.get(target); }, job_, query_, name);
    const HttpReply from_master = ask_master("jobs/" + name + "/map/0");
    EXPECT_EQ(from_master.status, 200);
    EXPECT_EQ(viewing.get("jobs/" + name + "/map/0").body, from_master.body);
    const auto map = parse_npy_header(from_master.bytes());
    ASSERT_TRUE(map);
    const ContactMap right = job_.map_in_one_process(query_);
    EXPECT_EQ(map.value().shape[0], right.bodies[0].size());
    const auto described = nlohmann::json::parse(ask_master("jobs/" + name).body);
    EXPECT_EQ(nlohmann::json::parse(viewing.get("jobs/" + name).body)["groups"],
              described["groups"]);
    ASSERT_EQ(described["groups"].size(), right.parts.pairs.size());
    EXPECT_EQ(described["groups_total"], right.parts.pairs.size());
    const NamedParts of_a = named_parts(job_.a->mesh());
    const NamedParts of_b = named_parts(job_.b->mesh());
    for (const PartPairContacts& pair : right.parts.pairs) {
        const nlohmann::json expected{
            {"a", of_a.names[pair.a]},
            {"b", of_b.names[pair.b]},
            {"scenarios", pair.scenarios},
            {"share", static_cast<double>(pair.scenarios) / static_cast<double>(scenarios_)},
            {"pairs", pair.pairs},
            {"worst", pair.worst},
            {"worst_pairs", pair.worst_pairs},
            {"near", pair.near},
            {"worst_near", pair.worst_near},
            {"class", pair.has_proper ? "cross" : "contact"}};
        EXPECT_THAT(described["groups"], testing::Contains(expected));
    }
}

TEST_F(PageOfAMaster, TheClusterIsShownWithItsHistory) {
    start_worker();
    const std::uint16_t port = http_port_of(master_);
    const auto ask_master = [&](const std::string& target) {
        return http_ask(port, request_text("GET", "/api/v1/" + target));
    };
    EXPECT_TRUE(comes_true(
        [&] { return ask_master("history").body.find("\"rows\":[[") != std::string::npos; }));
    EXPECT_TRUE(comes_true(
        [&] { return ask_master("cluster").body.find("\"longest\": null") != std::string::npos; }));
    EXPECT_THAT(ask_master("source").body, HasSubstr("\"kind\":\"master\""));
    const Viewing viewing(folder_, {"--master", master_.address()});
    EXPECT_THAT(viewing.get("source").body, HasSubstr("\"kind\":\"remote\""));
    EXPECT_EQ(nlohmann::json::parse(viewing.get("source").body)["tls"], false);
    EXPECT_THAT(viewing.get("cluster").body, HasSubstr("worker0"));
    EXPECT_EQ(http_ask(port, request_text("GET", "/", "", "evil.example")).status, 421);
    EXPECT_EQ(http_ask(port, request_text("GET", "/metrics", "", "evil.example")).status, 421);
    EXPECT_EQ(http_ask(port, request_text("GET", "/healthz", "", "evil.example")).status, 200);
    EXPECT_EQ(http_ask(port, request_text("POST", "/api/v1/jobs")).status, 405);
    EXPECT_EQ(http_ask(port, request_text("HEAD", "/")).status, 200);
}

TEST_F(PageOfAMaster, AFurtherNameOfTheMasterIsAccepted) {
    master_.kill();
    master_.set_options({"--http", "127.0.0.1:0", "--http-name", "monitor.example"});
    master_.start();
    const std::uint16_t port = http_port_of(master_);
    EXPECT_EQ(http_ask(port, request_text("GET", "/", "", "monitor.example:80")).status, 200);
    EXPECT_EQ(http_ask(port, request_text("GET", "/", "", "other.example")).status, 421);
}

TEST_F(SecuredPageOfAMaster, EachRoleSeesWhatItMay) {
    const std::uint16_t port = http_port_of(master_);
    const std::string jobs = "/api/v1/jobs";
    const std::string job = "/api/v1/jobs/j-0000";
    EXPECT_EQ(get(port, "/", CertifiedRole::Worker).status, 200);
    EXPECT_EQ(get(port, "/api/v1/source", CertifiedRole::Worker).status, 200);
    EXPECT_EQ(get(port, jobs, CertifiedRole::Worker).status, 403);
    EXPECT_EQ(get(port, jobs, CertifiedRole::Metrics).status, 200);
    const HttpReply refused = get(port, job, CertifiedRole::Metrics);
    EXPECT_EQ(refused.status, 403);
    EXPECT_THAT(refused.body, HasSubstr("cdctl view [JOB] --master"));
    EXPECT_EQ(get(port, job, CertifiedRole::Submitter).status, 404);
    const auto connection = connect();
    start_worker();
    const JobId id = submit_job(*connection, job_, query_, many_blocks());
    ASSERT_EQ(finish_job(*connection, id).state, JobState::Done);
    const std::string name = first_job(get(port, "/api/v1/jobs", CertifiedRole::Submitter));
    const Viewing viewing(folder_,
                          {name,
                           "--master",
                           master_.address(),
                           "--credential",
                           credential_of(CertifiedRole::Submitter)});
    expect_job([&](const std::string& target) { return viewing.get(target); }, job_, query_, name);
    EXPECT_EQ(nlohmann::json::parse(viewing.get("source").body)["tls"], true);
}

TEST(PageOfAFolder, DataNeedTheKeyAndAnInterruptEndsTheProgram) {
    const TemporaryFolder folder;
    write_obj(folder / "a.obj", make_torus(1.0, 0.4, 24, 12));
    write_obj(folder / "b.obj", make_sphere(1));
    const Ran ran = tests::run({cdctl(),
                                "run",
                                "--a",
                                folder / "a.obj",
                                "--b",
                                folder / "b.obj",
                                "--random",
                                "50",
                                "--out",
                                folder / "out"});
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    EXPECT_THAT(ran.output, HasSubstr("open it: cdctl view " + (folder / "out").string()));
    Viewing viewing(folder, {folder / "out"});
    EXPECT_THAT(viewing.get("jobs/folder").body, HasSubstr("\"scenarios\":50,"));
    EXPECT_EQ(viewing.get("cluster").status, 404);
    EXPECT_EQ(classes_in(viewing.get("jobs/folder/classes?first=0&count=50")).size(), 50u);
    EXPECT_THAT(viewing.get("jobs/folder/scenarios/7").body, HasSubstr("\"verified\":true"));
    EXPECT_EQ(http_ask(viewing.port(), request_text("GET", "/api/v1/jobs")).status, 401);
    EXPECT_EQ(http_ask(viewing.port(), request_text("GET", "/")).status, 200);
    viewing.process().signal(SIGINT);
    EXPECT_EQ(viewing.process().wait(), 0);
}

TEST(PageOfTheDemo, OnATerminalTheDemoShowsItsPageUntilAnInterrupt) {
    const TemporaryFolder folder;
    write_obj(folder / "car.obj", make_torus(2, 0.8, 60, 30));
    write_obj(folder / "post.obj", make_box({0.2, 0.2, 1}));
    Terminal terminal;
    const std::string cache = folder / "cache";
    Process demo({"/bin/sh",
                  "-c",
                  "unset DISPLAY WAYLAND_DISPLAY; XDG_CACHE_HOME=$1 exec \"$2\" demo --a \"$3\" "
                  "--b \"$4\" --scenarios 20 >\"$5\"",
                  "sh",
                  cache,
                  cdctl(),
                  folder / "car.obj",
                  folder / "post.obj",
                  terminal.device()},
                 folder / "demo");
    std::optional<PageAddress> page;
    EXPECT_TRUE(comes_true([&] {
        page = find_page(terminal.text());
        return page || !demo.is_running();
    }));
    ASSERT_TRUE(page) << terminal.text() << demo.errors();
    EXPECT_THAT(terminal.text(), HasSubstr("tested 20 of 20"));
    const std::string job = first_job(page->get("jobs"));
    EXPECT_EQ(classes_in(page->get("jobs/" + job + "/classes?first=0&count=20")).size(), 20u);
    EXPECT_EQ(page->get("jobs/" + job + "/map/0").status, 200);
    EXPECT_TRUE(demo.is_running());
    EXPECT_THAT(demo.errors(), HasSubstr("  Ctrl-C ends it\n")) << "and no limit of time does";
    demo.signal(SIGINT);
    EXPECT_EQ(demo.wait(), 0) << demo.errors();
    for (const char* log : {"master.log", "worker-1.log", "worker-2.log"}) {
        EXPECT_THAT(read_text(fs::path(cache) / "cdcluster/demo-logs" / log), HasSubstr("ended: "));
    }
}

} // namespace cd::tests

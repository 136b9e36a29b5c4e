// Proves what the daemons tell a service manager, and that their logs suit its journal and
// programs.
#include "tests/cluster/cluster_fixture.hpp"
#include "tests/support/comes_true.hpp"
#include "tests/support/notify_socket.hpp"

#include <fmt/core.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <csignal>
#include <set>
#include <sstream>

namespace cd::tests {
namespace {

using Strings = std::vector<std::string>;
using testing::HasSubstr;
using testing::Not;

Strings lines_of(const std::string& text) {
    std::istringstream in(text);
    Strings lines;
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// Parses each line of a log as a JSON object, and refuses a key that comes twice.
std::vector<nlohmann::json> parsed_lines(const std::string& log) {
    std::vector<nlohmann::json> found;
    for (const std::string& line : lines_of(log)) {
        std::set<std::string> keys;
        const auto no_key_twice = [&](int depth, auto event, const nlohmann::json& value) {
            if (depth == 1 && event == nlohmann::json::parse_event_t::key) {
                EXPECT_TRUE(keys.insert(value.get<std::string>()).second) << line;
            }
            return true;
        };
        const auto object = nlohmann::json::parse(line, no_key_twice, false);
        EXPECT_TRUE(object.is_object()) << line;
        for (const char* key : {"time", "level", "program", "event"}) {
            EXPECT_TRUE(object.is_object() && object.contains(key)) << key << ": " << line;
        }
        found.push_back(object);
    }
    return found;
}

const nlohmann::json* find_event(const std::vector<nlohmann::json>& lines,
                                 const std::string& event) {
    for (const nlohmann::json& line : lines) {
        if (line.value("event", "") == event) {
            return &line;
        }
    }
    return nullptr;
}

class Service : public testing::Test {
  protected:
    /// Starts a program with variables of the environment; its files are `name` and `name`.err.
    std::unique_ptr<Process>
    start(const std::string& name, const Strings& variables, const Strings& command) {
        Strings words{"/usr/bin/env"};
        words.insert(words.end(), variables.begin(), variables.end());
        words.insert(words.end(), command.begin(), command.end());
        return std::make_unique<Process>(words, folder_ / name);
    }

    std::unique_ptr<Process> start_master(const Strings& variables, const Strings& options) {
        Strings command{program("cdmaster").string(),
                        "--listen",
                        "127.0.0.1:0",
                        "--state",
                        (folder_ / "state").string(),
                        "--port-file",
                        (folder_ / "port").string()};
        command.insert(command.end(), options.begin(), options.end());
        return start("master", variables, command);
    }

    /// Waits until the master listens, and returns its address.
    std::string address() {
        EXPECT_TRUE(comes_true([&] {
            return std::filesystem::exists(folder_ / "port") &&
                   read_text(folder_ / "port").find('\n') != std::string::npos;
        }));
        const std::string port = read_text(folder_ / "port");
        return "127.0.0.1:" + port.substr(0, port.find('\n'));
    }

    /// Makes a program's stderr file and returns the variable with which systemd names it.
    std::string journal_stream(const std::string& name) {
        const std::string path = (folder_ / (name + ".err")).string();
        write_text(path, "");
        struct stat file {};
        EXPECT_EQ(::stat(path.c_str(), &file), 0);
        return fmt::format("JOURNAL_STREAM={}:{}", file.st_dev, file.st_ino);
    }

    TemporaryFolder folder_;
};

TEST_F(Service, TheManagerHearsWhenDaemonsAreReadyAndWhenTheyStop) {
    NotifySocket of_master((folder_ / "master.notify").string());
    NotifySocket of_worker("@cdcluster-worker-" + std::to_string(::getpid()));
    const auto master = start_master({of_master.variable()}, {});
    ASSERT_EQ(of_master.next(), "READY=1") << master->errors();
    // Ready is later than the port file: who waits for the service can connect.
    const auto worker =
        start("worker", {of_worker.variable()}, worker_command(address(), "w", 1, {}));
    ASSERT_EQ(of_worker.next(), "READY=1") << worker->errors();
    EXPECT_EQ(connect_to(address(), nullptr)->status().value().workers.size(), 1u);
    worker->signal(SIGTERM);
    EXPECT_EQ(of_worker.next(), "STOPPING=1") << worker->errors();
    EXPECT_EQ(worker->wait(), 0);
    master->signal(SIGTERM);
    EXPECT_EQ(of_master.next(), "STOPPING=1") << master->errors();
    EXPECT_EQ(master->wait(), 0);
}

TEST_F(Service, EachLogLineOfAClusterIsAJsonObject) {
    const auto master = start_master({"CDMASTER_LOG_FORMAT=json"}, {"--log-level", "debug"});
    const std::string at = address();
    const std::string name = "w \"1\"\\";
    const auto worker =
        start("worker",
              {},
              worker_command(at, name, 1, {"--log-format", "json", "--log-level", "debug"}));
    const auto connection = connect_to(at, nullptr);
    ASSERT_NE(connection, nullptr);
    const JobId id = submit_job(*connection, make_job(50), Query{}, many_blocks());
    EXPECT_EQ(finish_job(*connection, id).state, JobState::Done);
    worker->signal(SIGTERM);
    EXPECT_EQ(worker->wait(), 0);
    master->signal(SIGTERM);
    EXPECT_EQ(master->wait(), 0);

    const auto of_worker = parsed_lines(worker->errors());
    const auto of_master = parsed_lines(master->errors());
    const nlohmann::json* joined = find_event(of_master, "worker joined");
    ASSERT_NE(joined, nullptr) << master->errors();
    EXPECT_EQ(joined->at("name"), name);
    EXPECT_EQ(joined->at("threads"), 1);
    EXPECT_EQ(joined->at("program"), "cdmaster");
    EXPECT_EQ(joined->at("level"), "info");
    const nlohmann::json* ended = find_event(of_master, "job ended");
    ASSERT_NE(ended, nullptr) << master->errors();
    EXPECT_EQ(ended->at("merged"), 50);
    EXPECT_EQ(ended->at("total"), 50);
    EXPECT_TRUE(ended->at("seconds").is_number());
    EXPECT_NE(find_event(of_worker, "connected"), nullptr) << worker->errors();
}

TEST_F(Service, AMasterThatCannotStartSaysSoInJson) {
    write_text(folder_ / "state", "a file where the state folder should be");
    const auto master = start_master({}, {"--log-format", "json"});
    EXPECT_EQ(master->wait(), 2);
    const auto lines = parsed_lines(master->errors());
    const nlohmann::json* why = find_event(lines, "cannot run");
    ASSERT_NE(why, nullptr) << master->errors();
    EXPECT_THAT(why->at("error").get<std::string>(), HasSubstr("state"));
}

TEST_F(Service, LinesForTheJournalHaveAPriorityAndNoTime) {
    const auto master = start_master({journal_stream("master")}, {});
    const std::string at = address();
    const auto worker = start(
        "worker", {journal_stream("worker")}, worker_command(at, "w", 1, {"--log-format", "json"}));
    ASSERT_TRUE(
        comes_true([&] { return worker->errors().find("connected") != std::string::npos; }));
    worker->signal(SIGTERM);
    EXPECT_EQ(worker->wait(), 0);
    master->signal(SIGTERM);
    EXPECT_EQ(master->wait(), 0);
    for (const std::string& line : lines_of(master->errors())) {
        EXPECT_THAT(line, testing::MatchesRegex("<[2-7]>[a-z].*"));
    }
    EXPECT_THAT(master->errors(), HasSubstr("<6>listening: host=127.0.0.1 "));
    EXPECT_THAT(master->errors(), Not(HasSubstr("cdmaster")));
    for (const std::string& line : lines_of(worker->errors())) {
        ASSERT_EQ(line.substr(0, 3), "<6>");
        EXPECT_EQ(parsed_lines(line.substr(3)).size(), 1u);
    }
}

} // namespace
} // namespace cd::tests

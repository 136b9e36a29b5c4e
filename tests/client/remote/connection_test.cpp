// Proves that a client follows the protocol, accepts only valid answers, maps each failure to its
// own error, and can be interrupted while it waits. The master is a fake.

#include "client/remote/connection.hpp"

#include "common/core/limits/engine.hpp"
#include "common/job/result/packed_records.hpp"
#include "tests/client/fake_master.hpp"
#include "tests/support/memory_bound.hpp"
#include "tests/support/packed_poses.hpp"
#include "tests/support/shapes.hpp"
#include "web/server/cluster/result_records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

namespace cd::tests {
namespace {

using testing::HasSubstr;
using Answers = std::optional<std::vector<Message>>;

/// Welcomes the client; leaves all other messages to `rest`.
FakeMaster::Answer welcoming(FakeMaster::Answer rest) {
    return [rest = std::move(rest)](const Message& message) -> Answers {
        return std::holds_alternative<Hello>(message) ? FakeMaster::welcome() : rest(message);
    };
}

/// Always gives one answer.
FakeMaster::Answer always(Message answer) {
    return welcoming(
        [answer = std::move(answer)](const Message&) -> Answers { return std::vector{answer}; });
}

std::unique_ptr<Connection> open(
    const FakeMaster& master, std::function<bool()> stopped = [] { return false; }) {
    auto connection = Connection::open(master.address(), false, std::move(stopped));
    EXPECT_TRUE(connection) << connection.error().detail;
    return std::move(connection.value());
}

ScenarioResult make_result(std::uint64_t index) {
    ScenarioResult result;
    result.index = index;
    result.kind = ScenarioClass::Touch;
    result.pair_count = 1;
    result.pairs = {{static_cast<std::uint32_t>(index), 7, PairClass::Touch}};
    return result;
}

ResultsPart make_part(JobId job, std::uint64_t first, std::uint32_t count) {
    ByteWriter records;
    for (std::uint64_t i = first; i < first + count; ++i) {
        const Bytes record = encode_result(make_result(i));
        records.put(static_cast<std::uint32_t>(record.size()));
        for (const std::byte byte : record) {
            records.put(std::to_integer<std::uint8_t>(byte));
        }
    }
    return {job, first, first + count, {{first, count}}, count, pack_records(records.bytes())};
}

// ---- Opening --------------------------------------------------------------------------------

TEST(Connection, GreetsAsAClient) {
    FakeMaster master(always(ClusterStatus{}));
    const auto connection = open(master);
    const auto hellos = master.received_of<Hello>();
    ASSERT_EQ(hellos.size(), 1u);
    EXPECT_EQ(hellos[0].role, Role::Client);
    EXPECT_THAT(hellos[0].name, HasSubstr("cdctl"));
    EXPECT_THAT(hellos[0].user, HasSubstr("@"));
}

TEST(Connection, WhereNobodyListensIsUnreachable) {
    std::string address;
    {
        const FakeMaster master(always(ClusterStatus{}));
        address = master.address();
    }
    const auto connection = Connection::open(address, false, [] { return false; });
    ASSERT_FALSE(connection);
    EXPECT_EQ(connection.error().code, ErrorCode::Disconnected);
    EXPECT_THAT(connection.error().detail, HasSubstr(address));
}

TEST(Connection, AMasterThatSaysNoRefuses) {
    FakeMaster master([](const Message&) -> Answers {
        return std::vector<Message>{Failure{ErrorCode::Refused, "not you"}};
    });
    const auto connection = Connection::open(master.address(), false, [] { return false; });
    ASSERT_FALSE(connection);
    EXPECT_EQ(connection.error().code, ErrorCode::Refused);
    EXPECT_THAT(connection.error().detail, HasSubstr("not you"));
}

TEST(Connection, BadAddressesAndExposureAreRefusedBeforeAnythingIsSent) {
    const auto never = [] { return false; };
    EXPECT_EQ(Connection::open("nonsense", false, never).error().code, ErrorCode::BadInput);
    EXPECT_EQ(Connection::open("192.0.2.1:7600", false, never).error().code, ErrorCode::Refused);
}

// ---- Meshes ---------------------------------------------------------------------------------

TEST(Connection, UploadsOnlyWhatIsMissingAndThatWhole) {
    const auto large = share(make_sphere(7)); // It needs several pieces.
    const auto small = share(make_box({1, 2, 3}));
    FakeMaster master(welcoming([&](const Message& message) -> Answers {
        if (std::holds_alternative<MeshesQuery>(message)) {
            return std::vector<Message>{MeshesMissing{{large->hash()}}};
        }
        const auto& part = std::get<MeshPart>(message);
        return part.offset + part.bytes.size() < part.bytes_total
                   ? std::vector<Message>{}
                   : std::vector<Message>{MeshStored{part.mesh}};
    }));
    const auto connection = open(master);
    std::vector<std::uint64_t> told;

    const std::vector<NamedMesh> meshes{{"large", large}, {"small", small}, {"again", large}};
    const Status status =
        connection->upload(meshes, [&](const NamedMesh& mesh, std::uint64_t bytes, std::uint64_t) {
            EXPECT_EQ(mesh.name, "large");
            told.push_back(bytes);
        });

    ASSERT_TRUE(status) << status.error().detail;
    Bytes sent;
    for (const MeshPart& part : master.received_of<MeshPart>()) {
        EXPECT_EQ(part.mesh, large->hash());
        EXPECT_EQ(part.name, "large");
        EXPECT_EQ(part.offset, sent.size());
        sent.insert(sent.end(), part.bytes.begin(), part.bytes.end());
    }
    EXPECT_EQ(sent, large->canonical_bytes());
    EXPECT_GT(told.size(), 2u);
    EXPECT_EQ(told.front(), 0u);
    EXPECT_EQ(told.back(), sent.size());
}

TEST(Connection, AMeshThatIsRefusedFailsWithTheMastersWords) {
    const auto mesh = share(make_box({1, 2, 3}));
    const auto upload_refused_for = [&](ErrorCode code, const char* detail) {
        FakeMaster master(welcoming([&](const Message& message) -> Answers {
            if (std::holds_alternative<MeshesQuery>(message)) {
                return std::vector<Message>{MeshesMissing{{mesh->hash()}}};
            }
            return std::vector<Message>{Failure{code, detail}};
        }));
        return open(master)->upload(std::vector{NamedMesh{"A", mesh}},
                                    [](const auto&, auto, auto) {});
    };
    const Status refused = upload_refused_for(ErrorCode::TooLarge, "it has too many parts");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(refused.error().detail, "it has too many parts");
    const Status full = upload_refused_for(ErrorCode::Io, "No space left on device");
    ASSERT_FALSE(full);
    EXPECT_EQ(full.error().code, ErrorCode::Incomplete) << "exit code 3";
    EXPECT_THAT(
        full.error().detail,
        testing::MatchesRegex("the master has no room for A .[0-9]+ B.: No space left on device"));
}

// ---- Jobs -----------------------------------------------------------------------------------

TEST(Connection, AGridTravelsAsItsDescription) {
    FakeMaster master(always(Accepted{JobId{42}}));
    Submit submit;
    submit.name = "grid";
    submit.scenarios = 1;
    submit.grid = encode_grid(Grid{});
    submit.poses.kind = PosesKind::Grid;
    const auto job = open(master)->submit(submit);
    ASSERT_TRUE(job) << job.error().detail;
    EXPECT_EQ(job.value(), JobId{42});
    EXPECT_EQ(master.received_of<Submit>().size(), 1u);
    EXPECT_TRUE(master.received_of<PosesPart>().empty());
    EXPECT_TRUE(master.received_of<PosesEnd>().empty());
}

TEST(Connection, OtherPosesFollowInCoherentOrderAndToTheEnd) {
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        return std::holds_alternative<PosesEnd>(message) ? std::vector<Message>{Accepted{JobId{43}}}
                                                         : std::vector<Message>{};
    }));
    std::mt19937_64 random(3);
    std::vector<Scenario> scenarios(limits::order_window_scenarios + 10'000);
    for (std::size_t i = 0; i < scenarios.size(); ++i) {
        scenarios[i].index = i;
        scenarios[i].poses.b = make_pose(random, 1);
    }
    const auto source = make_list_source(scenarios);

    Submit submit;
    submit.bodies.resize(2);
    const auto job = open(master)->submit(submit, *source);

    ASSERT_TRUE(job) << job.error().detail;
    EXPECT_EQ(master.received_of<Submit>()[0].scenarios, scenarios.size());
    std::vector<Bytes> received;
    for (const PosesPart& part : master.received_of<PosesPart>()) {
        received.push_back(part.scenarios);
    }
    EXPECT_EQ(received, packed_runs(scenarios));
}

TEST(Connection, WatchesUntilTheJobHasEnded) {
    FakeMaster master(welcoming([](const Message&) -> Answers {
        std::vector<Message> statuses(3, JobStatus{});
        std::get<JobStatus>(statuses[2]).state = JobState::Done;
        return statuses;
    }));
    int told = 0;
    const auto status = open(master)->watch(JobId{1}, [&](const JobStatus&) { ++told; });
    ASSERT_TRUE(status) << status.error().detail;
    EXPECT_EQ(status.value().state, JobState::Done);
    EXPECT_EQ(told, 3);
}

TEST(Connection, AWatchThatIsInterruptedLeavesTheWordToCancel) {
    std::atomic<bool> stopped = false;
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        JobStatus status;
        status.state =
            std::holds_alternative<Cancel>(message) ? JobState::Cancelled : JobState::Running;
        // Pending status messages of the watch precede the answer to the cancel.
        return std::vector<Message>{JobStatus{}, status};
    }));
    const auto connection = open(master, [&] { return stopped.load(); });

    const auto status = connection->watch(JobId{5}, [&](const JobStatus&) { stopped = true; });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::Interrupted);

    const auto cancelled = connection->cancel(JobId{5});
    ASSERT_TRUE(cancelled) << cancelled.error().detail;
    EXPECT_EQ(cancelled.value().state, JobState::Cancelled);
    EXPECT_EQ(master.received_of<Cancel>()[0].job, JobId{5});
}

TEST(Connection, AClusterStatusThatCameAfterTheWatchIsNoAnswerToTheNextQuestion) {
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        if (std::holds_alternative<StatusQuery>(message)) {
            return std::vector<Message>{}; // The master still measures its files.
        }
        if (std::holds_alternative<Watch>(message)) {
            JobStatus done;
            done.state = JobState::Done;
            return std::vector<Message>{done};
        }
        Explained explained;
        explained.scenario = 3;
        return std::vector<Message>{ClusterStatus{}, explained};
    }));
    const auto connection = open(master);
    ASSERT_TRUE(connection->watch(
        JobId{1}, [](const JobStatus&) {}, [](const ClusterStatus&) {}));
    const Result<Explained> answer = connection->explain(JobId{1}, 3);
    ASSERT_TRUE(answer) << answer.error().detail;
    EXPECT_EQ(answer.value().scenario, 3u);
}

TEST(Connection, OneScenarioIsCancelledByItsNumber) {
    FakeMaster master(welcoming([](const Message&) -> Answers {
        return std::vector<Message>{JobStatus{}}; // The job still runs.
    }));
    const auto status = open(master)->cancel_scenario(JobId{5}, 17);
    ASSERT_TRUE(status) << status.error().detail;
    EXPECT_EQ(status.value().state, JobState::Running);
    EXPECT_EQ(master.received_of<Cancel>()[0].job, JobId{5});
    EXPECT_EQ(master.received_of<Cancel>()[0].scenario, 17u);
}

TEST(Connection, APriorityIsAskedForByItsJob) {
    FakeMaster master(welcoming([](const Message&) -> Answers {
        JobStatus status;
        status.turn.priority = -4;
        return std::vector<Message>{status};
    }));
    const auto status = open(master)->set_priority(JobId{5}, -4);
    ASSERT_TRUE(status) << status.error().detail;
    EXPECT_EQ(status.value().turn.priority, -4);
    EXPECT_EQ(master.received_of<SetPriority>()[0].job, JobId{5});
    EXPECT_EQ(master.received_of<SetPriority>()[0].priority, -4);
}

TEST(Connection, AMasterThatGoesAwayIsDisconnected) {
    FakeMaster master(welcoming([](const Message&) -> Answers { return std::nullopt; }));
    const auto status = open(master)->watch(JobId{1}, [](const JobStatus&) {});
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::Disconnected);
}

TEST(Connection, AnAnswerToSomethingElseIsNone) {
    FakeMaster master(always(Accepted{JobId{1}}));
    const auto status = open(master)->status();
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::BadFrame);
}

// ---- Results --------------------------------------------------------------------------------

TEST(Connection, FetchesResultsInRunsAndInOrder) {
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        const auto& query = std::get<ResultsQuery>(message);
        const auto count = static_cast<std::uint32_t>(std::min<std::uint64_t>(query.count, 100));
        return std::vector<Message>{make_part(query.job, query.first, count)};
    }));
    std::uint64_t next = 10;
    const Status status =
        open(master)->fetch(JobId{1}, 10, 350, [&](const ScenarioResult& result) -> Status {
            EXPECT_EQ(encode_result(result), encode_result(make_result(next)));
            ++next;
            return Done{};
        });
    ASSERT_TRUE(status) << status.error().detail;
    EXPECT_EQ(next, 360u);
    EXPECT_EQ(master.received_of<ResultsQuery>().size(), 4u);
}

TEST(Connection, ScenariosWithoutAResultArePassedOver) {
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        const std::uint64_t first = std::get<ResultsQuery>(message).first;
        ResultsPart part = make_part(JobId{1}, first + 2, first < 20 ? 3 : 0);
        part.first = first;
        part.next = first + 10;
        if (part.count == 0) {
            part.held.clear();
        }
        return std::vector<Message>{part};
    }));
    std::vector<std::uint64_t> came;
    const Status status =
        open(master)->fetch(JobId{1}, 0, 30, [&](const ScenarioResult& result) -> Status {
            came.push_back(result.index);
            return Done{};
        });
    ASSERT_TRUE(status) << status.error().detail;
    EXPECT_EQ(came, (std::vector<std::uint64_t>{2, 3, 4, 12, 13, 14}));
}

TEST(Connection, AMeshComesInPiecesAndIsCheckedAgainstItsHash) {
    const Mesh mesh = make_box({1, 2, 3});
    const Bytes bytes = mesh.canonical_bytes();
    std::atomic<bool> is_damaged = false;
    FakeMaster master(welcoming([&](const Message& message) -> Answers {
        const auto& query = std::get<MeshQuery>(message);
        const std::uint64_t end = std::min<std::uint64_t>(bytes.size(), query.offset + 100);
        MeshBytes part{query.mesh, bytes.size(), query.offset, {}};
        for (std::uint64_t i = query.offset; i < end; ++i) {
            part.bytes.push_back(bytes[i] ^ std::byte{is_damaged && i == 150});
        }
        return std::vector<Message>{part};
    }));
    const auto connection = open(master);
    const auto fetched = connection->fetch_mesh(mesh.hash());
    ASSERT_TRUE(fetched) << fetched.error().detail;
    EXPECT_EQ(fetched.value().canonical_bytes(), bytes);
    is_damaged = true;
    EXPECT_EQ(connection->fetch_mesh(mesh.hash()).error().code, ErrorCode::BadFrame);
}

TEST(Connection, PosesComeInRunsWithTheirLabels) {
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        const auto& query = std::get<PosesQuery>(message);
        JobPoses part{query.job, query.first, std::min<std::uint64_t>(query.count, 3), {}, {}};
        std::vector<Scenario> scenarios(part.count);
        for (std::uint64_t i = 0; i < part.count; ++i) {
            scenarios[i].index = query.first + i;
            part.labels.integers.push_back(static_cast<std::int64_t>(10 * (query.first + i)));
        }
        part.scenarios = pack_scenarios(scenarios);
        return std::vector<Message>{part};
    }));
    const auto poses = open(master)->fetch_poses(JobId{1}, 5, 8);
    ASSERT_TRUE(poses) << poses.error().detail;
    ASSERT_EQ(poses.value().scenarios.size(), 8u);
    EXPECT_EQ(poses.value().scenarios.back().index, 12u);
    EXPECT_EQ(poses.value().labels.integers,
              (std::vector<std::int64_t>{50, 60, 70, 80, 90, 100, 110, 120}));
}

TEST(Connection, TheTakersErrorEndsTheFetch) {
    FakeMaster master(welcoming([](const Message& message) -> Answers {
        return std::vector<Message>{make_part(JobId{1}, std::get<ResultsQuery>(message).first, 2)};
    }));
    const Status status = open(master)->fetch(JobId{1}, 0, 10, [](const ScenarioResult&) -> Status {
        return Error{ErrorCode::Io, "no room"};
    });
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().detail, "no room");
    EXPECT_EQ(master.received_of<ResultsQuery>().size(), 1u);
}

TEST(Connection, ResultsThatAreNoneAreErrors) {
    const auto fetch_from = [](const ResultsPart& part) {
        FakeMaster master(always(part));
        return open(master)->fetch(
            JobId{1}, 0, 10, [](const ScenarioResult&) -> Status { return Done{}; });
    };
    ResultsPart empty;
    EXPECT_EQ(fetch_from(empty).error().code, ErrorCode::BadFrame) << "it leads nowhere";

    ResultsPart shifted = make_part(JobId{1}, 3, 2);
    EXPECT_EQ(fetch_from(shifted).error().code, ErrorCode::BadFrame);
    shifted.first = 0;
    shifted.held = {{0, 2}};
    EXPECT_EQ(fetch_from(shifted).error().code, ErrorCode::BadFrame);

    EXPECT_EQ(fetch_from(make_part(JobId{1}, 0, 11)).error().code, ErrorCode::BadFrame);

    ResultsPart fewer = make_part(JobId{1}, 0, 2);
    for (const std::uint32_t count : {3u, 1u}) {
        fewer.count = count;
        fewer.held = {{0, count}};
        fewer.next = 3;
        EXPECT_EQ(fetch_from(fewer).error().code, ErrorCode::BadFrame);
    }

    ResultsPart garbage = make_part(JobId{1}, 0, 2);
    garbage.records.resize(garbage.records.size() / 2);
    EXPECT_EQ(fetch_from(garbage).error().code, ErrorCode::BadFrame);
}

TEST(Connection, ClaimedResultsTakeNoMemoryBeforeTheirRecordsAreRead) {
    ResultsPart part = make_part(JobId{1}, 0, 2);
    part.count = UINT32_MAX;
    part.next = part.count;
    part.held = {{0, part.count}};
    const MemoryBound bound(1u << 30);
    EXPECT_EQ(unpack_results(part, {{}, 0, part.count}, part.count).error().code,
              ErrorCode::BadFrame);
}

} // namespace
} // namespace cd::tests

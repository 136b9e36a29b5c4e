// Proves that the master applies its quotas wherever a client may exceed its share, names the
// exceeded quota, and serves others; and that abandoned operations end.
#include "common/core/limits/master.hpp"
#include "common/job/packed_scenarios.hpp"
#include "master/submission/submission.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/master_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

/// As `answer_to`, but repeats until the master has noticed all departed clients.
Message answer_in_the_end(Master& master, const std::vector<Message>& messages) {
    for (;;) {
        Message answer = answer_to(master, messages);
        const auto* const failure = std::get_if<Failure>(&answer);
        if (failure == nullptr || failure->detail.find("busy") == std::string::npos) {
            return answer;
        }
    }
}

void store_meshes(Master& master) {
    for (const Mesh* mesh : {&reference().a, &reference().b}) {
        const Bytes bytes = mesh->canonical_bytes();
        const Message answer =
            answer_to(master, {MeshPart{mesh->hash(), "mesh", bytes.size(), 0, bytes}});
        ASSERT_TRUE(std::holds_alternative<MeshStored>(answer));
    }
}

std::vector<Message> submission_of(std::size_t scenarios) {
    Submit submit = reference().submission();
    submit.scenarios = scenarios;
    const std::span<const Scenario> all(reference().scenarios);
    return {submit, PosesPart{pack_scenarios(all.first(scenarios))}, PosesEnd{}};
}

JobId accepted(Master& master, std::vector<Message> messages) {
    const Message answer = answer_to(master, std::move(messages));
    const auto* const job = std::get_if<Accepted>(&answer);
    EXPECT_NE(job, nullptr);
    return job == nullptr ? JobId{} : job->job;
}

/// A submission of a grid of so many steps about one axis.
Submit grid_submission(std::uint32_t steps) {
    Grid grid;
    for (int axis = 0; axis < 3; ++axis) {
        grid.rotation[static_cast<std::size_t>(axis)] =
            rotation_axis({0, 360, axis == 0 ? steps : 1}, axis);
    }
    return submission(grid);
}

/// One job takes all of the quota, which a restart does not change.
TEST(ServerQuota, WhatRunsIsCountedAlsoAfterARestart) {
    for (const auto& [quotas, what] :
         {std::pair(Quotas::Limits{.jobs = 1}, "1 jobs running"),
          std::pair(Quotas::Limits{.scenarios = 100}, "180 scenarios of jobs")}) {
        const TemporaryFolder state;
        const Stage stage{.clients = {.quotas = quotas}};
        JobId job;
        {
            Master master(no_return, state.path(), stage);
            store_meshes(master);
            job = accepted(master, submission_of(90));
            EXPECT_THAT(refusal_of(master, submission_of(90)), HasSubstr(what));
        }
        Master master(no_return, state.path(), stage);
        const std::string refusal = refusal_of(master, submission_of(90));
        EXPECT_THAT(refusal, testing::AllOf(HasSubstr(what), HasSubstr("retry after")));
        if (quotas.jobs != 1) {
            accepted(master, submission_of(10));
        }
        ASSERT_TRUE(std::holds_alternative<JobStatus>(answer_to(master, {Cancel{job}})));
        accepted(master, submission_of(90));
    }
}

TEST(ServerQuota, BytesOfMeshesPosesAndGridsAreCounted) {
    const std::size_t mesh_bytes =
        reference().a.canonical_bytes().size() + reference().b.canonical_bytes().size();
    const auto stage = [&](std::uint64_t bytes) {
        return Stage{.clients = {.quotas = {.bytes = mesh_bytes + bytes, .period = 10'000'000s}}};
    };
    Master little(no_return, {}, stage(100));
    store_meshes(little);
    EXPECT_THAT(refusal_of(little, submission_of(90)), HasSubstr("bytes"));
    EXPECT_THAT(refusal_of(little, {grid_submission(100)}), HasSubstr("bytes"));
    Submit ignoring = reference().submission();
    ignoring.query.ignored.resize(100);
    EXPECT_THAT(refusal_of(little, {ignoring}), HasSubstr("bytes"));
    const Bytes bytes = reference().a.canonical_bytes();
    const MeshPart again{reference().a.hash(), "mesh", bytes.size(), 0, bytes};
    EXPECT_THAT(refusal_of(little, {again}), HasSubstr("bytes"));
    Master enough(no_return, {}, stage(100'000));
    store_meshes(enough);
    accepted(enough, submission_of(90));
}

TEST(ServerQuota, QueuedBytesAreFreedWhenTheJobOrTheConnectionEnds) {
    const std::size_t bytes = pack_scenarios(reference().scenarios).size();
    Master master(no_return, {}, {.clients = {.quotas = {.queued = bytes}}});
    store_meshes(master);
    const JobId job = accepted(master, submission_of(90));
    EXPECT_THAT(refusal_of(master, submission_of(1)), HasSubstr("bytes of poses not yet done"));
    ASSERT_TRUE(std::holds_alternative<JobStatus>(answer_to(master, {Cancel{job}})));
    // Abandoned or refused submissions do not count.
    std::vector<Message> left = submission_of(90);
    left.back() = StatusQuery{};
    ASSERT_TRUE(std::holds_alternative<ClusterStatus>(answer_to(master, left)));
    left = submission_of(90);
    std::get<Submit>(left.front()).scenarios = 91;
    EXPECT_THAT(std::get<Failure>(answer_in_the_end(master, left)).detail,
                HasSubstr("come together"));
    EXPECT_TRUE(std::holds_alternative<Accepted>(answer_in_the_end(master, submission_of(90))));
}

TEST(ServerQuota, OneClientHasItsShareOfBegunMeshes) {
    Master master(no_return, {}, {.clients = {.quotas = {.uploads = 1}}});
    const Bytes bytes = reference().a.canonical_bytes();
    const MeshPart half{
        reference().a.hash(), "mesh", bytes.size(), 0, {bytes.begin(), bytes.begin() + 1000}};
    {
        Client first(master);
        first.start_asking({half, StatusQuery{}});
        first.run_until_done();
        EXPECT_THAT(refusal_of(master, {half}), HasSubstr("1 meshes begun"));
    }
    // The share is freed with the connection, and with a complete mesh.
    for (const Mesh* mesh : {&reference().a, &reference().b}) {
        const Bytes all = mesh->canonical_bytes();
        const MeshPart part{mesh->hash(), "mesh", all.size(), 0, all};
        EXPECT_TRUE(std::holds_alternative<MeshStored>(answer_in_the_end(master, {part})));
    }
}

TEST(ServerQuota, AbandonedOperationsEnd) {
    Master master(no_return, {}, {.clients = {.submission_idle_max = 20ms}});
    store_meshes(master);
    const Bytes bytes(1000);
    EXPECT_THAT(refusal_of(master, {MeshPart{Sha256{}, "mesh", 2000, 0, bytes}}),
                HasSubstr("stopped before its end"));
    EXPECT_THAT(refusal_of(master, {reference().submission()}),
                HasSubstr("stopped before its end"));
}

TEST(ServerQuota, ALargeGridIsDroppedWhenItsJobEnds) {
    const Submit small = grid_submission(10);
    Submit large = grid_submission(4000);
    ASSERT_GT(large.grid->size(), limits::ended_grid_bytes_max);
    EXPECT_TRUE(drop_bulk(large));
    EXPECT_EQ(large.grid, Bytes());
    Submit kept = small;
    kept.query.ignored.resize(3);
    kept.ignore = {{"wheel_*", "hull"}};
    EXPECT_EQ(bulk_bytes(kept), small.grid->size() + 3 * sizeof(IgnoredRange) + 11);
    drop_bulk(kept);
    EXPECT_EQ(kept.grid, small.grid);
    EXPECT_TRUE(kept.query.ignored.empty());
    EXPECT_TRUE(kept.ignore.empty());
}

TEST(ServerQuota, GridsBeyondTheLimitsAreRefused) {
    Master master;
    store_meshes(master);
    Submit many = grid_submission(10);
    many.scenarios = limits::client_scenarios_max + 1;
    EXPECT_THAT(refusal_of(master, {many}), HasSubstr("split the job into several"));
    Submit submit = reference().submission();
    submit.grid = Bytes(limits::grid_bytes_max + 1);
    submit.poses.kind = PosesKind::Grid;
    EXPECT_THAT(refusal_of(master, {submit}), HasSubstr("a grid of"));
}

} // namespace
} // namespace cd::tests

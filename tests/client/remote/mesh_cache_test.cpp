// Proves that a mesh is fetched from a master only once, and that an unusable cache folder does no
// harm.
#include "client/remote/mesh_cache.hpp"

#include "client/cluster/fetched_job.hpp"
#include "tests/client/fake_master.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cd::tests {

namespace {

namespace fs = std::filesystem;

TEST(MeshCache, GivesBackWhatItKeepsAndNothingElse) {
    const TemporaryFolder folder;
    const Mesh mesh = make_box({1, 2, 3});
    const MeshCache cache(folder / "trees");
    EXPECT_EQ(cache.find(mesh.hash()), nullptr);
    cache.keep(mesh);
    const auto found = cache.find(mesh.hash());
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->canonical_bytes(), mesh.canonical_bytes());
    EXPECT_EQ(cache.find(make_box({1, 1, 1}).hash()), nullptr);

    const fs::path file = mesh_file_path(folder / "trees" / "meshes", mesh.hash());
    write_text(file, read_text(file) + "x");
    EXPECT_EQ(cache.find(mesh.hash()), nullptr);
    cache.keep(mesh);
    EXPECT_NE(cache.find(mesh.hash()), nullptr);

    const MeshCache none{fs::path()};
    none.keep(mesh);
    EXPECT_EQ(none.find(mesh.hash()), nullptr);
}

TEST(MeshCache, BeyondTheBoundTheLongestUnusedLeaves) {
    const TemporaryFolder folder;
    const Mesh first = make_box({1, 2, 3});
    const Mesh second = make_box({1, 1, 1});
    const MeshCache cache(folder / "trees", first.canonical_bytes().size() + 1);
    cache.keep(first);
    cache.keep(second);
    EXPECT_EQ(cache.find(first.hash()), nullptr);
    EXPECT_NE(cache.find(second.hash()), nullptr);
}

TEST(MeshCache, AJobThatIsFetchedAgainBringsNoMesh) {
    const TemporaryFolder folder;
    const std::array<Mesh, 2> meshes{make_box({1, 2, 3}), make_box({1, 1, 1})};
    JobDescription job{JobId{1}, 1, {}};
    job.submit.scenarios = 1;
    ClusterStatus status;
    status.jobs.push_back({});
    status.jobs[0].job = JobId{1};
    for (const Mesh& mesh : meshes) {
        JobBody body;
        body.mesh = mesh.hash();
        body.unit = "m";
        job.submit.bodies.push_back(body);
        status.jobs[0].bodies.push_back(mesh.hash());
    }
    job.submit.unit = "m";
    FakeMaster master([&](const Message& message) -> std::optional<std::vector<Message>> {
        if (std::holds_alternative<Hello>(message)) {
            return FakeMaster::welcome();
        }
        if (std::holds_alternative<StatusQuery>(message)) {
            return std::vector<Message>{status};
        }
        if (std::holds_alternative<JobQuery>(message)) {
            return std::vector<Message>{job};
        }
        const auto* query = std::get_if<MeshQuery>(&message);
        if (query == nullptr) {
            return std::nullopt;
        }
        const Bytes bytes = meshes[query->mesh == meshes[0].hash() ? 0 : 1].canonical_bytes();
        return std::vector<Message>{MeshBytes{query->mesh, bytes.size(), 0, bytes}};
    });
    const MasterOptions options{master.address(), false, "none"};
    for (int time = 0; time < 2; ++time) {
        auto connected = open_job(options, "1");
        ASSERT_TRUE(connected) << connected.error().detail;
        auto fetched = FetchedJob::open(std::move(connected.value()), folder / "trees");
        ASSERT_TRUE(fetched) << fetched.error().detail;
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            EXPECT_EQ(fetched.value().prepared().meshes[i]->hash(), meshes[i].hash());
        }
        EXPECT_EQ(master.received_of<MeshQuery>().size(), 2u) << "time " << time;
    }
}

} // namespace

} // namespace cd::tests

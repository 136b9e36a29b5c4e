// Proves that a master returns a job's description, meshes and poses with labels to any client;
// removes them for the owner and admins only; and at its next start removes files whose job or mesh
// is gone.
#include "common/job/packed_scenarios.hpp"
#include "tests/master/fake_client.hpp"
#include "tests/master/fake_worker.hpp"
#include "tests/master/master_stage.hpp"

#include <gmock/gmock.h>

namespace cd::tests {
namespace {

using testing::HasSubstr;

Submit labelled_submission() {
    Submit submit = reference().submission();
    submit.unit = "mm";
    submit.poses.labels = {IdKind::Integer, true};
    return submit;
}

PoseLabels labels_of(std::uint64_t first, std::uint64_t count) {
    PoseLabels labels;
    for (std::uint64_t i = first; i < first + count; ++i) {
        labels.integers.push_back(-static_cast<std::int64_t>(i));
        labels.times.push_back(0.5 * static_cast<double>(i));
    }
    return labels;
}

std::vector<Message> parts_with_labels(const Submit& submit) {
    const std::span<const Scenario> all(reference().scenarios);
    return {submit, PosesPart{pack_scenarios(all), labels_of(0, all.size())}, PosesEnd{}};
}

/// Runs a job, so that its meshes are stored.
void do_a_job(Master& master) {
    FakeWorker worker(master, {});
    Client(master, reference().submission()).run_until_done();
}

TEST(Removal, AJobIsToldAsItWasSubmittedWithItsLabels) {
    Master master;
    do_a_job(master);
    const auto accepted =
        std::get<Accepted>(answer_to(master, parts_with_labels(labelled_submission())));
    const auto described = std::get<JobDescription>(answer_to(master, {JobQuery{accepted.job}}));
    EXPECT_EQ(described.job, accepted.job);
    EXPECT_EQ(described.submit.unit, "mm");
    EXPECT_EQ(described.submit.bodies, reference().submission().bodies);
    EXPECT_EQ(described.submit.poses, labelled_submission().poses);
    EXPECT_EQ(described.submit.cluster.depths, reference().submission().cluster.depths);

    const auto poses = std::get<JobPoses>(answer_to(master, {PosesQuery{accepted.job, 35, 10}}));
    EXPECT_EQ(poses.first, 35u);
    EXPECT_EQ(poses.count, 10u);
    EXPECT_EQ(poses.labels, labels_of(35, 10));
    const auto scenarios = unpack_scenarios(poses.scenarios, 10).value();
    EXPECT_TRUE(std::equal(scenarios.begin(),
                           scenarios.end(),
                           reference().scenarios.begin() + 35,
                           [](auto& a, auto& b) { return a == b; }));
}

TEST(Removal, ASampleOfPosesHasTheLabelsOfItsScenarios) {
    Master master;
    do_a_job(master);
    const auto accepted =
        std::get<Accepted>(answer_to(master, parts_with_labels(labelled_submission())));
    const std::uint64_t all = reference().scenarios.size();
    const auto poses = std::get<JobPoses>(answer_to(master, {PosesQuery{accepted.job, 1, 3, 4}}));
    EXPECT_EQ(poses.first, 1u);
    EXPECT_EQ(poses.count, 3u);
    const auto scenarios = unpack_scenarios(poses.scenarios, 3).value();
    ASSERT_EQ(scenarios.size(), 3u);
    PoseLabels labels;
    for (std::uint64_t i = 0; i < 3; ++i) {
        const std::uint64_t index = (i + 1) * all / 4;
        EXPECT_TRUE(scenarios[i] == reference().scenarios[index]);
        labels.append(labels_of(index, 1));
    }
    EXPECT_EQ(poses.labels, labels);
    EXPECT_THAT(refusal_of(master, {PosesQuery{accepted.job, 2, 3, 4}}),
                testing::HasSubstr("poses of 3 scenarios from 2 on"));
}

TEST(Removal, LabelsThatWereNotAnnouncedAreRefused) {
    Master master;
    do_a_job(master);
    const auto refused =
        std::get<Failure>(answer_to(master, parts_with_labels(reference().submission())));
    EXPECT_EQ(refused.code, ErrorCode::BadInput);
    EXPECT_THAT(refused.detail, HasSubstr("not announced"));
}

/// Counts job files below the folder that this process holds open.
std::size_t open_job_files(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for (const auto& descriptor : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        const auto file = std::filesystem::read_symlink(descriptor.path(), gone);
        count += !gone && file.parent_path() == folder / "jobs" ? 1 : 0;
    }
    return count;
}

TEST(Removal, JobsThatHaveEndedHoldNoFilesOpen) {
    constexpr int jobs = 20;
    const TemporaryFolder folder;
    const auto files_of_jobs = [&] {
        return static_cast<int>(std::ranges::count_if(
            std::filesystem::directory_iterator(folder / "jobs"),
            [](const auto& file) { return file.path().extension() == ".results"; }));
    };
    {
        Master master({}, folder.path());
        for (int i = 0; i < jobs; ++i) {
            do_a_job(master);
        }
        EXPECT_EQ(files_of_jobs(), jobs);
        master.run_until([&] { return open_job_files(folder.path()) == 0; });
    }
    Master master({}, folder.path());
    EXPECT_EQ(files_of_jobs(), jobs);
    EXPECT_EQ(open_job_files(folder.path()), 0u);
    const auto part = std::get<ResultsPart>(answer_to(master, {ResultsQuery{JobId{1}, 0, 10}}));
    EXPECT_GT(part.next, 0u);
    EXPECT_EQ(open_job_files(folder.path()), 0u) << "read, and closed again";
    Client connected(master);
    connected.start_asking({PosesQuery{JobId{1}, 0, 10}});
    connected.run_until_done();
    EXPECT_TRUE(std::holds_alternative<JobPoses>(connected.answer->value()));
    EXPECT_EQ(open_job_files(folder.path()), 0u) << "while the client stays";
}

TEST(Removal, AMeshIsSentFromAnyOffset) {
    Master master;
    do_a_job(master);
    const Bytes bytes = reference().a.canonical_bytes();
    const auto part =
        std::get<MeshBytes>(answer_to(master, {MeshQuery{reference().a.hash(), 100}}));
    EXPECT_EQ(part.bytes_total, bytes.size());
    ASSERT_EQ(part.bytes.size(), bytes.size() - 100);
    EXPECT_TRUE(std::equal(part.bytes.begin(), part.bytes.end(), bytes.begin() + 100));
    const auto behind =
        std::get<Failure>(answer_to(master, {MeshQuery{reference().a.hash(), bytes.size()}}));
    EXPECT_EQ(behind.code, ErrorCode::BadInput);
    EXPECT_EQ(std::get<Failure>(answer_to(master, {MeshQuery{}})).code, ErrorCode::NotFound);
}

TEST(Removal, AMeshOfASubmissionUnderWayStays) {
    Master master;
    do_a_job(master);
    Client submitting(master);
    submitting.start_asking({labelled_submission()}); // Sends no poses.
    master.run_until([&] {
        const std::filesystem::directory_iterator files(master.directory / "jobs");
        return std::any_of(begin(files), end(files), [](const auto& file) {
            return file.path().filename().string().starts_with("labels");
        });
    });
    const auto removed = std::get<Removed>(answer_to(master, {Remove{JobId{1}, false}}));
    EXPECT_GT(removed.bytes, 0u);
    master.run_until([&] { return master.cluster().jobs.empty(); });
    EXPECT_EQ(master.store->meshes().size(), 2u);
    const auto refused = std::get<Failure>(answer_to(master, {RemoveMesh{reference().a.hash()}}));
    EXPECT_EQ(refused.code, ErrorCode::Refused);
}

TEST(Removal, LeftoverFilesOfRemovedJobsAndMeshesAreDeletedAtTheNextStart) {
    const TemporaryFolder folder;
    const std::string gone = to_hex(Sha256{});
    std::filesystem::path kept;
    {
        Master master({}, folder.path());
        do_a_job(master);
        kept = folder / "trees" / (to_hex(reference().a.hash()) + ".tree");
    }
    const std::vector<std::filesystem::path> orphans{folder / "jobs" / "77.labels",
                                                     folder / "jobs" / "77.results",
                                                     folder / "trees" / (gone + ".tree"),
                                                     folder / "blocks" / (gone + "-d7.blocks"),
                                                     folder / "meshes" / (gone + ".info")};
    for (const auto& path : orphans) {
        write_text(path, "left");
    }
    const Master master({}, folder.path());
    for (const auto& path : orphans) {
        EXPECT_FALSE(std::filesystem::exists(path)) << path;
    }
    EXPECT_TRUE(std::filesystem::exists(kept));
}

} // namespace
} // namespace cd::tests

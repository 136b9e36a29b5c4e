// Proves that a check of a state directory finds all damage, names every file, changes nothing, and
// reports a sound directory as sound.
#include "master/check_state.hpp"

#include "common/job/packed_scenarios.hpp"
#include "master/geometry/geometry_store.hpp"
#include "master/identity/identity.hpp"
#include "master/journal/journal.hpp"
#include "master/submission/label_spool.hpp"
#include "master/submission/pose_spool.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace cd::tests {
namespace {

ScenarioResult failed_result(std::uint64_t scenario) {
    ScenarioResult result;
    result.index = scenario;
    result.kind = ScenarioClass::Failed;
    result.failure = "why not";
    return result;
}

/// State with a mesh, an unfinished job with poses and results, and an ended job with results.
class CheckState : public testing::Test {
  protected:
    void SetUp() override {
        ThreadPool pool(1);
        const auto store = std::move(GeometryStore::open(folder_.path(), pool).value());
        const Bytes bytes = mesh_.canonical_bytes();
        auto upload = std::move(store->begin_upload(mesh_.hash(), "ball", bytes.size()).value());
        ASSERT_TRUE(upload->append(0, bytes));
        ASSERT_TRUE(store->finish_upload(std::move(upload)));

        const auto journal =
            std::move(Journal::open({.directory = folder_.path(), .synced = false}).value());
        journal->start({[](std::uint64_t) {}, [](const std::string&) {}});
        for (const JobId id : {JobId{1}, JobId{2}}) {
            JobRecord job;
            job.id = id;
            job.submit.scenarios = 5;
            job.submit.bodies.resize(2);
            for (JobBody& body : job.submit.bodies) {
                body.mesh = mesh_.hash();
            }
            const auto spool = std::move(PoseSpool::create(folder_ / "jobs", {5, 2}).value());
            std::vector<Scenario> scenarios(5);
            for (std::uint64_t i = 0; i < 5; ++i) {
                scenarios[i].index = i;
            }
            ASSERT_TRUE(spool->append(pack_scenarios(scenarios)));
            ASSERT_TRUE(spool->seal(journal->poses_path(id), Durability::Unsynced));
            if (id == JobId{1}) {
                job.submit.poses.labels = {IdKind::Integer, false};
                const auto labels = std::move(
                    LabelSpool::create(folder_ / "jobs", job.submit.poses.labels, 5).value());
                PoseLabels ids;
                ids.integers = {1, 2, 3, 5, 8};
                ASSERT_TRUE(labels->append(ids, 5));
                ASSERT_TRUE(labels->seal(journal->labels_path(id), Durability::Unsynced));
            }
            journal->add(AcceptJob{job});
            AddResults add{id, ResultStore::create(journal->results_path(id), id, 5), {}, {}, {}};
            add.results.add(failed_result(3));
            add.alarms.emplace().add("somebody has to look at this");
            add.alarms->quarantine(7);
            journal->add(std::move(add));
        }
        journal->add(EndJob{JobId{2}, {JobState::Cancelled, "cancelled", {}}, {}});
    }

    void flip(const std::filesystem::path& path, std::size_t byte) const {
        std::string content = read_text(path);
        content.at(byte) = static_cast<char>(content.at(byte) ^ 1);
        write_text(path, content);
    }
    [[nodiscard]] std::filesystem::path mesh_path() const {
        for (const auto& file : std::filesystem::directory_iterator(folder_ / "meshes")) {
            if (file.path().extension() == ".mesh") {
                return file.path();
            }
        }
        return {};
    }

    TemporaryFolder folder_;
    Mesh mesh_ = make_sphere(2);
};

std::string text_of(const StateReport& report) {
    std::string text;
    for (const std::string& line : report.lines) {
        text += line + "\n";
    }
    return text;
}

TEST_F(CheckState, ASoundOneIsSaidToBeSo) {
    const StateReport report = check_state(folder_.path());
    EXPECT_TRUE(report.is_sound) << text_of(report);
    EXPECT_THAT(report.lines,
                testing::Contains("journal: 2 jobs, 1 of them unfinished, 2 results"));
    EXPECT_THAT(report.lines, testing::Contains("alarms: 1, quarantined workers: 1"));
    EXPECT_THAT(report.lines, testing::Contains("meshes: 1"));
}

TEST_F(CheckState, ADamagedIdentityIsNamed) {
    ASSERT_TRUE(MasterIdentity::init(folder_.path(), {std::chrono::hours(1)}));
    EXPECT_TRUE(check_state(folder_.path()).is_sound);
    flip(folder_ / "identity/authority.key", 60);
    const StateReport key = check_state(folder_.path());
    EXPECT_FALSE(key.is_sound);
    EXPECT_NE(text_of(key).find("cdmaster init"), std::string::npos) << "what to do";
    flip(folder_ / "identity/authority.key", 60);
    write_text(folder_ / "identity/tokens", "rubbish");
    std::filesystem::permissions(folder_ / "identity/tokens", std::filesystem::perms::owner_read);
    const StateReport tokens = check_state(folder_.path());
    EXPECT_FALSE(tokens.is_sound);
    EXPECT_NE(text_of(tokens).find("identity/tokens"), std::string::npos) << text_of(tokens);
}

TEST_F(CheckState, AnIdentityWithoutItsAuthorityIsDamagedAndNotMadeAgain) {
    const MasterIdentity::Options options{std::chrono::hours(1)};
    ASSERT_TRUE(MasterIdentity::init(folder_.path(), options));
    const auto authority = folder_ / "identity/authority.pem";
    std::filesystem::remove(authority);
    const StateReport report = check_state(folder_.path());
    EXPECT_FALSE(report.is_sound);
    EXPECT_THAT(text_of(report), testing::HasSubstr(authority.string() + " is missing"));
    const auto opened = MasterIdentity::open(folder_.path(), options);
    ASSERT_FALSE(opened) << "it would go on without TLS";
    EXPECT_THAT(opened.error().detail, testing::HasSubstr("is missing"));
    EXPECT_FALSE(MasterIdentity::init(folder_.path(), options));
    EXPECT_FALSE(std::filesystem::exists(authority));
}

TEST_F(CheckState, AMissingMeshOfAnUnfinishedJobIsNamed) {
    std::filesystem::remove(mesh_path());
    const StateReport report = check_state(folder_.path());
    EXPECT_FALSE(report.is_sound);
    EXPECT_THAT(text_of(report), testing::HasSubstr(to_hex(mesh_.hash()) + ".mesh is missing"));
    EXPECT_THAT(text_of(report), testing::HasSubstr("job 1"));
    EXPECT_THAT(text_of(report), testing::Not(testing::HasSubstr("job 2"))) << "it has ended";
}

TEST_F(CheckState, DamagedOrMissingLabelsAreNamed) {
    const auto labels = folder_ / "jobs/1.labels";
    flip(labels, 3);
    const StateReport damaged = check_state(folder_.path());
    EXPECT_FALSE(damaged.is_sound);
    EXPECT_THAT(text_of(damaged), testing::HasSubstr(labels.string() + " is damaged"));
    std::filesystem::remove(labels);
    const StateReport missing = check_state(folder_.path());
    EXPECT_FALSE(missing.is_sound);
    EXPECT_THAT(text_of(missing), testing::HasSubstr(labels.string()));
}

TEST_F(CheckState, ADamagedBlockIsNamed) {
    {
        ThreadPool pool(1);
        const auto store = std::move(GeometryStore::open(folder_.path(), pool).value());
        ASSERT_TRUE(store->cut(mesh_.hash(), 2));
    }
    EXPECT_TRUE(check_state(folder_.path()).is_sound);
    const auto blocks = std::filesystem::directory_iterator(folder_ / "blocks")->path();
    flip(blocks, std::filesystem::file_size(blocks) - 3);
    const StateReport report = check_state(folder_.path());
    EXPECT_FALSE(report.is_sound);
    EXPECT_THAT(text_of(report), testing::HasSubstr(blocks.string() + " is damaged"));
}

TEST_F(CheckState, AnEmptyFolderIsSoundAndStaysEmpty) {
    const TemporaryFolder empty;
    const StateReport report = check_state(empty.path());
    EXPECT_TRUE(report.is_sound) << text_of(report);
    EXPECT_TRUE(std::filesystem::is_empty(empty.path()));
}

TEST(CheckUnusedState, AnIdentityAloneIsSound) {
    const TemporaryFolder state;
    ASSERT_TRUE(MasterIdentity::init(state.path(), {std::chrono::hours(1)}));
    std::filesystem::create_directory(state / "identity.new");
    const StateReport report = check_state(state.path());
    EXPECT_TRUE(report.is_sound) << text_of(report);
    EXPECT_THAT(report.lines, testing::Contains("there is no state yet"));
    std::filesystem::remove(state / "identity/authority.pem");
    EXPECT_FALSE(check_state(state.path()).is_sound);
}

TEST_F(CheckState, NoFileIsMade) {
    std::filesystem::remove(folder_ / "lock");
    const auto names = [this] {
        std::set<std::string> found;
        for (const auto& file : std::filesystem::recursive_directory_iterator(folder_.path())) {
            found.insert(file.path().string());
        }
        return found;
    };
    const auto before = names();
    EXPECT_TRUE(check_state(folder_.path()).is_sound);
    EXPECT_EQ(names(), before);
}

TEST_F(CheckState, EveryDamagedFileIsNamedAtOnce) {
    ASSERT_FALSE(mesh_path().empty());
    flip(mesh_path(), 50);
    flip(folder_ / "jobs/1.results", 60);
    flip(folder_ / "jobs/2.results", 60);
    flip(folder_ / "jobs/1.poses", 3);
    const StateReport report = check_state(folder_.path());
    EXPECT_FALSE(report.is_sound);
    const std::string text = text_of(report);
    for (const std::string& name : {std::string("1.results"),
                                    std::string("2.results"),
                                    std::string("1.poses"),
                                    mesh_path().filename().string()}) {
        EXPECT_NE(text.find(name), std::string::npos) << text;
    }
}

TEST_F(CheckState, AFileThatCannotBeReadAtAllHidesNoOther) {
    flip(folder_ / "jobs/1.results", 3); // In the header.
    flip(folder_ / "jobs/1.poses", 3);
    std::filesystem::remove(folder_ / "jobs/2.results");
    flip(mesh_path(), 50);
    const StateReport report = check_state(folder_.path());
    EXPECT_FALSE(report.is_sound);
    const std::string text = text_of(report);
    for (const std::string& name : {std::string("1.results"),
                                    std::string("1.poses"),
                                    std::string("2.results"),
                                    mesh_path().filename().string(),
                                    std::string("2 jobs, 1 of them unfinished, 1 results")}) {
        EXPECT_NE(text.find(name), std::string::npos) << text;
    }
    EXPECT_EQ(
        std::ranges::count_if(report.lines,
                              [](const std::string& line) { return line.starts_with("PROBLEM"); }),
        4)
        << text;
}

TEST_F(CheckState, AJournalThatIsGoneIsNoNewState) {
    for (const char* name : {"journal.db", "journal.mark", "jobs/1.results", "jobs/2.results"}) {
        std::filesystem::remove(folder_ / name);
    }
    const StateReport report = check_state(folder_.path());
    EXPECT_FALSE(report.is_sound);
    EXPECT_NE(text_of(report).find("journal.db is missing"), std::string::npos) << text_of(report);
}

TEST_F(CheckState, NothingIsChanged) {
    flip(folder_ / "journal.mark", 9);
    std::map<std::string, std::string> before;
    const auto each_file = [&](const auto& visit) {
        for (const auto& file : std::filesystem::recursive_directory_iterator(folder_.path())) {
            // SQLite creates an empty log if none exists; ignore it.
            if (file.is_regular_file() && file.file_size() != 0) {
                visit(file.path().string());
            }
        }
    };
    each_file([&](const std::string& path) { before[path] = read_text(path); });
    EXPECT_FALSE(check_state(folder_.path()).is_sound);
    std::size_t files = 0;
    each_file([&](const std::string& path) {
        EXPECT_EQ(read_text(path), before[path]) << path;
        ++files;
    });
    EXPECT_EQ(files, before.size());
}

TEST_F(CheckState, WhatAMasterUsesOrWhatIsNoStateIsNotChecked) {
    ThreadPool pool(1);
    const auto store = std::move(GeometryStore::open(folder_.path(), pool).value());
    EXPECT_NE(text_of(check_state(folder_.path())).find("in use"), std::string::npos);
    EXPECT_FALSE(check_state(folder_ / "none").is_sound);
}

} // namespace
} // namespace cd::tests

// Proves that after a restart the journal knows each result's author, open disputes, losses and
// their workers, alarms, and quarantined workers; and that it refuses every other journal version.
#include "tests/master/journal_writer.hpp"

#include <map>

namespace cd::tests {
namespace {

using Kind = Remark::Kind;

AddResults results_by(InstanceId author,
                      const std::shared_ptr<ResultStore>& store,
                      std::uint64_t first,
                      std::uint64_t count) {
    AddResults add = results_of(JobId{1}, store, first, count);
    add.author = author;
    return add;
}

AddResults remarks_on(const std::shared_ptr<ResultStore>& store, std::vector<Remark> remarks) {
    AddResults add{JobId{1}, store, {}, {}, {}};
    add.remarks = std::move(remarks);
    return add;
}

std::map<std::uint64_t, InstanceId> authors_in(const RecoveredJob& job) {
    std::map<std::uint64_t, InstanceId> authors;
    EXPECT_EQ(job.done.size(), job.authors.size());
    for (std::size_t i = 0; i < job.done.size(); ++i) {
        authors[job.done[i].scenario] = job.authors.at(i);
    }
    return authors;
}

TEST(JournalAuthors, AuthorsAreRecoveredWhicheverEntriesShareACommit) {
    const TemporaryFolder folder;
    {
        Writer writer(folder.path());
        const auto store = writer.accept(JobId{1}, 100);
        for (std::uint64_t i = 0; i < 12; ++i) {
            writer.add(results_by(70 + i % 3, store, 5 * i, 5), i % 4 == 0);
        }
        writer.journal->add(results_by(0, store, 60, 1)); // The master's.
    }
    const Writer again(folder.path());
    const RecoveredJob& job = again.recovered.jobs.at(0);
    const auto authors = authors_in(job);
    ASSERT_EQ(authors.size(), 61u);
    for (std::uint64_t scenario = 0; scenario < 60; ++scenario) {
        EXPECT_EQ(authors.at(scenario), 70 + scenario / 5 % 3) << scenario;
    }
    EXPECT_EQ(authors.at(60), 0u);
    EXPECT_EQ(job.contributors, (std::set<InstanceId>{70, 71, 72}));
}

TEST(JournalAuthors, AnEndedJobKeepsItsContributors) {
    const TemporaryFolder folder;
    {
        Writer writer(folder.path());
        const auto store = writer.accept(JobId{1}, 100);
        writer.journal->add(results_by(7, store, 0, 5));
        writer.journal->add(results_by(8, store, 5, 5));
        writer.journal->add(EndJob{JobId{1}, {JobState::Cancelled, "cancelled", {}}, {}});
    }
    const Writer again(folder.path());
    EXPECT_EQ(again.recovered.jobs.at(0).contributors, (std::set<InstanceId>{7, 8}));
}

TEST(JournalAuthors, WithdrawnResultsCountAsNeverWrittenAndCorrectedOnesAreTheMasters) {
    for (const bool is_one_commit : {true, false}) {
        const TemporaryFolder folder;
        {
            Writer writer(folder.path());
            const auto store = writer.accept(JobId{1}, 100);
            const auto add = [&](AddResults entry) {
                return writer.add(std::move(entry), !is_one_commit);
            };
            add(results_by(7, store, 0, 10));
            add(results_by(8, store, 10, 10));
            AddResults withdrawal = remarks_on(store, {{Kind::Withdrawn, 0, {}, 7}});
            for (std::uint64_t scenario = 0; scenario < 10; ++scenario) {
                withdrawal.withdrawn.push_back(scenario);
            }
            add(std::move(withdrawal));
            add(results_by(8, store, 4, 2));                              // Done again.
            writer.wait_for(add(results_of(JobId{1}, store, 12, 1, 70))); // The master's.
            EXPECT_EQ(store->count(), 12u);
            EXPECT_FALSE(store->has(3));
            EXPECT_TRUE(store->has(4));
        }
        const Writer again(folder.path());
        const RecoveredJob& job = again.recovered.jobs.at(0);
        const auto authors = authors_in(job);
        ASSERT_EQ(authors.size(), 12u);
        for (const auto& [scenario, author] : authors) {
            EXPECT_TRUE(scenario == 4 || scenario == 5 || scenario >= 10) << scenario;
            EXPECT_EQ(author, scenario == 12 ? 0u : 8u) << scenario;
        }
        EXPECT_EQ(job.withdrawn, 10u);
        EXPECT_EQ(job.results->count(), 12u);
        EXPECT_EQ(job.contributors, (std::set<InstanceId>{8}));
        EXPECT_EQ(job.merger.digest_of(12), digest_of(result_of(12, 70)));
    }
}

TEST(JournalAuthors, ADisputeIsOpenUntilItIsSettled) {
    for (const bool is_one_commit : {true, false}) {
        const TemporaryFolder folder;
        const Remark first{Kind::Disputed, 4, some_hash(1), 8};
        const Remark second{Kind::Disputed, 4, some_hash(2), 9};
        const Remark other{Kind::Disputed, 5, some_hash(1), 8};
        {
            Writer writer(folder.path());
            const auto store = writer.accept(JobId{1}, 100);
            writer.journal->add(results_by(7, store, 0, 10));
            for (const Remark& one : {first, second, other}) {
                writer.add(remarks_on(store, {one}), !is_one_commit);
            }
            Remark settled = first;
            settled.kind = Kind::Settled;
            // Withdrawing the first result settles no dispute.
            writer.journal->add(remarks_on(store, {settled, {Kind::Withdrawn, 0, {}, 7}}));
        }
        const Writer again(folder.path());
        EXPECT_EQ(again.recovered.jobs.at(0).disputes, (std::vector<Remark>{second, other}));
    }
}

TEST(JournalAuthors, LossesOfAJobThatGoesOnComeBackInTheirOrder) {
    const std::vector<LostPositions> lost = {{{5, 90}, 7}, {{6, 1}, 8}, {{99, 1}, 9}};
    for (const bool is_one_commit : {true, false}) {
        const TemporaryFolder folder;
        {
            Writer writer(folder.path());
            for (const JobId job : {JobId{1}, JobId{2}}) {
                const auto store = writer.accept(job, 100);
                for (const LostPositions& one : lost) {
                    AddResults add{job, store, {}, {}, {}};
                    add.losses = {one};
                    writer.add(std::move(add), !is_one_commit);
                }
            }
            writer.journal->add(EndJob{JobId{2}, {JobState::Cancelled, "cancelled", {}}, {}});
        }
        const Writer again(folder.path());
        EXPECT_EQ(again.recovered.jobs.at(0).losses, lost);
        EXPECT_TRUE(again.recovered.jobs.at(1).losses.empty());
    }
}

TEST(JournalAuthors, LossesOfScenariosThatTheJobDoesNotHaveAreDamage) {
    const TemporaryFolder folder;
    {
        Writer writer(folder.path());
        AddResults add{JobId{1}, writer.accept(JobId{1}, 100), {}, {}, {}};
        add.losses = {{{99, 2}, 7}};
        writer.journal->add(std::move(add));
    }
    expect_refused(folder.path(), "were lost");
}

TEST(JournalAuthors, AlarmsAndTheQuarantinedComeBackAsTheyWereLast) {
    const TemporaryFolder folder;
    AlarmRecord alarms;
    {
        Writer writer(folder.path());
        EXPECT_EQ(writer.recovered.alarms, AlarmRecord{});
        const auto store = writer.accept(JobId{1}, 100);
        for (const InstanceId wrong : {7u, 8u}) {
            alarms.add("worker " + std::to_string(wrong) + " is wrong");
            alarms.quarantine(wrong);
            AddResults verdict = remarks_on(store, {});
            verdict.alarms = alarms;
            writer.journal->add(std::move(verdict));
        }
        writer.journal->add(DropJob{JobId{1}});
    }
    for (int round = 0; round < 2; ++round) {
        const Writer again(folder.path());
        EXPECT_EQ(again.recovered.alarms, alarms);
    }
}

TEST(JournalAuthors, DamagedAlarmsAreFoundAndNamed) {
    const TemporaryFolder folder;
    const std::string text = "somebody has to look at this";
    {
        Writer writer(folder.path());
        AddResults verdict = remarks_on(writer.accept(JobId{1}, 100), {});
        verdict.alarms.emplace().add(text);
        writer.journal->add(std::move(verdict));
    }
    std::string database = read_text(folder / "journal.db");
    const std::size_t at = database.find(text);
    ASSERT_NE(at, std::string::npos);
    database[at] = 'S';
    write_text(folder / "journal.db", database);
    expect_refused(folder.path(), "alarms");
}

// ---- Versions -----------------------------------------------------------------------------------

/// SQLite stores the version, big-endian, in its file's header.
constexpr std::size_t version_at = 60;

void set_version(const std::filesystem::path& path, char version) {
    std::string content = read_text(path);
    content.replace(version_at, 4, std::string("\0\0\0", 3) + version);
    write_text(path, content);
}

TEST(JournalAuthors, AJournalOfAnotherVersionIsRefusedWithARemedy) {
    for (const char version : {1, 14, 16}) {
        const TemporaryFolder folder;
        { const Writer writer(folder.path()); }
        set_version(folder / "journal.db", version);
        const std::string why = expect_refused(folder.path(), "journal.db");
        EXPECT_THAT(why, HasSubstr("is of version " + std::to_string(int{version})));
        EXPECT_THAT(why, HasSubstr("let its jobs end with the cdmaster that wrote it"));
        EXPECT_THAT(why, HasSubstr("delete journal.* and jobs in " + folder.path().string()));
        for (const char* name :
             {"journal.db", "journal.db-wal", "journal.db-shm", "journal.mark"}) {
            std::filesystem::remove(folder / name);
        }
        std::filesystem::remove_all(folder / "jobs");
        const Writer writer(folder.path()); // The way out that the refusal names.
    }
}

} // namespace
} // namespace cd::tests

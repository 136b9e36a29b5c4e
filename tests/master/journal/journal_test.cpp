// Proves that the journal restores all it confirmed and nothing that was never added; that it stops
// at a damaged file, names it and changes nothing; that two journals never share a directory; and
// that on a full disk it waits and resumes when there is room.
#include "master/journal/journal.hpp"

#include "common/job/poses/pose_source.hpp"
#include "master/journal/journal_database.hpp"
#include "proto/codec/codec.hpp"
#include "tests/master/journal_writer.hpp"
#include "tests/support/damage.hpp"
#include "tests/support/file_size_limit.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace cd::tests {
namespace {

TEST(Journal, ANewJournalIsEmptyAndHasAUniqueName) {
    const TemporaryFolder one;
    const TemporaryFolder two;
    const Writer first(one.path());
    const Writer second(two.path());
    EXPECT_TRUE(first.recovered.jobs.empty());
    EXPECT_NE(first.recovered.cluster, second.recovered.cluster);
}

TEST(Journal, TheRecordOfAJobHasAllFieldsOfItsSubmission) {
    const JobRecord job{JobId{3}, some_submit(), 7};
    const Bytes record = encode_job(job);
    const auto read = decode_job(record);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().began, 7u);
    EXPECT_EQ(encode_message(read.value().submit), encode_message(job.submit));
    expect_no_other_length(record, decode_job);
}

TEST(Journal, TheRecordOfAJobHasItsQuestion) {
    JobRecord job{JobId{3}, some_submit(), 7};
    job.submit.query = some_distance_query();
    const Bytes record = encode_job(job);
    const auto read = decode_job(record);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().submit.query.question, Question::Distance);
    EXPECT_EQ(read.value().submit.query.up_to, job.submit.query.up_to);
    expect_no_other_length(record, decode_job);
    job.submit.query.up_to = -1;
    EXPECT_FALSE(decode_job(encode_job(job)));
    job.submit.query.question = Question::Contacts;
    job.submit.query.up_to = 1;
    EXPECT_FALSE(decode_job(encode_job(job)));
}

TEST(Journal, TheRecordOfAJobHasItsFirstHits) {
    JobRecord job{JobId{3}, some_submit(), 7};
    job.submit.query = some_shots_query();
    const Bytes record = encode_job(job);
    const auto read = decode_job(record);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().submit.query.question, Question::Shots);
    EXPECT_TRUE(read.value().submit.query.first_hits);
    EXPECT_EQ(read.value().submit.poses, job.submit.poses);
    expect_no_other_length(record, decode_job);
    job.submit.query.question = Question::Contacts;
    EXPECT_FALSE(decode_job(encode_job(job)));
}

TEST(Journal, TheRecordOfAJobHasItsMotion) {
    JobRecord job{JobId{3}, some_submit(), 7};
    job.submit.query = some_motion_query();
    const Bytes record = encode_job(job);
    const auto read = decode_job(record);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read.value().submit.query.question, Question::Motion);
    EXPECT_EQ(read.value().submit.query.motion, job.submit.query.motion);
    expect_no_other_length(record, decode_job);
    job.submit.query.motion->resolution = 0;
    EXPECT_FALSE(decode_job(encode_job(job)));
    job.submit.query.motion.reset();
    EXPECT_FALSE(decode_job(encode_job(job)));
}

TEST(Journal, CommittedEntriesAreRecovered) {
    const TemporaryFolder folder;
    Sha256 cluster;
    {
        Writer writer(folder.path(), true);
        cluster = writer.recovered.cluster;
        const auto store = writer.accept(JobId{5}, 1000);
        writer.journal->add(results_of(JobId{5}, store, 100, 300));
        writer.wait_for(writer.journal->add(results_of(JobId{5}, store, 0, 50)));
        EXPECT_TRUE(store->has(120));
        EXPECT_EQ(store->count(), 350u);
        EXPECT_EQ(writer.journal->queued_bytes(), 0u);
    }
    const Writer again(folder.path());
    EXPECT_EQ(again.recovered.cluster, cluster);
    EXPECT_EQ(again.recovered.last_job, JobId{5});
    ASSERT_EQ(again.recovered.jobs.size(), 1u);
    const RecoveredJob& job = again.recovered.jobs[0];
    // Every member of a submission is kept.
    EXPECT_EQ(encode_message(job.record.submit), encode_message(job_record(JobId{5}, 1000).submit));
    EXPECT_FALSE(job.end);
    EXPECT_EQ(job.done.size(), 350u);
    EXPECT_EQ(job.merger.summary().failed, 350u);
    EXPECT_EQ(job.progress.answered_by_master, 50u);
    EXPECT_EQ(job.progress.traffic, (JobTraffic{{1, 2, 3, 4, 5, 6}, 7}));
    EXPECT_EQ(job.progress.help, (HelpAtEnd{8, 9, 10}));
    EXPECT_EQ(job.progress.statistics.search.effort, (SearchEffort{11, 12, 13, 14}));
    EXPECT_EQ(job.progress.depths, (std::vector<std::uint32_t>{7, 8}));
    EXPECT_EQ(job.results->count(), 350u);
    EXPECT_EQ(job.results->read(0, 1000, 1u << 20).value().count, 350u);
}

TEST(Journal, TheJournalWaitsUntilItsDirectoryIsBack) {
    const TemporaryFolder folder;
    const std::filesystem::path directory = folder / "state";
    std::filesystem::create_directory(directory);
    {
        Writer writer(directory);
        const auto store = writer.accept(JobId{1}, 100);
        const std::uint64_t last = writer.journal->add(results_of(JobId{1}, store, 0, 10));
        writer.wait_for(last);
        std::filesystem::rename(directory, folder / "elsewhere");
        const std::uint64_t next = writer.journal->add(results_of(JobId{1}, store, 10, 10));
        EXPECT_THAT(writer.wait_until_paused(), HasSubstr(directory.string() + " was removed"));
        EXPECT_EQ(writer.committed(), last);
        std::filesystem::rename(folder / "elsewhere", directory);
        writer.wait_for(next);
    }
    const Writer again(directory);
    EXPECT_EQ(again.recovered.jobs.at(0).done.size(), 20u);
}

TEST(Journal, MissingResultsOfAnEndedJobDoNotKeepTheMasterFromStarting) {
    const TemporaryFolder folder;
    std::filesystem::path results;
    {
        Writer writer(folder.path());
        const auto store = writer.accept(JobId{1}, 20);
        results = writer.journal->results_path(JobId{1});
        writer.journal->add(results_of(JobId{1}, store, 0, 20));
        writer.wait_for(
            writer.journal->add(EndJob{JobId{1}, {JobState::Cancelled, "enough", {}}, {}}));
    }
    const std::string whole = read_text(results);
    for (const std::size_t bytes : {whole.size() / 2, std::size_t{0}}) {
        if (bytes == 0) {
            std::filesystem::remove(results);
        } else {
            write_text(results, whole.substr(0, bytes));
        }
        const Writer again(folder.path());
        const RecoveredJob& job = again.recovered.jobs.at(0);
        EXPECT_EQ(job.results->count(), 20u);
        const auto read = job.results->read(0, 20, 1u << 20);
        ASSERT_FALSE(read);
        EXPECT_EQ(read.error().code, ErrorCode::Io);
        EXPECT_THAT(read.error().detail, HasSubstr(results.string()));
    }
}

TEST(Journal, AnEndedJobComesBackWithItsDigest) {
    const TemporaryFolder folder;
    std::optional<Sha256> digest;
    {
        Writer writer(folder.path());
        const auto store = writer.accept(JobId{1}, 20);
        ResultMerger merger(20);
        for (std::uint64_t i = 0; i < 20; ++i) {
            (void)merger.add(result_of(i));
        }
        digest = merger.digest();
        writer.journal->add(results_of(JobId{1}, store, 0, 20));
        writer.journal->add(EndJob{JobId{1}, {JobState::Done, "", digest}, {}});
        (void)writer.accept(JobId{2}, 20);
        writer.journal->add(EndJob{JobId{2}, {JobState::Failed, "why not", {}}, {}});
        (void)writer.accept(JobId{3}, 20);
        writer.wait_for(writer.journal->add(DropJob{JobId{3}}));
    }
    const Writer again(folder.path());
    ASSERT_EQ(again.recovered.jobs.size(), 2u);
    EXPECT_EQ(again.recovered.last_job, JobId{3});
    EXPECT_EQ(again.recovered.jobs[0].end->digest, digest);
    EXPECT_EQ(again.recovered.jobs[1].end->failure, "why not");
    EXPECT_EQ(again.recovered.jobs[1].end->state, JobState::Failed);
}

TEST(Journal, TheJournalGoesOnAfterAnyNumberOfRestarts) {
    const TemporaryFolder folder;
    for (std::uint64_t round = 0; round < 5; ++round) {
        Writer writer(folder.path());
        std::shared_ptr<ResultStore> store;
        if (round == 0) {
            store = writer.accept(JobId{1}, 100);
        } else {
            ASSERT_EQ(writer.recovered.jobs.size(), 1u);
            EXPECT_EQ(writer.recovered.jobs[0].done.size(), 10 * round);
            store = writer.recovered.jobs[0].results;
        }
        // The destructor writes all added entries.
        writer.journal->add(results_of(JobId{1}, store, 10 * round, 10));
    }
}

TEST(Journal, FilesOfNoJobAreClearedAway) {
    const TemporaryFolder folder;
    {
        Writer writer(folder.path());
        for (const JobId job : {JobId{1}, JobId{2}}) {
            const auto store = writer.accept(job, 10);
            writer.journal->add(results_of(job, store, 0, 3));
            write_text(writer.journal->poses_path(job), "poses");
        }
        writer.journal->add(EndJob{JobId{2}, {JobState::Cancelled, "cancelled", {}}, {}});
        for (const char* name : {"3.poses", "4.results", "poses.tmp-abc", "notes.txt"}) {
            write_text(folder.path() / "jobs" / name, "left");
        }
    }
    const Writer again(folder.path());
    std::set<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder / "jobs")) {
        names.insert(file.path().filename().string());
    }
    EXPECT_EQ(names,
              (std::set<std::string>{"1.poses", "1.results", "2.poses", "2.results", "notes.txt"}));
}

TEST(Journal, ManyEntriesShareACommit) {
    const TemporaryFolder folder;
    Writer writer(folder.path(), true);
    const auto store = writer.accept(JobId{1}, 100'000);
    std::uint64_t last = 0;
    for (std::uint64_t i = 0; i < 20'000; ++i) {
        last = writer.journal->add(results_of(JobId{1}, store, i, 1));
    }
    writer.wait_for(last);
    EXPECT_EQ(store->count(), 20'000u);
}

TEST(Journal, ASecondJournalOnTheSameDirectoryIsRefused) {
    const TemporaryFolder folder;
    const Writer writer(folder.path());
    expect_refused(folder.path(), "journal.db");
}

// ---- Damage -------------------------------------------------------------------------------------

/// Fills a directory with a job whose results are in several commits, as a killed master leaves it,
/// write-ahead log included.
void fill(const std::filesystem::path& directory) {
    Writer writer(directory / "live");
    const auto store = writer.accept(JobId{1}, 500);
    for (std::uint64_t i = 0; i < 5; ++i) {
        writer.wait_for(writer.journal->add(results_of(JobId{1}, store, 20 * i, 20)));
    }
    std::filesystem::copy(
        directory / "live", directory / "left", std::filesystem::copy_options::recursive);
}

constexpr const char* way_out = "restore the state directory from a copy";

TEST(Journal, TheJournalOfAKilledMasterIsWhole) {
    const TemporaryFolder folder;
    fill(folder.path());
    ASSERT_TRUE(std::filesystem::exists(folder / "left/journal.db-wal"));
    const Writer again(folder / "left");
    ASSERT_EQ(again.recovered.jobs.size(), 1u);
    EXPECT_EQ(again.recovered.jobs[0].done.size(), 100u);
}

TEST(Journal, FlippedBytesAreFoundNamedAndLeftAsTheyAre) {
    const TemporaryFolder folder;
    fill(folder.path());
    { const Writer closed(folder / "live"); } // Leaves one file without a log.
    std::mt19937_64 random(3);
    std::size_t found = 0;
    for (const char* which : {"left/journal.db-wal",
                              "left/journal.mark",
                              "left/jobs/1.results",
                              "live/journal.db",
                              "live/journal.mark",
                              "live/jobs/1.results"}) {
        const std::filesystem::path original = folder / which;
        const std::string good = read_text(original);
        for (int round = 0; round < 20; ++round) {
            const std::filesystem::path copy = folder / "copy";
            std::filesystem::remove_all(copy);
            std::filesystem::copy(original.parent_path().filename() == "jobs"
                                      ? original.parent_path().parent_path()
                                      : original.parent_path(),
                                  copy,
                                  std::filesystem::copy_options::recursive);
            const std::filesystem::path hit =
                copy / std::filesystem::relative(original,
                                                 folder.path() / std::string(which).substr(0, 4));
            std::string bad = good;
            const std::size_t byte = random() % bad.size();
            bad[byte] = static_cast<char>(bad[byte] ^ (1 << (random() % 8)));
            write_text(hit, bad);
            const auto opened = Journal::open({.directory = copy, .synced = false});
            if (opened) {
                // The damage may affect only bytes without meaning: no result is lost or changed.
                const Recovered recovered = opened.value()->take_recovered();
                ASSERT_EQ(recovered.jobs.size(), 1u) << which << " byte " << byte;
                ASSERT_EQ(recovered.jobs[0].done.size(), 100u) << which << " byte " << byte;
                ASSERT_TRUE(recovered.jobs[0].results->verify());
                continue;
            }
            ++found;
            EXPECT_THAT(opened.error().detail,
                        HasSubstr(original.filename().string().substr(0, 7)));
            EXPECT_THAT(opened.error().detail, HasSubstr(way_out));
            ASSERT_EQ(read_text(hit), bad) << "it was changed";
        }
    }
    EXPECT_GT(found, 60u);
}

TEST(Journal, MissingFilesAreNamed) {
    for (const char* gone : {"journal.db", "journal.db-wal", "journal.mark", "jobs/1.results"}) {
        const TemporaryFolder folder;
        fill(folder.path());
        std::filesystem::remove(folder / "left" / gone);
        EXPECT_THAT(expect_refused(folder / "left", gone), HasSubstr(way_out));
        // SQLite creates an empty log if none exists; ignore it.
        std::error_code none;
        const auto size = std::filesystem::file_size(folder / "left" / gone, none);
        EXPECT_TRUE(none || size == 0) << "it was made anew: " << gone;
    }
}

/// Removes all of a journal's files except those of the job.
TEST(Journal, AnEmptyIndexBesideJobFilesIsRefused) {
    using Names = std::vector<std::string>;
    for (const Names& left :
         {Names{"1.results"}, Names{"1.poses"}, Names{"1.poses", "1.results"}}) {
        for (const char* journal : {"nothing", "an empty file", "one without its log"}) {
            const TemporaryFolder folder;
            if (journal == std::string("one without its log")) {
                { const Writer writer(folder.path()); }
                std::filesystem::remove(folder / "journal.mark");
            }
            if (journal == std::string("an empty file")) {
                write_text(folder / "journal.db", "");
            }
            std::filesystem::create_directories(folder / "jobs");
            for (const std::string& name : left) {
                write_text(folder / "jobs" / name, "precious");
            }
            for (const bool create : {false, true, true}) {
                const auto opened = Journal::open({.directory = folder.path(), .create = create});
                ASSERT_FALSE(opened) << journal;
                EXPECT_THAT(opened.error().detail,
                            testing::AllOf(HasSubstr("journal."), HasSubstr(way_out)));
            }
            for (const std::string& name : left) {
                EXPECT_EQ(read_text(folder / "jobs" / name), "precious");
            }
        }
    }
}

/// The process was killed while it made the journal, before it wrote anything.
TEST(Journal, AnEmptyJournalWithoutAMarkGetsOne) {
    for (const bool is_empty : {false, true}) {
        const TemporaryFolder folder;
        { const Writer writer(folder.path()); }
        const std::string whole = read_text(folder / "journal.mark");
        std::filesystem::remove(folder / "journal.mark");
        if (is_empty) {
            write_text(folder / "journal.mark", "");
        }
        write_text(folder / "journal.mark.tmp-abcdef", whole.substr(0, 5));
        { const Writer writer(folder.path()); }
        EXPECT_EQ(read_text(folder / "journal.mark"), whole);
        EXPECT_FALSE(std::filesystem::exists(folder / "journal.mark.tmp-abcdef"));
    }
}

TEST(Journal, AFirstGroupThatIsNotTheFirstIsDamage) {
    const TemporaryFolder folder;
    {
        Writer writer(folder.path());
        writer.wait_for(writer.journal->add(AcceptJob{job_record(JobId{1}, 100)}));
    }
    {
        // Two records; the first is in no group.
        auto database = std::move(JournalDatabase::open(folder.path(), {}).value());
        const auto store = ResultStore::create(folder / "jobs/2.results", JobId{2}, 100);
        ResultBatch batch;
        batch.add(result_of(49));
        batch.add(result_of(50));
        ASSERT_TRUE(store->write(std::vector<const ResultBatch*>{&batch}));
        const auto rows = batch.rows();
        ResultGroup group;
        group.begin = ResultStore::end_of(ResultStore::place_at(store->end(), rows[0].length));
        group.rows = {rows[1]};
        group.authors = {{1, 0}};
        Bytes record = encode_job(job_record(JobId{2}, 100));
        using Kind = DatabaseChange::Kind;
        ASSERT_TRUE(database->write(
            std::vector<DatabaseChange>{{Kind::Accept, JobId{2}, std::move(record)},
                                        {Kind::Results, JobId{2}, encode_group(group)}}));
    }
    EXPECT_THAT(expect_refused(folder.path(), "job 2: results are missing"), HasSubstr(way_out));
}

TEST(Journal, ResultsOfAnUnknownJobAreDamage) {
    const TemporaryFolder folder;
    { const Writer writer(folder.path()); }
    {
        auto database = std::move(JournalDatabase::open(folder.path(), {}).value());
        ResultGroup group;
        group.begin = ResultStore::first_end();
        ASSERT_TRUE(database->write(std::vector<DatabaseChange>{
            {DatabaseChange::Kind::Results, JobId{7}, encode_group(group)}}));
    }
    EXPECT_THAT(expect_refused(folder.path(), "results of job 7, which is not there"),
                HasSubstr(way_out));
}

TEST(Journal, ASegmentMayBeLongerThanItsCommittedBytesButNotShorter) {
    const TemporaryFolder folder;
    fill(folder.path());
    const std::string whole = read_text(folder / "left/jobs/1.results");
    write_text(folder / "left/jobs/1.results", whole + "half a rec");
    { EXPECT_TRUE(Journal::open({.directory = folder / "left"})); }
    write_text(folder / "left/jobs/1.results", whole.substr(0, whole.size() - 1));
    expect_refused(folder / "left", "1.results");
}

// ---- A full disk --------------------------------------------------------------------------------

TEST(Journal, TheJournalWaitsUntilTheDiskHasRoom) {
    const TemporaryFolder folder;
    {
        Writer writer(folder.path());
        const auto store = writer.accept(JobId{1}, 10'000);
        writer.wait_for(1);
        std::uint64_t last = 0;
        {
            const FileSizeLimit full(200'000);
            for (std::uint64_t i = 0; i < 40; ++i) {
                last = writer.journal->add(results_of(JobId{1}, store, 20 * i, 20, 2000));
            }
            const std::string why = writer.wait_until_paused();
            EXPECT_FALSE(why.empty());
            EXPECT_LT(writer.committed(), last);
            EXPECT_GT(writer.journal->queued_bytes(), 0u);
        }
        writer.wait_for(last);
        EXPECT_EQ(store->count(), 800u);
    }
    const Writer again(folder.path());
    EXPECT_EQ(again.recovered.jobs.at(0).done.size(), 800u);
    EXPECT_TRUE(again.recovered.jobs.at(0).results->verify());
}

TEST(Journal, EndingDuringAWaitLosesOnlyUnconfirmedEntries) {
    const TemporaryFolder folder;
    std::uint64_t committed = 0;
    {
        Writer writer(folder.path());
        const auto store = writer.accept(JobId{1}, 10'000);
        writer.wait_for(1);
        const FileSizeLimit full(200'000);
        for (std::uint64_t i = 0; i < 40; ++i) {
            writer.journal->add(results_of(JobId{1}, store, 20 * i, 20, 2000));
        }
        (void)writer.wait_until_paused();
        committed = writer.committed();
    }
    const Writer again(folder.path());
    EXPECT_GE(again.recovered.jobs.at(0).done.size(), 20 * (committed - 1));
    EXPECT_TRUE(again.recovered.jobs.at(0).results->verify());
}

} // namespace
} // namespace cd::tests

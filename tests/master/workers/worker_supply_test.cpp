// Proves which jobs and trees a worker is sent, once each: events in, messages out.
#include "master/workers/worker_supply.hpp"

#include "common/core/limits/master.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace cd::tests {
namespace {

Sha256 cut_of(std::uint64_t number) {
    const std::string text = "cut " + std::to_string(number);
    return sha256(std::as_bytes(std::span(text)));
}

AddTree tree(std::uint64_t number) {
    AddTree add;
    add.tree = TreeId{number};
    add.cut = cut_of(number);
    return add;
}

AddJob job(std::uint64_t number, std::uint64_t a, std::uint64_t b) {
    return {JobId{number}, {TreeId{a}, TreeId{b}}, {}, {}};
}

/// "+t1 +j1 -t2": trees and jobs that the messages add and remove.
std::string text_of(const WorkerSupply::Messages& messages) {
    std::string text;
    for (const Message& message : messages) {
        text += text.empty() ? "" : " ";
        if (const auto* added = std::get_if<AddTree>(&message)) {
            text += "+t" + std::to_string(added->tree.value);
        } else if (const auto* job = std::get_if<AddJob>(&message)) {
            text += "+j" + std::to_string(job->job.value);
        } else if (const auto* gone = std::get_if<RemoveTree>(&message)) {
            text += "-t" + std::to_string(gone->tree.value);
        } else if (const auto* ended = std::get_if<RemoveJob>(&message)) {
            text += "-j" + std::to_string(ended->job.value);
        } else {
            text += "another message";
        }
    }
    return text;
}

TEST(WorkerSupply, AJobComesAfterThoseOfItsTreesThatTheWorkerLacks) {
    WorkerSupply supply;
    EXPECT_FALSE(supply.has_job(JobId{1}));
    EXPECT_EQ(text_of(supply.add_job(job(1, 1, 2), std::array{tree(1), tree(2)})), "+t1 +t2 +j1");
    EXPECT_TRUE(supply.has_job(JobId{1}));
    EXPECT_TRUE(supply.has_tree(TreeId{2}));
    EXPECT_EQ(text_of(supply.add_job(job(2, 2, 3), std::array{tree(2), tree(3)})), "+t3 +j2");
    EXPECT_EQ(text_of(supply.add_job(job(3, 4, 4), std::array{tree(4), tree(4)})), "+t4 +j3");
}

TEST(WorkerSupply, OnlyWhatTheWorkerKnowsIsRemoved) {
    WorkerSupply supply;
    (void)supply.add_job(job(1, 1, 2), std::array{tree(1), tree(2)});
    EXPECT_EQ(text_of(supply.remove_job(JobId{2})), "");
    EXPECT_EQ(text_of(supply.remove_tree(TreeId{3})), "");
    EXPECT_EQ(text_of(supply.remove_job(JobId{1})), "-j1");
    EXPECT_EQ(text_of(supply.remove_job(JobId{1})), "");
    EXPECT_EQ(text_of(supply.remove_tree(TreeId{1})), "-t1");
    EXPECT_EQ(text_of(supply.add_job(job(2, 1, 2), std::array{tree(1), tree(2)})), "+t1 +j2");
}

TEST(WorkerSupply, TreesWhoseBlocksAreKeptAreAddedWithoutAJob) {
    WorkerSupply supply;
    const std::array in_use{tree(1), tree(2), tree(3)};
    EXPECT_EQ(text_of(supply.add_kept(in_use)), "");
    ASSERT_TRUE(supply.cuts_kept({{cut_of(3), cut_of(9)}}));
    ASSERT_TRUE(supply.cuts_kept({{cut_of(1)}}));
    EXPECT_EQ(text_of(supply.add_kept(in_use)), "+t1 +t3");
    EXPECT_EQ(text_of(supply.add_kept(in_use)), "");
}

TEST(WorkerSupply, BlocksOfARemovedTreeAreKeptForTheNextTreeOfTheSameCut) {
    WorkerSupply supply;
    (void)supply.add_job(job(1, 1, 2), std::array{tree(1), tree(2)});
    EXPECT_EQ(text_of(supply.remove_tree(TreeId{1})), "-t1");
    AddTree again = tree(3);
    again.cut = cut_of(1);
    EXPECT_EQ(text_of(supply.add_kept(std::array{tree(2), again, tree(4)})), "+t3");
}

TEST(WorkerSupply, TooManyKeptCutsAreAnError) {
    WorkerSupply supply;
    Holding holding;
    for (std::uint64_t number = 0; number <= limits::cuts_held_max; ++number) {
        holding.cuts.push_back(cut_of(number));
    }
    const Sha256 last = holding.cuts.back();
    holding.cuts.pop_back();
    EXPECT_TRUE(supply.cuts_kept(holding));
    EXPECT_TRUE(supply.cuts_kept(holding)) << "they are the same";
    EXPECT_EQ(supply.cuts_kept({{last}}).error().code, ErrorCode::TooLarge);
}

TEST(WorkerSupply, AnInventoryIsMadeToAgreeWithTheRecord) {
    WorkerSupply supply;
    (void)supply.add_job(job(1, 1, 2), std::array{tree(1), tree(2)});
    (void)supply.add_job(job(2, 1, 3), std::array{tree(1), tree(3)});
    Inventory inventory;
    inventory.trees = {{TreeId{2}, {}}, {TreeId{8}, {}}, {TreeId{1}, {}}};
    inventory.jobs = {JobId{7}, JobId{1}};
    EXPECT_EQ(text_of(supply.compare(inventory)), "-t8 -j7") << "their removal was lost";
    EXPECT_EQ(text_of(supply.compare({{{TreeId{1}, {}}, {TreeId{2}, {}}}, {JobId{1}}, {}})), "");
    EXPECT_TRUE(supply.has_job(JobId{1}));
    EXPECT_EQ(text_of(supply.add_job(job(2, 1, 3), std::array{tree(1), tree(3)})), "+t3 +j2")
        << "they were lost on their way";
}

} // namespace
} // namespace cd::tests

// Proves that a search for the next contact in a cluster's job reports the last scenario that it
// read, so that the page can continue from there. Also proves that the search finds parts by the
// names that the job's groups have.
#include "web/server/cluster/cluster_jobs.hpp"

#include "common/core/errors.hpp"
#include "common/core/limits/web.hpp"
#include "tests/support/parts.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Has one job, whose bodies are boxes; A has two parts.
class FakeReader final : public ClusterReader {
  public:
    void status(Take<ClusterStatus> take) override { take(ClusterStatus()); }
    void map(const ContactMapQuery& /*query*/, Take<ContactMapAnswer> take) override {
        take(ContactMapAnswer());
    }
    [[nodiscard]] Result<RecordReader> records(JobId /*job*/,
                                               std::uint64_t /*scenarios*/) override {
        return none();
    }
    [[nodiscard]] Status may_run() override { return Done{}; }
    [[nodiscard]] Result<JobDescription> description(JobId /*job*/) override {
        JobDescription description;
        description.submit.query.level = Level::Pairs;
        description.submit.bodies.resize(2);
        return description;
    }
    [[nodiscard]] Result<LabelledScenarios> poses(JobId /*job*/,
                                                  const ScenarioChoice& /*choice*/) override {
        return none();
    }
    [[nodiscard]] Result<BodyTrees> trees(const Submit& /*submit*/) override { return trees_; }
    [[nodiscard]] Result<std::shared_ptr<HttpBody>> mesh(const Sha256& /*mesh*/) override {
        return none();
    }

  private:
    static Error none() { return {ErrorCode::NotFound, "there is none"}; }
    BodyTrees trees_{
        std::make_shared<const ObbTree>(
            make_tree(with_parts(make_box({1, 1, 1}), {{"hood", 0, 6}, {"door", 6, 12}}))),
        std::make_shared<const ObbTree>(make_tree(make_box({1, 1, 1}))),
    };
};

constexpr std::uint64_t window = limits::page_scenarios_max;
constexpr std::uint64_t total = 3 * window + 100;

class Searched : public testing::Test {
  protected:
    Searched() { job_.status.summary.total = total; }

    /// Scenarios of `contacts_` are in contact, those of even number with the hood.
    [[nodiscard]] RecordReader records() const {
        return [this](const ScenarioChoice& choice, const auto& take) -> Status {
            for (std::uint64_t i = choice.first; i < choice.first + choice.count; ++i) {
                ScenarioResult result;
                result.index = i;
                if (contacts_.contains(i)) {
                    result.kind = ScenarioClass::Cross;
                    result.pairs = {{i % 2 == 0 ? 0u : 9u, 4, PairClass::Proper}};
                }
                CD_TRY(take(i, result));
            }
            return Done{};
        };
    }
    NextFound next(std::uint64_t from, bool is_backwards, const std::string& part = "") {
        const auto found = next_of(reader_, records(), job_, {from, is_backwards, part, ""});
        EXPECT_TRUE(found) << found.error().detail;
        return found ? found.value() : NextFound();
    }
    /// Goes on until a search has found a scenario or reached the end; counts the searches.
    std::optional<std::uint64_t> search(std::uint64_t from, bool is_backwards, int& searches) {
        for (searches = 1;; ++searches) {
            const NextFound found = next(from, is_backwards);
            if (!found.searched_to) {
                return found.scenario;
            }
            EXPECT_FALSE(found.scenario);
            EXPECT_TRUE(is_backwards ? *found.searched_to < from : *found.searched_to > from);
            from = *found.searched_to;
        }
    }

    FakeReader reader_;
    PagedJob job_;
    std::set<std::uint64_t> contacts_;
};

} // namespace

TEST_F(Searched, GoesOnWhereTheLastSearchEnded) {
    contacts_ = {5, total - 1};
    int searches = 0;
    EXPECT_EQ(next(5, false).searched_to, 5 + window);
    EXPECT_EQ(search(5, false, searches), total - 1);
    EXPECT_EQ(searches, 4);
    EXPECT_EQ(next(total - 1, true).searched_to, total - 1 - window);
    EXPECT_EQ(search(total - 1, true, searches), 5u);
    EXPECT_EQ(searches, 4);
    EXPECT_EQ(search(total - 1, false, searches), std::nullopt);
    EXPECT_EQ(searches, 1);
    EXPECT_EQ(search(5, true, searches), std::nullopt);
    EXPECT_EQ(searches, 1);
    EXPECT_EQ(search(UINT64_MAX, false, searches), std::nullopt);
    contacts_.clear();
    EXPECT_EQ(search(0, false, searches), std::nullopt);
    EXPECT_EQ(searches, 4);
}

TEST_F(Searched, AWindowThatEndsWithTheJobIsItsEnd) {
    EXPECT_FALSE(next(total - 1 - window, false).searched_to);
    EXPECT_EQ(next(total - 2 - window, false).searched_to, total - 2);
    EXPECT_FALSE(next(window, true).searched_to);
    EXPECT_EQ(next(window + 1, true).searched_to, 1u);
}

TEST_F(Searched, FindsTheContactsOfAPart) {
    contacts_ = {11, 12, 13, 14};
    EXPECT_EQ(next(0, false, "hood").scenario, 12u);
    EXPECT_EQ(next(0, false, "door").scenario, 11u);
    EXPECT_EQ(next(100, true, "hood").scenario, 14u);
    const auto wrong = next_of(reader_, records(), job_, {0, false, "", "piece 2"});
    EXPECT_THAT(wrong.error().detail, HasSubstr("has no part 'piece 2'"));
    EXPECT_EQ(wrong.error().code, ErrorCode::BadInput);
}

TEST_F(Searched, PartsAreNamedOnes) {
    EXPECT_THAT(parts_of(reader_, job_, 0).value()->names, ElementsAre("hood", "door"));
    EXPECT_THAT(parts_of(reader_, job_, 1).value()->names, ElementsAre("whole"));
    EXPECT_EQ(parts_of(reader_, job_, 2).error().code, ErrorCode::NotFound);
    EXPECT_TRUE(next_of(reader_, records(), job_, {0, false, "", "whole"}));
}

} // namespace cd::tests

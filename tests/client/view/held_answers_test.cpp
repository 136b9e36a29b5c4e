// Proves that a report holds what `cdctl view` would answer to the page, byte for byte.
#include "client/view/held_answers.hpp"

#include "tests/client/view/asked_server.hpp"
#include "tests/client/view/viewed_scene.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <map>

namespace cd::tests {
namespace {

using testing::HasSubstr;

class Held : public Viewed {
  protected:
    static std::vector<HeldAnswer> answers_of(ViewedRun& run, const PageOrigin& origin) {
        std::vector<HeldAnswer> answers;
        const auto worst = run.worst(3);
        EXPECT_EQ(worst.size(), 3u);
        const Status told = for_each_answer(
            run,
            origin,
            worst,
            [&](const HeldAnswer& answer) {
                answers.push_back(answer);
                return Status(Done{});
            },
            never());
        EXPECT_TRUE(told);
        return answers;
    }

    static std::map<std::string, std::string> texts_of(const std::vector<HeldAnswer>& answers) {
        std::map<std::string, std::string> texts;
        for (const HeldAnswer& each : answers) {
            texts[each.path] = {reinterpret_cast<const char*>(each.bytes.data()),
                                each.bytes.size()};
        }
        return texts;
    }
};

} // namespace

TEST_F(Held, AnswersAreThoseOfTheServerAtAnyLevel) {
    for (const std::string query : {"level = \"any\"\n",
                                    "level = \"count\"\nmaps = true\n",
                                    "level = \"pairs\"\nlimit_pairs = 2\n",
                                    "level = \"contacts\"\n"}) {
        auto run = view(query);
        const bool has_map = query.find("any") == query.npos;
        const auto answers = answers_of(*run, folder_origin(*run));
        EXPECT_EQ(answers.size(), 2u + 2 + 4 + (has_map ? 2 : 0) + 3 * 3) << query;
        Server server(std::move(run));
        for (const HeldAnswer& each : answers) {
            const HeldAnswer served = server.ask(each.path);
            EXPECT_TRUE(each.bytes == served.bytes) << query << each.path;
            EXPECT_EQ(each.is_cut, served.is_cut) << query << each.path;
        }
        const auto texts = texts_of(answers);
        const auto scenario = nlohmann::json::parse(texts.lower_bound("jobs/folder/scen")->second);
        EXPECT_EQ(scenario.at("verified"), true) << query;
        EXPECT_EQ(scenario.at("class"), "inside") << "the worst of " << query;
    }
}

TEST_F(Held, LinesHaveTheirHitsAndClosedParts) {
    for (const std::string query : {"level = \"count\"\n", "level = \"pairs\"\n"}) {
        auto run = view_lines(query);
        const auto answers = answers_of(*run, folder_origin(*run));
        const bool has_map = query.find("pairs") != query.npos;
        EXPECT_EQ(answers.size(), 2u + 2 + 5 + (has_map ? 2 : 0) + 3 * 4) << query;
        const auto texts = texts_of(answers);
        EXPECT_TRUE(texts.contains("jobs/folder/parts/0/closed"));
        const auto job = nlohmann::json::parse(texts.at("jobs/folder"));
        EXPECT_EQ(job.at("question"), "shots");
        EXPECT_EQ(job.at("poses").at("kind"), "shots");
        EXPECT_EQ(job.at("poses").at("axes").at(0).at("name"), "azimuth");
        EXPECT_EQ(job.at("poses").at("axes").at(0).at("count"), 2);
        Server server(std::move(run));
        for (const HeldAnswer& each : answers) {
            EXPECT_TRUE(each.bytes == server.ask(each.path).bytes) << query << each.path;
        }
    }
}

TEST_F(Held, MotionsHaveTheirRunsAndKeys) {
    auto run = view_motions("level = \"any\"\n");
    const PageOrigin origin = folder_origin(*run);
    std::vector<HeldAnswer> answers;
    const auto take = [&](const HeldAnswer& answer) {
        answers.push_back(answer);
        return Status(Done{});
    };
    EXPECT_TRUE(for_each_answer(*run, origin, std::vector<std::uint64_t>{0, 1}, take, never()));
    const auto texts = texts_of(answers);
    EXPECT_EQ(nlohmann::json::parse(texts.at("jobs/folder")).at("question"), "motion");
    const auto free = nlohmann::json::parse(texts.at("jobs/folder/scenarios/0"));
    EXPECT_EQ(free.at("verified"), true);
    EXPECT_TRUE(free.at("motion").at("event").is_null());
    const auto met = nlohmann::json::parse(texts.at("jobs/folder/scenarios/1"));
    EXPECT_EQ(met.at("verified"), true);
    EXPECT_FALSE(met.at("motion").at("event").is_null());
    EXPECT_GT(met.at("motion").at("runs").size(), 1u);
    EXPECT_EQ(met.at("motion").at("from").at("b").at(4), 4.0);
    EXPECT_EQ(met.at("motion").at("to").at("b").at(4), 0.0);
    EXPECT_GT(met.at("exact_pairs").get<int>(), 0);
}

TEST_F(Held, AMeshHasTheHashOfItsPath) {
    auto run = view("level = \"pairs\"\n");
    std::size_t meshes = 0;
    for (const HeldAnswer& each : answers_of(*run, folder_origin(*run))) {
        if (each.path.starts_with("meshes/")) {
            EXPECT_EQ(each.path, "meshes/" + to_hex(sha256(each.bytes)));
            ++meshes;
        }
    }
    EXPECT_EQ(meshes, 2u);
}

TEST_F(Held, AJobOfAMasterNamesItsIdAndNoFolder) {
    auto run = view("level = \"pairs\"\n");
    const auto texts = texts_of(
        answers_of(*run, {PageOrigin::Kind::Remote, "cdctl", "node-1:7600", false, "j-5692"}));
    const auto source = nlohmann::json::parse(texts.at("source"));
    EXPECT_EQ(source.at("kind"), "remote");
    EXPECT_EQ(source.at("job"), "j-5692");
    const auto job = nlohmann::json::parse(texts.at("jobs/j-5692"));
    EXPECT_EQ(job.at("job"), "j-5692");
    EXPECT_EQ(job.at("folder"), "");
    for (const auto& [path, text] : texts) {
        EXPECT_EQ(text.find(folder_.path() / "out"), text.npos) << path;
    }
}

TEST_F(Held, AnErrorOfTheTakerAndASignalEndIt) {
    auto run = view("level = \"pairs\"\n");
    const auto worst = run->worst(2);
    const PageOrigin origin = folder_origin(*run);
    std::size_t taken = 0;
    const auto count = [&](const HeldAnswer&) {
        return ++taken < 3 ? Status(Done{}) : Error{ErrorCode::TooLarge, "enough"};
    };
    EXPECT_EQ(for_each_answer(*run, origin, worst, count, never()).error().code,
              ErrorCode::TooLarge);
    EXPECT_EQ(taken, 3u);
    const auto take = [](const HeldAnswer&) { return Status(Done{}); };
    EXPECT_EQ(for_each_answer(*run, origin, worst, take, [] { return true; }).error().code,
              ErrorCode::Interrupted);
}

} // namespace cd::tests

// Proves the status code, the headers and the content of each answer of the page, over a source
// that knows one job.
#include "web/server/page_server.hpp"

#include "common/core/files/npy_header.hpp"
#include "common/core/limits/web.hpp"
#include "common/shots/line_hit.hpp"
#include "tests/support/near_results.hpp"
#include "web/server/page_assets.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <cstring>

namespace cd::tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* the_job = "j-4f2a";

/// A job of ten scenarios.
class FakeSource final : public PageSource {
  public:
    [[nodiscard]] const PageOrigin& origin() const override { return origin_; }
    void cluster(Take<ClusterView> take) override { take(ClusterView()); }
    void history(Take<std::vector<HistorySample>> take) override {
        take(std::vector<HistorySample>{{100, 1, 2, 3, 4}});
    }
    void jobs(Take<std::vector<JobRow>> take) override { take(std::vector{row_}); }
    void job(const std::string& id, Take<JobView> take) override {
        answer(id, std::move(take), [&] {
            JobView view;
            view.row = row_;
            view.bodies = {{.body = {.name = "a"}}, {.body = {.name = "b"}}};
            view.poses.random = RandomPoses{.seed = UINT64_MAX};
            view.groups =
                GroupsView{{{.part_a = "left", .part_b = "right", .scenarios = 3, .near = 8}}, 1};
            view.query.clearance = 0.25;
            return view;
        });
    }
    void progress(const std::string& id, Take<JobRow> take) override {
        answer(id, std::move(take), [&] { return row_; });
    }
    void classes(const std::string& id,
                 const ScenarioChoice& choice,
                 Take<std::vector<std::uint8_t>> take) override {
        if (const Status fits = choice.check(10, 8); !fits) {
            return take(fits.error());
        }
        answer(id, std::move(take), [&] {
            std::vector<std::uint8_t> classes;
            for (std::uint64_t i = 0; i < choice.size(); ++i) {
                classes.push_back(static_cast<std::uint8_t>(choice.at(i, 10)));
            }
            return classes;
        });
    }
    void counts(const std::string& id,
                const ScenarioChoice& /*choice*/,
                Take<std::vector<std::uint32_t>> take) override {
        answer(id, std::move(take), [] { return std::vector<std::uint32_t>{7, 8}; });
    }
    void distances(const std::string& id,
                   const ScenarioChoice& /*choice*/,
                   Take<std::vector<double>> take) override {
        answer(id, std::move(take), [] { return std::vector<double>{0.25, 0.5}; });
    }
    void poses(const std::string& id, const ScenarioChoice& choice, Take<PoseRows> take) override {
        answer(id, std::move(take), [&] {
            PoseRows rows{choice.sample != 0 ? std::size_t{2} : 1, {}};
            rows.add({Pose{}, Pose::from_matrix(Mat3::Identity(), Vec3(1, 2, 3))});
            return rows;
        });
    }
    void keys(const std::string& id,
              const ScenarioChoice& /*choice*/,
              Take<std::vector<MotionKeys>> take) override {
        answer(id, std::move(take), [] {
            const auto key = [](double x) {
                return Pose::from_quaternion({1, 0, 0, 2}, Vec3(x, 0, 0.5));
            };
            return std::vector<MotionKeys>{{{key(1), key(2)}, {key(3), key(4)}}};
        });
    }
    void bodies(const std::string& id,
                const ScenarioChoice& /*choice*/,
                Take<std::vector<ScenePlace>> take) override {
        answer(id, std::move(take), [] { return std::vector<ScenePlace>{{4, 1, 3}, {5, 0, 2}}; });
    }
    void steps(const std::string& id,
               const ScenarioChoice& /*choice*/,
               Take<std::vector<StepRow>> take) override {
        answer(id, std::move(take), [] { return std::vector<StepRow>{{0, 0.5}, {7, 1.25}}; });
    }
    void map(const std::string& id,
             std::uint64_t body,
             Take<std::vector<TriangleContacts>> take) override {
        answer(id, std::move(take), [&] {
            return body < 2 ? Result(std::vector<TriangleContacts>{{5, 6}})
                            : Error{ErrorCode::NotFound, "there is no such body"};
        });
    }
    void parts(const std::string& id,
               std::uint64_t /*body*/,
               Take<std::shared_ptr<const NamedParts>> take) override {
        answer(id, std::move(take), [] {
            return std::make_shared<const NamedParts>(
                NamedParts{PartRuns::create({{0, 1}, {7, 0}}).value(), {"hood", "<b>"}});
        });
    }
    void closed_parts(const std::string& id,
                      std::uint64_t /*body*/,
                      Take<std::vector<bool>> take) override {
        answer(id, std::move(take), [] { return std::vector<bool>{true, false}; });
    }
    void scenario(const std::string& id,
                  std::uint64_t number,
                  Take<std::shared_ptr<const ScenarioView>> take) override {
        if (number == 9) {
            return take(Error{ErrorCode::TooLarge, "other scenarios are being run; try again"});
        }
        answer(id, std::move(take), [&] { return view_; });
    }
    void next(const std::string& id, const NextContact& wanted, Take<NextFound> take) override {
        answer(id, std::move(take), [&] {
            return wanted.is_backwards ? NextFound{{}, wanted.from - 1}
                                       : NextFound{wanted.from + 1, {}};
        });
    }
    void mesh(const Sha256& /*mesh*/, Take<std::shared_ptr<HttpBody>> take) override {
        take(make_memory_body(std::string("canonical")));
    }

    std::shared_ptr<ScenarioView> view_ = std::make_shared<ScenarioView>();

  private:
    template <class T, class Make>
    static void answer(const std::string& id, Take<T> take, Make make) {
        if (id != the_job) {
            return take(Error{ErrorCode::NotFound, "there is no job " + id});
        }
        take(Result<T>(make()));
    }

    PageOrigin origin_{PageOrigin::Kind::Master, "cdmaster 0.1.0", "node-1", false, ""};
    JobRow row_{the_job, "running", {}};
};

struct Answered {
    HttpAnswer answer;
    Bytes bytes;

    [[nodiscard]] unsigned status() const { return answer.status; }
    [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(answer.body); }
    [[nodiscard]] std::string header(std::string_view name) const {
        for (const auto& [key, value] : answer.headers) {
            if (key == name) {
                return value;
            }
        }
        return "";
    }
    [[nodiscard]] std::vector<std::uint64_t> shape() const {
        const auto header = parse_npy_header(bytes);
        EXPECT_TRUE(header) << header.error().detail;
        return header ? header.value().shape : std::vector<std::uint64_t>();
    }
    template <class T>
    [[nodiscard]] std::vector<T> values() const {
        std::vector<T> values((bytes.size() - npy_header_bytes) / sizeof(T));
        std::memcpy(values.data(), bytes.data() + npy_header_bytes, values.size() * sizeof(T));
        return values;
    }
};

class PageAnswers : public testing::Test {
  protected:
    Answered ask(HttpRequest request) {
        if (request.host.empty()) {
            request.host = "127.0.0.1:8080";
        }
        PageServer server(context_.get_executor(), source_, options_);
        std::optional<Answered> answered;
        server.answer(
            request,
            [&](PageRight right) {
                return right <= right_ ? Status(Done{})
                                       : Error{ErrorCode::Refused, "use cdctl view JOB"};
            },
            [&](HttpAnswer answer) {
                answered.emplace();
                if (answer.content != nullptr) {
                    answer.content->read(0, answer.content->size(), [&](const auto& bytes) {
                        answered->bytes.assign(bytes.value().begin(), bytes.value().end());
                    });
                }
                answered->answer = std::move(answer);
            });
        context_.restart();
        context_.run();
        EXPECT_TRUE(answered) << request.target;
        return answered.value_or(Answered());
    }
    Answered get(const std::string& target) { return ask({"GET", "/api/v1/" + target}); }
    Answered of_job(const std::string& target) {
        return get("jobs/" + std::string(the_job) + target);
    }

    asio::io_context context_;
    FakeSource source_;
    PageOptions options_;
    PageRight right_ = PageRight::Jobs;
};

} // namespace

TEST_F(PageAnswers, ValuesBecomeJson) {
    EXPECT_EQ(get("source").json().at("kind"), "master");
    EXPECT_TRUE(get("source").json().at("job").is_null());
    EXPECT_TRUE(get("cluster").json().contains("workers"));
    EXPECT_EQ(get("history").json().at("rows").at(0), (std::vector<double>{100, 1, 2, 3, 4}));
    EXPECT_EQ(get("jobs").json().at("jobs").at(0).at("job"), the_job);
    const auto job = of_job("").json();
    EXPECT_EQ(job.at("state"), "running");
    EXPECT_EQ(job.at("bodies").at(1).at("name"), "b");
    EXPECT_TRUE(job.at("bodies").at(1).at("closed").is_null());
    EXPECT_EQ(job.at("groups").at(0).at("scenarios"), 3);
    EXPECT_EQ(job.at("groups").at(0).at("near"), 8);
    EXPECT_EQ(job.at("clearance"), 0.25);
    EXPECT_EQ(job.at("near"), 0);
    EXPECT_EQ(job.at("poses").at("seed"), "18446744073709551615") << "above 2^53";
    const auto found = of_job("/scenarios/next?from=3").json();
    EXPECT_EQ(found.at("index"), 4);
    EXPECT_TRUE(found.at("searched_to").is_null());
    const auto searched = of_job("/scenarios/next?from=3&step=-1").json();
    EXPECT_TRUE(searched.at("index").is_null());
    EXPECT_EQ(searched.at("searched_to"), 2);
    EXPECT_EQ(of_job("/parts/0/names").json(), nlohmann::json({"hood", "<b>"}));
}

TEST_F(PageAnswers, ProgressIsWhatTheJobTellsOfItself) {
    const auto job = of_job("").json();
    const auto progress = of_job("/progress").json();
    for (const auto& [key, value] : progress.items()) {
        EXPECT_EQ(job.at(key), value) << key;
    }
    for (const char* key : {"state", "done", "scenarios", "cross", "near", "digest", "paused"}) {
        EXPECT_TRUE(progress.contains(key)) << key;
    }
    for (const char* key : {"bodies", "poses", "groups", "command"}) {
        EXPECT_FALSE(progress.contains(key)) << key;
    }
    EXPECT_EQ(get("jobs/j-0/progress").status(), 404u);
}

TEST_F(PageAnswers, ArraysAreInNumpysFormat) {
    const Answered classes = of_job("/classes?first=2&count=3");
    EXPECT_THAT(classes.shape(), ElementsAre(3));
    EXPECT_THAT(classes.values<std::uint8_t>(), ElementsAre(2, 3, 4));
    EXPECT_EQ(classes.header("Cache-Control"), "no-store");
    EXPECT_THAT(of_job("/classes?sample=5").values<std::uint8_t>(), ElementsAre(0, 2, 4, 6, 8));
    EXPECT_THAT(of_job("/counts?sample=2").values<std::uint32_t>(), ElementsAre(7, 8));
    EXPECT_THAT(of_job("/distances?sample=2").values<double>(), ElementsAre(0.25, 0.5));
    EXPECT_THAT(of_job("/poses?first=0&count=1").shape(), ElementsAre(1, 12));
    EXPECT_THAT(of_job("/poses?first=0&count=1").values<double>(),
                ElementsAre(1, 0, 0, 1, 0, 1, 0, 2, 0, 0, 1, 3));
    EXPECT_THAT(of_job("/poses?sample=1").shape(), ElementsAre(1, 2, 12));
    const Answered keys = of_job("/keys?first=0&count=1");
    EXPECT_THAT(keys.shape(), ElementsAre(1, 4, 7));
    const std::vector<double> numbers{1, 0, 0, 2, 1, 0, 0.5, 1, 0, 0, 2, 2, 0, 0.5,
                                      1, 0, 0, 2, 3, 0, 0.5, 1, 0, 0, 2, 4, 0, 0.5};
    EXPECT_EQ(keys.values<double>(), numbers) << "A and B at the begin, then at the end";
    EXPECT_THAT(of_job("/parts/0").shape(), ElementsAre(2, 2));
    EXPECT_THAT(of_job("/parts/0").values<std::uint32_t>(), ElementsAre(0, 1, 7, 0));
    EXPECT_THAT(of_job("/map/1").shape(), ElementsAre(1, 2));
    const Answered bodies = of_job("/bodies?first=0&count=2");
    EXPECT_THAT(bodies.shape(), ElementsAre(2, 3));
    EXPECT_THAT(bodies.values<std::uint32_t>(), ElementsAre(4, 1, 3, 5, 0, 2));
    EXPECT_THAT(of_job("/steps?first=0&count=2").values<double>(), ElementsAre(0, 0.5, 7, 1.25));
    EXPECT_THAT(of_job("/map/1").values<std::uint64_t>(), ElementsAre(5, 6));
}

TEST_F(PageAnswers, AScenarioTellsItsDistance) {
    ScenarioView& view = *source_.view_;
    view.result = ScenarioResult();
    EXPECT_FALSE(of_job("/scenarios/3").json().contains("distance")) << "the job does not ask";
    view.result->question = Question::Distance;
    view.result->level = Level::Any;
    EXPECT_TRUE(of_job("/scenarios/3").json().at("distance").is_null());
    view.result->nearest = NearestWitness{0.25, 3, 7};
    const auto json = of_job("/scenarios/3").json();
    EXPECT_EQ(json.at("distance"), 0.25);
    EXPECT_EQ(json.at("witness"), nlohmann::json::parse("[3,7]"));
}

TEST_F(PageAnswers, AScenarioOfASceneTellsItsStepAndBodies) {
    EXPECT_FALSE(of_job("/scenarios/3").json().contains("bodies"));
    source_.view_->scene = ScenePlace{7, 2, 5};
    source_.view_->time = 3.5;
    const auto json = of_job("/scenarios/3").json();
    EXPECT_EQ(json["step"], 7);
    EXPECT_EQ(json["time"], 3.5);
    EXPECT_EQ(json["bodies"], (nlohmann::json{2, 5}));
}

TEST_F(PageAnswers, HitsOfLinesAreDepthFlagsAndRank) {
    EXPECT_THAT(of_job("/parts/0/closed").values<std::uint8_t>(), ElementsAre(1, 0));
    EXPECT_THAT(of_job("/scenarios/3/hits").shape(), ElementsAre(0, 3)) << "nothing is drawn";
    ScenarioResult drawn;
    drawn.question = Question::Shots;
    drawn.pairs = {{3, 7, PairClass::Proper}, {4, 7, PairClass::Proper}};
    drawn.pair_count = 2;
    drawn.hits = {{0.5, hit_flag::crosses | hit_flag::front, 0}, {0.75, hit_flag::corner, 1}};
    source_.view_->drawn = std::make_shared<const ScenarioResult>(drawn);
    EXPECT_THAT(of_job("/scenarios/3/hits").values<double>(), ElementsAre(0.5, 3, 0, 0.75, 16, 1));
    EXPECT_EQ(of_job("/scenarios/3/hits").header("X-Cut"), "");
    drawn.pair_count = 5;
    source_.view_->drawn = std::make_shared<const ScenarioResult>(drawn);
    EXPECT_EQ(of_job("/scenarios/3/hits").header("X-Cut"), "true");
}

TEST_F(PageAnswers, AScenarioTellsItsRecordAndWhatIsDrawn) {
    ScenarioView& view = *source_.view_;
    auto json = of_job("/scenarios/3").json();
    EXPECT_TRUE(json.at("class").is_null());
    EXPECT_TRUE(json.at("verified").is_null());
    EXPECT_EQ(json.at("exact_pairs"), 0);
    EXPECT_EQ(json.at("draw_note"), "");
    view.draw_note = "it takes too long";
    EXPECT_EQ(of_job("/scenarios/3").json().at("draw_note"), "it takes too long");
    EXPECT_THAT(of_job("/scenarios/3/pairs").shape(), ElementsAre(0, 3));
    ScenarioResult result;
    result.kind = ScenarioClass::Cross;
    result.pair_count = 2;
    view.result = result;
    view.listed = 1;
    view.verified = true;
    view.id = "frame 7";
    result.pairs = {{4, 5, PairClass::Touch}, {6, 7, PairClass::Proper}};
    result.point_origins = {Vec3(1, 0, 0), Vec3(0, 0, 0)};
    result.point_offsets = {0, 1, 2};
    result.points = {Vec3(0, 1, 0), Vec3(0, 0, 1)};
    view.drawn = std::make_shared<const ScenarioResult>(result);
    json = of_job("/scenarios/3").json();
    EXPECT_EQ(json.at("class"), "cross");
    EXPECT_EQ(json.at("verified"), true);
    EXPECT_EQ(json.at("cut"), true);
    EXPECT_EQ(json.at("id"), "frame 7");
    EXPECT_EQ(json.at("pose_b").size(), 12u);
    const Answered pairs = of_job("/scenarios/3/pairs");
    EXPECT_THAT(pairs.values<std::uint32_t>(), ElementsAre(4, 5, 1, 6, 7, 3));
    EXPECT_EQ(pairs.header("X-Cut"), "");
    EXPECT_THAT(of_job("/scenarios/3/points").values<double>(),
                ElementsAre(0, 1, 1, 0, 1, 0, 0, 1));
    result.pair_count = limits::page_rows_max + 1;
    view.drawn = std::make_shared<const ScenarioResult>(result);
    EXPECT_EQ(of_job("/scenarios/3/pairs").header("X-Cut"), "true");
    EXPECT_EQ(of_job("/scenarios/3/points").header("X-Cut"), "true");
}

TEST_F(PageAnswers, AScenarioTellsItsNearPairs) {
    ScenarioView& view = *source_.view_;
    ScenarioResult result = near_results(Level::Contacts)[2];
    view.result = result;
    view.listed = 2;
    view.drawn = std::make_shared<const ScenarioResult>(result);
    auto json = of_job("/scenarios/3").json();
    EXPECT_EQ(json.at("count"), 1);
    EXPECT_EQ(json.at("near_count"), 3);
    EXPECT_EQ(json.at("cut"), true) << "four pairs, of which two are listed";
    EXPECT_TRUE(json.at("least_distance").is_null()) << "a pair that is not listed may be nearer";
    EXPECT_EQ(of_job("/scenarios/3/pairs").header("X-Cut"), "true");
    result = near_results(Level::Contacts)[1];
    view.result = result;
    view.drawn = std::make_shared<const ScenarioResult>(result);
    json = of_job("/scenarios/3").json();
    EXPECT_EQ(json.at("class"), "near");
    EXPECT_EQ(json.at("cut"), false);
    EXPECT_EQ(json.at("least_distance"), 0.125);
    EXPECT_THAT(of_job("/scenarios/3/pairs").values<std::uint32_t>(),
                ElementsAre(0, 5, 4, 7, 2, 4));
    EXPECT_EQ(of_job("/scenarios/3/pairs").header("X-Cut"), "");
    EXPECT_THAT(of_job("/scenarios/3/points").shape(), ElementsAre(4, 4));
}

TEST_F(PageAnswers, EachKindOfRefusalHasItsStatusAndItsReason) {
    const Answered missing = get("jobs/none");
    EXPECT_EQ(missing.status(), 404u);
    EXPECT_EQ(missing.json().at("error"), "there is no job none");
    EXPECT_EQ(of_job("/map/2").status(), 404u);
    EXPECT_EQ(ask({"GET", "/nowhere"}).status(), 404u);
    EXPECT_EQ(of_job("/classes").status(), 400u);
    EXPECT_EQ(of_job("/classes?first=9&count=2").status(), 400u);
    EXPECT_EQ(of_job("/classes?first=0&count=9").status(), 400u);
    EXPECT_EQ(of_job("/scenarios/9").status(), 503u);
    for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "PATCH"}) {
        EXPECT_EQ(ask({method, "/api/v1/jobs"}).status(), 405u);
        EXPECT_EQ(ask({method, "/"}).status(), 405u);
    }
    EXPECT_EQ(ask({"HEAD", "/api/v1/jobs"}).status(), 200u);
}

TEST_F(PageAnswers, OnlyAskersWithTheRightGetData) {
    right_ = PageRight::Cluster;
    for (const char* target : {"cluster", "history", "jobs", "source"}) {
        EXPECT_EQ(get(target).status(), 200u) << target;
    }
    EXPECT_EQ(of_job("").status(), 403u);
    EXPECT_EQ(of_job("").json().at("error"), "use cdctl view JOB");
    EXPECT_EQ(get("meshes/" + std::string(64, 'a')).status(), 403u);
    right_ = PageRight::Nothing;
    EXPECT_EQ(get("jobs").status(), 403u);
    EXPECT_EQ(get("source").status(), 200u);
    EXPECT_EQ(ask({"GET", "/"}).status(), 200u);
}

TEST_F(PageAnswers, ANameOfAnotherHostIsMisdirected) {
    options_.host_names = {"monitor.example"};
    for (const char* own : {"127.0.0.1",
                            "127.0.0.1:7601",
                            "[::1]:80",
                            "LOCALHOST:1",
                            "master",
                            "Monitor.Example:8443"}) {
        EXPECT_EQ(ask({"GET", "/", own}).status(), 200u) << own;
    }
    for (const char* other : {"evil.example",
                              "127.0.0.1.evil.example",
                              "localhost.evil.example:80",
                              "[::2]",
                              "[::1",
                              " ",
                              "2130706433"}) {
        EXPECT_EQ(ask({"GET", "/", other}).status(), 421u) << other;
        EXPECT_EQ(ask({"GET", "/api/v1/jobs", other}).status(), 421u) << other;
    }
}

TEST_F(PageAnswers, DataNeedTheKeyAndAWrongOneIsAnsweredLate) {
    options_.key = "0123456789abcdef";
    const auto ask_with = [&](const std::string& authorization) {
        return ask({"GET", "/api/v1/jobs", "", authorization}).status();
    };
    EXPECT_EQ(ask_with("Bearer 0123456789abcdef"), 200u);
    const auto begun = std::chrono::steady_clock::now();
    for (const char* wrong : {"", "Bearer ", "Bearer 0123456789abcdeg", "0123456789abcdef"}) {
        EXPECT_EQ(ask_with(wrong), 401u) << wrong;
    }
    EXPECT_GE(std::chrono::steady_clock::now() - begun, std::chrono::milliseconds(400));
    EXPECT_EQ(get("source").status(), 401u);
    EXPECT_EQ(ask({"GET", "/"}).status(), 200u);
}

TEST_F(PageAnswers, StaticFilesArePackedAndKnownByTheirTags) {
    for (const PageAsset& asset : page_assets()) {
        HttpRequest request{"GET", std::string(asset.path)};
        const Answered plain = ask(request);
        EXPECT_EQ(plain.header("Content-Encoding"), "");
        EXPECT_EQ(plain.bytes.size(), asset.bytes.size());
        request.accept_encoding = "br;q=1.0, gzip;q=0.8";
        const Answered packed = ask(request);
        EXPECT_EQ(packed.header("Content-Encoding"), "gzip");
        ASSERT_GE(packed.bytes.size(), 2u);
        EXPECT_EQ(std::to_integer<int>(packed.bytes[0]), 0x1f);
        EXPECT_EQ(std::to_integer<int>(packed.bytes[1]), 0x8b);
        request.if_none_match = "\"other\", " + packed.header("ETag");
        EXPECT_EQ(ask(request).status(), 304u);
        request.if_none_match = "\"other\"";
        EXPECT_EQ(ask(request).status(), 200u);
    }
    EXPECT_THAT(page_assets().front().content_type, HasSubstr("text/html"));
}

TEST_F(PageAnswers, AMeshMayBeKeptForeverAndNothingElseMay) {
    const Answered mesh = get("meshes/" + std::string(64, 'a'));
    EXPECT_THAT(mesh.header("Cache-Control"), HasSubstr("immutable"));
    EXPECT_EQ(mesh.bytes.size(), 9u);
    EXPECT_EQ(get("jobs").header("Cache-Control"), "no-store");
    EXPECT_EQ(get("jobs/none").header("Cache-Control"), "no-store");
}

} // namespace cd::tests

#include "bench/accuracy/ours.hpp"

#include "bench/accuracy/suites/pair_batch.hpp"
#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/job/run_scenario.hpp"
#include "common/pair/stages/double/double_triangle_pair.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"
#include "common/tree/build/build.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace cd::bench {

namespace {

/// Evaluates in floats, with error bounds or without; without bounds, zeros count as contact. Open
/// cases go to doubles with error bounds, or count as contact.
class Filters final : public PairEngine {
  public:
    Filters(double bound_scale, bool doubles_next)
        : bound_scale_(bound_scale), doubles_next_(doubles_next) {}

    void prepare(std::span<const PairGroup> groups) override {
        groups_ = groups;
        floats_.clear();
        doubles_.clear();
        std::size_t largest = 0;
        for (const PairGroup& group : groups) {
            floats_.emplace_back(group.poses, bound_scale_);
            doubles_.emplace_back(group.poses);
            largest = std::max(largest, group.candidates.size());
        }
        verdicts_.resize(largest);
    }

    void decide(std::span<std::uint8_t> answers) override {
        std::size_t next = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const PairGroup& group = groups_[g];
            const auto verdicts = std::span(verdicts_).first(group.candidates.size());
            floats_[g].classify(group.a, group.b, group.candidates, verdicts);
            for (std::size_t i = 0; i < verdicts.size(); ++i) {
                bool touches = verdicts[i] != FloatVerdict::Separate;
                if (doubles_next_ && verdicts[i] == FloatVerdict::Unknown) {
                    const Candidate& c = group.candidates[i];
                    touches = doubles_[g].classify(group.a.corners_at(c.a),
                                                   group.b.corners_at(c.b)) != PairClass::Separate;
                }
                answers[next++] = touches ? 1 : 0;
            }
        }
    }

  private:
    double bound_scale_;
    bool doubles_next_;
    std::span<const PairGroup> groups_;
    std::vector<FloatTrianglePair> floats_;
    std::vector<DoubleTrianglePair> doubles_;
    std::vector<FloatVerdict> verdicts_;
};

/// The product's decision, on one SIMD target.
class Certified final : public PairEngine {
  public:
    explicit Certified(SimdTarget target) : target_(target) {}

    void prepare(std::span<const PairGroup> groups) override {
        groups_ = groups;
        tests_.clear();
        for (const PairGroup& group : groups) {
            tests_.emplace_back(group.poses);
        }
    }

    void decide(std::span<std::uint8_t> answers) override {
        const SimdTarget before = simd_target();
        CD_CHECK(force_simd_target(to_text(target_)).has_value());
        std::size_t next = 0;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            decide_as_product(tests_[g], groups_[g], [&](std::span<const PairClass> kinds) {
                for (const PairClass kind : kinds) {
                    answers[next++] = static_cast<std::uint8_t>(kind);
                }
            });
        }
        CD_CHECK(force_simd_target(to_text(before)).has_value());
    }

    [[nodiscard]] bool tells_class() const override { return true; }
    [[nodiscard]] bool gives_points() const override { return true; }

    [[nodiscard]] SharedPoints shared_points(const PairGroup& group, const Candidate& c) override {
        TrianglePairTest test(group.poses);
        const PairCorners pair{group.a.corners_at(c.a), group.b.corners_at(c.b)};
        SharedPoints found;
        if (test.classify(pair.a, pair.b) != PairClass::Separate) {
            test.shared_points({&pair, 1}, [&](const Vec3& origin, std::span<const Vec3> points) {
                found = {origin, {points.begin(), points.end()}};
            });
        }
        return found;
    }

  private:
    SimdTarget target_;
    std::span<const PairGroup> groups_;
    std::vector<TrianglePairTest> tests_;
};

/// Runs a whole scenario as a worker does.
class CertifiedMeshes final : public MeshEngine {
  public:
    void load(const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b) override {
        ThreadPool pool(1);
        a_.emplace(build_tree(a, {}, pool));
        b_.emplace(build_tree(b, {}, pool));
    }

    MeshAnswer ask(const PosePair& poses, Level level) override {
        Scenario scenario;
        scenario.poses = poses;
        Query query;
        query.level = level;
        const ScenarioRun run = run_scenario(*a_, *b_, scenario, query);
        MeshAnswer answer;
        answer.touches = run.result.kind == ScenarioClass::Touch ||
                         run.result.kind == ScenarioClass::Cross ||
                         run.result.kind == ScenarioClass::Contact;
        answer.pair_count = run.result.pair_count;
        for (const ContactPair& pair : run.result.pairs) {
            answer.pairs.emplace_back(pair.a, pair.b);
        }
        return answer;
    }

  private:
    std::optional<ObbTree> a_;
    std::optional<ObbTree> b_;
};

} // namespace

std::vector<Engine> our_engines() {
    std::vector<Engine> engines;
    const auto add = [&](const std::string& name) -> Engine& {
        Engine& engine = engines.emplace_back();
        engine.name = name;
        engine.is_ours = true;
        return engine;
    };
    add("cdcluster, plain floats").make_pairs = [] { return std::make_unique<Filters>(0, false); };
    add("cdcluster, float filter").make_pairs = [] { return std::make_unique<Filters>(1, false); };
    add("cdcluster, float and double filters").make_pairs = [] {
        return std::make_unique<Filters>(1, true);
    };
    for (const SimdTarget target : available_simd_targets()) {
        if (target != simd_target()) {
            add(std::string(certified) + " (" + std::string(to_text(target)) + ")").make_pairs =
                [target] { return std::make_unique<Certified>(target); };
        }
    }
    Engine& exact = add(certified);
    exact.make_pairs = [] { return std::make_unique<Certified>(simd_target()); };
    exact.make_meshes = [] { return std::make_unique<CertifiedMeshes>(); };
    exact.levels = {Level::Any, Level::Count, Level::Pairs, Level::Contacts};
    return engines;
}

} // namespace cd::bench

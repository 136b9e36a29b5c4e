#include "bench/accuracy/suites/coarse_suite.hpp"

#include "bench/accuracy/distance.hpp"
#include "bench/accuracy/timing.hpp"
#include "common/core/check.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/geometry/aabb.hpp"
#include "common/search/binary_search.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/cut.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace cd::bench {

namespace {

/// "Apart" and "in contact" are proven; otherwise the bodies are at most `distance` apart.
struct CoarseAnswer {
    enum class Kind { Apart, Contact, Undecided } kind = Kind::Apart;
    double distance = 0;
};

struct Setting {
    std::string kind;
    double value = 0;
    std::function<CoarseAnswer(const PosePair&)> ask;
};

struct Totals {
    std::uint64_t apart = 0;
    std::uint64_t contact = 0;
    std::uint64_t undecided = 0;
    std::uint64_t missed = 0;       ///< "Apart" though they touch.
    std::uint64_t invented = 0;     ///< "Contact" though they do not.
    std::uint64_t bound_broken = 0; ///< Cases whose distance exceeds the bound.
    std::vector<double> errors;     ///< Bound minus distance for each pose; 0 for proofs.
};

CoarseAnswer ask_exactly(const ObbTree& a, const ObbTree& b, const PosePair& poses) {
    BinarySearch search(poses);
    return search.any(a.view(), b.view()) ? CoarseAnswer{CoarseAnswer::Kind::Contact, 0}
                                          : CoarseAnswer{};
}

/// Bounds the distance between any point of box `a` and any point of box `b`.
double distance_max(const ObbNode& a, const PosedBox& b) {
    Vec3 between;
    Vec3 half_a;
    Vec3 half_b;
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        between[i] = b.center[k] - a.center[k];
        half_a[i] = static_cast<double>(a.half[k]);
        half_b[i] = b.half[k];
    }
    // The frames of boxes are orthonormal up to rounding to floats.
    constexpr double rounding = 0x1p-20;
    return between.norm() + (1 + rounding) * (half_a.norm() + half_b.norm()) + 2 * b.error;
}

/// Descends the boxes alone, down to a depth.
CoarseAnswer ask_cut(const TreeTop& a, const TreeTop& b, const PosePair& poses) {
    const std::vector<RootPair> pairs = colliding_roots(a, b, poses).value().pairs;
    const BoxTest boxes(relative_pose(poses));
    CoarseAnswer answer{CoarseAnswer::Kind::Undecided, std::numeric_limits<double>::infinity()};
    for (const RootPair& pair : pairs) {
        const ObbNode& node_a = a.nodes[a.root_nodes[pair.a]];
        const ObbNode& node_b = b.nodes[b.root_nodes[pair.b]];
        answer.distance = std::min(answer.distance, distance_max(node_a, boxes.pose(node_b)));
    }
    return pairs.empty() ? CoarseAnswer{} : answer;
}

void judge(const CoarseAnswer& answer, bool touches, double distance, Totals& totals) {
    // Both sums carry a few roundings relative to the bodies' size; the bound is rounded upwards.
    const double slack = 1e-12 * (1 + distance);
    switch (answer.kind) {
    case CoarseAnswer::Kind::Apart:
        ++totals.apart;
        totals.missed += touches ? 1u : 0u;
        totals.errors.push_back(0);
        break;
    case CoarseAnswer::Kind::Contact:
        ++totals.contact;
        totals.invented += touches ? 0u : 1u;
        totals.errors.push_back(0);
        break;
    case CoarseAnswer::Kind::Undecided:
        ++totals.undecided;
        totals.bound_broken += answer.distance + slack < distance ? 1u : 0u;
        totals.errors.push_back(std::max(0.0, answer.distance - distance));
        break;
    }
}

std::vector<Setting>
settings_for(const ObbTree& a, const ObbTree& b, const CoarseOptions& options) {
    std::vector<Setting> settings;
    settings.push_back(
        {"exact", 0, [&a, &b](const PosePair& poses) { return ask_exactly(a, b, poses); }});
    for (const std::uint32_t depth : options.cuts) {
        const auto tops =
            std::make_shared<std::pair<TreeTop, TreeTop>>(cut_tree(a, depth), cut_tree(b, depth));
        settings.push_back({"cut", static_cast<double>(depth), [tops](const PosePair& poses) {
                                return ask_cut(tops->first, tops->second, poses);
                            }});
    }
    return settings;
}

void write_row(CsvFile& csv,
               const Scene& scene,
               const Setting& setting,
               Totals totals,
               double diagonal,
               double seconds_a_query) {
    std::sort(totals.errors.begin(), totals.errors.end());
    double sum = 0;
    for (const double error : totals.errors) {
        sum += error;
    }
    const std::size_t count = totals.errors.size();
    csv.row({scene.suite,
             scene.name,
             setting.kind,
             cell(setting.value),
             cell(std::uint64_t{count}),
             cell(totals.apart),
             cell(totals.contact),
             cell(totals.undecided),
             cell(totals.missed),
             cell(totals.invented),
             cell(totals.bound_broken),
             cell(sum / static_cast<double>(count) / diagonal),
             cell(totals.errors[count * 99 / 100] / diagonal),
             cell(totals.errors.back() / diagonal),
             cell(1e6 * seconds_a_query)});
}

} // namespace

void run_coarse(const Scene& scene,
                std::span<const TrueContacts> truth,
                const CoarseOptions& options,
                CsvFile& csv) {
    ThreadPool pool(1);
    const ObbTree a = build_tree(scene.a, {}, pool);
    const ObbTree b = build_tree(scene.b, {}, pool);
    const double diagonal = bounding_box(scene.a->vertices()).diagonal();
    const std::vector<Setting> settings = settings_for(a, b, options);
    std::vector<Totals> totals(settings.size());
    for (std::size_t s = 0; s < scene.poses.size(); ++s) {
        const bool touches = !truth[s].empty();
        const double apart = touches ? 0 : distance_of_bodies(a, b, scene.poses[s]);
        for (std::size_t i = 0; i < settings.size(); ++i) {
            judge(settings[i].ask(scene.poses[s]), touches, apart, totals[i]);
        }
    }
    const auto medians = interleaved_medians(options.rounds, settings.size(), [&](std::size_t i) {
        for (const PosePair& poses : scene.poses) {
            static_cast<void>(settings[i].ask(poses));
        }
    });
    for (std::size_t i = 0; i < settings.size(); ++i) {
        write_row(csv,
                  scene,
                  settings[i],
                  totals[i],
                  diagonal,
                  medians[i] / static_cast<double>(scene.poses.size()));
    }
}

CsvFile open_coarse_csv(const std::filesystem::path& folder) {
    return {folder / "coarse.csv",
            {"suite",
             "scene",
             "setting",
             "value",
             "queries",
             "apart",
             "contact",
             "undecided",
             "missed",
             "invented",
             "bound_broken",
             "error_mean",
             "error_p99",
             "error_max",
             "us_query"}};
}

} // namespace cd::bench

#include "bench/peers/threads.hpp"

#include "bench/accuracy/isolate.hpp"
#include "bench/accuracy/timing.hpp"
#include "bench/peers/ours.hpp"
#include "common/core/check.hpp"

#include <atomic>
#include <cstdio>
#include <functional>
#include <thread>

namespace cd::bench {

namespace {

/// Seconds on one thread and on two, round by round, measured in a child.
struct TwoTimes {
    double one;
    double two;
};

/// Each row begins with the names in `what`.
void measure(const std::vector<std::string>& what,
             const ThreadOptions& options,
             CsvFile& csv,
             const std::function<void(SharedArray<TwoTimes>&)>& work) {
    SharedArray<TwoTimes> times(options.rounds);
    const Ending ending = run_isolated(options.limit, [&] { work(times); });
    if (ending != Ending::Done) {
        std::fprintf(stderr,
                     "MISSING: %s on threads: %s\n",
                     what.back().c_str(),
                     std::string(to_text(ending)).c_str());
        return;
    }
    for (std::size_t round = 0; round < options.rounds; ++round) {
        const TwoTimes& t = times[round];
        std::vector<std::string> cells = what;
        for (const std::string& value :
             {cell(std::uint64_t{round}), cell(t.one), cell(t.two), cell(t.one / t.two)}) {
            cells.push_back(value);
        }
        csv.row(cells);
    }
}

/// Searches every pose `repeats` times; threads take poses dynamically.
double seconds_on(const Scene& scene,
                  const std::vector<std::unique_ptr<MeshEngine>>& engines,
                  std::size_t threads,
                  std::size_t repeats) {
    std::atomic<std::size_t> next = 0;
    const auto run = [&](MeshEngine& engine) {
        for (std::size_t i = next++; i < repeats * scene.poses.size(); i = next++) {
            static_cast<void>(engine.ask(scene.poses[i % scene.poses.size()], Level::Pairs));
        }
    };
    return seconds_of([&] {
        std::vector<std::thread> others;
        for (std::size_t t = 1; t < threads; ++t) {
            others.emplace_back(run, std::ref(*engines[t]));
        }
        run(*engines[0]);
        for (std::thread& other : others) {
            other.join();
        }
    });
}

} // namespace

void run_threads(const std::string& suite,
                 const Scene& scene,
                 const Engine& ours,
                 const ThreadOptions& options,
                 CsvFile& csv) {
    measure({suite, scene.name}, options, csv, [&](SharedArray<TwoTimes>& times) {
        std::vector<std::unique_ptr<MeshEngine>> engines;
        engines.push_back(ours.make_meshes());
        engines[0]->load(scene.a, scene.b);
        engines.push_back(engines[0]->for_another_thread());
        CD_CHECK(engines[1] != nullptr);
        const double once = seconds_on(scene, engines, 1, 1);
        const auto repeats = 1 + static_cast<std::size_t>(options.run_seconds / once);
        for (TwoTimes& t : times.values()) {
            t.one = seconds_on(scene, engines, 1, repeats);
            t.two = seconds_on(scene, engines, 2, repeats);
        }
    });
}

void run_builds(const std::string& name,
                const std::shared_ptr<const Mesh>& mesh,
                const ThreadOptions& options,
                CsvFile& csv) {
    measure({name}, options, csv, [&](SharedArray<TwoTimes>& times) {
        for (TwoTimes& t : times.values()) {
            t.one = seconds_of([&] { build_ours(mesh, 1); });
            t.two = seconds_of([&] { build_ours(mesh, 2); });
        }
    });
}

CsvFile open_threads_csv(const std::filesystem::path& folder) {
    return {folder / "threads.csv", {"suite", "scene", "round", "seconds_1", "seconds_2", "ratio"}};
}

CsvFile open_builds_csv(const std::filesystem::path& folder) {
    return {folder / "builds.csv", {"mesh", "round", "seconds_1", "seconds_2", "ratio"}};
}

} // namespace cd::bench

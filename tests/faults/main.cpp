// Runs the tests, or the simulations of `--count` seeds from `--seed` on.
//
//   faults_test                              runs the tests
//   faults_test --seed 1234 --log            runs one seed and logs all events
//   faults_test --seed 0 --count 100000      runs many seeds
//   faults_test --seed 3 --workers 1000      starts with so many workers
//   faults_test --seed 0 --count 50 --fault 3  switches on a mutation (master/base/mutation.hpp)
#include "tests/faults/simulation.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace {

struct Options {
    std::optional<std::uint64_t> seed;
    std::uint64_t count = 1;
    std::uint64_t fault = 0;
    std::size_t workers = 0;
    bool logs = false;
};

Options parse(int count, char** arguments) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const auto number = [&] {
            return i + 1 < count ? std::strtoull(arguments[i + 1], nullptr, 10) : 0;
        };
        if (std::strcmp(arguments[i], "--seed") == 0) {
            options.seed = number();
        } else if (std::strcmp(arguments[i], "--count") == 0) {
            options.count = number();
        } else if (std::strcmp(arguments[i], "--fault") == 0) {
            options.fault = number();
        } else if (std::strcmp(arguments[i], "--workers") == 0) {
            options.workers = number();
        } else if (std::strcmp(arguments[i], "--log") == 0) {
            options.logs = true;
        }
    }
    return options;
}

int simulate(const Options& options) {
    const auto fault = static_cast<cd::Mutation>(options.fault);
    std::uint64_t failed = 0;
    cd::tests::Outcome sum;
    for (std::uint64_t seed = *options.seed; seed < *options.seed + options.count; ++seed) {
        const cd::tests::Outcome outcome =
            cd::tests::simulate(seed, {options.logs, fault, options.workers});
        if (options.count == 1 || !outcome.problems.empty()) {
            std::printf("seed %llu: %s (%.1f s simulated, %llu events)\n",
                        static_cast<unsigned long long>(seed),
                        outcome.problems.empty() ? "all is well" : outcome.problems[0].c_str(),
                        outcome.seconds,
                        static_cast<unsigned long long>(outcome.events));
        }
        failed += outcome.problems.empty() ? 0 : 1;
        sum += outcome;
    }
    std::printf("%s\n", sum.counts().c_str());
    std::printf("%llu of %llu seeds failed\n",
                static_cast<unsigned long long>(failed),
                static_cast<unsigned long long>(options.count));
    return failed == 0 ? 0 : 1;
}

} // namespace

int main(int count, char** arguments) {
    const Options options = parse(count, arguments);
    spdlog::set_level(options.logs ? spdlog::level::debug : spdlog::level::off);
    spdlog::set_pattern("%v");
    if (options.seed) {
        return simulate(options);
    }
    testing::InitGoogleTest(&count, arguments);
    return RUN_ALL_TESTS();
}

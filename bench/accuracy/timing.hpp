// Measures times in turn, round by round, and compares their medians.
#pragma once

#include <algorithm>
#include <chrono>
#include <vector>

namespace cd::bench {

template <class Work>
double seconds_of(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Returns the median, or the lower of the two middle values. `values` must not be empty.
[[nodiscard]] inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Returns the medians of `rounds` rounds. Each round runs each of `count` pieces of work once; one
/// uncounted round comes first.
template <class Work>
std::vector<double> interleaved_medians(std::size_t rounds, std::size_t count, const Work& work) {
    std::vector<std::vector<double>> seconds(count);
    for (std::size_t round = 0; round <= rounds; ++round) {
        for (std::size_t i = 0; i < count; ++i) {
            const double taken = seconds_of([&] { work(i); });
            if (round > 0 || rounds == 0) {
                seconds[i].push_back(taken);
            }
        }
    }
    std::vector<double> medians;
    for (const std::vector<double>& each : seconds) {
        medians.push_back(median(each));
    }
    return medians;
}

} // namespace cd::bench

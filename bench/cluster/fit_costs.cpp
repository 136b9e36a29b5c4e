// Fits the two constants of the master's cost model (master/dispatch/cost_model.cpp) to traces.
//
//   fit_costs TRACE...
#include "bench/cluster/trace/trace.hpp"
#include "master/dispatch/cost_model.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <vector>

namespace cd::bench {

namespace {

std::vector<Trace> read_all(int count, char** paths) {
    std::vector<Trace> traces;
    for (int i = 0; i < count; ++i) {
        auto trace = read_trace(paths[i]);
        if (!trace) {
            throw std::runtime_error(trace.error().detail);
        }
        traces.push_back(std::move(trace.value()));
    }
    return traces;
}

/// Fits nanoseconds to the meeting size by least squares, at all depths of all traces. A scenario
/// is weighted by its time, so that neither short nor long ones dominate.
Eigen::Vector2d fit(const std::vector<Trace>& traces) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Trace& trace : traces) {
        for (const DepthTrace& depth : trace.depths) {
            for (const ScenarioTrace& scenario : depth.scenarios) {
                const double ns = 1e9 * scenario.work_seconds;
                const Eigen::Vector2d terms(1, scenario.meeting_size);
                normal += terms * terms.transpose() / ns;
                right += terms; // Time in ns, divided by ns.
            }
        }
    }
    return normal.ldlt().solve(right);
}

struct Error {
    double ratio = 0;   ///< Predicted sum divided by measured sum.
    double log_dev = 0; ///< Standard deviation of the logarithm of that ratio over scenarios.
};

Error error_of(const DepthTrace& depth, const std::function<double(double)>& predicted_ns) {
    double predicted = 0;
    double measured = 0;
    double logs = 0;
    double squares = 0;
    for (const ScenarioTrace& scenario : depth.scenarios) {
        const double ns = predicted_ns(scenario.meeting_size);
        const double log = std::log(ns / (1e9 * scenario.work_seconds));
        predicted += ns;
        measured += 1e9 * scenario.work_seconds;
        logs += log;
        squares += log * log;
    }
    const auto count = static_cast<double>(depth.scenarios.size());
    return {predicted / measured, std::sqrt(squares / count - logs / count * (logs / count))};
}

void print(const std::vector<Trace>& traces) {
    const Eigen::Vector2d constants = fit(traces);
    std::printf("scenario_ns = %.0f, size_ns = %.1f\n", constants[0], constants[1]);
    std::puts("                   fitted          in cost_model.cpp");
    std::puts("trace  depth  ratio  deviation  ratio  deviation");
    for (const Trace& trace : traces) {
        for (const DepthTrace& depth : trace.depths) {
            const Error fitted =
                error_of(depth, [&](double size) { return constants[0] + constants[1] * size; });
            const Error built = error_of(
                depth, [](double size) { return static_cast<double>(predicted_ns(size)); });
            std::printf("%-6s %5u  %5.2f  %9.2f  %5.2f  %9.2f\n",
                        trace.name.c_str(),
                        depth.a.depth,
                        fitted.ratio,
                        fitted.log_dev,
                        built.ratio,
                        built.log_dev);
        }
    }
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    try {
        cd::bench::print(cd::bench::read_all(argc - 1, argv + 1));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}

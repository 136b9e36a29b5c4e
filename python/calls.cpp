#include "python/calls.hpp"

#include <string>
#include <utility>

namespace cdcluster {

namespace {

/// Raises what a pending signal's handler raises. Needs Python's lock.
void look_for_signals() {
    if (PyErr_CheckSignals() != 0) {
        throw py::error_already_set();
    }
}

/// Looks for signals and calls the user's function, on the thread that called from Python.
class PythonProgress {
  public:
    explicit PythonProgress(py::object function) : function_(std::move(function)) {}

    /// Throws what the function or a signal's handler raises; returns false if the function does.
    bool operator()(const Progress& progress) const {
        const py::gil_scoped_acquire gil;
        look_for_signals();
        if (function_.is_none()) {
            return true;
        }
        const py::object answer = function_(progress.done, progress.total);
        return answer.is_none() || answer.cast<bool>();
    }

  private:
    py::object function_;
};

} // namespace

std::function<bool(const Progress&)> progress_of(py::object function) {
    std::shared_ptr<PythonProgress> shared(new PythonProgress(std::move(function)),
                                           [](PythonProgress* progress) {
                                               const py::gil_scoped_acquire gil;
                                               delete progress;
                                           });
    return [shared](const Progress& progress) { return (*shared)(progress); };
}

struct SignalStop::State {
    std::exception_ptr raised; ///< Null: nothing yet.
    std::chrono::steady_clock::time_point looked;
};

SignalStop::SignalStop() : state_(std::make_shared<State>()) {}

cd::StopCheck SignalStop::check() const {
    return [state = state_] {
        constexpr auto period = std::chrono::milliseconds(20);
        const auto now = std::chrono::steady_clock::now();
        if (state->raised == nullptr && now - state->looked >= period) {
            state->looked = now;
            const py::gil_scoped_acquire gil;
            try {
                look_for_signals();
            } catch (...) {
                state->raised = std::current_exception();
            }
        }
        return state->raised != nullptr;
    };
}

void SignalStop::throw_raised() const {
    if (state_->raised != nullptr) {
        std::rethrow_exception(std::exchange(state_->raised, nullptr));
    }
}

Query query_of(const py::dict& asked, std::function<bool(const Progress&)> progress) {
    Query query;
    query.level = static_cast<Level>(asked["level"].cast<int>());
    query.limit_pairs = asked["limit_pairs"].cast<std::uint64_t>();
    query.maps = asked["maps"].cast<bool>();
    query.clearance = asked["clearance"].cast<std::optional<double>>();
    query.up_to = asked["up_to"].cast<std::optional<double>>();
    for (const auto& rule : asked["ignore"]) {
        const auto [of_a, of_b] = rule.cast<std::pair<std::string, std::string>>();
        query.ignore.push_back({of_a, of_b});
    }
    query.threads = asked["threads"].cast<unsigned>();
    query.progress = std::move(progress);
    return query;
}

} // namespace cdcluster

// What calls from Python share: arrays as arguments, signals, and the user's own functions.
#pragma once

#include "common/core/host/stop_check.hpp"
#include "library/include/cdcluster/cdcluster.hpp"
#include "python/cluster.hpp"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace cdcluster {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::uint32_t, py::array::c_style>;

/// Returns a read-only array over memory that `owner` keeps alive.
template <class Number>
[[nodiscard]] py::array
view(const void* data, std::vector<py::ssize_t> shape, const py::handle& owner) {
    py::array_t<Number> made(std::move(shape), static_cast<const Number*>(data), owner);
    made.attr("setflags")(py::arg("write") = false);
    return made;
}

template <class Number>
[[nodiscard]] std::span<const Number>
span_of(const py::array_t<Number, py::array::c_style>& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Makes the `progress` of a question: it looks for signals, and calls the user's function unless
/// that is None. It may be copied and destroyed without Python's lock.
[[nodiscard]] std::function<bool(const Progress&)> progress_of(py::object function);

/// Ends calls to a master when a signal's handler raises. Any number of calls may use it, one after
/// the other; copies share what was raised.
class SignalStop {
  public:
    SignalStop();

    /// Looks for signals now and then. Returns true once a handler has raised.
    [[nodiscard]] cd::StopCheck check() const;
    /// Runs a function without Python's lock. Throws what a handler has raised meanwhile.
    template <class Function>
    auto run(const Function& function) const {
        const py::gil_scoped_release released;
        try {
            if constexpr (std::is_void_v<decltype(function())>) {
                function();
                throw_raised();
            } else {
                auto result = function();
                throw_raised();
                return result;
            }
        } catch (const ClusterError&) {
            throw_raised();
            throw;
        }
    }

  private:
    struct State;
    void throw_raised() const;

    std::shared_ptr<State> state_;
};

/// Returns the query that the package describes by a dict.
[[nodiscard]] Query query_of(const py::dict& asked, std::function<bool(const Progress&)> progress);

/// Adds the class of results to the module.
void define_results(py::module_& module);
/// Adds clusters, jobs on them and watches to the module.
void define_cluster(py::module_& module);

} // namespace cdcluster

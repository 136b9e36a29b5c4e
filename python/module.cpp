// The native part of the Python package: meshes, questions and results as NumPy arrays. What a
// Python user calls, and how arguments become these, is in cdcluster/__init__.py.
#include "library/include/cdcluster/cdcluster.hpp"

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace cdcluster {

namespace {

using Doubles = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::uint32_t, py::array::c_style>;

/// Returns a read-only array over memory that `owner` keeps alive.
template <class Number>
py::array view(const void* data, std::vector<py::ssize_t> shape, const py::handle& owner) {
    py::array_t<Number> made(std::move(shape), static_cast<const Number*>(data), owner);
    made.attr("setflags")(py::arg("write") = false);
    return made;
}

template <class Number, class Element>
py::array view_of(const std::vector<Element>& values, const py::handle& owner) {
    static_assert(sizeof(Element) == sizeof(Number));
    return view<Number>(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

/// Returns an array whose rows are the elements of `values`, each of `columns` numbers.
template <class Number, class Element>
py::array
rows_of(const std::vector<Element>& values, py::ssize_t columns, const py::handle& owner) {
    return view<Number>(values.data(), {static_cast<py::ssize_t>(values.size()), columns}, owner);
}

template <class Number>
std::span<const Number> span_of(const py::array_t<Number, py::array::c_style>& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

/// Looks for signals and calls the user's function, on the thread that called from Python.
class PythonProgress {
  public:
    explicit PythonProgress(py::object function) : function_(std::move(function)) {}

    /// Throws what the function or a signal's handler raises; returns false if the function does.
    bool operator()(const Progress& progress) const {
        const py::gil_scoped_acquire gil;
        if (PyErr_CheckSignals() != 0) {
            throw py::error_already_set();
        }
        if (function_.is_none()) {
            return true;
        }
        const py::object answer = function_(progress.done, progress.total);
        return answer.is_none() || answer.cast<bool>();
    }

  private:
    py::object function_;
};

/// Makes a `progress` that may be copied and destroyed without Python's lock.
std::function<bool(const Progress&)> progress_of(py::object function) {
    std::shared_ptr<PythonProgress> shared(new PythonProgress(std::move(function)),
                                           [](PythonProgress* progress) {
                                               const py::gil_scoped_acquire gil;
                                               delete progress;
                                           });
    return [shared](const Progress& progress) { return (*shared)(progress); };
}

Mesh mesh_from_arrays(
    const Doubles& xyz,
    const Indices& triangles,
    const std::vector<std::tuple<std::string, std::uint32_t, std::uint32_t>>& parts) {
    std::vector<Part> named;
    for (const auto& [name, begin, end] : parts) {
        named.push_back({name, begin, end});
    }
    return Mesh::from_arrays(span_of(xyz), span_of(triangles), named);
}

py::bytes bytes_of(const Mesh& mesh) {
    const std::vector<std::byte> bytes = mesh.canonical_bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Mesh mesh_from_bytes(const py::bytes& bytes) {
    const auto text = static_cast<std::string_view>(bytes);
    return Mesh::from_canonical_bytes(std::as_bytes(std::span(text)));
}

void define_mesh(py::module_& module) {
    py::class_<Mesh>(module, "Mesh")
        .def_static("from_arrays", &mesh_from_arrays)
        .def_static("load",
                    [](const std::filesystem::path& file, double factor) {
                        const py::gil_scoped_release released;
                        return Mesh::load(file, factor);
                    })
        .def_property_readonly(
            "vertices",
            [](const py::object& self) {
                const auto xyz = self.cast<const Mesh&>().xyz();
                return view<double>(
                    xyz.data(), {static_cast<py::ssize_t>(xyz.size() / 3), 3}, self);
            })
        .def_property_readonly(
            "triangles",
            [](const py::object& self) {
                const auto numbers = self.cast<const Mesh&>().triangles();
                return view<std::uint32_t>(
                    numbers.data(), {static_cast<py::ssize_t>(numbers.size() / 3), 3}, self);
            })
        .def_property_readonly("parts",
                               [](const Mesh& mesh) {
                                   py::list parts;
                                   for (const Part& part : mesh.parts()) {
                                       parts.append(
                                           py::make_tuple(part.name, part.begin, part.end));
                                   }
                                   return parts;
                               })
        .def_property_readonly("sha256", &Mesh::sha256)
        .def_property_readonly("is_closed", &Mesh::is_closed)
        .def(py::pickle(&bytes_of, &mesh_from_bytes));
}

void define_results(py::module_& module) {
    py::class_<Results> results(module, "Results");
    const auto array = [&](const char* name, auto make) {
        results.def_property_readonly(name, [make](const py::object& self) {
            return make(self.cast<const Results&>(), self);
        });
    };
    array("kind", [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.kind, self); });
    array("count",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.count, self); });
    array("near_count",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.near_count, self); });
    array("surfaces_only", [](const Results& r, auto& self) {
        return view_of<std::uint8_t>(r.surfaces_only, self);
    });
    array("offsets",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.offsets, self); });
    array("pairs",
          [](const Results& r, auto& self) { return rows_of<std::uint32_t>(r.pairs, 2, self); });
    array("pair_class",
          [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.pair_class, self); });
    array("point_offsets", [](const Results& r, auto& self) {
        return view_of<std::uint64_t>(r.point_offsets, self);
    });
    array("points",
          [](const Results& r, auto& self) { return rows_of<double>(r.points, 3, self); });
    array("pair_distance",
          [](const Results& r, auto& self) { return view_of<double>(r.pair_distance, self); });
    array("hit_depth",
          [](const Results& r, auto& self) { return view_of<double>(r.hit_depth, self); });
    array("hit_flags",
          [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.hit_flags, self); });
    array("hit_rank",
          [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.hit_rank, self); });
    array("distance",
          [](const Results& r, auto& self) { return view_of<double>(r.distance, self); });
    array("witness",
          [](const Results& r, auto& self) { return rows_of<std::uint32_t>(r.witness, 2, self); });
    array("witness_points", [](const Results& r, auto& self) {
        return view<double>(r.witness_points.data(),
                            {static_cast<py::ssize_t>(r.witness_points.size()), 2, 3},
                            self);
    });
    array("step",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.step, self); });
    array("body_a",
          [](const Results& r, auto& self) { return view_of<std::uint32_t>(r.body_a, self); });
    array("body_b",
          [](const Results& r, auto& self) { return view_of<std::uint32_t>(r.body_b, self); });
    array("map_a",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.map_a, self); });
    array("map_b",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.map_b, self); });
    array("motion_end",
          [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.motion.end, self); });
    array("motion_depth",
          [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.motion.depth, self); });
    array("t0",
          [](const Results& r, auto& self) { return view_of<std::uint32_t>(r.motion.t0, self); });
    array("t1",
          [](const Results& r, auto& self) { return view_of<std::uint32_t>(r.motion.t1, self); });
    array("run_offsets", [](const Results& r, auto& self) {
        return view_of<std::uint64_t>(r.motion.run_offsets, self);
    });
    array("runs", [](const Results& r, auto& self) {
        return rows_of<std::uint32_t>(r.motion.runs, 5, self);
    });
    results.def_readwrite("first", &Results::first)
        .def_readonly("digest", &Results::digest)
        .def_readonly("body_names", &Results::body_names)
        .def_property_readonly("failures",
                               [](const Results& r) {
                                   py::dict failures;
                                   for (const Failure& failure : r.failures) {
                                       failures[py::int_(failure.scenario)] = failure.reason;
                                   }
                                   return failures;
                               })
        .def("__len__", &Results::size);
}

std::unique_ptr<Results> find(const Mesh& a,
                              const Mesh& b,
                              const Doubles& poses,
                              PoseForm form,
                              const py::dict& asked,
                              py::object progress) {
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
    query.progress = progress_of(std::move(progress));
    const Poses rows{span_of(poses), form};
    const py::gil_scoped_release released;
    return std::make_unique<Results>(find_contacts(a, b, rows, query));
}

std::unique_ptr<Results> run_job(const Job& job,
                                 const std::filesystem::path& out,
                                 const std::filesystem::path& tree_cache,
                                 unsigned threads,
                                 py::object progress) {
    RunOptions options;
    options.out = out;
    options.tree_cache = tree_cache;
    options.threads = threads;
    options.progress = progress_of(std::move(progress));
    const py::gil_scoped_release released;
    return std::make_unique<Results>(run(job, options));
}

/// Raises the Python exception for an error.
void raise_error(const Error& error, const py::object& input_error) {
    switch (error.code()) {
    case ErrorCode::NotFound:
        PyErr_SetString(PyExc_FileNotFoundError, error.what());
        return;
    case ErrorCode::Io:
        PyErr_SetString(PyExc_OSError, error.what());
        return;
    case ErrorCode::Interrupted:
        PyErr_SetString(PyExc_InterruptedError, error.what());
        return;
    case ErrorCode::BadInput:
    case ErrorCode::TooLarge:
        break;
    }
    PyErr_SetString(input_error.ptr(), error.what());
}

} // namespace

} // namespace cdcluster

PYBIND11_MODULE(_native, module) {
    using namespace cdcluster;
    // It is never destroyed, since Python's memory is gone when the process ends.
    static const auto* const input_error =
        new py::exception<Error>(module, "InputError", PyExc_ValueError);
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) {
                std::rethrow_exception(thrown);
            }
        } catch (const Error& error) {
            raise_error(error, *input_error);
        }
    });
    py::enum_<PoseForm>(module, "PoseForm")
        .value("Matrix44", PoseForm::Matrix44)
        .value("Matrix34", PoseForm::Matrix34)
        .value("Xyzw", PoseForm::Xyzw)
        .value("Wxyz", PoseForm::Wxyz);
    define_mesh(module);
    define_results(module);
    py::class_<Job>(module, "Job")
        .def_static("from_toml",
                    [](const std::string& text, const std::filesystem::path& folder) {
                        return Job::from_toml(text, folder);
                    })
        .def_static("from_file", &Job::from_file)
        .def_static("from_folder", &Job::from_folder)
        .def_property_readonly("name", &Job::name);
    module.def("find_contacts", &find);
    module.def("run", &run_job);
    module.def("open", [](const std::filesystem::path& folder) {
        const py::gil_scoped_release released;
        return std::make_unique<Results>(open(folder));
    });
    module.def("version", [] { return std::string(version()); });
}

// The native part of the Python package: meshes, questions, jobs and errors. What a Python user
// calls, and how arguments become these, is in cdcluster/__init__.py.
#include "common/core/files/hash.hpp"
#include "library/borrowed_poses.hpp"
#include "library/kept_run.hpp"
#include "library/pose_sweep.hpp"
#include "python/calls.hpp"
#include "python/cluster.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cdcluster {

namespace {

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
        .def_property_readonly("is_closed",
                               [](const Mesh& mesh) {
                                   // Another thread may build the mesh's tree, and look for
                                   // signals meanwhile.
                                   const py::gil_scoped_release released;
                                   return mesh.is_closed();
                               })
        .def(py::pickle(&bytes_of, &mesh_from_bytes));
}

/// The answers of a question about poses in memory, and a checksum of these poses.
struct KeptPoses {
    KeptAnswers answers;
    std::uint64_t checksum = 0;
};

std::uint64_t checksum_of(const Doubles& poses) {
    return cd::checksum(std::as_bytes(span_of(poses)));
}

/// Returns the results, and what `save_pair` needs.
py::tuple find(const Mesh& a,
               const Mesh& b,
               const Doubles& poses,
               PoseForm form,
               const py::dict& asked,
               py::object progress) {
    const Query query = query_of(asked, progress_of(std::move(progress)));
    auto kept = std::make_unique<KeptPoses>();
    std::unique_ptr<Results> results;
    {
        const Poses rows{span_of(poses), form};
        const py::gil_scoped_release released;
        kept->checksum = checksum_of(poses);
        results =
            std::make_unique<Results>(PoseSweep(a, b, query).next(rows, true, {}, &kept->answers));
    }
    return py::make_tuple(std::move(results), std::move(kept));
}

void save_pair(const Mesh& a,
               const Mesh& b,
               const Doubles& poses,
               PoseForm form,
               const py::dict& asked,
               const KeptPoses& kept,
               const std::filesystem::path& folder,
               bool overwrite) {
    const Query query = query_of(asked, {});
    const Poses rows{span_of(poses), form};
    const py::gil_scoped_release released;
    if (checksum_of(poses) != kept.checksum) {
        throw Error(ErrorCode::BadInput,
                    "the array of poses has changed since the question was answered; ask again");
    }
    cd::PreparedJob job = pair_job(a, b, std::make_unique<BorrowedPoses>(rows), form, query);
    job.spec.output.dir = folder;
    save_answers(job, kept.answers, overwrite);
}

/// Returns the results, and what `save_run` needs.
py::tuple run_job(const Job& job,
                  const std::filesystem::path& out,
                  const std::filesystem::path& tree_cache,
                  unsigned threads,
                  py::object progress) {
    RunOptions options;
    options.out = out;
    options.tree_cache = tree_cache;
    options.threads = threads;
    options.progress = progress_of(std::move(progress));
    auto kept = std::make_unique<KeptRun>();
    std::unique_ptr<Results> results;
    {
        const py::gil_scoped_release released;
        results = std::make_unique<Results>(run_and_keep(job, options, *kept));
    }
    return py::make_tuple(std::move(results), std::move(kept));
}

void define_calls(py::module_& module) {
    py::class_<KeptPoses>(module, "KeptPoses");
    py::class_<KeptRun>(module, "KeptRun").def_property_readonly("folder", [](const KeptRun& kept) {
        return kept.folder.string();
    });
    py::class_<PoseSweep>(module, "PoseSweep")
        .def(py::init([](const Mesh& a, const Mesh& b, const py::dict& asked, py::object progress) {
            return std::make_unique<PoseSweep>(
                a, b, query_of(asked, progress_of(std::move(progress))));
        }))
        .def("next", [](PoseSweep& sweep, const Doubles& poses, PoseForm form, bool last) {
            const Poses rows{span_of(poses), form};
            const py::gil_scoped_release released;
            return std::make_unique<Results>(sweep.next(rows, last));
        });
    module.def("find_contacts", &find);
    module.def("save_pair", &save_pair);
    module.def("run", &run_job);
    module.def("save_run",
               [](const Job& job,
                  const KeptRun& kept,
                  const std::filesystem::path& folder,
                  bool overwrite) {
                   const py::gil_scoped_release released;
                   save_run(job, kept, folder, overwrite);
               });
    module.def("open", [](const std::filesystem::path& folder) {
        const py::gil_scoped_release released;
        return std::make_unique<Results>(open(folder));
    });
}

/// The exceptions of the package. They are never destroyed, since Python's memory is gone when the
/// process ends.
struct Exceptions {
    py::exception<Error> input;
    py::exception<ClusterError> unreachable;
    py::exception<ClusterError> refused;
    py::exception<ClusterError> incomplete;
};

void raise_error(const Error& error, const Exceptions& exceptions) {
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
    PyErr_SetString(exceptions.input.ptr(), error.what());
}

void raise_error(const ClusterError& error, const Exceptions& exceptions) {
    switch (error.code()) {
    case cd::ErrorCode::Disconnected:
    case cd::ErrorCode::Timeout:
    case cd::ErrorCode::BadFrame:
        PyErr_SetString(exceptions.unreachable.ptr(), error.what());
        return;
    case cd::ErrorCode::Refused:
        PyErr_SetString(exceptions.refused.ptr(), error.what());
        return;
    case cd::ErrorCode::Incomplete:
        PyErr_SetString(exceptions.incomplete.ptr(), error.what());
        return;
    case cd::ErrorCode::Interrupted:
        PyErr_SetString(PyExc_InterruptedError, error.what());
        return;
    case cd::ErrorCode::Io:
        PyErr_SetString(PyExc_OSError, error.what());
        return;
    case cd::ErrorCode::BadInput:
    case cd::ErrorCode::TooLarge:
    case cd::ErrorCode::NotFound: // A job that the master does not have.
        break;
    }
    PyErr_SetString(exceptions.input.ptr(), error.what());
}

} // namespace

} // namespace cdcluster

PYBIND11_MODULE(_native, module) {
    using namespace cdcluster;
    namespace py = pybind11;
    static const auto* const exceptions =
        new Exceptions{{module, "InputError", PyExc_ValueError},
                       {module, "Unreachable", PyExc_ConnectionError},
                       {module, "RefusedError", PyExc_PermissionError},
                       {module, "IncompleteError", PyExc_RuntimeError}};
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) {
                std::rethrow_exception(thrown);
            }
        } catch (const ClusterError& error) {
            raise_error(error, *exceptions);
        } catch (const Error& error) {
            raise_error(error, *exceptions);
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
    define_calls(module);
    define_cluster(module);
    module.def("version", [] { return std::string(version()); });
}

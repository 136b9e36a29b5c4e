// Clusters and their jobs.
#include "client/trees/tree_cache.hpp"
#include "python/calls.hpp"
#include "python/cluster.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cdcluster {

namespace {

std::unique_ptr<Cluster> make_cluster(std::string address,
                                      std::string credential,
                                      bool insecure,
                                      const std::optional<std::string>& tree_cache) {
    cd::MasterOptions master;
    master.address = std::move(address);
    master.credential = std::move(credential);
    master.insecure = insecure;
    return std::make_unique<Cluster>(
        std::move(master), cd::tree_cache_folder(tree_cache.value_or(cd::default_tree_cache())));
}

JobFacts submit_pair(const Cluster& cluster,
                     const Mesh& a,
                     const Mesh& b,
                     const Doubles& poses,
                     PoseForm form,
                     const py::dict& asked,
                     const std::string& name,
                     std::int32_t priority) {
    const Query query = query_of(asked, {});
    const Poses rows{span_of(poses), form};
    const SignalStop stop;
    return stop.run(
        [&] { return cluster.submit(a, b, rows, query, name, priority, stop.check()); });
}

/// A watch that ends when a signal's handler raises.
struct PythonWatch {
    PythonWatch(const Cluster& cluster, std::string id)
        : watch(cluster.master(), std::move(id), stop.check()) {}

    SignalStop stop;
    JobWatch watch;
};

void define_facts(py::module_& module) {
    py::class_<JobFacts>(module, "JobFacts")
        .def_readonly("id", &JobFacts::id)
        .def_readonly("number", &JobFacts::number)
        .def_readonly("name", &JobFacts::name)
        .def_readonly("owner", &JobFacts::owner)
        .def_readonly("priority", &JobFacts::priority)
        .def_readonly("state", &JobFacts::state)
        .def_readonly("failure", &JobFacts::failure)
        .def_readonly("paused", &JobFacts::paused)
        .def_readonly("done", &JobFacts::done)
        .def_readonly("total", &JobFacts::total)
        .def_readonly("rate", &JobFacts::rate)
        .def_readonly("seconds", &JobFacts::seconds);
}

} // namespace

void define_cluster(py::module_& module) {
    define_facts(module);
    py::class_<PythonWatch>(module, "Watch").def("next", [](PythonWatch& watch, unsigned wait_ms) {
        return watch.stop.run([&] { return watch.watch.next(std::chrono::milliseconds(wait_ms)); });
    });
    py::class_<Cluster>(module, "Cluster")
        .def(py::init(&make_cluster))
        .def("jobs",
             [](const Cluster& cluster) {
                 const SignalStop stop;
                 return stop.run([&] { return cluster.jobs(stop.check()); });
             })
        .def("job",
             [](const Cluster& cluster, const std::string& id) {
                 const SignalStop stop;
                 return stop.run([&] { return cluster.job(id, stop.check()); });
             })
        .def("submit_pair", &submit_pair)
        .def("submit_job",
             [](const Cluster& cluster, const Job& job, std::int32_t priority) {
                 const SignalStop stop;
                 return stop.run([&] { return cluster.submit(job, priority, stop.check()); });
             })
        .def("set_priority",
             [](const Cluster& cluster, const std::string& id, std::int32_t priority) {
                 const SignalStop stop;
                 return stop.run([&] { return cluster.set_priority(id, priority, stop.check()); });
             })
        .def("cancel",
             [](const Cluster& cluster, const std::string& id) {
                 const SignalStop stop;
                 return stop.run([&] { return cluster.cancel(id, stop.check()); });
             })
        .def("watch",
             [](const Cluster& cluster, const std::string& id) {
                 return std::make_unique<PythonWatch>(cluster, id);
             })
        .def("results",
             [](const Cluster& cluster, const std::string& id, bool partial) {
                 const SignalStop stop;
                 return stop.run([&] {
                     return std::make_unique<Results>(cluster.results(id, partial, stop.check()));
                 });
             })
        .def("save",
             [](const Cluster& cluster,
                const std::string& id,
                const std::filesystem::path& folder,
                bool overwrite) {
                 const SignalStop stop;
                 stop.run([&] { cluster.save(id, folder, overwrite, stop.check()); });
             });
}

} // namespace cdcluster

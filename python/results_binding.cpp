// Results as NumPy arrays.
#include "python/calls.hpp"

#include <utility>
#include <vector>

namespace cdcluster {

namespace {

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

} // namespace

void define_results(py::module_& module) {
    py::class_<Results> results(module, "Results");
    const auto array = [&](const char* name, auto make) {
        results.def_property_readonly(name, [make](const py::object& self) {
            return make(self.cast<const Results&>(), self);
        });
    };
    array("kind", [](const Results& r, auto& self) { return view_of<std::uint8_t>(r.kind, self); });
    array("index",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.index, self); });
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
    array("bundle",
          [](const Results& r, auto& self) { return view_of<std::uint64_t>(r.bundle, self); });
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
    results.def_readonly("first", &Results::first)
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

} // namespace cdcluster

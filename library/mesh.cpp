#include "client/import/mesh_import.hpp"
#include "common/core/errors.hpp"
#include "common/geometry/topology.hpp"
#include "library/errors.hpp"
#include "library/mesh_state.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cdcluster {

namespace {

/// More pairs of meshes and queries than a loop over a few bodies has.
constexpr std::size_t searches_max = 8;

Mesh::State& state_of(const Mesh& mesh) {
    if (!mesh.state()) {
        throw Error(ErrorCode::BadInput, "the mesh was moved from");
    }
    return *mesh.state();
}

template <class Number>
void check_threes(std::span<const Number> numbers, const char* what) {
    if (numbers.size() % 3 != 0) {
        throw Error(ErrorCode::BadInput,
                    std::string(what) + " have " + std::to_string(numbers.size()) +
                        " numbers, which is no multiple of 3");
    }
}

std::shared_ptr<Mesh::State> state_with(cd::Mesh mesh) {
    return std::make_shared<Mesh::State>(std::make_shared<const cd::Mesh>(std::move(mesh)));
}

/// Makes the trees of both meshes in the forms that a question about them needs.
std::pair<std::shared_ptr<const cd::ObbTree>, std::shared_ptr<const cd::ObbTree>>
trees_of(Mesh::State& a,
         Mesh::State& b,
         bool wants_points,
         unsigned threads,
         const cd::StopCheck& stop) {
    std::unique_lock lock_a(a.mutex, std::defer_lock);
    std::unique_lock lock_b(b.mutex, std::defer_lock);
    if (&a == &b) {
        lock_a.lock();
    } else {
        std::lock(lock_a, lock_b);
    }
    cd::TreeCache no_cache({});
    std::optional<cd::ThreadPool> pool;
    const auto with_pool = [&]() -> cd::ThreadPool& {
        return pool ? *pool : pool.emplace(threads);
    };
    // What `stop` throws may not pass through a build, whose other threads still run.
    std::exception_ptr thrown;
    bool is_stopped = false;
    const auto held_stop = [&] {
        try {
            is_stopped = is_stopped || stop();
        } catch (...) {
            thrown = std::current_exception();
            is_stopped = true;
        }
        return is_stopped;
    };
    const auto stop_if_asked = [&] {
        if (!held_stop()) {
            return;
        }
        if (thrown) {
            std::rethrow_exception(thrown);
        }
        check(cd::interrupted());
    };
    for (cd::MeshTrees* trees : {&a.trees, &b.trees}) {
        if (!trees->has_wide()) {
            trees->need_wide(no_cache, with_pool(), held_stop);
            stop_if_asked();
        }
        if (wants_points && !trees->has_points()) {
            trees->need_points(true, no_cache, with_pool());
            stop_if_asked();
        }
    }
    // As for a job: two closed bodies may contain each other, and a body that floats cannot hold
    // is searched in the binary form.
    const bool need_binary = (a.trees.is_closed() && b.trees.is_closed()) ||
                             !a.trees.has_wide_nodes() || !b.trees.has_wide_nodes();
    if (need_binary) {
        a.trees.need_binary(no_cache, with_pool());
        b.trees.need_binary(no_cache, with_pool());
    }
    return {a.trees.tree(), b.trees.tree()};
}

} // namespace

const cd::Mesh& mesh_of(const Mesh& mesh) {
    return *state_of(mesh).mesh;
}

std::shared_ptr<PairSearch> search_of(const Mesh& mesh_a,
                                      const Mesh& mesh_b,
                                      const cd::Query& query,
                                      bool wants_points,
                                      unsigned threads,
                                      const cd::StopCheck& stop) {
    Mesh::State& a = state_of(mesh_a);
    Mesh::State& b = state_of(mesh_b);
    {
        const std::lock_guard lock(a.mutex);
        const auto known = std::ranges::find_if(a.searches, [&](const auto& search) {
            return search->is_of(*a.mesh, *b.mesh, query) &&
                   (search->has_points() || !wants_points);
        });
        if (known != a.searches.end()) {
            std::rotate(a.searches.begin(), known, known + 1);
            return a.searches.front();
        }
    }
    auto [tree_a, tree_b] = trees_of(a, b, wants_points, threads, stop);
    auto made = std::make_shared<PairSearch>(std::move(tree_a), std::move(tree_b), query);
    const std::lock_guard lock(a.mutex);
    std::erase_if(a.searches,
                  [&](const auto& search) { return search->is_of(*a.mesh, *b.mesh, query); });
    a.searches.insert(a.searches.begin(), made);
    if (a.searches.size() > searches_max) {
        a.searches.pop_back();
    }
    return made;
}

Mesh Mesh::from_arrays(std::span<const double> xyz,
                       std::span<const std::uint32_t> triangles,
                       std::span<const Part> parts) {
    check_threes(xyz, "xyz");
    check_threes(triangles, "triangles");
    cd::MeshArrays arrays;
    arrays.vertices.reserve(xyz.size() / 3);
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
        arrays.vertices.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
    }
    arrays.triangles.reserve(triangles.size() / 3);
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        arrays.triangles.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
    }
    for (const Part& part : parts) {
        arrays.parts.push_back({part.name, part.begin, part.end});
    }
    arrays.precision = cd::precision_of(arrays.vertices);
    return Mesh(state_with(value_of(cd::Mesh::create(std::move(arrays)))));
}

Mesh Mesh::load(const std::filesystem::path& file, double factor) {
    if (!(std::isfinite(factor) && factor > 0)) {
        throw Error(ErrorCode::BadInput, "factor must be above 0 and finite");
    }
    cd::ImportOptions options;
    options.unit_factor = factor;
    auto state = std::make_shared<State>(value_of(cd::import_mesh(file, options)).mesh);
    state->file = file;
    return Mesh(std::move(state));
}

Mesh Mesh::from_canonical_bytes(std::span<const std::byte> bytes) {
    return Mesh(state_with(value_of(cd::Mesh::from_canonical_bytes(bytes))));
}

Mesh::Mesh(std::shared_ptr<State> state) : state_(std::move(state)) {}
Mesh::Mesh(const Mesh&) = default;
Mesh::Mesh(Mesh&&) noexcept = default;
Mesh& Mesh::operator=(const Mesh&) = default;
Mesh& Mesh::operator=(Mesh&&) noexcept = default;
Mesh::~Mesh() = default;

std::size_t Mesh::vertex_count() const {
    return mesh_of(*this).vertices().size();
}

std::size_t Mesh::triangle_count() const {
    return mesh_of(*this).triangles().size();
}

std::span<const double> Mesh::xyz() const {
    const auto& vertices = mesh_of(*this).vertices();
    static_assert(sizeof(cd::Vec3) == 3 * sizeof(double));
    return {vertices.empty() ? nullptr : vertices.front().data(), 3 * vertices.size()};
}

std::span<const std::uint32_t> Mesh::triangles() const {
    const auto& triangles = mesh_of(*this).triangles();
    return {triangles.front().data(), 3 * triangles.size()};
}

std::vector<Part> Mesh::parts() const {
    std::vector<Part> parts;
    for (const cd::Part& part : mesh_of(*this).parts()) {
        parts.push_back({part.name, part.triangles_begin, part.triangles_end});
    }
    return parts;
}

std::string Mesh::sha256() const {
    return cd::to_hex(mesh_of(*this).hash());
}

bool Mesh::is_closed() const {
    State& state = state_of(*this);
    const std::lock_guard lock(state.mutex);
    return state.trees.has_wide() ? state.trees.is_closed()
                                  : cd::analyse_topology(*state.mesh).is_closed();
}

std::vector<std::byte> Mesh::canonical_bytes() const {
    const cd::Bytes bytes = mesh_of(*this).canonical_bytes();
    return {bytes.begin(), bytes.end()};
}

} // namespace cdcluster

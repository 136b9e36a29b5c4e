// Counts the box and triangle tests of the methods in the paper's related work (section 4), on
// equal poses: counts, not engines. See README.md.
//
//   related_counts MESH_A MESH_B --name heavy --out FOLDER [--count 40]
#include "bench/accuracy/csv.hpp"
#include "client/import/mesh_import.hpp"
#include "common/geometry/aabb.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <vector>

namespace cd::bench {

namespace {

struct Options {
    std::filesystem::path a;
    std::filesystem::path b;
    std::filesystem::path out;
    std::string name;
    RandomPoses poses;
};

struct Counts {
    double box_tests = 0;
    double triangle_tests = 0;

    [[nodiscard]] double sum() const { return box_tests + triangle_tests; }
    Counts& operator+=(const Counts& other) {
        box_tests += other.box_tests;
        triangle_tests += other.triangle_tests;
        return *this;
    }
};

/// Returns the world box of each triangle.
std::vector<Aabb> boxes_of(const Mesh& mesh, const Pose& pose) {
    std::vector<Aabb> boxes;
    boxes.reserve(mesh.triangles().size());
    for (const auto& triangle : mesh.triangles()) {
        Aabb box;
        for (const auto vertex : triangle) {
            box.add(pose.apply(mesh.vertices()[vertex]));
        }
        boxes.push_back(box);
    }
    return boxes;
}

Aabb box_around(const std::vector<Aabb>& boxes, std::span<const std::uint32_t> which) {
    Aabb around;
    for (const std::uint32_t index : which) {
        around.add(boxes[index].min);
        around.add(boxes[index].max);
    }
    return around;
}

std::vector<std::uint32_t> all_of(const std::vector<Aabb>& boxes) {
    std::vector<std::uint32_t> all(boxes.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

// ---- Lawlor and Kale: voxels of one size
// ----------------------------------------------------------

using Cell = std::array<std::int32_t, 3>;
struct InCell {
    Cell cell;
    std::uint32_t triangle = 0;

    friend auto operator<=>(const InCell&, const InCell&) = default;
};

Cell cell_of(const Vec3& point, double size) {
    Cell cell{};
    for (int axis = 0; axis < 3; ++axis) {
        cell[static_cast<std::size_t>(axis)] =
            static_cast<std::int32_t>(std::floor(point[axis] / size));
    }
    return cell;
}

/// Uses only boxes near the other body: elsewhere a voxel holds one body alone.
std::vector<InCell> in_cells(const std::vector<Aabb>& boxes, const Aabb& near, double size) {
    std::vector<InCell> entries;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (are_apart(boxes[i], near)) {
            continue;
        }
        const Cell low = cell_of(boxes[i].min, size);
        const Cell high = cell_of(boxes[i].max, size);
        for (std::int32_t x = low[0]; x <= high[0]; ++x) {
            for (std::int32_t y = low[1]; y <= high[1]; ++y) {
                for (std::int32_t z = low[2]; z <= high[2]; ++z) {
                    entries.push_back({{x, y, z}, i});
                }
            }
        }
    }
    std::ranges::sort(entries);
    return entries;
}

/// A pair of triangles counts once, in the voxel of the lowest corner that both boxes share.
bool is_first_cell(const Aabb& one, const Aabb& other, const Cell& cell, double size) {
    return cell_of(one.min.cwiseMax(other.min), size) == cell;
}

Counts count_voxels(const std::vector<Aabb>& a, const std::vector<Aabb>& b, double size) {
    const std::vector<InCell> cells_a = in_cells(a, box_around(b, all_of(b)), size);
    const std::vector<InCell> cells_b = in_cells(b, box_around(a, all_of(a)), size);
    Counts counts;
    auto begin_b = cells_b.begin();
    for (const InCell& entry : cells_a) {
        while (begin_b != cells_b.end() && begin_b->cell < entry.cell) {
            ++begin_b;
        }
        for (auto other = begin_b; other != cells_b.end() && other->cell == entry.cell; ++other) {
            ++counts.box_tests;
            const Aabb& box_a = a[entry.triangle];
            const Aabb& box_b = b[other->triangle];
            if (!are_apart(box_a, box_b) && is_first_cell(box_a, box_b, entry.cell, size)) {
                ++counts.triangle_tests;
            }
        }
    }
    return counts;
}

double mean_extent(const std::vector<Aabb>& boxes) {
    double sum = 0;
    for (const Aabb& box : boxes) {
        sum += (box.max - box.min).maxCoeff();
    }
    return sum / static_cast<double>(boxes.size());
}

// ---- Figueiredo and Fernando: three levels of boxes
// ------------------------------------------------

constexpr std::size_t parts_each = 16;

/// Halves along the longest axis until there are enough parts.
std::vector<std::vector<std::uint32_t>>
parts_of(const std::vector<Aabb>& boxes, std::vector<std::uint32_t> which, std::size_t parts) {
    if (parts == 1 || which.size() < 2) {
        return {std::move(which)};
    }
    int axis = 0;
    const Aabb around = box_around(boxes, which);
    (around.max - around.min).maxCoeff(&axis);
    const auto middle = which.begin() + static_cast<std::ptrdiff_t>(which.size() / 2);
    std::nth_element(
        which.begin(), middle, which.end(), [&](std::uint32_t one, std::uint32_t other) {
            return std::tuple(boxes[one].min[axis] + boxes[one].max[axis], one) <
                   std::tuple(boxes[other].min[axis] + boxes[other].max[axis], other);
        });
    auto found = parts_of(boxes, {which.begin(), middle}, parts / 2);
    auto second = parts_of(boxes, {middle, which.end()}, parts / 2);
    std::move(second.begin(), second.end(), std::back_inserter(found));
    return found;
}

/// A body, its parts, and their parts, which hold triangles.
struct ThreeLevels {
    struct Part {
        std::vector<std::vector<std::uint32_t>> leaves;
    };
    std::vector<Part> parts;
};

ThreeLevels three_levels(const std::vector<Aabb>& boxes) {
    ThreeLevels levels;
    for (auto& part : parts_of(boxes, all_of(boxes), parts_each)) {
        levels.parts.push_back({parts_of(boxes, std::move(part), parts_each)});
    }
    return levels;
}

/// A part at the body's current pose.
struct PosedPart {
    Aabb box;
    std::vector<Aabb> leaf_boxes;
    std::vector<double> leaf_triangles;
};

std::vector<PosedPart> posed(const ThreeLevels& levels, const std::vector<Aabb>& boxes) {
    std::vector<PosedPart> posed;
    for (const ThreeLevels::Part& part : levels.parts) {
        PosedPart& one = posed.emplace_back();
        for (const auto& leaf : part.leaves) {
            one.leaf_boxes.push_back(box_around(boxes, leaf));
            one.leaf_triangles.push_back(static_cast<double>(leaf.size()));
            one.box.add(one.leaf_boxes.back().min);
            one.box.add(one.leaf_boxes.back().max);
        }
    }
    return posed;
}

Counts count_leaves(const PosedPart& a, const PosedPart& b) {
    Counts counts;
    for (std::size_t i = 0; i < a.leaf_boxes.size(); ++i) {
        for (std::size_t j = 0; j < b.leaf_boxes.size(); ++j) {
            ++counts.box_tests;
            if (!are_apart(a.leaf_boxes[i], b.leaf_boxes[j])) {
                counts.triangle_tests += a.leaf_triangles[i] * b.leaf_triangles[j];
            }
        }
    }
    return counts;
}

Counts count_three_levels(const std::vector<PosedPart>& a, const std::vector<PosedPart>& b) {
    Counts counts{1, 0}; // The bodies' own boxes count first: these poses touch.
    for (const PosedPart& part_a : a) {
        for (const PosedPart& part_b : b) {
            ++counts.box_tests;
            if (!are_apart(part_a.box, part_b.box)) {
                counts += count_leaves(part_a, part_b);
            }
        }
    }
    return counts;
}

// ---- The program
// -------------------------------------------------------------------------------------

constexpr std::array voxel_sizes{
    1.0, 2.0, 4.0, 8.0}; ///< Relative to the mean extent of a triangle.

struct AllCounts {
    Counts obb;
    std::array<Counts, voxel_sizes.size()> voxels;
    Counts three;
};

AllCounts count_all(const ObbTree& a, const ObbTree& b, const std::vector<Scenario>& scenarios) {
    AllCounts all;
    const ThreeLevels levels_a = three_levels(boxes_of(a.mesh(), Pose{}));
    const ThreeLevels levels_b = three_levels(boxes_of(b.mesh(), Pose{}));
    for (const Scenario& scenario : scenarios) {
        const auto boxes_a = boxes_of(a.mesh(), scenario.poses.a);
        const auto boxes_b = boxes_of(b.mesh(), scenario.poses.b);
        const SubtreePair pair{a.view(), b.view()};
        const QueryStatistics statistics = run_on_subtrees({&pair, 1}, scenario, {}).statistics;
        all.obb += {static_cast<double>(statistics.box_tests),
                    static_cast<double>(statistics.triangle_tests)};
        const double extent = std::max(mean_extent(boxes_a), mean_extent(boxes_b));
        for (std::size_t i = 0; i < voxel_sizes.size(); ++i) {
            all.voxels[i] += count_voxels(boxes_a, boxes_b, voxel_sizes[i] * extent);
        }
        all.three += count_three_levels(posed(levels_a, boxes_a), posed(levels_b, boxes_b));
    }
    return all;
}

Result<ObbTree> tree_of(const std::filesystem::path& path, ThreadPool& pool) {
    const auto mesh = import_mesh(path, {});
    if (!mesh) {
        return mesh.error();
    }
    BuildOptions build;
    build.prepare_search = false;
    return build_tree(mesh.value().mesh, build, pool);
}

Status run(const Options& options) {
    ThreadPool pool(1);
    const auto a = tree_of(options.a, pool);
    const auto b = tree_of(options.b, pool);
    for (const auto* tree : {&a, &b}) {
        if (!*tree) {
            return tree->error();
        }
    }
    const auto scenarios = make_random_poses(options.poses, a.value(), b.value(), pool);
    const AllCounts all = count_all(a.value(), b.value(), scenarios);
    CsvFile csv(options.out / ("related_" + options.name + ".csv"),
                {"scene", "scenarios", "way", "box_tests", "triangle_tests"});
    const auto count = static_cast<double>(scenarios.size());
    const auto row = [&](const std::string& way, const Counts& counts) {
        csv.row({options.name,
                 cell(std::uint64_t{scenarios.size()}),
                 way,
                 cell(counts.box_tests / count),
                 cell(counts.triangle_tests / count)});
    };
    row("OBB trees (ours, binary)", all.obb);
    const auto best = std::ranges::min_element(all.voxels, {}, &Counts::sum);
    const double size = voxel_sizes[static_cast<std::size_t>(best - all.voxels.begin())];
    row("voxels, " + cell(size) + " mean triangles wide (the best of 1, 2, 4, 8)", *best);
    row("three levels of AABBs, 16 x 16", all.three);
    return Done{};
}

} // namespace

} // namespace cd::bench

int main(int argc, char** argv) {
    cd::bench::Options options;
    options.poses.count = 40;
    CLI::App app("Counts what the ways of related work test");
    app.add_option("MESH_A", options.a, "The fixed body")->required();
    app.add_option("MESH_B", options.b, "The other")->required();
    app.add_option("--name", options.name, "Of the scene")->required();
    app.add_option("--out", options.out, "A folder for related_NAME.csv")->required();
    app.add_option("--count", options.poses.count, "Random poses")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    try {
        const cd::Status status = cd::bench::run(options);
        if (!status) {
            std::fprintf(stderr, "%s\n", status.error().detail.c_str());
            return 2;
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}

#include "client/poses/pose_file.hpp"

#include "client/formats/npz_file.hpp"
#include "client/poses/pose_rows.hpp"
#include "client/poses/text_poses.hpp"
#include "common/core/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>

namespace cd {

namespace {

/// Returns the layout of a pose, from the axes of an array after the first axis.
Result<PoseLayout> layout_of(std::vector<std::uint64_t> shape, const PoseFileSpec& spec) {
    const std::vector<std::uint64_t> given = shape;
    shape.erase(shape.begin());
    if (spec.of_both_bodies) {
        if (shape.empty() || shape.front() != 2) {
            return bad_input("poses of both bodies need a second axis of 2");
        }
        shape.erase(shape.begin());
    }
    using Shape = std::vector<std::uint64_t>;
    if (shape == Shape{4, 4}) {
        return PoseLayout::Matrix44;
    }
    if (shape == Shape{3, 4} || shape == Shape{12}) {
        return PoseLayout::Matrix34;
    }
    if (shape == Shape{7} && spec.quat_order == "xyzw") {
        return PoseLayout::Xyzw;
    }
    if (shape == Shape{7} && spec.quat_order == "wxyz") {
        return PoseLayout::Wxyz;
    }
    if (shape == Shape{7}) {
        return bad_input(
            "a bare (N, 7) array does not say which column is qw; give quat_order \"xyzw\" or "
            "\"wxyz\"");
    }
    return bad_input(
        fmt::format("an array of shape ({}); expected (N,4,4), (N,3,4), (N,12) or (N,7)",
                    fmt::join(given, ", ")));
}

Result<PoseTable> table_of(std::unique_ptr<NpyRows> rows, const PoseFileSpec& spec) {
    const auto layout = CD_TRY(layout_of(rows->shape(), spec));
    return PoseTable{std::move(rows), layout, spec.of_both_bodies};
}

Result<PoseTable> open_npz(const PoseFileSpec& spec) {
    const auto file = CD_TRY(NpzFile::open(spec.path));
    const std::vector<std::string> names = file.names();
    const bool has_poses = std::ranges::find(names, "poses") != names.end();
    if (!has_poses && names.size() != 1) {
        return bad_input("has several arrays, and none is called 'poses'");
    }
    auto poses = CD_TRY(file.read(has_poses ? "poses" : names.front()));
    return table_of(NpyRows::of(std::move(poses)), spec);
}

Result<PoseTable> open_npy(const PoseFileSpec& spec) {
    auto rows = CD_TRY(NpyRows::open(spec.path));
    return table_of(std::move(rows), spec);
}

Result<PoseTable> open_table(const PoseFileSpec& spec) {
    if (spec.path == "-") {
        return read_csv_poses(std::cin, spec.of_both_bodies);
    }
    const std::string ending = spec.path.extension().string();
    if (ending == ".npy") {
        return open_npy(spec);
    }
    if (ending == ".npz") {
        return open_npz(spec);
    }
    if (std::filesystem::is_directory(spec.path)) {
        return bad_input("is a folder; a file of poses is needed");
    }
    std::ifstream in(spec.path, std::ios::binary);
    if (!in) {
        return bad_input("cannot be opened");
    }
    if (ending == ".csv") {
        return read_csv_poses(in, spec.of_both_bodies);
    }
    if (ending == ".tum" || ending == ".txt") {
        if (spec.of_both_bodies) {
            return bad_input("a TUM file has the poses of one body; use .csv or .npy for both");
        }
        return read_tum_poses(in);
    }
    return bad_input("the ending '" + ending + "' is not one of .csv, .npy, .npz, .tum, .txt");
}

Result<OpenedPoses> open_named(const PoseFileSpec& spec, const std::string& name) {
    const auto named = [&](const Error& error) {
        const bool has_name = error.detail.starts_with(name);
        return bad_input(has_name ? error.detail : name + ": " + error.detail);
    };
    auto table = open_table(spec);
    if (!table) {
        return named(table.error());
    }
    if (table.value().rows->row_count() == 0) {
        return named(bad_input("has no poses"));
    }
    table.value().length_factor = spec.length_factor;
    const auto report = check_rows(table.value(), spec.rigid_tolerance);
    if (!report) {
        return named(report.error());
    }
    OpenedPoses opened;
    if (report.value().off != 0) {
        opened.warnings.push_back(fmt::format(
            "{}: {} poses are off from rigid by more than 1e-9; the worst is {}, "
            "off by {:.3g}. A matrix is taken as it is, a quaternion is scaled to length 1",
            name,
            report.value().off,
            place_of_pose(table.value(), report.value().worst_pose),
            report.value().worst));
    }
    opened.zeros = table.value().zeros;
    opened.labels = std::move(table.value().labels);
    table.value().name = name;
    opened.source = make_table_source(std::move(table.value()));
    return opened;
}

} // namespace

Result<OpenedPoses> open_pose_file(const PoseFileSpec& spec) {
    const std::string name = spec.path == "-" ? "standard input" : spec.path.string();
    try {
        return open_named(spec, name);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, name + ": too little memory to read it"};
    }
}

} // namespace cd

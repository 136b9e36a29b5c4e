#include "client/poses/pose_file.hpp"

#include "client/formats/npz_file.hpp"
#include "client/poses/pose_rows.hpp"
#include "client/poses/scene_csv.hpp"
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

/// What the job says about a file of poses.
struct FileOfPoses {
    const PoseFileSpec& spec;
    std::vector<std::string> bodies; ///< Names of the bodies of a row; empty: one pose.
    bool is_of_scene = false;
    bool nan_is_absent = false;
};

/// Checks an array's second axis. Errors: BadInput unless it has an element for each body.
Status check_bodies_axis(const std::vector<std::uint64_t>& shape, const FileOfPoses& file) {
    if (file.is_of_scene && file.bodies.empty()) {
        return bad_input("an array does not say whose poses it has; give [poses] body_order with "
                         "the names of its bodies");
    }
    if (shape.size() > 1 && shape[1] == file.bodies.size()) {
        return Done{};
    }
    return bad_input(file.is_of_scene
                         ? fmt::format("an array of shape ({}); body_order names {} bodies, so the "
                                       "second axis has to have {}",
                                       fmt::join(shape, ", "),
                                       file.bodies.size(),
                                       file.bodies.size())
                         : "poses of both bodies need a second axis of 2");
}

/// Returns the layout of a pose, from the axes of an array after that of its bodies, or after the
/// first.
Result<PoseLayout> layout_of(const std::vector<std::uint64_t>& given, const FileOfPoses& file) {
    std::size_t axes = 1;
    if (file.is_of_scene || !file.bodies.empty()) {
        CD_TRY(check_bodies_axis(given, file));
        axes = 2;
    }
    using Shape = std::vector<std::uint64_t>;
    const Shape shape(given.begin() + static_cast<std::ptrdiff_t>(std::min(axes, given.size())),
                      given.end());
    if (shape == Shape{4, 4}) {
        return PoseLayout::Matrix44;
    }
    if (shape == Shape{3, 4} || shape == Shape{12}) {
        return PoseLayout::Matrix34;
    }
    if (shape == Shape{7} && file.spec.quat_order == "xyzw") {
        return PoseLayout::Xyzw;
    }
    if (shape == Shape{7} && file.spec.quat_order == "wxyz") {
        return PoseLayout::Wxyz;
    }
    const char* const bodies = file.is_of_scene ? "bodies, " : "";
    if (shape == Shape{7}) {
        return bad_input(fmt::format("a bare (N, {}7) array does not say which column is qw; give "
                                     "quat_order \"xyzw\" or \"wxyz\"",
                                     bodies));
    }
    return bad_input(file.is_of_scene
                         ? fmt::format("an array of shape ({}); expected (N,bodies,7), "
                                       "(N,bodies,4,4), (N,bodies,3,4) or (N,bodies,12)",
                                       fmt::join(given, ", "))
                         : fmt::format("an array of shape ({}); expected (N,4,4), (N,3,4), (N,12) "
                                       "or (N,7)",
                                       fmt::join(given, ", ")));
}

Result<PoseTable> table_of(std::unique_ptr<NpyRows> rows, const FileOfPoses& file) {
    const auto layout = CD_TRY(layout_of(rows->shape(), file));
    return PoseTable{std::move(rows), layout, file.bodies};
}

Result<PoseTable> open_npz(const FileOfPoses& wanted) {
    const auto file = CD_TRY(NpzFile::open(wanted.spec.path));
    const std::vector<std::string> names = file.names();
    const bool has_poses = std::ranges::find(names, "poses") != names.end();
    if (!has_poses && names.size() != 1) {
        return bad_input("has several arrays, and none is called 'poses'");
    }
    auto poses = CD_TRY(file.read(has_poses ? "poses" : names.front()));
    return table_of(NpyRows::of(std::move(poses)), wanted);
}

Result<PoseTable> open_npy(const FileOfPoses& wanted) {
    auto rows = CD_TRY(NpyRows::open(wanted.spec.path));
    return table_of(std::move(rows), wanted);
}

Result<PoseTable> read_csv(std::istream& in, const FileOfPoses& file) {
    if (!file.is_of_scene) {
        return read_csv_poses(in, !file.bodies.empty());
    }
    if (!file.bodies.empty()) {
        return bad_input("has a column that names the bodies, so body_order does not belong to it; "
                         "leave body_order out");
    }
    return read_scene_csv(in, file.nan_is_absent);
}

Result<PoseTable> open_table(const FileOfPoses& file) {
    const std::filesystem::path& path = file.spec.path;
    if (path == "-") {
        return read_csv(std::cin, file);
    }
    const std::string ending = path.extension().string();
    if (ending == ".npy") {
        return open_npy(file);
    }
    if (ending == ".npz") {
        return open_npz(file);
    }
    if (std::filesystem::is_directory(path)) {
        return bad_input("is a folder; a file of poses is needed");
    }
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        return bad_input("cannot be opened");
    }
    if (ending == ".csv") {
        return read_csv(in, file);
    }
    if (ending == ".tum" || ending == ".txt") {
        if (file.is_of_scene) {
            return bad_input("a TUM file has the poses of one body; use .csv or .npy for a scene");
        }
        if (!file.bodies.empty()) {
            return bad_input("a TUM file has the poses of one body; use .csv or .npy for both");
        }
        return read_tum_poses(in);
    }
    return bad_input("the ending '" + ending + "' is not one of .csv, .npy, .npz, .tum, .txt");
}

Result<OpenedTable> open_named(const FileOfPoses& file, const std::string& name) {
    const auto named = [&](const Error& error) {
        const bool has_name = error.detail.starts_with(name);
        return bad_input(has_name ? error.detail : name + ": " + error.detail);
    };
    auto table = open_table(file);
    if (!table) {
        return named(table.error());
    }
    if (table.value().rows->row_count() == 0) {
        return named(bad_input("has no poses"));
    }
    table.value().length_factor = file.spec.length_factor;
    table.value().nan_is_absent = file.nan_is_absent;
    table.value().name = name;
    const auto report = check_rows(table.value(), file.spec.rigid_tolerance);
    if (!report) {
        return named(report.error());
    }
    OpenedTable checked;
    if (report.value().off != 0) {
        checked.warnings.push_back(fmt::format(
            "{}: {} poses are off from rigid by more than 1e-9; the worst is {}, "
            "off by {:.3g}. A matrix is taken as it is, a quaternion is scaled to length 1",
            name,
            report.value().off,
            place_of_pose(table.value(), report.value().worst_pose),
            report.value().worst));
    }
    checked.table = std::move(table.value());
    return checked;
}

Result<OpenedTable> open_checked(const FileOfPoses& file) {
    const std::string name = file.spec.path == "-" ? "standard input" : file.spec.path.string();
    try {
        return open_named(file, name);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, name + ": too little memory to read it"};
    }
}

} // namespace

Result<OpenedPoses> open_pose_file(const PoseFileSpec& spec) {
    auto checked = CD_TRY(
        open_checked({spec, spec.of_both_bodies ? both_bodies() : std::vector<std::string>()}));
    OpenedPoses opened;
    opened.warnings = std::move(checked.warnings);
    opened.zeros = checked.table.zeros;
    opened.labels = std::move(checked.table.labels);
    opened.rates = std::move(checked.table.rates);
    for (PoseRates& rates : opened.rates) {
        rates.velocity *= spec.length_factor;
        rates.acceleration *= spec.length_factor;
    }
    opened.source = make_table_source(std::move(checked.table));
    return opened;
}

Result<OpenedTable> open_scene_poses(const ScenePosesSpec& spec) {
    return open_checked({spec.file, spec.body_order, true, spec.nan_is_absent});
}

} // namespace cd

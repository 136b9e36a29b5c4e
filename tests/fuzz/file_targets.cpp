#include "client/formats/npy.hpp"
#include "client/formats/npz_file.hpp"
#include "client/import/foreign/ac3d_text.hpp"
#include "client/import/foreign/assimp_checks.hpp"
#include "client/import/gltf/gltf_container.hpp"
#include "client/import/gltf/gltf_document.hpp"
#include "client/import/mesh_readers.hpp"
#include "client/poses/fcd_file.hpp"
#include "client/poses/pose_rows.hpp"
#include "client/poses/text_poses.hpp"
#include "client/spec/job_file.hpp"
#include "tests/fuzz/memory_file.hpp"
#include "tests/fuzz/require.hpp"
#include "tests/fuzz/targets.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>
#include <utility>

namespace cd::fuzz {

namespace {

constexpr std::uint64_t elements_max = 1u << 16;

/// Accepted poses are rigid, and there are as many scenarios as rows.
void use(Result<PoseTable> table) {
    if (!table) {
        return require_reason(table.error());
    }
    if (!check_rows(table.value(), std::nullopt)) {
        return;
    }
    const std::uint64_t rows = table.value().rows->row_count();
    const auto source = make_table_source(std::move(table.value()));
    require(source->count() == rows, "each row is a scenario");
    const auto read = source->read(0, source->count());
    require(read.has_value() && read.value().size() == rows, "what was checked can be read");
}

void use(const NpyArray& array) {
    require(array.data.size() % size_of(array.type) == 0, "an array has whole elements");
    if (array.data.size() <= elements_max) {
        require(array.to_doubles().size() == array.data.size() / size_of(array.type),
                "each element is a number");
        static_cast<void>(array.to_integers());
    }
}

/// A file read in runs gives what it gives when read whole.
void check_rows_of(Input input, const Result<NpyArray>& array) {
    const MemoryFile file(input);
    const auto rows = NpyRows::open(file.path());
    require(rows.has_value() == (array && !array.value().shape.empty()),
            "arrays with rows are those that can be read in runs");
    if (rows && !array.value().data.empty() && array.value().data.size() <= elements_max) {
        const auto values = rows.value()->read(0, rows.value()->row_count());
        const auto whole = array.value().to_doubles();
        require(values && std::ranges::equal(std::as_bytes(std::span(values.value())),
                                             std::as_bytes(std::span(whole))),
                "rows are the array's");
    }
}

constexpr std::array<const char*, 4> mesh_extensions{".ac", ".dae", ".3mf", ""};

/// A reader returns a mesh with no more triangles than the file has bytes, or a one-line error that
/// names the file.
void use_reader(Input input, Result<ImportedMesh> (*read)(const MeshSource&)) {
    const std::string text = text_of(input);
    const std::filesystem::path path = "/nowhere/at/all";
    const auto imported = read({path, text, {}});
    if (imported) {
        require(imported.value().mesh->triangles().size() <= text.size(),
                "no more triangles than bytes");
    } else {
        require_reason(imported.error(), path);
        require(imported.error().detail.find('\n') == std::string::npos, "an error is one line");
    }
}

/// A few bytes may place a mesh many times, by design: bounds the triangles of all placements.
std::uint64_t triangles_at_most(const GltfDocument& document) {
    std::uint64_t elements = 1;
    std::uint64_t primitives = 1;
    for (const GltfAccessor& accessor : document.accessors) {
        elements = std::max(elements, std::min(accessor.count, elements_max));
    }
    for (const GltfMesh& mesh : document.meshes) {
        primitives = std::max(primitives, std::uint64_t{mesh.primitives.size()});
    }
    const bool has_instances = std::ranges::any_of(
        document.nodes, [](const GltfNode& n) { return n.instances.has_value(); });
    return elements * primitives * document.nodes.size() * (has_instances ? elements : 1);
}

} // namespace

void job_file(Input input) {
    const auto read = parse_job(text_of(input), "job.toml");
    if (!read) {
        require(read.error().detail.find("job.toml") != std::string::npos,
                "an error names the file");
    }
}

void csv_poses(Input input) {
    std::istringstream text(text_of(rest_of(input)));
    use(read_csv_poses(text, is_odd(input)));
}

void tum_poses(Input input) {
    std::istringstream text(text_of(input));
    use(read_tum_poses(text));
}

void fcd(Input input) {
    FcdSpec spec;
    spec.types = {{"passenger", "car"}};
    spec.skips_other_types = true;
    std::istringstream text(text_of(rest_of(input)));
    const auto read = is_odd(input) ? read_fcd_csv(text, spec) : read_fcd_xml(text, spec);
    if (!read) {
        return require_reason(read.error());
    }
    const RoadTraffic& traffic = read.value();
    require(!traffic.times.empty() && traffic.ends.size() == traffic.times.size(),
            "each step has a time");
    require(traffic.ends.back() == traffic.rows.size(), "each row is of a step");
    require(std::ranges::is_sorted(traffic.ends), "the steps are in order");
    require(std::ranges::adjacent_find(traffic.times, std::ranges::greater_equal()) ==
                traffic.times.end(),
            "times rise");
    for (const TrafficRow& row : traffic.rows) {
        require(row.vehicle < traffic.vehicles.size(), "each row is of a vehicle");
        require(Pose::from_quaternion(row.rotation, row.position).is_finite(), "poses are finite");
    }
}

void npy(Input input) {
    const auto header = parse_npy_header(input);
    const auto array = parse_npy(input);
    require(header || !array, "no array without a header");
    check_rows_of(input, array);
    if (array) {
        use(array.value());
    }
}

void npz(Input input) {
    const MemoryFile file(input);
    const auto archive = NpzFile::open(file.path());
    if (!archive) {
        return;
    }
    for (const std::string& name : archive.value().names()) {
        const auto array = archive.value().read(name);
        if (array) {
            use(array.value());
        } else {
            require_reason(array.error(), file.path());
        }
    }
}

void gltf(Input input) {
    const std::string text = text_of(input);
    const auto container = open_gltf(input);
    const auto document = container ? parse_gltf(container.value().json) : container.error();
    if (document && triangles_at_most(document.value()) > 1u << 20) {
        return;
    }
    const std::filesystem::path path = "/nowhere/at/all.gltf";
    const auto imported = read_gltf({path, text, {}});
    if (!imported) {
        return require_reason(imported.error(), path);
    }
    require(document.has_value(), "no mesh without a document");
    require(!imported.value().mesh->triangles().empty(), "a mesh has triangles");
}

void stl(Input input) {
    use_reader(input, import_stl);
}

void obj(Input input) {
    use_reader(input, import_obj);
}

void ply(Input input) {
    use_reader(input, import_ply);
}

void off(Input input) {
    use_reader(input, import_off);
}

void mesh_text(Input input) {
    if (input.empty()) {
        return;
    }
    const MemoryFile file(input.subspan(1));
    const std::string extension =
        mesh_extensions[std::to_integer<std::size_t>(input.front()) % mesh_extensions.size()];
    if (const Status sound = check_for_assimp(file.path(), extension); !sound) {
        require_reason(sound.error(), file.path());
    }
    if (is_ac3d(file.path(), extension)) {
        const auto triangles = count_ac3d_triangles(file.path());
        if (!triangles) {
            require_reason(triangles.error(), file.path());
        } else {
            require(triangles.value() <= input.size(), "no more triangles than bytes");
        }
    }
}

} // namespace cd::fuzz

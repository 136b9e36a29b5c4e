// Writes valid inputs of every target as the initial corpus:
//
// fuzz_seeds FOLDER
#include "client/bundle/line_bundle.hpp"
#include "client/folder/run_manifest.hpp"
#include "client/formats/npy.hpp"
#include "client/formats/npz.hpp"
#include "client/poses/label_file.hpp"
#include "client/spec/query_spec.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/varint.hpp"
#include "common/geometry/mesh.hpp"
#include "common/job/packed_scenarios.hpp"
#include "common/job/poses/pose_order.hpp"
#include "common/job/poses/pose_source.hpp"
#include "common/job/result/packed_map.hpp"
#include "common/job/result/packed_records.hpp"
#include "common/job/result/record_file.hpp"
#include "common/job/run_scenario.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/tree_file.hpp"
#include "common/tree/wire/subtree_block.hpp"
#include "common/tree/wire/top_block.hpp"
#include "master/base/result_batch.hpp"
#include "master/journal/alarm_record.hpp"
#include "master/journal/journal_records.hpp"
#include "master/journal/result_group.hpp"
#include "master/submission/pose_spool.hpp"
#include "proto/access/join_token.hpp"
#include "proto/channel/frame.hpp"
#include "proto/codec/codec.hpp"
#include "proto/identity/certificate.hpp"
#include "tests/client/import/gltf_text.hpp"
#include "tests/fuzz/sample_mesh.hpp"
#include "tests/proto/sample_messages.hpp"
#include "tests/support/motions.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/trees.hpp"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace cd::fuzz {
namespace {

namespace fs = std::filesystem;
using namespace std::string_view_literals;

Bytes bytes_of(std::string_view text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

/// Ends the program if something could not be made.
void need(bool is_made) {
    if (!is_made) {
        std::exit(1);
    }
}

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

class Seeds {
  public:
    explicit Seeds(fs::path folder) : folder_(std::move(folder)) {}

    void add(const std::string& target, const std::string& name, std::span<const std::byte> bytes) {
        fs::create_directories(folder_ / target);
        std::ofstream file(folder_ / target / name, std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()),
                   static_cast<std::streamsize>(bytes.size()));
    }
    void add(const std::string& target, const std::string& name, std::string_view text) {
        add(target, name, bytes_of(text));
    }

  private:
    fs::path folder_;
};

/// Returns the bytes after a first byte, whose parity selects the target's mode.
Bytes marked(std::uint8_t mark, std::span<const std::byte> bytes) {
    ByteWriter out;
    out.put(mark);
    put_bytes(out, bytes);
    return out.take();
}

void add_wire(Seeds& seeds) {
    for (const Message& message : tests::sample_messages()) {
        const std::uint16_t type = message_type(message);
        std::string name(message_name(type));
        std::replace(name.begin(), name.end(), ' ', '_');
        const Bytes payload = encode_message(message);
        ByteWriter typed;
        typed.put(type);
        put_bytes(typed, payload);
        seeds.add("message", name, typed.bytes());

        FrameHeader header;
        header.type = type;
        ByteWriter framed;
        put_bytes(framed, encode_header(header));
        const std::size_t half = payload.size() / 2;
        for (const bool is_first : {true, false}) {
            const std::size_t size = is_first ? half : payload.size() - half;
            framed.put(static_cast<std::uint8_t>(type));
            framed.put(static_cast<std::uint8_t>(is_first && half > 0 ? 3 : 2));
            framed.put(static_cast<std::uint16_t>(size));
            put_bytes(framed, std::span(payload).subspan(is_first ? 0 : half, size));
        }
        seeds.add("frames", name, framed.bytes());
    }
    const JoinToken token{5, tests::some_hash(1), tests::some_hash(9)};
    seeds.add("token", "token", to_text(token));
    MeshArrays arrays;
    arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1}};
    arrays.triangles = {{0, 1, 2}, {0, 1, 3}, {2, 2, 2}};
    arrays.parts = {{"base", 0, 1}, {"rest", 1, 3}};
    seeds.add("mesh", "doubles", Mesh::create(arrays).value().canonical_bytes());
    arrays.vertices.back() = {0, 0, 2};
    arrays.precision = Precision::Float;
    seeds.add("mesh", "floats", Mesh::create(arrays).value().canonical_bytes());
}

/// Unpacks records into columns, each a length (two bytes) and its bytes.
Bytes columns_of(std::span<const std::byte> packed) {
    ByteReader in(packed);
    std::array<std::uint64_t, 8> sizes{};
    for (std::uint64_t& size : sizes) {
        size = get_varint(in).value();
    }
    ByteWriter out;
    for (const std::uint64_t size : sizes) {
        const auto column = in.get_bytes(size);
        const Bytes bytes = column.empty() ? Bytes() : decompress(column, 1u << 16).value();
        out.put(static_cast<std::uint16_t>(bytes.size()));
        put_bytes(out, bytes);
    }
    return out.take();
}

struct AskedScenario {
    std::string name;
    Scenario scenario;
    Query query;
};

/// Returns a scenario in contact at each level, one that is near at each level, and the distance of
/// bodies in contact and apart.
std::vector<AskedScenario> asked_scenarios() {
    std::vector<AskedScenario> all;
    for (const bool is_near : {false, true}) {
        for (const Level level : {Level::Any, Level::Count, Level::Pairs, Level::Contacts}) {
            AskedScenario& asked = all.emplace_back();
            asked.name = (is_near ? "near_" : "") + std::string(to_text(level));
            asked.scenario.index = all.size() - 1;
            asked.scenario.poses.b =
                Pose::from_matrix(Mat3::Identity(), {is_near ? 2.45 : 0.9, 0.1, 0.05});
            asked.query.level = level;
            asked.query.clearance = is_near ? std::optional(0.25) : std::nullopt;
        }
    }
    for (const bool is_near : {false, true}) {
        AskedScenario asked = all[is_near ? level_names.size() : 0];
        asked.name = is_near ? "distance" : "no_distance";
        asked.scenario.index = all.size();
        asked.query.question = Question::Distance;
        asked.query.clearance.reset();
        all.push_back(asked);
    }
    return all;
}

/// Adds the hits of four lines through a body, of which some pass through vertices.
void add_shots(Seeds& seeds, const ObbTree& body) {
    std::vector<LineEnds> ends;
    for (const double x : {-1.4, -1.0, 0.6, 1.0}) {
        ends.push_back({Vec3(x, 0, 2), Vec3(x, 0, -2)});
    }
    const ObbTree lines = tests::make_tree(line_mesh(ends).value());
    Query query;
    query.question = Question::Shots;
    for (const Level level : {Level::Count, Level::Pairs}) {
        query.level = level;
        seeds.add("result",
                  "shots_" + std::string(to_text(level)),
                  encode_result(run_scenario(body, lines, Scenario{}, query).result));
    }
}

/// Adds motions of one body past and onto another.
void add_motions(Seeds& seeds, const ObbTree& a, const ObbTree& b) {
    const BodyRadii radii{body_radius(a.mesh().vertices()), body_radius(b.mesh().vertices())};
    const auto at = [](double x, double y) {
        return PosePair{tests::moved_pose(Vec3::Zero()), tests::moved_pose(Vec3(x, y, 0))};
    };
    constexpr double resolution = 0.25;
    const auto keys =
        round_keys(std::array{at(4, 0), at(0.5, 0), at(4, 4), at(-4, 4)}, radii, resolution);
    for (const Until until : {Until::Contact, Until::Free, Until::End}) {
        for (std::size_t i = 0; i < 3; ++i) {
            Query query;
            query.level = i == 0 ? Level::Pairs : Level::Any;
            query.question = Question::Motion;
            query.motion = MotionQuery{resolution, until};
            query.clearance = i == 1 ? std::optional(0.125) : std::nullopt;
            Scenario scenario;
            scenario.poses = keys.value().keys[i];
            scenario.to = keys.value().keys[i + 1];
            const Bytes record = encode_result(run_scenario(a, b, scenario, query).result);
            seeds.add("result",
                      "motion_" + std::string(to_text(until)) + "_" + std::to_string(i),
                      record);
            seeds.add("scenarios",
                      "motion_" + std::to_string(i),
                      pack_scenarios(std::span(&scenario, 1)));
        }
    }
}

void add_blocks_and_records(Seeds& seeds) {
    const ObbTree a = tests::make_tree(tests::make_torus(1.0, 0.4, 8, 6));
    const ObbTree b = tests::make_tree(tests::make_sphere(1));
    add_shots(seeds, a);
    add_motions(seeds, a, b);
    for (const std::uint32_t depth : {0u, 2u}) {
        const std::uint32_t root = cut_nodes(a, depth).front();
        const std::string name = "depth_" + std::to_string(depth);
        const Bytes wide = encode_subtree(extract_subtree(a, root, SubtreeForm::Wide));
        const Bytes binary = encode_subtree(extract_subtree(a, root));
        const Bytes top = encode_top(cut_tree(a, depth));
        seeds.add("block", "wide_" + name, wide);
        seeds.add("block", "binary_" + name, binary);
        seeds.add("top", name, top);
        const auto sent = [](std::uint8_t mark, const Bytes& block) {
            return marked(mark, compress(block, compression_level_geometry));
        };
        seeds.add("sent_block", "wide_" + name, sent(0, wide));
        seeds.add("sent_block", "binary_" + name, sent(0, binary));
        seeds.add("sent_block", "top_" + name, sent(1, top));
    }
    ByteWriter records;
    ByteWriter segment;
    for (const AskedScenario& asked : asked_scenarios()) {
        const Bytes record = encode_result(run_scenario(a, b, asked.scenario, asked.query).result);
        seeds.add("result", asked.name, record);
        records.put(static_cast<std::uint32_t>(record.size()));
        put_bytes(records, record);
        segment.put(std::uint64_t{record.size()});
        segment.put(asked.scenario.index);
        put_bytes(segment, record);
        segment.put(record_footer(asked.scenario.index, record));
    }
    const Bytes packed = pack_records(records.bytes());
    seeds.add("packed", "records", marked(0, packed));
    seeds.add("packed", "columns", marked(1, columns_of(packed)));
    ContactMap map;
    map.bodies = {{{{1, 1}, {5, 300}}, {{0, 2}}}};
    map.parts.parts = {{{{0, 300}}, {{0, 2}, {3, 299}}}};
    map.parts.pairs = {{0, 0, 2, 2, 17, 1, 17, 19, true}, {0, 3, 299, 1000, 400, 9, 0, 400, false}};
    seeds.add("map", "of_two_bodies", decompress(pack_map(map), 100).value());
    seeds.add("map", "compressed", pack_map(map));
    map.parts.pairs.back().near = 77;
    map.parts.pairs.back().worst_near = 70;
    seeds.add("map", "with_near_pairs", decompress(pack_map(map), 100).value());
    seeds.add("segment", "records", marked(0, segment.bytes()));
    seeds.add("segment", "summed_up", marked(1, segment.bytes()));
}

void add_rows(Seeds& seeds) {
    const auto add = [&](std::uint8_t kind, const std::string& name, const Bytes& row) {
        seeds.add("journal_row", name, marked(kind, row));
    };
    for (const Message& message : tests::sample_messages()) {
        if (const auto* submit = std::get_if<Submit>(&message)) {
            add(0, "job", encode_job({JobId{3}, *submit}));
        }
    }
    JobProgress progress;
    progress.seconds = 1.5;
    add(1, "progress", encode_progress(progress));
    add(2, "end", encode_end({JobState::Failed, "why", tests::some_hash(3)}));
    ResultGroup group;
    group.begin = 100;
    group.rows = {{4, 20, {}}, {9, 300, {}}};
    group.rows.back().facts.kind = ScenarioClass::Near;
    group.rows.back().facts.near_count = 1000;
    group.authors = {{1, 7}, {1, 0}};
    group.remarks = {{Remark::Kind::Disputed, 4, tests::some_hash(3), 8},
                     {Remark::Kind::Settled, 4, tests::some_hash(3), 8},
                     {Remark::Kind::Withdrawn, 0, {}, 9}};
    add(3, "group", encode_group(group));
    add(4, "alarms", encode_alarms({2, {"results differ"}, {7, 8}}));

    Grid grid;
    grid.position = {GridAxis{0, 1, 3}, GridAxis{-1, 1, 2}, GridAxis{}};
    for (int axis = 0; axis < 3; ++axis) {
        grid.rotation[static_cast<std::size_t>(axis)] = rotation_axis({0, 90, 2}, axis);
    }
    seeds.add("grid", "grid", encode_grid(grid));

    const Pose moved = Pose::from_matrix(Mat3::Identity(), {1, 2, 3});
    const Pose turned = Pose::from_quaternion({1, 2, 3, 4}, {1, 2, 3});
    Mat3 quarter;
    quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    const Pose by_matrix = Pose::from_matrix(quarter, {1, 2, 3});
    std::vector<Scenario> scenarios;
    for (const Pose& a : {Pose{}, moved, turned, by_matrix}) {
        for (const std::uint64_t index : {0, 1, 2, 9}) {
            scenarios.push_back({index, 0, 1, {a, index == 2 ? turned : moved}});
        }
    }
    seeds.add("scenarios", "mixed", pack_scenarios(scenarios));
    seeds.add(
        "scenarios", "identities", pack_scenarios(std::vector<Scenario>(5, Scenario{0, 0, 1, {}})));
}

constexpr std::string_view job_text = R"(name = "van"
unit = "mm"
level = "contacts"
limit_pairs = 10
[a]
path = "van.glb"
[b]
path = "bollard.stl"
unit = "in"
name = "bollard"
[poses]
file = "poses.csv"
quat_order = "wxyz"
[[ignore]]
a = "wheel_*"
b = "ground"
[output]
dir = "results"
formats = ["csv", "npz"]
[cluster]
strategy = "lowest"
depth = [10, 4]
q = 7
)";
constexpr std::string_view grid_job_text = R"([a]
path = "a.obj"
[b]
path = "b.obj"
[poses.grid]
x = [0, 1, 3]
yaw = [0, 90, 2]
)";
constexpr std::string_view distance_job_text = R"([a]
mesh = "a.obj"
[b]
mesh = "b.obj"
[poses]
random = { n = 10 }
[query]
level = "distance"
up_to = 2.5
)";

constexpr std::string_view shots_job_text = R"([a]
mesh = "a.obj"
[shots]
spacing = 0.25
tile = 16
offset = [0.25, 0.5]
azimuth_deg = [0, 270, 4]
elevation_deg = [-30, 90, 5]
first = true
[query]
level = "count"
maps = true
)";

constexpr std::string_view motion_job_text = R"([a]
mesh = "a.obj"
[b]
mesh = "b.obj"
[poses]
drive = [ { start = [0, 0, 0], velocity = [12, 0, 0], seconds = 2 }, { spin_deg = [0, 0, 9], seconds = 1 } ]
[motion]
resolution = 0.5
until = "free"
chord = 0.25
[query]
level = "any"
)";

void add_files(Seeds& seeds) {
    seeds.add("job_file", "motion", motion_job_text);
    seeds.add("job_file", "all", job_text);
    seeds.add("job_file", "grid", grid_job_text);
    seeds.add("job_file", "distance", distance_job_text);
    seeds.add("job_file", "shots", shots_job_text);
    seeds.add("csv_poses",
              "quaternions",
              "\0x,y,z,qx,qy,qz,qw,id\n# c\n1,2,3,0,0,0,1,7\n1e-3,-2,3,0,0.6,0,0.8,8\n"sv);
    seeds.add("csv_poses", "angles", "\0x,y,z,roll_rad,pitch_deg,yaw_deg\n1,2,3,0,90,-45.5\n"sv);
    seeds.add("csv_poses",
              "both",
              "\1scenario,body,x,y,z,qx,qy,qz,qw\n0,a,0,0,0,0,0,0,1\n0,b,1,0,0,0,0,0,1\n"sv);
    seeds.add("csv_poses",
              "matrices",
              "\0m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n1,0,0,5,0,1,0,6,0,0,1,7\n"sv);
    seeds.add(
        "fcd",
        "xml",
        "\0<fcd-export>\n<!-- c --><timestep time=\"0.00\">\n<vehicle id=\"a&amp;b\" x=\"1.5\" "
        "y=\"-2\" z=\"3\" angle=\"81.83\" type=\"passenger\" slope=\"1\"/><person id=\"p\"/>"
        "</timestep>\n<timestep time=\"0.20\"/></fcd-export>\n"sv);
    seeds.add("fcd",
              "csv",
              "\1timestep_time;vehicle_angle;vehicle_id;vehicle_type;vehicle_x;vehicle_y\n"
              "0.00;81.83;a;passenger;1;2\n0.20;;;;;\n0.40;270;a;passenger;1;2\n"sv);
    seeds.add("tum_poses", "tum", "# t x y z\n0.5 1 2 3 0 0 0 1\n1.5 1 2 3 0 0.6 0 0.8\n");
    const std::array<double, 12> pose{1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7};
    const std::array<std::uint64_t, 3> shape{1, 3, 4};
    Bytes array = make_npy_header(NpyType::F8, shape);
    const auto data = std::as_bytes(std::span(pose));
    array.insert(array.end(), data.begin(), data.end());
    seeds.add("npy", "matrix", array);
    const tests::TemporaryFolder folder;
    NpzWriter writer(folder / "poses.npz");
    const auto array_of_poses = writer.add_array({"poses", NpyType::F8, 12});
    need(writer.append<double>(array_of_poses, pose) && writer.finish());
    seeds.add("npz", "poses", read_file(folder / "poses.npz"));
}

/// Returns the bytes between the lines of a PEM text.
Bytes der_of(const std::string& pem) {
    Bytes bytes(pem.size());
    const std::size_t begin = pem.find('\n') + 1;
    std::string letters = pem.substr(begin, pem.find("-----END") - begin);
    std::erase(letters, '\n');
    auto* const out = reinterpret_cast<unsigned char*>(bytes.data());
    const int size = EVP_DecodeBlock(out,
                                     reinterpret_cast<const unsigned char*>(letters.data()),
                                     static_cast<int>(letters.size()));
    bytes.resize(static_cast<std::size_t>(size) -
                 static_cast<std::size_t>(std::ranges::count(letters, '=')));
    return bytes;
}

void add_certificates(Seeds& seeds) {
    const WallTime now{std::chrono::hours(24 * 365 * 50)};
    const auto authority = CertificateAuthority::make(now);
    const auto add =
        [&](const std::string& target, const std::string& name, const std::string& pem) {
            seeds.add(target, name + "_pem", marked(0, bytes_of(pem)));
            seeds.add(target, name + "_der", marked(1, der_of(pem)));
        };
    const Identity identity{CertifiedRole::Admin, "ada", now, now + std::chrono::hours(1)};
    add("certificate", "authority", authority.certificate());
    add("certificate", "admin", authority.issue(identity).certificate);
    add("certificate_request", "request", make_certificate_request().request);
}

constexpr std::string_view ac3d_text = R"(AC3Db
OBJECT world
kids 1
OBJECT poly
loc 0 0 1
numvert 3
0 0 0
1 0 0
0 1 0
numsurf 1
SURF 0x10
refs 3
0 0 0
1 0 0
2 0 0
kids 0
)";
constexpr std::string_view collada_text =
    R"(<?xml version="1.0"?><COLLADA><asset><unit meter="1"/></asset>
<library_geometries><geometry><mesh><source id="s"><float_array id="f" count="9">0 0 0 1 0 0 0 1 0</float_array>
<technique_common><accessor source="#f" count="3" stride="3"><param name="X"/><param/><param/></accessor>
</technique_common></source><triangles count="1"><input offset="0" source="#v"/><p>0 1 2</p></triangles></mesh>
</geometry></library_geometries><node><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix></node></COLLADA>
)";

void add_meshes(Seeds& seeds) {
    seeds.add("mesh_text", "ac3d", marked(0, bytes_of(ac3d_text))); // The formats' numbers.
    seeds.add("mesh_text", "collada", marked(1, bytes_of(collada_text)));
    const auto add = [&](const std::string& target, const std::string& name, std::string text) {
        seeds.add(target, name, bytes_of(text));
    };
    add("obj",
        "parts",
        "o a b\nv 0 0 0\nv 1 0 0 1\nv 0 1 -0.5e1 # c\nv 1 1 0 1 0 0\ng c\nusemtl m\nf 1/1 2//1 "
        "\\\n-1\nf 1 2 4 3\nf 1 2 3 4 2\nl 1 2\np 1\n");
    add("off",
        "colours",
        "COFF # c\n4 2 0\n0 0 0 1 1 1 1\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n3 0 1 2\n");
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 "
                              "0\nvertex 0 1 0\nendloop\nendfacet\n";
    add("stl", "text", "solid s t\n" + facet + "endsolid\nSOLID\n" + facet + "endsolid");
    std::string binary = "solid s";
    binary.resize(80, ' ');
    binary += std::string("\1\0\0\0", 4) + std::string(50, '\0') + "end";
    add("stl", "binary", binary);
    const std::string vertices =
        "element vertex 3\nproperty uchar x\nproperty uchar y\nproperty uchar z\n";
    const std::string faces = "element face 1\nproperty list uchar int8 vertex_indices\n";
    const std::string strips = "element tristrips 1\nproperty list uchar int8 vertex_indices\n";
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string bytes("\0\0\0\1\0\0\0\1\0\3\0\1\2", 13);
    add("ply",
        "text",
        "ply\nformat ascii 1.0\n" + vertices + faces + "end_header\n" + points + "3 0 1 2\n");
    add("ply",
        "strips",
        "ply\nformat ascii 1.0\ncomment c\n" + vertices + strips +
            "element e 1\nproperty list int float l\nend_header\n" + points +
            "5 0 1 2 -1 0\n1 nan\n");
    add("ply",
        "little",
        "ply\nformat binary_little_endian 1.0\n" + vertices + faces + "end_header\n" + bytes);
    add("ply",
        "big",
        "ply\nformat binary_big_endian 1.0\n" + vertices + strips + "end_header\n" + bytes);
}

void add_gltf(Seeds& seeds) {
    using tests::GltfText;
    GltfText plain = GltfText::triangle();
    plain.json["nodes"] = {{{"children", {1}}, {"translation", {1, 0, 0}}},
                           {{"mesh", 0}, {"rotation", {0, 0, 1, 1}}}};
    seeds.add("gltf", "text", plain.text());
    seeds.add("gltf", "glb", plain.glb());
    GltfText odd;
    const auto positions =
        odd.add(std::vector<std::int16_t>{0, 0, 0, 9, 0, 0, 0, 9, 0, 9, 9, 0}, 5122, "VEC3", true);
    const auto replaced = odd.add_view<std::uint8_t>({2});
    const auto values = odd.add_view<std::int16_t>({0, 5, 0});
    odd.json["accessors"][positions]["sparse"] = {
        {"count", 1},
        {"indices", {{"bufferView", replaced}, {"componentType", 5121}}},
        {"values", {{"bufferView", values}}}};
    const auto moved = odd.add_positions({0, 0, 0, 1, 0, 0});
    odd.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", moved}};
    odd.primitive() = {{"attributes", {{"POSITION", positions}}}, {"mode", 5}};
    seeds.add("gltf", "sparse_strip_of_instances", odd.glb());
}

/// Adds each input twice: with its own checksums, and for the target to correct them.
void add_both(Seeds& seeds,
              const std::string& target,
              const std::string& name,
              unsigned mark,
              std::span<const std::byte> bytes) {
    seeds.add(target, name, marked(static_cast<std::uint8_t>(mark), bytes));
    seeds.add(target, name + "_summed_up", marked(static_cast<std::uint8_t>(mark + 1), bytes));
}

void add_state(Seeds& seeds) {
    const std::string hash(64, 'a');
    seeds.add("tokens",
              "tokens",
              "cdcluster tokens 2\n5 " + hash + " worker 3 1700000000\n9 " + hash +
                  " admin 1 1800000000\n");

    const tests::TemporaryFolder folder;
    std::vector<Scenario> scenarios;
    for (std::uint64_t i = 0; i < 150; ++i) { // Few of them move, so the file stays small.
        const Pose b = i < 3 ? Pose::from_matrix(Mat3::Identity(), {1, 2, 3}) : Pose();
        scenarios.push_back({i, 0, 1, {Pose(), b}});
    }
    const auto spool = PoseSpool::create(folder / "spool", {scenarios.size(), 2});
    for (const Bytes& run : pack_in_order(scenarios)) {
        need(bool(spool.value()->append(run)));
    }
    need(bool(spool.value()->seal(folder / "spool" / "poses", Durability::Unsynced)));
    ThreadPool pool(1);
    const ObbTree tree = build_tree(sample_mesh(), {}, pool);
    need(write_tree_file(folder / "binary", tree, {}, Durability::Unsynced) &&
         write_wide_tree_file(folder / "wide", tree, {}, Durability::Unsynced));
    Bytes poses = bytes_of(read_file(folder / "spool" / "poses"));
    poses.insert(poses.begin(), static_cast<std::byte>(scenarios.size()));
    add_both(seeds, "pose_spool", "one_run", 0, poses);
    poses.front() = std::byte{149};
    seeds.add("pose_spool", "fewer_than_its_run", marked(1, poses));
    add_both(seeds, "tree_file", "binary", 0, bytes_of(read_file(folder / "binary")));
    add_both(seeds, "tree_file", "wide", 2, bytes_of(read_file(folder / "wide")));
}

void add_folders(Seeds& seeds) {
    const tests::TemporaryFolder folder;
    auto writer = RecordWriter::create(folder / "records");
    need(writer.has_value());
    for (std::uint64_t i = 0; i < 6; ++i) {
        ScenarioResult result;
        result.index = 2 * i;
        if (i % 2 == 1) {
            result.kind = ScenarioClass::Cross;
            result.pairs = {{1, 2, PairClass::Proper}, {1, 3, PairClass::Touch}};
            result.pair_count = 2;
        }
        writer.value().add(result.index, encode_result(result));
        need(i != 2 || writer.value().flush());
    }
    need(writer.value().finish().has_value());
    add_both(seeds, "record_file", "two_blocks", 0, bytes_of(read_file(folder / "records")));

    for (const auto& [name, labels] :
         {std::pair<std::string, PoseLabels>{"integers", {{7, -3}, {}, {}}},
          {"texts_and_times", {{}, {"a, b", "say \"x\"\nand y"}, {0.1, -1e300}}},
          {"times", {{}, {}, {0.25, 2}}}}) {
        need(write_labels(folder / "ids", labels).has_value());
        seeds.add("labels", name, read_file(folder / "ids"));
    }

    RunManifest manifest;
    manifest.name = "car";
    manifest.job = job_text;
    manifest.bodies = {{{sha256({}), "a", "/m/car.obj", "m"}, {"wheel"}},
                       {{sha256({}), "post", "/m/post.stl", "mm", true}}};
    manifest.query.ignored = {IgnoredRange{}};
    manifest.poses.count = 4;
    manifest.poses.kind = PosesKind::Random;
    manifest.poses.random = RandomPoses{4, 1, 0.1, 0.2};
    manifest.files = {{"records", 12}};
    seeds.add("run_json", "random", manifest_json(manifest));
    manifest.query.clearance = 0.005;
    seeds.add("run_json", "clearance", manifest_json(manifest));
    manifest.query.clearance.reset();
    const Query contacts = std::exchange(manifest.query, tests::some_distance_query());
    seeds.add("run_json", "distance", manifest_json(manifest));
    manifest.query = tests::some_shots_query();
    seeds.add("run_json", "shots", manifest_json(manifest));
    manifest.query = tests::some_motion_query();
    seeds.add("run_json", "motion", manifest_json(manifest));
    manifest.query = contacts;
    manifest.poses = {};
    manifest.poses.count = 4;
    manifest.poses.kind = PosesKind::Grid;
    Grid grid;
    grid.position[0] = {0, 1, 2};
    grid.rotation[2] = rotation_axis({0, 90, 2}, 2);
    manifest.poses.grid = grid;
    manifest.poses.hash = sha256({});
    manifest.outcome.digest = sha256({});
    seeds.add("run_json", "grid", manifest_json(manifest));
}

void add_requests(Seeds& seeds) {
    const auto add = [&](std::uint16_t cut, const std::string& name, std::string_view text) {
        ByteWriter out;
        out.put(cut);
        put_bytes(out, bytes_of(text));
        seeds.add("http", name, out.bytes());
    };
    add(9, "metrics", "GET /metrics HTTP/1.1\r\nHost: here\r\nAccept: */*\r\n\r\n");
    add(40,
        "page",
        "GET /api/v1/jobs/j-4f2a/scenarios/next?from=7&step=-1&part_a=a%2Fb HTTP/1.1\r\n"
        "Host: 127.0.0.1\r\nAuthorization: Bearer k\r\n\r\n");
    add(50,
        "classes",
        "HEAD /api/v1/jobs/j-4f2a/classes?first=0&count=65536 HTTP/1.1\r\nHost: [::1]:1\r\n\r\n");
    add(30, "body", "POST / HTTP/1.1\r\nContent-Length: 4\r\n\r\nbody");
    add(3, "chunked", "PUT /x HTTP/1.0\r\nTransfer-Encoding: chunked\r\n\r\n1\r\nx\r\n0\r\n\r\n");
}

} // namespace
} // namespace cd::fuzz

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: fuzz_seeds FOLDER\n";
        return 2;
    }
    cd::fuzz::Seeds seeds(argv[1]);
    cd::fuzz::add_wire(seeds);
    cd::fuzz::add_blocks_and_records(seeds);
    cd::fuzz::add_rows(seeds);
    cd::fuzz::add_files(seeds);
    cd::fuzz::add_state(seeds);
    cd::fuzz::add_meshes(seeds);
    cd::fuzz::add_gltf(seeds);
    cd::fuzz::add_certificates(seeds);
    cd::fuzz::add_requests(seeds);
    cd::fuzz::add_folders(seeds);
    return 0;
}

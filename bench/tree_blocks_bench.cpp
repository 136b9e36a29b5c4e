// Measures meshes on their way to the workers. Cuts the trees of meshes and prints the size of
// their blocks, in either form, and the time to encode a subtree and to decode it for a search.
//
//   tree_blocks_bench MESH... [--depths 12,6] [--rounds 5] [--binary]
//
// Prints a row per mesh and depth: triangles, roots, bytes per triangle before and after
// compression (block by block, as on the wire), compressed bytes per triangle of each column alone,
// ns per triangle to extract, encode, decompress, hash and decode (medians of the rounds, in one
// thread's own time), the decoder's GB/s of block bytes, and bytes per triangle in memory.
#include "bench/accuracy/timing.hpp"
#include "bench/timed_work.hpp"
#include "client/import/mesh_import.hpp"
#include "common/core/check.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/varint.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/cut.hpp"
#include "common/tree/wire/subtree_block.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cd {

namespace {

struct Options {
    std::vector<std::string> meshes;
    std::vector<std::uint32_t> depths{12, 6};
    std::size_t rounds = 5;
    bool is_binary = false;
};

/// Returns the median time of a function over the rounds.
template <class Function>
double median_seconds(std::size_t rounds, const Function& function) {
    std::vector<double> seconds;
    for (std::size_t round = 0; round < rounds; ++round) {
        const double before = bench::processor_seconds();
        function();
        seconds.push_back(bench::processor_seconds() - before);
    }
    return bench::median(std::move(seconds));
}

/// The columns of a wide block (wide_block.hpp), in order.
constexpr std::array<const char*, 7> column_names{
    "header", "nodes", "frames", "corners", "numbers", "vertices", "ids"};
using ColumnSizes = std::array<std::size_t, column_names.size()>;

ColumnSizes columns_of(const Bytes& block, const WideView& wide) {
    ByteReader in(block);
    const unsigned flags = in.get<std::uint16_t>() >> 8;
    (void)get_varint(in);
    const std::size_t vertices = get_varint(in).value();
    ColumnSizes sizes{};
    sizes[0] = block.size() - in.remaining();
    sizes[1] = wide.nodes.size();
    std::size_t triangles = 0;
    for (const WideNode& node : wide.nodes) {
        const bool in_body = node.columns[0][0] == 1 && node.columns[1][1] == 1;
        sizes[2] += in_body ? 0 : 6;
        triangles += node.is_leaf ? node.count : 0;
    }
    sizes[3] = 3 * triangles;
    sizes[4] = (flags >> 1 & 7) * std::size_t{wide.triangles.vertex_begin.back()};
    sizes[5] = vertices * 3 * ((flags & 1) != 0 ? sizeof(double) : sizeof(float));
    sizes[6] = (flags >> 4 & 7) * triangles;
    return sizes;
}

struct Blocks {
    std::vector<Bytes> plain;
    std::vector<Bytes> compressed;
    double bytes = 0;
    double compressed_bytes = 0;
    double memory_bytes = 0;
    std::array<double, column_names.size()> columns{};
    std::array<double, column_names.size()> columns_compressed{};
};

void add_columns(const Bytes& block, const WideView& wide, Blocks& blocks) {
    const ColumnSizes sizes = columns_of(block, wide);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const auto column = std::span(block).subspan(begin, sizes[i]);
        blocks.columns[i] += static_cast<double>(sizes[i]);
        blocks.columns_compressed[i] +=
            static_cast<double>(compress(column, compression_level_geometry).size());
        begin += sizes[i];
    }
}

Blocks encode_all(const std::vector<Subtree>& subtrees) {
    Blocks blocks;
    for (const Subtree& subtree : subtrees) {
        blocks.plain.push_back(encode_subtree(subtree));
        blocks.compressed.push_back(compress(blocks.plain.back(), compression_level_geometry));
        blocks.bytes += static_cast<double>(blocks.plain.back().size());
        blocks.compressed_bytes += static_cast<double>(blocks.compressed.back().size());
        blocks.memory_bytes += static_cast<double>(subtree.memory_bytes());
        if (subtree.form() == SubtreeForm::Wide) {
            add_columns(blocks.plain.back(), subtree.view().wide, blocks);
        }
    }
    return blocks;
}

void print_row(const std::string& name,
               const ObbTree& tree,
               std::uint32_t depth,
               const Options& options) {
    const SubtreeForm form = options.is_binary ? SubtreeForm::Binary : SubtreeForm::Wide;
    const std::vector<std::uint32_t> nodes = cut_nodes(tree, depth);
    std::vector<Subtree> subtrees;
    const double extract = median_seconds(options.rounds, [&] {
        subtrees.clear();
        for (const std::uint32_t node : nodes) {
            subtrees.push_back(extract_subtree(tree, node, form));
        }
    });
    const double encode = median_seconds(options.rounds, [&] {
        for (const Subtree& subtree : subtrees) {
            static_cast<void>(encode_subtree(subtree));
        }
    });
    const Blocks blocks = encode_all(subtrees);
    const double unpack = median_seconds(options.rounds, [&] {
        for (const Bytes& block : blocks.compressed) {
            static_cast<void>(decompress(block, limits::subtree_block_bytes_max));
        }
    });
    const double hash = median_seconds(options.rounds, [&] {
        for (const Bytes& block : blocks.plain) {
            static_cast<void>(sha256(block));
        }
    });
    const double decode = median_seconds(options.rounds, [&] {
        for (const Bytes& block : blocks.plain) {
            CD_CHECK(decode_subtree(block));
        }
    });
    const auto triangles = static_cast<double>(tree.mesh().triangles().size());
    std::printf("| %s | %u | %.0f | %zu | %.2f | %.2f |",
                name.c_str(),
                depth,
                triangles,
                nodes.size(),
                blocks.bytes / triangles,
                blocks.compressed_bytes / triangles);
    for (std::size_t i = 0; i < column_names.size() && !options.is_binary; ++i) {
        std::printf(" %.2f / %.2f |",
                    blocks.columns[i] / triangles,
                    blocks.columns_compressed[i] / triangles);
    }
    for (const double seconds : {extract, encode, unpack, hash, decode}) {
        std::printf(" %.1f |", 1e9 * seconds / triangles);
    }
    std::printf(" %.2f | %.1f |\n", 1e-9 * blocks.bytes / decode, blocks.memory_bytes / triangles);
    std::fflush(stdout);
}

void print_head(const Options& options) {
    std::printf("| mesh | depth | triangles | roots | B/t | zstd |");
    for (std::size_t i = 0; i < column_names.size() && !options.is_binary; ++i) {
        std::printf(" %s |", column_names[i]);
    }
    std::printf(" extract ns/t | encode | decompress | hash | decode | GB/s | memory B/t |\n");
}

bool run(const Options& options) {
    ThreadPool pool(1);
    BuildOptions rule;
    rule.prepare_search = false;
    print_head(options);
    for (const std::string& path : options.meshes) {
        const Result<ImportedMesh> imported = import_mesh(path, {});
        if (!imported) {
            std::fprintf(stderr, "%s\n", imported.error().detail.c_str());
            return false;
        }
        const ObbTree tree = build_tree(imported.value().mesh, rule, pool);
        for (const std::uint32_t depth : options.depths) {
            print_row(std::filesystem::path(path).stem().string(), tree, depth, options);
        }
    }
    return true;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    cd::Options options;
    CLI::App app("Measures subtree blocks.");
    app.add_option("meshes", options.meshes, "mesh files")->required();
    app.add_option("--depths", options.depths, "distribution depths")->delimiter(',');
    app.add_option("--rounds", options.rounds, "of each measurement")->check(CLI::PositiveNumber);
    app.add_flag("--binary", options.is_binary, "the form of bodies that a wide tree cannot hold");
    CLI11_PARSE(app, argc, argv);
    return cd::run(options) ? 0 : 1;
}

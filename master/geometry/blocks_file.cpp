#include "master/geometry/blocks_file.hpp"

#include "common/core/check.hpp"
#include "common/core/files/checked_file.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/tree/tree_file.hpp"
#include "common/tree/wire/subtree_block.hpp"

#include <algorithm>

namespace cd {

namespace {

constexpr std::uint64_t magic = 0x31'4b'4c'42'54'44'43'00; // "\0CDTBLK1"
constexpr std::uint32_t format_version = 2;
constexpr std::size_t place_bytes = 3 * sizeof(std::uint64_t) + 32 + sizeof(std::uint64_t);
constexpr std::size_t header_bytes = sizeof magic + sizeof format_version + 32 +
                                     sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t) +
                                     sizeof(SubtreeForm);

/// Number of subtrees that are encoded before they are written; bounds the memory.
constexpr std::size_t roots_at_once_per_thread = 16;

/// Encodes the header, the index, and the checksum of both.
Bytes encode_index(const ObbTree& tree,
                   std::uint32_t depth,
                   SubtreeForm form,
                   const std::vector<BlockEntry>& places) {
    ByteWriter out;
    out.put(magic);
    out.put(format_version);
    put_hash(out, tree.mesh().hash());
    out.put(tree_checksum(tree));
    out.put(depth);
    out.put(static_cast<std::uint8_t>(form));
    out.put(static_cast<std::uint32_t>(places.size()));
    for (const BlockEntry& place : places) {
        out.put(place.offset);
        out.put(place.compressed_bytes);
        out.put(place.bytes);
        put_hash(out, place.hash);
        out.put(place.checksum);
    }
    out.put(checksum(out.bytes()));
    return out.take();
}

std::size_t index_bytes(std::size_t roots) {
    return header_bytes + roots * place_bytes + sizeof(std::uint64_t);
}

BlockEntry get_place(ByteReader& in) {
    BlockEntry place;
    place.offset = in.get<std::uint64_t>();
    place.compressed_bytes = in.get<std::uint64_t>();
    place.bytes = in.get<std::uint64_t>();
    place.hash = get_hash(in);
    place.checksum = in.get<std::uint64_t>();
    return place;
}

/// One encoded block with its index entry, in which the offset is not set yet.
struct EncodedBlock {
    Bytes compressed;
    BlockEntry place;
};

EncodedBlock encode_block(const ObbTree& tree, std::uint32_t node, SubtreeForm form) {
    const Bytes bytes = encode_subtree(extract_subtree(tree, node, form));
    EncodedBlock block;
    block.compressed = compress(bytes, compression_level_geometry);
    block.place.compressed_bytes = block.compressed.size();
    block.place.bytes = bytes.size();
    block.place.hash = sha256(bytes);
    block.place.checksum = checksum(block.compressed);
    return block;
}

} // namespace

Status write_blocks_file(const std::filesystem::path& path,
                         const ObbTree& tree,
                         std::uint32_t depth,
                         SubtreeForm form,
                         ThreadPool* pool) {
    Result<DiskFile> file = DiskFile::create_for(path);
    if (!file) {
        return file.error();
    }
    const std::vector<std::uint32_t> roots = cut_nodes(tree, depth);
    std::vector<BlockEntry> places(roots.size());
    std::uint64_t offset = index_bytes(roots.size());
    const std::size_t step = roots_at_once_per_thread * (pool == nullptr ? 1 : pool->size());
    for (std::size_t begin = 0; begin < roots.size(); begin += step) {
        std::vector<EncodedBlock> blocks(std::min(step, roots.size() - begin));
        parallel_for(pool, blocks.size(), [&](std::size_t i) {
            blocks[i] = encode_block(tree, roots[begin + i], form);
        });
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            BlockEntry& place = places[begin + i] = blocks[i].place;
            if (place.bytes > limits::subtree_block_bytes_max) {
                return Error{ErrorCode::TooLarge,
                             "a subtree of " + std::to_string(place.bytes) +
                                 " bytes; choose a greater distribution depth"};
            }
            place.offset = offset;
            const Status status = file.value().write_at(offset, blocks[i].compressed);
            if (!status) {
                return status.error();
            }
            offset += place.compressed_bytes;
        }
    }
    const Bytes index = encode_index(tree, depth, form, places);
    CD_CHECK(index.size() == index_bytes(roots.size()));
    if (const Status status = file.value().write_at(0, index); !status) {
        return status.error();
    }
    return file.value().commit();
}

namespace {

struct WholeFile {
    BlocksFile blocks;
    Bytes index;
};

/// Reads the file and checks all that can be checked without the tree.
Result<WholeFile> read_whole(const std::filesystem::path& path) {
    Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return file.error();
    }
    const Error damaged{ErrorCode::Io, path.string() + " is damaged"};
    const Result<Bytes> header = file.value().read_at(0, header_bytes);
    if (!header) {
        return header.error();
    }
    const auto roots =
        ByteReader(std::span(header.value()).last(sizeof(std::uint32_t))).get<std::uint32_t>();
    Result<Bytes> index = file.value().read_at(0, index_bytes(roots));
    if (!index) {
        return index.error();
    }
    const auto content = std::span(index.value()).first(index.value().size() - sizeof magic);
    ByteReader footer(std::span(index.value()).last(sizeof magic));
    if (ByteReader(content).get<std::uint64_t>() != magic ||
        footer.get<std::uint64_t>() != checksum(content)) {
        return damaged;
    }
    ByteReader in(content);
    (void)in.get_array<std::uint8_t>(header_bytes);
    WholeFile whole{{std::move(file.value()), {}}, std::move(index.value())};
    std::uint64_t end = whole.index.size();
    for (std::uint32_t root = 0; root < roots; ++root) {
        const BlockEntry place = get_place(in);
        if (place.offset != end || place.compressed_bytes > limits::subtree_block_bytes_max) {
            return damaged;
        }
        end += place.compressed_bytes;
        whole.blocks.places.push_back(place);
    }
    const Result<std::uint64_t> size = whole.blocks.file.size();
    if (!size || size.value() != end) {
        return damaged;
    }
    for (std::uint32_t root = 0; root < roots; ++root) {
        if (const Result<Bytes> block = read_block(whole.blocks, root); !block) {
            return block.error();
        }
    }
    return whole;
}

} // namespace

Status check_blocks_file(const std::filesystem::path& path) {
    const Result<WholeFile> whole = read_whole(path);
    return whole ? Status(Done{}) : Status(whole.error());
}

Result<BlocksFile> open_blocks_file(const std::filesystem::path& path,
                                    const ObbTree& tree,
                                    std::uint32_t depth,
                                    SubtreeForm form) {
    Result<WholeFile> whole = read_whole(path);
    if (!whole) {
        return whole.error();
    }
    // Tree, depth, form and index entries determine the header and the index.
    BlocksFile& blocks = whole.value().blocks;
    if (blocks.places.size() != cut_nodes(tree, depth).size() ||
        encode_index(tree, depth, form, blocks.places) != whole.value().index) {
        return Error{ErrorCode::Io, path.string() + " is damaged, or was made of another tree"};
    }
    return std::move(blocks);
}

Bytes make_block(const ObbTree& tree, std::uint32_t depth, SubtreeForm form, RootIndex root) {
    return encode_block(tree, cut_nodes(tree, depth)[root], form).compressed;
}

Result<Bytes> read_block(const BlocksFile& blocks, RootIndex root) {
    const BlockEntry& place = blocks.places[root];
    Result<Bytes> bytes = blocks.file.read_at(place.offset, place.compressed_bytes);
    if (bytes && checksum(bytes.value()) != place.checksum) {
        return Error{ErrorCode::Io,
                     blocks.file.path().string() + " is damaged: the block of root " +
                         std::to_string(root) + " has a wrong checksum"};
    }
    return bytes;
}

} // namespace cd

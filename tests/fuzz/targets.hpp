// Fuzz targets: readers of untrusted bytes. Each target returns after an error or after checking
// that its encoder writes the input; it ends the program if a promise is broken.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace cd::fuzz {

using Input = std::span<const std::byte>;

// Wire messages.
void frames(Input input);  ///< A stream of frames and their messages.
void message(Input input); ///< A message's type (two bytes), then its payload.
void token(Input input);   ///< A join token as text.
void mesh(Input input);    ///< A mesh in its canonical form.
/// A peer's certificate: DER if the first byte is odd, else PEM.
void certificate(Input input);
void certificate_request(Input input); ///< DER if the first byte is odd, else PEM.
/// Position at which to split the request (two bytes), then the request.
void http(Input input);

// Blocks and records. Compression and checksums would expose every change at once; so an odd first
// byte makes the target compress, or compute the checksums of, the rest.
void block(Input input);       ///< A subtree's block.
void top(Input input);         ///< The block of an upper tree.
void sent_block(Input input);  ///< An upper tree if the first byte is odd; then the compressed
                               ///< block.
void result(Input input);      ///< A scenario's record.
void packed(Input input);      ///< Odd or even, then records in wire form.
void map(Input input);         ///< A contact map, read as unpacked and as packed.
void journal_row(Input input); ///< Kind of row (a byte), then its bytes.
void segment(Input input);     ///< Odd or even, then a job's results without header.
void grid(Input input);        ///< A grid of poses.
void scenarios(Input input);   ///< Poses one by one, in wire form.

// User files.
void job_file(Input input);
void csv_poses(Input input); ///< Odd first byte: poses of both bodies; then the text.
void tum_poses(Input input);
void fcd(Input input); ///< Odd first byte: traffic of SUMO as CSV, else as XML; then the text.
void npy(Input input);
void npz(Input input);
void gltf(Input input); ///< A glTF file or a GLB.
void stl(Input input);
void obj(Input input);
void ply(Input input);
void off(Input input);
void mesh_text(Input input); ///< Format (a byte), then a mesh file.

// Files of our own programs.
void tokens(Input input);     ///< A master's tokens as text.
void pose_spool(Input input); ///< Odd or even, number of scenarios (a byte), then a job's poses.
void tree_file(Input input);  ///< Odd or even, next bit: wide; a tree of `sample_mesh`.

// Results folders.
void record_file(Input input); ///< Odd or even, then a record file.
void run_json(Input input);
void labels(Input input); ///< The file `inputs/ids`.

struct Target {
    std::string_view name; ///< Name of the function and of its corpus folder.
    void (*run)(Input);
};
[[nodiscard]] std::span<const Target> targets();

} // namespace cd::fuzz

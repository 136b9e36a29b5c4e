// What takes bytes from strangers, for a fuzzer to feed: each target ends with an error or with
// what its encoder would have written, and ends the program where a promise is broken.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

namespace cd::fuzz {

using Input = std::span<const std::byte>;

// The wire.
void frames(Input input);  ///< A stream of frames, and the messages that it holds.
void message(Input input); ///< A message's type (two bytes), then its payload.
void token(Input input);   ///< A token to join with, as text.
void mesh(Input input);    ///< A mesh in its canonical form.
/// What one end of a connection shows: in DER where the first byte is odd, else in PEM.
void certificate(Input input);
void certificate_request(Input input); ///< The same.
/// Where the bytes of a request are cut in two (two bytes), then the request.
void http(Input input);

// Blocks and records. Where bytes are compressed or behind checksums, changes of them are found
// before they do anything; so an odd first byte has the target compress, or sum up, what follows.
void block(Input input);       ///< A subtree's block.
void top(Input input);         ///< The block of a tree's top.
void sent_block(Input input);  ///< Of a top where the first byte is odd; then it, compressed.
void result(Input input);      ///< A scenario's record.
void packed(Input input);      ///< Odd or even, then records as they travel.
void map(Input input);         ///< A map of contacts, before it is compressed, and as if after.
void journal_row(Input input); ///< Which kind of row (a byte), then its bytes.
void segment(Input input);     ///< Odd or even, then what follows the header of a job's results.
void grid(Input input);        ///< A grid of poses.
void scenarios(Input input);   ///< Poses, one by one, as they travel.

// Files of users.
void job_file(Input input);
void csv_poses(Input input); ///< Poses of both bodies where the first byte is odd, then the text.
void tum_poses(Input input);
void npy(Input input);
void npz(Input input);
void gltf(Input input); ///< A glTF file or a GLB.
void stl(Input input);
void obj(Input input);
void ply(Input input);
void off(Input input);
void mesh_text(Input input); ///< Which format (a byte), then a mesh's file.

// Files of our programs.
void tokens(Input input);     ///< A master's tokens, as text.
void pose_spool(Input input); ///< Odd or even, how many scenarios (a byte), then a job's poses.
void tree_file(Input input);  ///< Odd or even, wide where its next bit is set; of `sample_mesh`.

// Results folders.
void record_file(Input input); ///< Odd or even, then a file of records.
void run_json(Input input);

struct Target {
    std::string_view name; ///< That of the function, and of its folder in the corpus.
    void (*run)(Input);
};
[[nodiscard]] std::span<const Target> targets();

} // namespace cd::fuzz

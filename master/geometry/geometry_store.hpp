// Keeps meshes, their trees and their encoded blocks on disk, and makes trees and blocks only once.
#pragma once

#include "common/core/files/hash.hpp"
#include "common/core/host/thread_pool.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/core/result.hpp"
#include "common/tree/obb_tree.hpp"
#include "master/geometry/cut_geometry.hpp"
#include "master/geometry/mesh_hold.hpp"
#include "master/geometry/mesh_upload.hpp"
#include "proto/messages/client_messages.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cd {

/// A value from the geometry store, or an error.
template <class T>
class [[nodiscard]] StoreResult : public Result<T> {
  public:
    using Result<T>::Result;
    StoreResult(Result<T> result) : Result<T>(std::move(result)) {}
    /// Makes a result without a value, because the disk failed.
    [[nodiscard]] static StoreResult unwritten(Error why) {
        StoreResult result(std::move(why));
        result.is_unwritten_ = true;
        return result;
    }

    /// True if only the disk prevented the value: the caller may retry later.
    [[nodiscard]] bool is_unwritten() const { return is_unwritten_; }

  private:
    bool is_unwritten_ = false;
};

/// The geometry in the folders `meshes`, `trees` and `blocks` of the state directory. Any thread
/// may call any member. `finish_upload`, `tree` and `cut` may take seconds: they build and encode
/// on the pool, so functions on that pool must not call them. Concurrent callers of one value wait
/// for a single computation. All other members take at most one file operation. Damaged files are
/// never deleted. A damaged tree or blocks file is logged, renamed and made again. A mesh cannot be
/// made again, so a damaged mesh is an error that names the file.
class GeometryStore {
  public:
    /// Makes missing directories, and locks the state against other processes. Errors: Io.
    [[nodiscard]] static Result<std::unique_ptr<GeometryStore>>
    open(const std::filesystem::path& directory,
         ThreadPool& pool,
         std::size_t meshes_max = limits::meshes_max);
    GeometryStore(const GeometryStore&) = delete;
    GeometryStore& operator=(const GeometryStore&) = delete;
    ~GeometryStore();

    [[nodiscard]] bool has(const Sha256& mesh) const;
    /// Returns the meshes that are not stored, in the given order, each once.
    [[nodiscard]] std::vector<Sha256> missing(std::span<const Sha256> meshes) const;

    /// Starts the upload of a mesh. `name` is shown to people and is kept with the mesh. Errors:
    /// TooLarge over `limits::mesh_bytes_max`, with `limits::mesh_uploads_max` open uploads, or
    /// with the maximum number of stored meshes; Io.
    [[nodiscard]] Result<std::unique_ptr<MeshUpload>>
    begin_upload(const Sha256& mesh, const std::string& name, std::uint64_t bytes_total);

    /// Checks the hash of the bytes, validates the mesh, builds the tree, and stores both. Does
    /// nothing for a stored mesh. Errors: BadInput for an incomplete upload, a wrong hash, or an
    /// invalid mesh; TooLarge with the maximum number of stored meshes; Io.
    [[nodiscard]] Status finish_upload(std::unique_ptr<MeshUpload> upload);

    /// Returns the tree, from memory or from disk, or builds it. A new tree is returned even if it
    /// cannot be written. Also finds a mesh that a person put into the folder. Errors: NotFound
    /// naming the missing file; Io naming a file that is damaged or unreadable.
    [[nodiscard]] Result<std::shared_ptr<const ObbTree>> tree(const Sha256& mesh);

    /// Returns the tree cut at `depth`, and encodes its blocks unless they are on disk. Form Wide
    /// requires `suits_wide_tree`. Errors: as `tree`; TooLarge for a depth over
    /// `limits::distribution_depth_max`; Io if the blocks cannot be written.
    [[nodiscard]] StoreResult<std::shared_ptr<const CutGeometry>>
    cut(const Sha256& mesh, std::uint32_t depth, SubtreeForm form = SubtreeForm::Wide);

    /// Reads at most `bytes_max` canonical bytes of a mesh from `offset` on. Errors: NotFound;
    /// BadInput for an offset at or past the end; Io.
    [[nodiscard]] Result<MeshBytes>
    read(const Sha256& mesh, std::uint64_t offset, std::uint64_t bytes_max) const;

    /// Returns an object that prevents the removal of these meshes, stored or not, while it exists.
    [[nodiscard]] std::shared_ptr<const MeshHold> hold(std::vector<Sha256> meshes);
    /// Deletes the mesh, its tree and its blocks. Returns the freed bytes. Errors: NotFound;
    /// Refused while it is held; Io.
    [[nodiscard]] Result<std::uint64_t> remove(const Sha256& mesh);

    /// Returns all stored meshes in the order of their hashes.
    [[nodiscard]] std::vector<MeshStatus> meshes() const;

  private:
    struct State;
    explicit GeometryStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd

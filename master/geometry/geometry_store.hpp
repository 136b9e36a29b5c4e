// Keeps meshes, their trees and their encoded subtrees on disk. Makes each only once.
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

/// A value of the store, or the reason why there is none.
template <class T>
class [[nodiscard]] StoreResult : public Result<T> {
  public:
    using Result<T>::Result;
    StoreResult(Result<T> result) : Result<T>(std::move(result)) {}
    /// Returns a failure to write to the disk.
    [[nodiscard]] static StoreResult unwritten(Error why) {
        StoreResult result(std::move(why));
        result.is_unwritten_ = true;
        return result;
    }

    /// The value was made but not written; the caller may retry when the disk has room.
    [[nodiscard]] bool is_unwritten() const { return is_unwritten_; }

  private:
    bool is_unwritten_ = false;
};

/// The geometry under `<state>/meshes`, `trees` and `blocks`. Any thread may call any member.
/// `finish_upload`, `tree` and `cut` may take seconds: they read, build and encode on the pool, so
/// functions on that pool must not call them. Concurrent callers of one value wait for a single
/// computation. All other members return within a file operation. Damaged files are never deleted.
/// A damaged tree or blocks file is logged, renamed and made again. A mesh cannot be made again, so
/// a damaged one is an error that names the file.
class GeometryStore {
  public:
    /// Makes missing directories and locks them against other processes. Errors: Io.
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

    /// `name` is for people and is kept with the mesh. Errors: TooLarge over
    /// `limits::mesh_bytes_max`, with `limits::mesh_uploads_max` open uploads, or with the maximum
    /// of stored meshes; Io.
    [[nodiscard]] Result<std::unique_ptr<MeshUpload>>
    begin_upload(const Sha256& mesh, const std::string& name, std::uint64_t bytes_total);

    /// Checks the bytes against their hash, validates the mesh, builds the tree, and keeps both.
    /// Does nothing for a stored mesh. Errors: BadInput when incomplete, of another hash, or no
    /// valid mesh; Io.
    [[nodiscard]] Status finish_upload(std::unique_ptr<MeshUpload> upload);

    /// Returns the tree from memory, from disk, or newly built, even if it then cannot be written.
    /// Also finds a mesh that a person put into the folder. Errors: NotFound naming the missing
    /// file; Io naming a file that is damaged or unreadable.
    [[nodiscard]] Result<std::shared_ptr<const ObbTree>> tree(const Sha256& mesh);

    /// Returns the tree cut at `depth`, encoded now or earlier; wide only if it `suits_wide_tree`.
    /// Errors: as `tree`; TooLarge over `limits::distribution_depth_max`; Io when it cannot be
    /// written.
    [[nodiscard]] StoreResult<std::shared_ptr<const CutGeometry>>
    cut(const Sha256& mesh, std::uint32_t depth, SubtreeForm form = SubtreeForm::Wide);

    /// Reads at most `bytes_max` canonical bytes of a mesh from `offset` on. Errors: NotFound;
    /// BadInput for an offset at or past the end; Io.
    [[nodiscard]] Result<MeshBytes>
    read(const Sha256& mesh, std::uint64_t offset, std::uint64_t bytes_max) const;

    /// Returns a hold that keeps these meshes, stored or not, from being removed while it exists.
    [[nodiscard]] std::shared_ptr<const MeshHold> hold(std::vector<Sha256> meshes);
    /// Deletes the mesh, its tree and its blocks. Returns the freed bytes. Errors: NotFound;
    /// Refused while it is held; Io.
    [[nodiscard]] Result<std::uint64_t> remove(const Sha256& mesh);

    /// Returns all stored meshes, by hash.
    [[nodiscard]] std::vector<MeshStatus> meshes() const;

  private:
    struct State;
    explicit GeometryStore(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace cd

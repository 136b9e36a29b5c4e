#include "master/geometry/geometry_store.hpp"

#include "common/core/files/disk_file.hpp"
#include "common/core/host/log.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/tree/build/build.hpp"
#include "common/tree/tree_file.hpp"
#include "master/geometry/blocks_file.hpp"
#include "master/geometry/mesh_file.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <map>
#include <mutex>
#include <set>

namespace cd {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

namespace {

constexpr std::size_t hash_digits = 2 * sizeof(Sha256);

/// One mesh, stored or being stored.
struct Entry {
    std::mutex making; ///< Held while the tree or a cut is made; guards all members below.
    bool stored = false;
    std::weak_ptr<const ObbTree> tree;
    std::map<std::pair<std::uint32_t, SubtreeForm>, std::weak_ptr<const CutGeometry>> cuts;
};

} // namespace

struct GeometryStore::State {
    State(std::filesystem::path where, DiskFile locked, ThreadPool& threads, std::size_t meshes)
        : directory(std::move(where)),
          lock_file(std::move(locked)),
          pool(threads),
          meshes_max(meshes) {}

    std::filesystem::path directory;
    DiskFile lock_file;
    ThreadPool& pool;
    std::size_t meshes_max;
    std::shared_ptr<std::atomic<std::size_t>> open_uploads =
        std::make_shared<std::atomic<std::size_t>>(0);

    std::shared_ptr<MeshUses> uses = std::make_shared<MeshUses>();

    mutable std::mutex mutex; ///< Guards all members below; not held during long work.
    std::map<Sha256, std::shared_ptr<Entry>> entries;
    std::map<Sha256, MeshStatus> statuses; ///< Has exactly the stored meshes.
    /// Keeps recent trees in memory between jobs.
    std::deque<std::shared_ptr<const ObbTree>> recent;

    [[nodiscard]] std::filesystem::path mesh_path(const Sha256& mesh) const {
        return cd::mesh_path(directory, mesh);
    }
    [[nodiscard]] std::filesystem::path info_path(const Sha256& mesh) const {
        return directory / "meshes" / (to_hex(mesh) + ".info");
    }
    [[nodiscard]] std::filesystem::path tree_path(const Sha256& mesh) const {
        return directory / "trees" / (to_hex(mesh) + ".tree");
    }
    [[nodiscard]] std::filesystem::path
    blocks_path(const Sha256& mesh, std::uint32_t depth, SubtreeForm form) const {
        const char* const suffix = form == SubtreeForm::Wide ? "-wide.blocks" : ".blocks";
        return directory / "blocks" / (to_hex(mesh) + "-d" + std::to_string(depth) + suffix);
    }

    void find_meshes();
    void add_stored(const Sha256& mesh);
    void find_mesh(const Sha256& mesh);
    [[nodiscard]] Error missing(const Sha256& mesh) const;
    void remove_orphans() const;
    [[nodiscard]] std::uint64_t remove_files(const Sha256& mesh) const;
    [[nodiscard]] bool has(const Sha256& mesh) const;
    [[nodiscard]] Status check_room(const Sha256& mesh) const;
    [[nodiscard]] std::shared_ptr<Entry> find(const Sha256& mesh) const;
    [[nodiscard]] std::shared_ptr<Entry> find_or_add(const Sha256& mesh);
    void keep(const std::shared_ptr<const ObbTree>& tree);
    Status store(Entry& entry, MeshUpload& upload);
    std::shared_ptr<const ObbTree> build(std::shared_ptr<const Mesh> mesh, double& seconds);
    [[nodiscard]] Status write(const ObbTree& tree) const;
    Result<std::shared_ptr<const ObbTree>> load_tree(Entry& entry, const Sha256& mesh);
    StoreResult<std::shared_ptr<const CutGeometry>>
    load_cut(Entry& entry,
             const std::shared_ptr<const ObbTree>& tree,
             std::uint32_t depth,
             SubtreeForm form);
};

/// Finds the meshes that are on disk, and deletes unfinished files.
void GeometryStore::State::find_meshes() {
    for (const char* folder : {"meshes", "trees", "blocks"}) {
        for (const auto& file : std::filesystem::directory_iterator(directory / folder)) {
            const std::filesystem::path& path = file.path();
            std::error_code ignored;
            if (path.filename().string().find(temporary_marker) != std::string::npos) {
                std::filesystem::remove(path, ignored);
                continue;
            }
            const std::optional<Sha256> hash = sha256_from_hex(path.stem().string());
            if (path.extension() != mesh_suffix || !hash) {
                continue;
            }
            add_stored(*hash);
        }
    }
}

/// Records the mesh as stored, unless its file is missing.
void GeometryStore::State::add_stored(const Sha256& mesh) {
    const std::shared_ptr<Entry> entry = find_or_add(mesh);
    const std::lock_guard making(entry->making); // Waits for a removal in progress.
    std::error_code missing;
    const std::uintmax_t bytes = std::filesystem::file_size(mesh_path(mesh), missing);
    if (missing) {
        return;
    }
    const MeshInfo info = read_info(info_path(mesh));
    entry->stored = true;
    const std::lock_guard lock(mutex);
    statuses[mesh] = {mesh, info.name, info.triangles, bytes, 0, false};
}

/// Adds a mesh that a person has put into the folder while the master runs.
void GeometryStore::State::find_mesh(const Sha256& mesh) {
    std::error_code error;
    if (!has(mesh) && std::filesystem::exists(mesh_path(mesh), error)) {
        add_stored(mesh);
    }
}

Error GeometryStore::State::missing(const Sha256& mesh) const {
    return {ErrorCode::NotFound,
            mesh_path(mesh).string() +
                " is missing; restore it, or submit a job with the mesh again"};
}

bool GeometryStore::State::has(const Sha256& mesh) const {
    const std::lock_guard lock(mutex);
    return statuses.contains(mesh);
}

/// Deletes trees, blocks and descriptions without a mesh, which an interrupted removal leaves
/// behind. Files with other names stay, for example damaged files that were renamed.
void GeometryStore::State::remove_orphans() const {
    for (const char* folder : {"meshes", "trees", "blocks"}) {
        for (const auto& file : std::filesystem::directory_iterator(directory / folder)) {
            const std::string name = file.path().filename().string();
            const std::optional<Sha256> hash = sha256_from_hex(name.substr(0, hash_digits));
            const std::string rest = name.substr(std::min(name.size(), hash_digits));
            const bool is_ours = rest == ".info" || rest == ".tree" ||
                                 (rest.starts_with("-d") && rest.ends_with(".blocks"));
            std::error_code ignored;
            if (hash && is_ours && !statuses.contains(*hash)) {
                std::filesystem::remove(file.path(), ignored);
            }
        }
    }
}

/// Deletes the mesh file first: a crash then leaves only orphans, which the next start deletes.
/// Returns the freed bytes.
std::uint64_t GeometryStore::State::remove_files(const Sha256& mesh) const {
    std::vector<std::filesystem::path> files{mesh_path(mesh), info_path(mesh), tree_path(mesh)};
    std::error_code error;
    for (std::filesystem::directory_iterator file(directory / "blocks", error), end;
         !error && file != end;
         file.increment(error)) {
        if (file->path().filename().string().starts_with(to_hex(mesh) + "-d")) {
            files.push_back(file->path());
        }
    }
    std::uint64_t bytes = 0;
    for (const auto& path : files) {
        std::error_code missing;
        const std::uintmax_t size = std::filesystem::file_size(path, missing);
        if (!missing && std::filesystem::remove(path, missing)) {
            bytes += size;
        }
    }
    return bytes;
}

Status GeometryStore::State::check_room(const Sha256& mesh) const {
    const std::lock_guard lock(mutex);
    if (statuses.size() < meshes_max || statuses.contains(mesh)) {
        return Done{};
    }
    return Error{ErrorCode::TooLarge,
                 std::to_string(statuses.size()) + " meshes are stored, of at most " +
                     std::to_string(meshes_max) +
                     "; an admin has to remove some (`cdctl rm MESH`)"};
}

std::shared_ptr<Entry> GeometryStore::State::find(const Sha256& mesh) const {
    const std::lock_guard lock(mutex);
    const auto found = entries.find(mesh);
    return found == entries.end() ? nullptr : found->second;
}

std::shared_ptr<Entry> GeometryStore::State::find_or_add(const Sha256& mesh) {
    const std::lock_guard lock(mutex);
    std::shared_ptr<Entry>& entry = entries[mesh];
    if (entry == nullptr) {
        entry = std::make_shared<Entry>();
    }
    return entry;
}

void GeometryStore::State::keep(const std::shared_ptr<const ObbTree>& tree) {
    const std::lock_guard lock(mutex);
    std::erase(recent, tree);
    recent.push_back(tree);
    if (recent.size() > limits::trees_kept_max) {
        recent.pop_front();
    }
}

/// Checks that a file, if it exists, can be opened. Otherwise a lack of file descriptors, for
/// example, would count as damage. Errors: Io.
Status check_opens(const std::filesystem::path& path) {
    const Result<DiskFile> file = DiskFile::open(path);
    return file || file.error().code == ErrorCode::NotFound ? Status(Done{}) : file.error();
}

Error no_mesh(const Sha256& mesh) {
    return {ErrorCode::NotFound, "no mesh " + to_short_hex(mesh) + " is stored here"};
}

/// Returns the options of the master's trees: not prepared for contact searches, which workers run.
BuildOptions build_options() {
    BuildOptions options;
    options.prepare_search = false;
    return options;
}

std::shared_ptr<const ObbTree> GeometryStore::State::build(std::shared_ptr<const Mesh> mesh,
                                                           double& seconds) {
    const auto start = std::chrono::steady_clock::now();
    auto tree = std::make_shared<const ObbTree>(build_tree(std::move(mesh), build_options(), pool));
    seconds = seconds_since(start);
    log_info("tree built: mesh={} triangles={} seconds={:.3f}",
             to_short_hex(tree->mesh().hash()),
             tree->mesh().triangles().size(),
             seconds);
    return tree;
}

Status GeometryStore::State::write(const ObbTree& tree) const {
    const Sha256 hash = tree.mesh().hash();
    return write_tree_file(
        tree_path(hash), tree, tree_key(hash, build_options()), Durability::Synced);
}

/// Builds the tree and writes all files. Renames the mesh file last, so that a stored mesh has all
/// its files.
Status GeometryStore::State::store(Entry& entry, MeshUpload& upload) {
    const Result<std::shared_ptr<const Mesh>> mesh = upload.read();
    if (!mesh) {
        return mesh.error();
    }
    const Sha256& hash = upload.mesh();
    const std::uint64_t triangles = mesh.value()->triangles().size();
    MeshStatus facts{hash, upload.name(), triangles, upload.bytes_total(), 0, false};
    const std::shared_ptr<const ObbTree> tree = build(mesh.value(), facts.build_seconds);
    if (Status status = write(*tree); !status) {
        return status;
    }
    if (Status status = write_info(info_path(hash), {facts.name, facts.triangles}); !status) {
        return status;
    }
    if (Status status = upload.commit(); !status) {
        return status;
    }
    keep(tree);
    entry.tree = tree;
    entry.stored = true;
    const std::lock_guard lock(mutex);
    statuses[hash] = std::move(facts);
    return Done{};
}

Result<std::shared_ptr<const ObbTree>> GeometryStore::State::load_tree(Entry& entry,
                                                                       const Sha256& mesh_hash) {
    if (auto tree = entry.tree.lock()) {
        keep(tree);
        return tree;
    }
    const Result<std::shared_ptr<const Mesh>> mesh = read_mesh(mesh_path(mesh_hash), mesh_hash);
    if (!mesh && mesh.error().code == ErrorCode::NotFound) {
        entry.stored = false; // A new upload restores the mesh.
        const std::lock_guard lock(mutex);
        statuses.erase(mesh_hash);
        return missing(mesh_hash);
    }
    if (!mesh) {
        return mesh.error();
    }
    const std::filesystem::path path = tree_path(mesh_hash);
    if (const Status opens = check_opens(path); !opens) {
        return opens.error();
    }
    Result<std::shared_ptr<const ObbTree>> tree =
        read_tree_file(path, mesh.value(), tree_key(mesh_hash, build_options()));
    double seconds = 0;
    if (!tree) {
        Status status = tree.error().code == ErrorCode::NotFound
                            ? Status(Done{})
                            : set_aside(path, tree.error().detail);
        tree = build(mesh.value(), seconds);
        if (status) {
            status = write(*tree.value());
        }
        if (!status) {
            log_warning("tree not written: mesh={} error=\"{}\"",
                        to_short_hex(mesh_hash),
                        status.error().detail);
        }
    }
    if (tree) {
        keep(tree.value());
        entry.tree = tree.value();
        const std::lock_guard lock(mutex);
        statuses[mesh_hash].build_seconds += seconds;
        statuses[mesh_hash].triangles = mesh.value()->triangles().size();
    }
    return tree;
}

StoreResult<std::shared_ptr<const CutGeometry>>
GeometryStore::State::load_cut(Entry& entry,
                               const std::shared_ptr<const ObbTree>& tree,
                               std::uint32_t depth,
                               SubtreeForm form) {
    using Cut = StoreResult<std::shared_ptr<const CutGeometry>>;
    std::weak_ptr<const CutGeometry>& kept = entry.cuts[{depth, form}];
    if (auto cut = kept.lock()) {
        return cut;
    }
    const std::filesystem::path path = blocks_path(tree->mesh().hash(), depth, form);
    if (const Status opens = check_opens(path); !opens) {
        return Cut::unwritten(opens.error());
    }
    Result<std::shared_ptr<const CutGeometry>> cut = CutGeometry::open(path, tree, depth, form);
    if (!cut && cut.error().code != ErrorCode::NotFound) {
        if (const Status status = set_aside(path, cut.error().detail); !status) {
            return Cut::unwritten(status.error());
        }
    }
    if (!cut) {
        const auto start = std::chrono::steady_clock::now();
        if (const Status status = write_blocks_file(path, *tree, depth, form, &pool); !status) {
            const bool is_of_disk = status.error().code == ErrorCode::Io;
            return is_of_disk ? Cut::unwritten(status.error()) : Cut(status.error());
        }
        log_info("blocks encoded: mesh={} depth={} seconds={:.3f}",
                 to_short_hex(tree->mesh().hash()),
                 depth,
                 seconds_since(start));
        cut = CutGeometry::open(path, tree, depth, form);
    }
    if (cut) {
        kept = cut.value();
    }
    return cut;
}

GeometryStore::GeometryStore(std::unique_ptr<State> state) : state_(std::move(state)) {}
GeometryStore::~GeometryStore() = default;

Result<std::unique_ptr<GeometryStore>> GeometryStore::open(const std::filesystem::path& directory,
                                                           ThreadPool& pool,
                                                           std::size_t meshes_max) {
    for (const char* folder : {"meshes", "trees", "blocks"}) {
        if (const Status status = make_directories(directory / folder); !status) {
            return status.error();
        }
    }
    Result<DiskFile> lock_file = DiskFile::lock(directory / "lock");
    if (!lock_file) {
        return lock_file.error();
    }
    auto state = std::make_unique<State>(directory, std::move(lock_file.value()), pool, meshes_max);
    try {
        state->find_meshes();
        state->remove_orphans();
    } catch (const std::filesystem::filesystem_error& error) {
        return Error{ErrorCode::Io, error.what()};
    }
    return std::unique_ptr<GeometryStore>(new GeometryStore(std::move(state)));
}

bool GeometryStore::has(const Sha256& mesh) const {
    return state_->has(mesh);
}

std::vector<Sha256> GeometryStore::missing(std::span<const Sha256> meshes) const {
    std::vector<Sha256> missing;
    std::set<Sha256> named;
    for (const Sha256& mesh : meshes) {
        if (!has(mesh) && named.insert(mesh).second) {
            missing.push_back(mesh);
        }
    }
    return missing;
}

Result<std::unique_ptr<MeshUpload>> GeometryStore::begin_upload(const Sha256& mesh,
                                                                const std::string& name,
                                                                std::uint64_t bytes_total) {
    if (bytes_total > limits::mesh_bytes_max) {
        return Error{ErrorCode::TooLarge,
                     "a mesh of " + std::to_string(bytes_total) + " bytes; at most " +
                         std::to_string(limits::mesh_bytes_max) + " are allowed"};
    }
    if (*state_->open_uploads >= limits::mesh_uploads_max) {
        return Error{ErrorCode::TooLarge, "too many meshes are being uploaded; try again later"};
    }
    if (const Status room = state_->check_room(mesh); !room) {
        return room.error();
    }
    Result<DiskFile> file = DiskFile::create_for(state_->mesh_path(mesh));
    if (!file) {
        return file.error();
    }
    return std::make_unique<MeshUpload>(
        std::move(file.value()), mesh, name, bytes_total, state_->open_uploads);
}

Status GeometryStore::finish_upload(std::unique_ptr<MeshUpload> given) {
    // A local variable, so that the upload and its temporary file are deleted before the return.
    const std::unique_ptr<MeshUpload> upload = std::move(given);
    const Sha256 mesh = upload->mesh();
    const std::shared_ptr<Entry> entry = state_->find_or_add(mesh);
    const std::lock_guard making(entry->making);
    Status status = entry->stored ? Status(Done{}) : state_->check_room(mesh);
    if (status && !entry->stored) {
        status = state_->store(*entry, *upload);
    }
    const std::lock_guard lock(state_->mutex);
    if (status) {
        state_->entries[mesh] = entry;
    } else if (const auto found = state_->entries.find(mesh);
               found != state_->entries.end() && found->second == entry) {
        state_->entries.erase(found);
    }
    return status;
}

Result<std::shared_ptr<const ObbTree>> GeometryStore::tree(const Sha256& mesh) {
    state_->find_mesh(mesh);
    const std::shared_ptr<Entry> entry = state_->find(mesh);
    if (entry == nullptr) {
        return state_->missing(mesh);
    }
    const std::lock_guard making(entry->making);
    return entry->stored ? state_->load_tree(*entry, mesh) : state_->missing(mesh);
}

StoreResult<std::shared_ptr<const CutGeometry>>
GeometryStore::cut(const Sha256& mesh, std::uint32_t depth, SubtreeForm form) {
    if (depth > limits::distribution_depth_max) {
        return Error{ErrorCode::TooLarge,
                     "distribution depth " + std::to_string(depth) + "; at most " +
                         std::to_string(limits::distribution_depth_max) + " is allowed"};
    }
    const Result<std::shared_ptr<const ObbTree>> tree = this->tree(mesh);
    if (!tree) {
        return tree.error();
    }
    const std::shared_ptr<Entry> entry = state_->find(mesh);
    if (entry == nullptr) { // The mesh was removed meanwhile.
        return state_->missing(mesh);
    }
    const std::lock_guard making(entry->making);
    return entry->stored ? state_->load_cut(*entry, tree.value(), depth, form)
                         : StoreResult<std::shared_ptr<const CutGeometry>>(state_->missing(mesh));
}

std::shared_ptr<const MeshHold> GeometryStore::hold(std::vector<Sha256> meshes) {
    return std::make_shared<const MeshHold>(state_->uses, std::move(meshes));
}

Result<std::uint64_t> GeometryStore::remove(const Sha256& mesh) {
    const std::shared_ptr<Entry> entry = state_->find(mesh);
    if (entry == nullptr) {
        return no_mesh(mesh);
    }
    const std::lock_guard making(entry->making);
    if (!entry->stored) {
        return no_mesh(mesh);
    }
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->uses->contains(mesh)) {
            return Error{ErrorCode::Refused,
                         "mesh " + to_short_hex(mesh) +
                             " is needed by a job; remove its jobs first (`cdctl get jobs`)"};
        }
        state_->statuses.erase(mesh);
        std::erase_if(state_->recent,
                      [&](const auto& tree) { return tree->mesh().hash() == mesh; });
    }
    entry->stored = false;
    const std::uint64_t bytes = state_->remove_files(mesh);
    const std::lock_guard lock(state_->mutex);
    state_->entries.erase(mesh);
    return bytes;
}

Result<MeshBytes>
GeometryStore::read(const Sha256& mesh, std::uint64_t offset, std::uint64_t bytes_max) const {
    if (!has(mesh)) {
        return no_mesh(mesh);
    }
    const Result<DiskFile> file = DiskFile::open(state_->mesh_path(mesh));
    if (!file) {
        return file.error();
    }
    const Result<std::uint64_t> size = file.value().size();
    if (!size) {
        return size.error();
    }
    if (offset >= size.value()) {
        return Error{ErrorCode::BadInput,
                     "byte " + std::to_string(offset) + " of a mesh of " +
                         std::to_string(size.value()) + " bytes"};
    }
    Result<Bytes> bytes = file.value().read_at(offset, std::min(bytes_max, size.value() - offset));
    if (!bytes) {
        return bytes.error();
    }
    return MeshBytes{mesh, size.value(), offset, std::move(bytes.value())};
}

std::vector<MeshStatus> GeometryStore::meshes() const {
    const std::lock_guard lock(state_->mutex);
    std::vector<MeshStatus> meshes;
    meshes.reserve(state_->statuses.size());
    for (const auto& [hash, status] : state_->statuses) {
        meshes.push_back(status);
        meshes.back().is_needed = state_->uses->contains(hash);
    }
    return meshes;
}

} // namespace cd

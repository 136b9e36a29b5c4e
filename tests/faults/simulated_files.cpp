// Replaces the disk by files in memory.
#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"
#include "tests/faults/world.hpp"

#include <algorithm>

namespace cd {

using tests::Files;
using tests::SimulatedFile;
using tests::World;

namespace {

constexpr std::string_view state_prefix = "/state/";

/// Maps descriptors to open files.
std::map<int, std::shared_ptr<SimulatedFile>>& open_files() {
    static std::map<int, std::shared_ptr<SimulatedFile>> files;
    return files;
}

int open_descriptor(std::shared_ptr<SimulatedFile> file) {
    static int last = 1 << 20;
    open_files()[++last] = std::move(file);
    return last;
}

bool is_of_master(const std::string& path) {
    return path.starts_with(state_prefix);
}

Files& files_of(const std::string& path) {
    return is_of_master(path) ? World::current()->disk : tests::safe_files();
}

/// Fails at random for poses and blocks, which a running job needs. (The master does not start if
/// its files are damaged at the start.)
Status check_readable(const std::filesystem::path& path) {
    World* world = World::current();
    const bool is_needed = path.extension() == ".poses" || path.extension() == ".blocks";
    if (world == nullptr || !world->disk_is_unreadable || !is_needed) {
        return Done{};
    }
    world->troubles.add(tests::Trouble::DiskUnreadable);
    return Error{ErrorCode::Io, path.string() + " is damaged"};
}

/// Must be called before each change of a file.
Status touch(const std::string& path) {
    World* world = World::current();
    if (world == nullptr) {
        return Done{};
    }
    if (is_of_master(path)) {
        world->touch_disk();
    }
    if (world->disk_is_full) {
        world->troubles.add(tests::Trouble::DiskFull);
        return Error{ErrorCode::Io, "cannot write " + path + ": no space left on device"};
    }
    return Done{};
}

void change(Bytes& content, std::uint64_t offset, std::span<const std::byte> bytes) {
    content.resize(std::max<std::size_t>(content.size(), offset + bytes.size()));
    std::copy(bytes.begin(), bytes.end(), content.begin() + static_cast<std::ptrdiff_t>(offset));
}

void sync_file(SimulatedFile& file) {
    file.durable = file.content;
    file.pending.clear();
}

} // namespace

FileMapping::~FileMapping() {
    delete[] bytes_.data();
}

DiskFile::DiskFile(int descriptor, std::filesystem::path path, std::filesystem::path temporary)
    : descriptor_(descriptor), path_(std::move(path)), temporary_(std::move(temporary)) {}

DiskFile::DiskFile(DiskFile&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)),
      path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})) {}

DiskFile& DiskFile::operator=(DiskFile&& other) noexcept {
    std::swap(descriptor_, other.descriptor_);
    std::swap(path_, other.path_);
    std::swap(temporary_, other.temporary_);
    return *this;
}

DiskFile::~DiskFile() {
    close();
}

void DiskFile::close() {
    open_files().erase(descriptor_);
    descriptor_ = -1;
}

Result<DiskFile> DiskFile::open(const std::filesystem::path& path) {
    const auto& files = files_of(path.string()).by_path;
    const auto found = files.find(path.string());
    if (found == files.end()) {
        return Error{ErrorCode::NotFound, "cannot open " + path.string() + ": no such file"};
    }
    return DiskFile(open_descriptor(found->second), path, {});
}

Result<DiskFile> DiskFile::create_for(const std::filesystem::path& path) {
    if (const Status status = touch(path.string()); !status) {
        return status.error();
    }
    return DiskFile(open_descriptor(std::make_shared<SimulatedFile>()), path, path);
}

Result<DiskFile> DiskFile::open_to_write(const std::filesystem::path& path) {
    auto& files = files_of(path.string()).by_path;
    if (!files.contains(path.string())) {
        if (const Status status = touch(path.string()); !status) {
            return status.error();
        }
        files[path.string()] = std::make_shared<SimulatedFile>();
    }
    return DiskFile(open_descriptor(files.at(path.string())), path, {});
}

Result<DiskFile> DiskFile::lock(const std::filesystem::path& path) {
    return open_to_write(path);
}

Status DiskFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) const {
    if (Status status = touch(path_.string()); !status) {
        return status;
    }
    SimulatedFile& file = *open_files().at(descriptor_);
    change(file.content, offset, bytes);
    file.pending.push_back({offset, Bytes(bytes.begin(), bytes.end())});
    return Done{};
}

Result<Bytes> DiskFile::read_at(std::uint64_t offset, std::uint64_t size) const {
    if (const Status status = check_readable(path_); !status) {
        return status.error();
    }
    const Bytes& content = open_files().at(descriptor_)->content;
    if (offset > content.size() || content.size() - offset < size) {
        return Error{ErrorCode::Io, path_.string() + " is damaged: it is cut short"};
    }
    const auto begin = content.begin() + static_cast<std::ptrdiff_t>(offset);
    return Bytes(begin, begin + static_cast<std::ptrdiff_t>(size));
}

Result<std::uint64_t> DiskFile::size() const {
    return std::uint64_t{open_files().at(descriptor_)->content.size()};
}

Status DiskFile::resize(std::uint64_t size) const {
    open_files().at(descriptor_)->content.resize(size);
    return Done{};
}

Status DiskFile::sync() const {
    if (Status status = touch(path_.string()); !status) {
        return status;
    }
    sync_file(*open_files().at(descriptor_));
    return Done{};
}

Result<FileMapping> DiskFile::map() const {
    const Bytes& content = open_files().at(descriptor_)->content;
    auto* copy = new std::byte[content.size()];
    std::copy(content.begin(), content.end(), copy);
    return FileMapping(std::span<const std::byte>(copy, content.size()));
}

Status DiskFile::commit(Durability durability) {
    if (Status status = touch(path_.string()); !status) {
        return status;
    }
    const std::shared_ptr<SimulatedFile>& file = open_files().at(descriptor_);
    if (durability == Durability::Synced) {
        sync_file(*file);
        file->is_named_for_ever = true;
    }
    files_of(path_.string()).by_path[path_.string()] = file;
    if (World* world = World::current(); world != nullptr && !is_of_master(path_.string())) {
        world->troubles.add(tests::Trouble::BlocksLost); // Otherwise all block files already exist.
    }
    return Done{};
}

Status DiskFile::commit_as(const std::filesystem::path& path, Durability durability) {
    path_ = path;
    return commit(durability);
}

Status make_directories(const std::filesystem::path&) {
    return Done{};
}

Status sync_directory(const std::filesystem::path& directory) {
    if (Status status = touch(directory.string() + "/"); !status) {
        return status;
    }
    for (auto& [path, file] : files_of(directory.string() + "/").by_path) {
        file->is_named_for_ever |= path.starts_with(directory.string() + "/");
    }
    return Done{};
}

Status set_aside(const std::filesystem::path& path, const std::string& why) {
    if (is_of_master(path.string())) {
        return Error{ErrorCode::Io, path.string() + ": " + why};
    }
    files_of(path.string()).by_path.erase(path.string());
    return Done{};
}

} // namespace cd

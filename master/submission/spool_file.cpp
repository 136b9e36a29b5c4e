#include "master/submission/spool_file.hpp"

#include "common/core/files/hash.hpp"
#include "common/core/limits/engine.hpp"

#include <algorithm>

namespace cd {

namespace {

std::uint64_t runs_of(std::uint64_t scenarios) {
    return (scenarios + limits::pose_run_scenarios - 1) / limits::pose_run_scenarios;
}

} // namespace

Result<SpoolFile> SpoolFile::create(const std::filesystem::path& path, Content content) {
    Result<DiskFile> file = DiskFile::create_for(path);
    if (!file) {
        return file.error();
    }
    return SpoolFile(std::move(file.value()), std::move(content));
}

Result<SpoolFile> SpoolFile::open(const std::filesystem::path& path, Content content) {
    Result<DiskFile> file = DiskFile::open(path);
    if (!file) {
        return Error{ErrorCode::Io, file.error().detail};
    }
    SpoolFile spool(std::move(file.value()), std::move(content));
    if (const Status read = spool.read_index(); !read) {
        return read.error();
    }
    return spool;
}

std::vector<SpoolFile::Slice> SpoolFile::slices(std::uint64_t first, std::uint64_t count) {
    std::vector<Slice> slices;
    const std::uint64_t end = first + count;
    while (first < end) {
        const std::uint64_t skipped = first % limits::pose_run_scenarios;
        const std::uint64_t taken = std::min(limits::pose_run_scenarios - skipped, end - first);
        slices.push_back({first / limits::pose_run_scenarios, skipped, taken});
        first += taken;
    }
    return slices;
}

SpoolFile::Run SpoolFile::run(std::uint64_t number) const {
    const std::uint64_t begin = number == 0 ? 0 : ends_[number - 1];
    return {begin, ends_[number] - begin, sums_[number]};
}

Status SpoolFile::append(std::span<const std::byte> run) {
    const std::uint64_t begin = end();
    if (Status status = file_.write_at(begin, run); !status) {
        return status;
    }
    ends_.push_back(begin + run.size());
    sums_.push_back(checksum(run));
    return Done{};
}

Bytes SpoolFile::footer() const {
    ByteWriter out;
    out.put_array(std::span<const std::uint64_t>(content_.kind));
    out.put(content_.scenarios);
    out.put(runs_of(content_.scenarios));
    return out.take();
}

/// The index consists of the runs' ends and checksums, the footer, and a checksum over these.
Status SpoolFile::seal(const std::filesystem::path& path, Durability durability) {
    ByteWriter out;
    out.put_array(std::span<const std::uint64_t>(ends_));
    out.put_array(std::span<const std::uint64_t>(sums_));
    put_bytes(out, footer());
    out.put(checksum(out.bytes()));
    if (Status status = file_.write_at(end(), out.bytes()); !status) {
        return status;
    }
    return file_.commit_as(path, durability);
}

Status SpoolFile::read_index() {
    const Result<std::uint64_t> size = file_.size();
    if (!size) {
        return size.error();
    }
    const std::uint64_t runs = runs_of(content_.scenarios);
    const Bytes expected = footer();
    const std::uint64_t summed_bytes = 2 * sizeof(std::uint64_t) * runs + expected.size();
    const std::uint64_t index_bytes = summed_bytes + sizeof(std::uint64_t);
    if (size.value() < index_bytes) {
        return damaged("it is cut short");
    }
    const std::uint64_t begin = size.value() - index_bytes;
    const Result<Bytes> bytes = file_.read_at(begin, index_bytes);
    if (!bytes) {
        return bytes.error();
    }
    ByteReader in(bytes.value());
    ends_ = in.get_array<std::uint64_t>(runs);
    sums_ = in.get_array<std::uint64_t>(runs);
    const bool is_ours = std::ranges::equal(in.get_bytes(expected.size()), expected);
    const std::uint64_t sum = checksum(std::span(bytes.value()).first(summed_bytes));
    if (!is_ours || in.get<std::uint64_t>() != sum || !std::ranges::is_sorted(ends_) ||
        end() != begin) {
        return damaged("its index has a wrong checksum, or is of another job");
    }
    return Done{};
}

Result<Bytes> SpoolFile::read(const Run& run) const {
    Result<Bytes> bytes = file_.read_at(run.offset, run.bytes);
    return bytes && checksum(bytes.value()) != run.sum ? damaged("a run has a wrong checksum")
                                                       : std::move(bytes);
}

Error SpoolFile::damaged(const std::string& why) const {
    return {ErrorCode::Io, file_.path().string() + " is damaged: " + why};
}

} // namespace cd

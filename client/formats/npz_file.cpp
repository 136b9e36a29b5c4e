#include "client/formats/npz_file.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <span>

namespace cd {

namespace {

constexpr std::string_view ending = ".npy";

} // namespace

NpzArray::NpzArray(NpyHeader header, ZipEntry entry, Bytes begun, std::string place)
    : header_(std::move(header)),
      entry_(std::move(entry)),
      begun_(std::move(begun)),
      bytes_left_(header_.count() * size_of(header_.type)),
      place_(std::move(place)) {}

Result<NpyArray> NpzArray::next() {
    constexpr std::uint64_t piece_bytes_max = 24u << 15; // A multiple of 24: whole rows of three.
    NpyArray piece{{}, header_.type, Bytes(std::min(bytes_left_, piece_bytes_max))};
    const std::size_t there = std::min(begun_.size(), piece.data.size());
    std::copy_n(begun_.begin(), there, piece.data.begin());
    begun_.erase(begun_.begin(), begun_.begin() + static_cast<std::ptrdiff_t>(there));
    const auto got = entry_.read(std::span(piece.data).subspan(there));
    if (!got || got.value() + there != piece.data.size()) {
        return bad_input(place_ + "is damaged");
    }
    bytes_left_ -= piece.data.size();
    piece.shape = {piece.data.size() / size_of(header_.type)};
    return piece;
}

Result<NpzFile> NpzFile::open(const std::filesystem::path& path) {
    auto zip = CD_TRY(within(path.string() + ": ", ZipFile::open(path)));
    return NpzFile(path, std::move(zip));
}

std::vector<std::string> NpzFile::names() const {
    std::vector<std::string> names = zip_.names();
    for (std::string& name : names) {
        name.resize(name.size() - (name.ends_with(ending) ? ending.size() : 0));
    }
    return names;
}

Result<NpzArray> NpzFile::array(const std::string& name) const {
    const std::string place = path_.string() + ": array '" + name + "' ";
    const bool has_ending =
        std::ranges::find(zip_.names(), name + std::string(ending)) != zip_.names().end();
    auto entry = zip_.entry(has_ending ? name + std::string(ending) : name);
    if (!entry) {
        return bad_input(place + entry.error().detail);
    }
    const std::uint64_t size = entry.value().size();
    if (size > limits::npz_array_bytes_max) {
        return bad_input(place + "is too large");
    }
    Bytes begun(std::min<std::uint64_t>(size, npy_header_bytes_max));
    CD_TRY(within(place, entry.value().read(begun)));
    const NpyHeader h = CD_TRY(within(place + "is ", parse_npy_header(begun)));
    const std::uint64_t data_bytes = size - h.data_offset;
    if (h.count() > data_bytes || h.count() * size_of(h.type) != data_bytes) {
        return bad_input(place + "has data whose size contradicts its header");
    }
    begun.erase(begun.begin(), begun.begin() + static_cast<std::ptrdiff_t>(h.data_offset));
    return NpzArray(h, std::move(entry.value()), std::move(begun), place);
}

Result<NpyArray> NpzFile::read(const std::string& name) const {
    auto found = CD_TRY(array(name));
    Bytes data;
    data.reserve(found.header().count() * size_of(found.header().type));
    for (;;) {
        auto piece = CD_TRY(found.next());
        if (piece.data.empty()) {
            return make_npy_array(found.header(), std::move(data));
        }
        data.insert(data.end(), piece.data.begin(), piece.data.end());
    }
}

} // namespace cd

#include "client/formats/npy.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <numeric>

namespace cd {

namespace {

template <class To, class From>
void append_as(std::span<const std::byte> data, std::vector<To>& out) {
    for (std::size_t i = 0; i + sizeof(From) <= data.size(); i += sizeof(From)) {
        From value{};
        std::memcpy(&value, data.data() + i, sizeof value);
        out.push_back(static_cast<To>(value));
    }
}

template <class To>
std::vector<To> converted(NpyType type, std::span<const std::byte> data) {
    std::vector<To> out;
    out.reserve(data.size() / size_of(type));
    switch (type) {
    case NpyType::F8:
        append_as<To, double>(data, out);
        break;
    case NpyType::F4:
        append_as<To, float>(data, out);
        break;
    case NpyType::I8:
        append_as<To, std::int64_t>(data, out);
        break;
    case NpyType::I4:
        append_as<To, std::int32_t>(data, out);
        break;
    case NpyType::I2:
        append_as<To, std::int16_t>(data, out);
        break;
    case NpyType::I1:
        append_as<To, std::int8_t>(data, out);
        break;
    case NpyType::U8:
        append_as<To, std::uint64_t>(data, out);
        break;
    case NpyType::U4:
        append_as<To, std::uint32_t>(data, out);
        break;
    case NpyType::U2:
        append_as<To, std::uint16_t>(data, out);
        break;
    case NpyType::U1:
        append_as<To, std::uint8_t>(data, out);
        break;
    }
    return out;
}

/// Reorders an array in Fortran order to C order; `item` is the size of an element in bytes.
Bytes to_c_order(std::span<const std::byte> data,
                 std::span<const std::uint64_t> shape,
                 std::size_t item) {
    Bytes out(data.size());
    const std::size_t count = data.size() / item;
    std::vector<std::uint64_t> index(shape.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        std::uint64_t source = 0;
        for (std::size_t k = shape.size(); k-- > 0;) {
            source = source * shape[k] + index[k];
        }
        std::memcpy(out.data() + i * item, data.data() + source * item, item);
        for (std::size_t k = shape.size(); k-- > 0 && ++index[k] == shape[k];) {
            index[k] = 0;
        }
    }
    return out;
}

} // namespace

std::vector<double> NpyArray::to_doubles() const {
    return converted<double>(type, data);
}

Result<std::vector<std::int64_t>> NpyArray::to_integers() const {
    if (type == NpyType::F8 || type == NpyType::F4) {
        return bad_input("an array of " + std::string(to_text(type)) +
                         " where integers are needed");
    }
    std::vector<std::int64_t> values = converted<std::int64_t>(type, data);
    if (type == NpyType::U8 &&
        std::any_of(values.begin(), values.end(), [](std::int64_t v) { return v < 0; })) {
        return bad_input("an integer beyond 2^63");
    }
    return values;
}

NpyArray make_npy_array(const NpyHeader& header, Bytes data) {
    if (header.is_fortran) {
        data = to_c_order(data, header.shape, size_of(header.type));
    }
    return {header.shape, header.type, std::move(data)};
}

Result<NpyArray> parse_npy(std::span<const std::byte> file) {
    const auto header = CD_TRY(parse_npy_header(file));
    const NpyHeader& h = header;
    const auto data = file.subspan(h.data_offset);
    if (h.count() > data.size() || h.count() * size_of(h.type) != data.size()) {
        return bad_input("a NumPy array whose data size contradicts its header");
    }
    return make_npy_array(h, Bytes(data.begin(), data.end()));
}

Result<std::unique_ptr<NpyRows>> NpyRows::open(const std::filesystem::path& path) {
    std::unique_ptr<NpyRows> rows(new NpyRows());
    rows->name_ = path.string();
    rows->file_.open(path, std::ios::binary);
    if (!rows->file_) {
        return Error{ErrorCode::NotFound, rows->name_ + ": cannot be opened"};
    }
    rows->file_.seekg(0, std::ios::end);
    const auto file_size = static_cast<std::uint64_t>(rows->file_.tellg());
    const Bytes start =
        CD_TRY(rows->read_bytes(0, std::min<std::uint64_t>(file_size, npy_header_bytes_max)));
    const NpyHeader h = CD_TRY(within(rows->name_ + ": ", parse_npy_header(start)));
    const std::uint64_t data_bytes = file_size - h.data_offset;
    if (h.shape.empty() || h.count() > data_bytes || h.count() * size_of(h.type) != data_bytes) {
        return bad_input(rows->name_ + ": the size of the array's data contradicts its header");
    }
    rows->shape_ = h.shape;
    rows->type_ = h.type;
    rows->data_offset_ = h.data_offset;
    if (h.is_fortran) {
        const Bytes data = CD_TRY(rows->read_bytes(h.data_offset, data_bytes));
        rows->data_ = to_c_order(data, h.shape, size_of(h.type));
    }
    return rows;
}

std::unique_ptr<NpyRows> NpyRows::of(NpyArray array) {
    std::unique_ptr<NpyRows> rows(new NpyRows());
    rows->shape_ = array.shape.empty() ? std::vector<std::uint64_t>{1} : array.shape;
    rows->type_ = array.type;
    rows->data_ = std::move(array.data);
    return rows;
}

std::uint64_t NpyRows::row_size() const {
    return std::accumulate(shape_.begin() + 1, shape_.end(), std::uint64_t{1}, std::multiplies());
}

Result<Bytes> NpyRows::read_bytes(std::uint64_t offset, std::uint64_t count) {
    Bytes bytes(count);
    file_.clear();
    file_.seekg(static_cast<std::streamoff>(offset));
    file_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(count));
    if (!file_) {
        return Error{ErrorCode::Io, name_ + ": cannot be read to its end"};
    }
    return bytes;
}

Result<std::vector<double>> NpyRows::read(std::uint64_t first, std::uint64_t count) {
    const std::uint64_t row_bytes = row_size() * size_of(type_);
    if (data_) {
        return converted<double>(type_,
                                 std::span(*data_).subspan(first * row_bytes, count * row_bytes));
    }
    const Bytes data = CD_TRY(read_bytes(data_offset_ + first * row_bytes, count * row_bytes));
    return converted<double>(type_, data);
}

} // namespace cd

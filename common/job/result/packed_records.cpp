#include "common/job/result/packed_records.hpp"

#include "common/core/check.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/varint.hpp"
#include "common/job/result/result.hpp"

#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

namespace cd {

namespace {

enum Column : std::size_t {
    lengths,
    heads,
    tails,
    a_steps,
    run_lengths,
    first_b_steps,
    b_steps,
    classes,
    column_count
};

/// The level of zstd. Columns become a few percent smaller than at the fastest level. This level is
/// affordable because columns are a quarter as long as the records.
constexpr int compression_level = 3;
/// The level for points, which hardly shrink: level 3 takes three times as long for 1 % less.
constexpr int compression_level_tails = 1;

/// Bytes of a pair in a record: a triangle of A, a triangle of B and a class (result.hpp).
constexpr std::size_t pair_bytes = 2 * sizeof(std::uint32_t) + 1;

class Packer {
  public:
    void add(std::span<const std::byte> record);
    [[nodiscard]] Bytes take();

  private:
    void add_pairs(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

    std::array<ByteWriter, column_count> columns_;
};

void Packer::add(std::span<const std::byte> record) {
    const std::optional<std::size_t> split = bytes_before_pairs(record);
    const std::span<const std::byte> head = record.first(split.value_or(record.size()));
    put_varint(columns_[lengths], 2 * std::uint64_t{head.size()} + (split ? 1 : 0));
    put_bytes(columns_[heads], head);
    ByteReader in(record.subspan(head.size()));
    if (split) {
        std::uint32_t count = 0;
        std::memcpy(&count, head.data() + head.size() - sizeof count, sizeof count);
        const auto a = in.get_array<std::uint32_t>(count);
        const auto b = in.get_array<std::uint32_t>(count);
        add_pairs(a, b);
        put_bytes(columns_[classes], in.get_bytes(count));
    }
    put_varint(columns_[lengths], in.remaining());
    put_bytes(columns_[tails], in.get_bytes(in.remaining()));
}

void Packer::add_pairs(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
    std::uint32_t a_before = 0;
    std::uint32_t b_before = 0;
    for (std::size_t i = 0; i < a.size();) {
        std::size_t end = i + 1;
        while (end < a.size() && a[end] == a[i]) {
            put_varint(columns_[b_steps], b[end] - b[end - 1] - 1); // Steps are modulo 2^32.
            ++end;
        }
        put_varint(columns_[a_steps], a[i] - a_before);
        put_varint(columns_[run_lengths], end - i - 1);
        put_varint(columns_[first_b_steps], zigzag(std::int64_t{b[i]} - std::int64_t{b_before}));
        a_before = a[i];
        b_before = b[i];
        i = end;
    }
}

Bytes Packer::take() {
    // Compressed together, columns would share zstd's code tables and be a few percent larger.
    std::array<Bytes, column_count> compressed;
    ByteWriter out;
    for (std::size_t i = 0; i < column_count; ++i) {
        if (columns_[i].size() > 0) {
            compressed[i] = compress(columns_[i].bytes(),
                                     i == tails ? compression_level_tails : compression_level);
        }
        put_varint(out, compressed[i].size());
    }
    for (const Bytes& column : compressed) {
        put_bytes(out, column);
    }
    return out.take();
}

Error bad() {
    return {ErrorCode::BadFrame, "packed records that contradict themselves"};
}

class Unpacker {
  public:
    /// The columns outlive the unpacker.
    Unpacker(const std::array<Bytes, column_count>& columns, std::uint64_t bytes_max)
        : bytes_max_(bytes_max) {
        for (const Bytes& column : columns) {
            columns_.emplace_back(column);
        }
    }

    [[nodiscard]] bool is_at_end() const { return columns_[lengths].remaining() == 0; }
    [[nodiscard]] Status add_record();
    [[nodiscard]] bool is_complete() const;
    [[nodiscard]] Bytes take() { return out_.take(); }

  private:
    /// Reads a record's pairs. Returns false if columns end early or a run has too many pairs.
    [[nodiscard]] bool get_pairs(std::uint32_t count);
    [[nodiscard]] std::uint64_t number(Column column) {
        const std::optional<std::uint64_t> value = get_varint(columns_[column]);
        is_good_ = is_good_ && value.has_value();
        return value.value_or(0);
    }

    std::vector<ByteReader> columns_;
    std::uint64_t bytes_max_;
    bool is_good_ = true;
    std::vector<std::uint32_t> a_;
    std::vector<std::uint32_t> b_;
    ByteWriter out_;
};

bool Unpacker::get_pairs(std::uint32_t count) {
    a_.clear();
    b_.clear();
    std::uint32_t a = 0;
    std::uint32_t first_b = 0;
    while (a_.size() < count && is_good_) {
        a += static_cast<std::uint32_t>(number(a_steps));
        first_b += static_cast<std::uint32_t>(unzigzag(number(first_b_steps)));
        const std::uint64_t more = number(run_lengths);
        if (more >= count - a_.size()) {
            return false;
        }
        a_.insert(a_.end(), static_cast<std::size_t>(more) + 1, a);
        b_.push_back(first_b);
        for (std::uint64_t i = 0; i < more; ++i) {
            b_.push_back(b_.back() + static_cast<std::uint32_t>(number(b_steps)) + 1);
        }
    }
    return is_good_;
}

Status Unpacker::add_record() {
    const std::uint64_t head_length = number(lengths);
    const std::uint64_t tail_length = number(lengths);
    const std::span<const std::byte> head = columns_[heads].get_bytes(head_length / 2);
    const std::span<const std::byte> tail = columns_[tails].get_bytes(tail_length);
    const bool has_pairs = head_length % 2 != 0;
    std::uint32_t count = 0;
    if (!is_good_ || columns_[heads].failed() || columns_[tails].failed() ||
        (has_pairs && head.size() < sizeof count)) {
        return bad();
    }
    if (has_pairs) {
        std::memcpy(&count, head.data() + head.size() - sizeof count, sizeof count);
    }
    const std::span<const std::byte> kinds = columns_[classes].get_bytes(count);
    if (columns_[classes].failed()) {
        return bad();
    }
    const std::uint64_t bytes = head.size() + pair_bytes * std::uint64_t{count} + tail.size();
    if (out_.size() + sizeof(std::uint32_t) + bytes > bytes_max_ || bytes > UINT32_MAX) {
        return Error{ErrorCode::TooLarge,
                     "packed records of more than " + std::to_string(bytes_max_) + " bytes"};
    }
    if (!get_pairs(count)) {
        return bad();
    }
    out_.put(static_cast<std::uint32_t>(bytes));
    put_bytes(out_, head);
    out_.put_array(std::span<const std::uint32_t>(a_));
    out_.put_array(std::span<const std::uint32_t>(b_));
    put_bytes(out_, kinds);
    put_bytes(out_, tail);
    return Done{};
}

bool Unpacker::is_complete() const {
    for (const ByteReader& column : columns_) {
        if (!column.complete()) {
            return false;
        }
    }
    return true;
}

} // namespace

Bytes pack_records(std::span<const std::byte> records) {
    Packer packer;
    ByteReader in(records);
    while (in.remaining() > 0) {
        packer.add(in.get_bytes(in.get<std::uint32_t>()));
        CD_CHECK(!in.failed());
    }
    return packer.take();
}

Result<Bytes> unpack_records(std::span<const std::byte> packed, std::uint64_t bytes_max) {
    ByteReader in(packed);
    std::array<std::uint64_t, column_count> sizes{};
    for (std::uint64_t& size : sizes) {
        size = get_varint(in).value_or(UINT64_MAX);
    }
    std::array<Bytes, column_count> columns;
    std::uint64_t bytes_left = bytes_max;
    for (std::size_t i = 0; i < column_count; ++i) {
        const std::span<const std::byte> compressed = in.get_bytes(sizes[i]);
        if (compressed.empty()) {
            continue;
        }
        Result<Bytes> column = decompress(compressed, bytes_left);
        if (!column) {
            return column.error();
        }
        bytes_left -= column.value().size();
        columns[i] = std::move(column.value());
    }
    if (!in.complete()) {
        return bad();
    }
    Unpacker unpacker(columns, bytes_max);
    while (!unpacker.is_at_end()) {
        if (const Status status = unpacker.add_record(); !status) {
            return status.error();
        }
    }
    if (!unpacker.is_complete()) {
        return bad();
    }
    return unpacker.take();
}

} // namespace cd

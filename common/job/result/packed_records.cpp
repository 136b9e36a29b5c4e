#include "common/job/result/packed_records.hpp"

#include "common/core/check.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/compress.hpp"
#include "common/core/files/disk_file.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/varint.hpp"
#include "common/job/result/result.hpp"

#include <algorithm>
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

/// The level of zstd. Level 3 takes 10 us more for a record of 694 pairs, as long as a 1 Gb/s link
/// needs for the whole packed record, and makes it only 2 % smaller.
constexpr int compression_level = 1;

/// Bytes of a pair in a record: a triangle of A, a triangle of B and a class (result.hpp).
constexpr std::size_t pair_bytes = 2 * sizeof(std::uint32_t) + 1;

/// Appends numbers to a column as varints. While it exists, nothing else may use the column. The
/// inner loop of packing, so the column gets room for all numbers at once.
class NumberWriter {
  public:
    NumberWriter(Bytes& column, std::size_t numbers_max) : column_(column) {
        const std::size_t end = column.size();
        column.resize(end + numbers_max * bytes_max);
        at_ = column.data() + end;
    }
    NumberWriter(const NumberWriter&) = delete;
    NumberWriter& operator=(const NumberWriter&) = delete;
    ~NumberWriter() { column_.resize(static_cast<std::size_t>(at_ - column_.data())); }

    void put(std::uint64_t value) {
        while (value >= 0x80) {
            *at_++ = static_cast<std::byte>(value | 0x80);
            value >>= 7;
        }
        *at_++ = static_cast<std::byte>(value);
    }

  private:
    static constexpr std::size_t bytes_max = 5; ///< A number has at most 35 bits.

    Bytes& column_;
    std::byte* at_;
};

void append(Bytes& column, std::span<const std::byte> bytes) {
    column.insert(column.end(), bytes.begin(), bytes.end());
}

/// A column to read. Reading a small number is the inner loop of unpacking.
class ColumnReader {
  public:
    explicit ColumnReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    /// Reads a varint. Returns 0 and has failed if there is none.
    [[nodiscard]] std::uint64_t get_number() {
        if (!rest_.empty() && std::to_integer<std::uint8_t>(rest_.front()) < 0x80) {
            const auto value = std::to_integer<std::uint64_t>(rest_.front());
            rest_ = rest_.subspan(1);
            return value;
        }
        ByteReader in(rest_);
        const std::optional<std::uint64_t> value = get_varint(in);
        failed_ = failed_ || !value;
        rest_ = rest_.last(in.remaining());
        return value.value_or(0);
    }
    /// Reads so many bytes. Returns none and has failed if there are fewer.
    [[nodiscard]] std::span<const std::byte> get_bytes(std::uint64_t count) {
        failed_ = failed_ || count > rest_.size();
        const std::span<const std::byte> bytes = rest_.first(failed_ ? 0 : count);
        rest_ = rest_.subspan(bytes.size());
        return bytes;
    }
    [[nodiscard]] bool is_at_end() const { return rest_.empty(); }
    [[nodiscard]] bool has_failed() const { return failed_; }

  private:
    std::span<const std::byte> rest_;
    bool failed_ = false;
};

class Packer {
  public:
    void add(std::span<const std::byte> record);
    [[nodiscard]] Bytes take();

  private:
    void add_pairs(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b);

    std::array<Bytes, column_count> columns_;
};

void Packer::add(std::span<const std::byte> record) {
    const std::optional<std::size_t> split = bytes_before_pairs(record);
    const std::span<const std::byte> head = record.first(split.value_or(record.size()));
    NumberWriter record_lengths(columns_[lengths], 2);
    record_lengths.put(2 * std::uint64_t{head.size()} + (split ? 1 : 0));
    append(columns_[heads], head);
    ByteReader in(record.subspan(head.size()));
    if (split) {
        std::uint32_t count = 0;
        std::memcpy(&count, head.data() + head.size() - sizeof count, sizeof count);
        const auto a = in.get_array<std::uint32_t>(count);
        const auto b = in.get_array<std::uint32_t>(count);
        add_pairs(a, b);
        append(columns_[classes], in.get_bytes(count));
    }
    record_lengths.put(in.remaining());
    append(columns_[tails], in.get_bytes(in.remaining()));
}

void Packer::add_pairs(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b) {
    NumberWriter a_step(columns_[a_steps], a.size());
    NumberWriter run_length(columns_[run_lengths], a.size());
    NumberWriter first_b_step(columns_[first_b_steps], a.size());
    NumberWriter b_step(columns_[b_steps], a.size());
    std::uint32_t a_before = 0;
    std::uint32_t b_before = 0;
    for (std::size_t i = 0; i < a.size();) {
        std::size_t end = i + 1;
        while (end < a.size() && a[end] == a[i]) {
            b_step.put(b[end] - b[end - 1] - 1); // Steps are modulo 2^32.
            ++end;
        }
        a_step.put(a[i] - a_before);
        run_length.put(end - i - 1);
        first_b_step.put(zigzag(std::int64_t{b[i]} - std::int64_t{b_before}));
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
        if (!columns_[i].empty()) {
            compressed[i] = compress(columns_[i], compression_level);
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

    [[nodiscard]] bool is_at_end() const { return columns_[lengths].is_at_end(); }
    [[nodiscard]] Status add_record();
    [[nodiscard]] bool is_complete() const;
    [[nodiscard]] Bytes take() { return out_.take(); }

  private:
    /// Reads a record's pairs. Returns false if columns end early or a run has too many pairs.
    [[nodiscard]] bool get_pairs(std::uint32_t count);
    [[nodiscard]] bool has_failed() const {
        return std::ranges::any_of(columns_, &ColumnReader::has_failed);
    }

    std::vector<ColumnReader> columns_;
    std::uint64_t bytes_max_;
    std::vector<std::uint32_t> a_;
    std::vector<std::uint32_t> b_;
    ByteWriter out_;
};

bool Unpacker::get_pairs(std::uint32_t count) {
    a_.resize(count);
    b_.resize(count);
    // Local copies stay in registers.
    ColumnReader a_step = columns_[a_steps];
    ColumnReader first_b_step = columns_[first_b_steps];
    ColumnReader run_length = columns_[run_lengths];
    ColumnReader b_step = columns_[b_steps];
    std::uint32_t a = 0;
    std::uint32_t b_first = 0;
    for (std::size_t i = 0; i < count; ++i) {
        a += static_cast<std::uint32_t>(a_step.get_number());
        b_first += static_cast<std::uint32_t>(unzigzag(first_b_step.get_number()));
        const std::uint64_t more = run_length.get_number();
        if (more >= count - i) {
            return false;
        }
        std::uint32_t b = b_first;
        a_[i] = a;
        b_[i] = b;
        for (const std::size_t last = i + more; i < last;) {
            b += static_cast<std::uint32_t>(b_step.get_number()) + 1;
            ++i;
            a_[i] = a;
            b_[i] = b;
        }
    }
    columns_[a_steps] = a_step;
    columns_[first_b_steps] = first_b_step;
    columns_[run_lengths] = run_length;
    columns_[b_steps] = b_step;
    return !has_failed();
}

Status Unpacker::add_record() {
    const std::uint64_t head_length = columns_[lengths].get_number();
    const std::uint64_t tail_length = columns_[lengths].get_number();
    const std::span<const std::byte> head = columns_[heads].get_bytes(head_length / 2);
    const std::span<const std::byte> tail = columns_[tails].get_bytes(tail_length);
    const bool has_pairs = head_length % 2 != 0;
    std::uint32_t count = 0;
    const bool is_cut = columns_[lengths].has_failed() || columns_[heads].has_failed() ||
                        columns_[tails].has_failed();
    if (is_cut || (has_pairs && head.size() < sizeof count)) {
        return bad();
    }
    if (has_pairs) {
        std::memcpy(&count, head.data() + head.size() - sizeof count, sizeof count);
    }
    const std::span<const std::byte> kinds = columns_[classes].get_bytes(count);
    if (columns_[classes].has_failed()) {
        return bad();
    }
    const std::uint64_t bytes = head.size() + pair_bytes * std::uint64_t{count} + tail.size();
    if (out_.size() + sizeof(std::uint32_t) + bytes > bytes_max_ || bytes > UINT32_MAX) {
        return Error{ErrorCode::TooLarge,
                     "packed records of more than " + std::to_string(bytes_max_) + " bytes"};
    }
    if (count != 0 && !get_pairs(count)) {
        return bad();
    }
    out_.put(static_cast<std::uint32_t>(bytes));
    put_bytes(out_, head);
    if (count != 0) {
        out_.put_array(std::span<const std::uint32_t>(a_));
        out_.put_array(std::span<const std::uint32_t>(b_));
        put_bytes(out_, kinds);
    }
    put_bytes(out_, tail);
    return Done{};
}

bool Unpacker::is_complete() const {
    return !has_failed() && std::ranges::all_of(columns_, &ColumnReader::is_at_end);
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

SentRecords records_to_send(Bytes records, bool is_within_host) {
    return is_within_host && records.size() <= limits::plain_records_bytes_max
               ? SentRecords{std::move(records), false}
               : SentRecords{pack_records(records), true};
}

Result<std::span<const std::byte>>
received_records(std::span<const std::byte> bytes, bool are_packed, Bytes& unpacked) {
    if (!are_packed) {
        return bytes;
    }
    unpacked = CD_TRY(unpack_records(bytes, limits::results_bytes_max));
    return std::span<const std::byte>(unpacked);
}

} // namespace cd

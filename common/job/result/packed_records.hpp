// Packs many records of results together for sending: lists of pairs take a quarter of the bytes
// that they take in separate records.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Packs canonical records (result.hpp), each preceded by its length as u32. Writes the compressed
/// lengths of eight columns as varints, then the columns, each compressed unless it is empty:
///
///     0: for each record, varints: twice the size of its head in bytes, plus 1 if pairs follow;
///        the size of its tail in bytes
///     1: heads: the bytes up to and including the number of pairs, or a whole record without pairs
///     2: tails: the bytes after the pairs
///     3: for each run of pairs with the same triangle of A, a varint: the step from the previous
///        run's triangle of A
///     4: for each run a varint: its number of pairs minus 1
///     5: for each run a zigzag varint: the step from the previous run's first triangle of B
///     6: for each pair that is not the first of its run, a varint: the step from the previous
///        pair's triangle of B, minus 1
///     7: the class of each pair, u8
///
/// The first steps of each record start from triangle 0. Most steps are small, because neighbouring
/// triangles have close indices.
[[nodiscard]] Bytes pack_records(std::span<const std::byte> records);

/// Unpacks the bytes of `pack_records`. The bytes are untrusted. The result has at most `bytes_max`
/// bytes of records, each preceded by its length; records need not be canonical. No allocation is
/// larger than `bytes_max`, or than 9 bytes for each byte of the uncompressed columns. Errors:
/// BadFrame, TooLarge.
[[nodiscard]] Result<Bytes> unpack_records(std::span<const std::byte> packed,
                                           std::uint64_t bytes_max);

/// Records as a message carries them.
struct SentRecords {
    Bytes bytes;
    bool are_packed = true; ///< False: each preceded by its length, as `pack_records` takes them.
};

/// Packs records for a message. Leaves them as they are if the receiver is on this host, where to
/// pack and unpack them costs more than to move them, unless they are more than
/// `limits::plain_records_bytes_max`.
[[nodiscard]] SentRecords records_to_send(Bytes records, bool is_within_host);

/// Returns the records of a message, each preceded by its length. They are part of `bytes`, or of
/// `unpacked`, if they were packed. The bytes are untrusted: records that were not packed may be
/// cut short. Errors: those of `unpack_records`.
[[nodiscard]] Result<std::span<const std::byte>>
received_records(std::span<const std::byte> bytes, bool are_packed, Bytes& unpacked);

} // namespace cd

// Packs many records of results together for sending: lists of pairs take a quarter of the bytes
// that they take in separate records.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Packs canonical records (result.hpp), each preceded by its length as u32: the lengths of eight
/// columns as varints, then the columns, each compressed separately, empty ones left uncompressed:
///
///     0: for each record, varints: twice the size of its head in bytes, plus 1 if pairs follow;
///        the size of its tail in bytes
///     1: heads: the bytes up to and with the number of pairs; without pairs the whole record
///     2: tails: the bytes after the pairs
///     3: for each run of pairs with the same triangle of A, a varint: the step from the previous
///        run's triangle of A
///     4: for each run a varint: its number of pairs minus 1
///     5: for each run a zigzag varint: the step from the previous run's first triangle of B
///     6: for each other pair a varint: the step from the previous pair's triangle of B, minus 1
///     7: the class of each pair, u8
///
/// In each record the first steps start from triangle 0. Neighbouring triangles have close numbers,
/// so most steps are small.
[[nodiscard]] Bytes pack_records(std::span<const std::byte> records);

/// Unpacks `pack_records`. The bytes are untrusted: the result holds records preceded by their
/// lengths, which need not be canonical, and at most `bytes_max` bytes; no allocation is larger
/// than that, or than 9 bytes for each byte of the uncompressed columns. Errors: BadFrame,
/// TooLarge.
[[nodiscard]] Result<Bytes> unpack_records(std::span<const std::byte> packed,
                                           std::uint64_t bytes_max);

} // namespace cd

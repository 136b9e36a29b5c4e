// Packs many records of results together for sending: lists of pairs take a quarter of the bytes
// that they take singly.
#pragma once

#include "common/core/files/bytes.hpp"
#include "common/core/result.hpp"

#include <cstdint>
#include <span>

namespace cd {

/// Packs canonical records (result.hpp), each preceded by its length as u32: the lengths of eight
/// columns as varints, then the columns, each compressed separately, empty ones left uncompressed:
///
///     0: of each record, varints: twice the bytes of its head, and 1 more if pairs follow; and the
///        bytes of its tail
///     1: heads: what stands before the pairs, and their number; without pairs the whole record
///     2: tails: what stands after the pairs
///     3: of each run of pairs with the same triangle of A, a varint: the step from that of the run
///        before
///     4: of each run a varint: its pairs less 1
///     5: of each run a zigzag varint: the step from the first triangle of B of the run before
///     6: of each other pair a varint: the step from the triangle of B before, less 1
///     7: the class of each pair, u8
///
/// Every record starts from triangles 0 and 0. Neighbouring triangles have close numbers, so most
/// steps are small.
[[nodiscard]] Bytes pack_records(std::span<const std::byte> records);

/// Unpacks `pack_records`. The bytes may be hostile: the result holds records preceded by their
/// lengths, which need not be canonical, and at most `bytes_max` bytes; nothing is allocated that
/// is larger, or that the uncompressed columns do not justify (9 bytes for one). Errors: BadFrame,
/// TooLarge.
[[nodiscard]] Result<Bytes> unpack_records(std::span<const std::byte> packed,
                                           std::uint64_t bytes_max);

} // namespace cd

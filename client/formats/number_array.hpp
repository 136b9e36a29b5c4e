// Arrays of numbers that are produced while they are written to a binary file.
#pragma once

#include "client/formats/output_file.hpp"
#include "common/core/errors.hpp"
#include "common/core/files/npy_header.hpp"
#include "common/core/host/stop_check.hpp"
#include "common/core/result.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace cd {

/// Receives the next bytes of an array.
using ByteSink = std::function<Status(std::span<const std::byte>)>;

/// An array of little-endian numbers whose size is known before they are produced.
struct NumberArray {
    NpyType type = NpyType::F8;
    std::uint64_t count = 0;
    /// Passes all numbers in order and in pieces. Errors: those of the sink. Unused if `count` is
    /// 0.
    std::function<Status(const ByteSink&)> produce = {};

    [[nodiscard]] std::uint64_t bytes() const { return count * size_of(type); }
};

/// Returns the type of an array of `Number`.
template <class Number>
requires std::integral<Number> || std::floating_point<Number>
[[nodiscard]] constexpr NpyType npy_type() {
    if constexpr (std::floating_point<Number>) {
        return sizeof(Number) == 8 ? NpyType::F8 : NpyType::F4;
    } else if constexpr (std::signed_integral<Number>) {
        return sizeof(Number) == 8   ? NpyType::I8
               : sizeof(Number) == 4 ? NpyType::I4
               : sizeof(Number) == 2 ? NpyType::I2
                                     : NpyType::I1;
    } else {
        return sizeof(Number) == 8   ? NpyType::U8
               : sizeof(Number) == 4 ? NpyType::U4
               : sizeof(Number) == 2 ? NpyType::U2
                                     : NpyType::U1;
    }
}

/// Makes an array whose number i is `number_at(i)`, which is called in ascending order.
template <class Number, class NumberAt>
[[nodiscard]] NumberArray make_numbers(std::uint64_t count, NumberAt number_at) {
    const auto produce = [count, number_at](const ByteSink& sink) -> Status {
        constexpr std::uint64_t numbers_at_once = 8192;
        NumberAt number = number_at; // A function may have state, such as the part found last.
        std::vector<Number> numbers;
        for (std::uint64_t i = 0; i < count; ++i) {
            numbers.push_back(static_cast<Number>(number(i)));
            if (numbers.size() == numbers_at_once) {
                CD_TRY(sink(std::as_bytes(std::span(numbers))));
                numbers.clear();
            }
        }
        return sink(std::as_bytes(std::span(numbers)));
    };
    return {npy_type<Number>(), count, produce};
}

/// Appends an array to a file. Errors: as `OutputFile::write`; Interrupted.
[[nodiscard]] Status
write_numbers(const NumberArray& array, OutputFile& file, const StopCheck& stop);

} // namespace cd

#include "client/import/text/ply_values.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

static_assert(std::endian::native == std::endian::little);

namespace cd {

PlyText::PlyText(const MeshSource& source, const PlyHeader& header)
    : source_(source),
      text_(
          source.bytes.substr(header.data_begin), TextReader::Backslash::IsText, header.data_line) {
}

bool PlyText::begin_element() {
    word_ = text_.word();
    return !word_.empty();
}

bool PlyText::end_element() {
    return word_.empty();
}

std::optional<double> PlyText::number(PlyType) {
    const auto value = to_number(word_);
    if (value) {
        word_ = text_.word_in_line();
    }
    return value;
}

std::optional<std::int64_t> PlyText::integer(PlyType) {
    const auto value = number_in<std::int64_t>(word_);
    if (value) {
        word_ = text_.word_in_line();
    }
    return value;
}

bool PlyText::skip(PlyType) {
    const bool is_there = !word_.empty();
    word_ = text_.word_in_line();
    return is_there;
}

Error PlyText::no_number(const std::string& element) const {
    return refusal(word_.empty() ? element + " has fewer numbers than its properties"
                                 : element + " has " + in_quotes(word_) +
                                       " in place of a number of its property");
}

Error PlyText::refusal(const std::string& detail) const {
    return source_.refusal(text_.line(), detail);
}

bool PlyText::has_room_for(const PlyElement& element) const {
    const std::size_t bytes = std::max<std::size_t>(1, 2 * element.properties.size());
    return element.count <= (text_.rest().size() + 1) / bytes;
}

bool PlyText::is_at_end() {
    return text_.word().empty();
}

PlyBinary::PlyBinary(const MeshSource& source, const PlyHeader& header)
    : source_(source),
      is_big_endian_(header.format == PlyFormat::BigEndian),
      at_(header.data_begin),
      element_begin_(at_) {}

bool PlyBinary::begin_element() {
    element_begin_ = at_;
    return at_ < source_.bytes.size();
}

/// Takes the next number's bits, in the lowest bytes; nothing at the end of the data.
std::optional<std::uint64_t> PlyBinary::take(PlyType type) {
    const std::size_t size = size_of(type);
    if (source_.bytes.size() - at_ < size) {
        return std::nullopt;
    }
    std::array<char, sizeof(std::uint64_t)> bytes{};
    std::memcpy(bytes.data(), source_.bytes.data() + at_, size);
    if (is_big_endian_) {
        std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    }
    at_ += size;
    return std::bit_cast<std::uint64_t>(bytes);
}

std::optional<double> PlyBinary::number(PlyType type) {
    if (is_integer(type)) {
        const auto value = integer(type);
        return value ? std::optional(static_cast<double>(*value)) : std::nullopt;
    }
    const auto bits = take(type);
    if (!bits) {
        return std::nullopt;
    }
    return type == PlyType::Float64
               ? std::bit_cast<double>(*bits)
               : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(*bits)));
}

std::optional<std::int64_t> PlyBinary::integer(PlyType type) {
    const auto bits = is_integer(type) ? take(type) : std::nullopt;
    if (!bits) {
        return std::nullopt;
    }
    // Copies the sign bit of a signed type to all higher bits.
    const bool is_signed =
        type == PlyType::Int8 || type == PlyType::Int16 || type == PlyType::Int32;
    const auto unused = 64 - 8 * size_of(type);
    return is_signed ? static_cast<std::int64_t>(*bits << unused) >> unused
                     : static_cast<std::int64_t>(*bits);
}

bool PlyBinary::skip(PlyType type) {
    return take(type).has_value();
}

Error PlyBinary::no_number(const std::string& element) const {
    return refusal("is cut short within " + element);
}

Error PlyBinary::refusal(const std::string& detail) const {
    return source_.refusal(detail + " (byte " + std::to_string(element_begin_) + ")");
}

bool PlyBinary::has_room_for(const PlyElement& element) const {
    std::size_t bytes = 0;
    for (const PlyProperty& property : element.properties) {
        bytes += size_of(property.count_type.value_or(property.type));
    }
    return bytes == 0 || element.count <= (source_.bytes.size() - at_) / bytes;
}

bool PlyBinary::is_at_end() const {
    constexpr std::string_view padding("\0\t\n\r ", 5);
    return source_.bytes.find_first_not_of(padding, at_) == std::string_view::npos;
}

} // namespace cd

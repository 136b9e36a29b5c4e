#include "client/import/text/ply_values.hpp"

#include "client/import/text/mesh_words.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
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
    std::int64_t value = 0;
    const char* const end = word_.data() + word_.size();
    const auto [behind, error] = std::from_chars(word_.data(), end, value);
    if (word_.empty() || behind != end || error != std::errc{}) {
        return std::nullopt;
    }
    word_ = text_.word_in_line();
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

template <class T>
T PlyBinary::load() const {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), source_.bytes.data() + at_, sizeof(T));
    if (is_big_endian_) {
        std::reverse(bytes.begin(), bytes.end());
    }
    return std::bit_cast<T>(bytes);
}

std::optional<double> PlyBinary::number(PlyType type) {
    if (source_.bytes.size() - at_ < size_of(type)) {
        return std::nullopt;
    }
    double value = 0;
    if (type == PlyType::Float32) {
        value = static_cast<double>(load<float>());
    } else if (type == PlyType::Float64) {
        value = load<double>();
    } else {
        return static_cast<double>(*integer(type));
    }
    at_ += size_of(type);
    return value;
}

std::optional<std::int64_t> PlyBinary::integer(PlyType type) {
    if (source_.bytes.size() - at_ < size_of(type)) {
        return std::nullopt;
    }
    std::int64_t value = 0;
    switch (type) {
    case PlyType::Int8:
        value = load<std::int8_t>();
        break;
    case PlyType::Uint8:
        value = load<std::uint8_t>();
        break;
    case PlyType::Int16:
        value = load<std::int16_t>();
        break;
    case PlyType::Uint16:
        value = load<std::uint16_t>();
        break;
    case PlyType::Int32:
        value = load<std::int32_t>();
        break;
    case PlyType::Uint32:
        value = load<std::uint32_t>();
        break;
    case PlyType::Float32:
    case PlyType::Float64:
        return std::nullopt;
    }
    at_ += size_of(type);
    return value;
}

bool PlyBinary::skip(PlyType type) {
    if (source_.bytes.size() - at_ < size_of(type)) {
        return false;
    }
    at_ += size_of(type);
    return true;
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

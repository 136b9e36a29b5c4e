#include "client/import/text/ply_header.hpp"

#include "client/import/text/text_reader.hpp"
#include "common/core/errors.hpp"

#include <algorithm>
#include <array>

namespace cd {

namespace {

struct TypeName {
    std::string_view old_name;
    std::string_view name;
    PlyType type;
};

constexpr std::array type_names{TypeName{"char", "int8", PlyType::Int8},
                                TypeName{"uchar", "uint8", PlyType::Uint8},
                                TypeName{"short", "int16", PlyType::Int16},
                                TypeName{"ushort", "uint16", PlyType::Uint16},
                                TypeName{"int", "int32", PlyType::Int32},
                                TypeName{"uint", "uint32", PlyType::Uint32},
                                TypeName{"float", "float32", PlyType::Float32},
                                TypeName{"double", "float64", PlyType::Float64}};

std::optional<PlyType> to_type(std::string_view word) {
    const auto found = std::find_if(type_names.begin(), type_names.end(), [&](const TypeName& t) {
        return word == t.name || word == t.old_name;
    });
    return found == type_names.end() ? std::nullopt : std::optional(found->type);
}

std::optional<PlyFormat> to_format(std::string_view word) {
    if (word == "ascii") {
        return PlyFormat::Text;
    }
    if (word == "binary_little_endian") {
        return PlyFormat::LittleEndian;
    }
    return word == "binary_big_endian" ? std::optional(PlyFormat::BigEndian) : std::nullopt;
}

/// Returns how the header's lines end: "\r" if no "\n" follows the first "\r", else "\n". All lines
/// of a header end like the first, so the data may begin with any byte.
char line_end_of(std::string_view bytes) {
    const std::size_t end = bytes.find_first_of("\r\n");
    const bool is_return = end != bytes.npos && bytes[end] == '\r';
    return is_return && bytes.substr(end + 1, 1) != "\n" ? '\r' : '\n';
}

class HeaderReader {
  public:
    explicit HeaderReader(const MeshSource& source)
        : source_(source), line_end_(line_end_of(source.bytes)) {}

    Result<PlyHeader> read() {
        const std::string_view magic = next_line();
        if (magic != "ply" && magic != "PLY") {
            return source_.refusal("is no PLY file: its first line is not 'ply'");
        }
        bool has_format = false;
        while (at_ < source_.bytes.size()) {
            TextReader words(next_line());
            const std::string_view keyword = words.word();
            if (keyword == "end_header") {
                header_.data_begin = at_;
                header_.data_line = line_ + 1;
                return has_format ? Result(std::move(header_)) : refusal("no format was named");
            }
            CD_TRY(take(keyword, words));
            has_format = has_format || keyword == "format";
        }
        return source_.refusal("is cut short: its header has no line 'end_header'");
    }

  private:
    Error refusal(const std::string& detail) const { return source_.refusal(line_, detail); }

    std::string_view next_line() {
        const std::string_view rest = source_.bytes.substr(at_);
        std::string_view line = rest.substr(0, rest.find(line_end_));
        at_ = std::min(source_.bytes.size(), at_ + line.size() + 1);
        ++line_;
        line.remove_suffix(line.ends_with('\r') ? 1 : 0);
        return line;
    }

    Status take(std::string_view keyword, TextReader& words) {
        if (keyword == "format") {
            return take_format(words);
        }
        if (keyword == "element") {
            return take_element(words);
        }
        if (keyword == "property") {
            return take_property(words);
        }
        const bool is_comment = keyword == "comment" || keyword == "obj_info" || keyword.empty();
        return is_comment ? Status(Done{})
                          : refusal(in_quotes(keyword) + " is no line of a PLY header");
    }

    Status take_format(TextReader& words) {
        const auto format = to_format(words.word());
        if (!format || words.word() != "1.0") {
            return refusal("a format other than ascii, binary_little_endian and binary_big_endian, "
                           "each 1.0");
        }
        header_.format = *format;
        return Done{};
    }

    Status take_element(TextReader& words) {
        const std::string_view name = words.word();
        const auto count = to_whole(words.word());
        if (!count) {
            return refusal("an element without a name and a count");
        }
        header_.elements.push_back({std::string(name), *count, {}});
        return Done{};
    }

    Status take_property(TextReader& words) {
        if (header_.elements.empty()) {
            return refusal("a property before any element");
        }
        PlyProperty property;
        std::string_view word = words.word();
        if (word == "list") {
            property.count_type = to_type(words.word());
            if (!property.count_type || !is_integer(*property.count_type)) {
                return refusal("a list whose count has no whole type");
            }
            word = words.word();
        }
        const auto type = to_type(word);
        property.name = words.word();
        if (!type || property.name.empty()) {
            return refusal("a property without a known type and a name");
        }
        property.type = *type;
        header_.elements.back().properties.push_back(std::move(property));
        return Done{};
    }

    const MeshSource& source_;
    char line_end_;
    std::size_t at_ = 0;
    std::uint64_t line_ = 0;
    PlyHeader header_;
};

} // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) {
    return type != PlyType::Float32 && type != PlyType::Float64;
}

Result<PlyHeader> read_ply_header(const MeshSource& source) {
    return HeaderReader(source).read();
}

} // namespace cd

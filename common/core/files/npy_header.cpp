#include "common/core/files/npy_header.hpp"

#include "common/core/errors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

namespace cd {

namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::size_t header_text_max = npy_header_bytes_max - 16;

struct TypeName {
    std::string_view text;
    NpyType type;
    std::size_t size;
};

constexpr std::array<TypeName, 10> types{{{"<f8", NpyType::F8, 8},
                                          {"<f4", NpyType::F4, 4},
                                          {"<i8", NpyType::I8, 8},
                                          {"<i4", NpyType::I4, 4},
                                          {"<i2", NpyType::I2, 2},
                                          {"|i1", NpyType::I1, 1},
                                          {"<u8", NpyType::U8, 8},
                                          {"<u4", NpyType::U4, 4},
                                          {"<u2", NpyType::U2, 2},
                                          {"|u1", NpyType::U1, 1}}};

const TypeName& name_of(NpyType type) {
    return *std::find_if(
        types.begin(), types.end(), [&](const TypeName& name) { return name.type == type; });
}

/// Returns the value of 'key' in the header's dictionary, up to the next comma outside parentheses.
std::optional<std::string_view> value_of(std::string_view dictionary, std::string_view key) {
    const std::string quoted = "'" + std::string(key) + "':";
    const std::size_t found = dictionary.find(quoted);
    if (found == std::string_view::npos) {
        return std::nullopt;
    }
    std::string_view rest = dictionary.substr(found + quoted.size());
    int depth = 0;
    std::size_t end = 0;
    for (; end < rest.size(); ++end) {
        const char c = rest[end];
        if (depth == 0 && (c == ',' || c == '}')) {
            break;
        }
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    }
    rest = rest.substr(0, end);
    const std::size_t first = rest.find_first_not_of(' ');
    const std::size_t last = rest.find_last_not_of(' ');
    return first == std::string_view::npos ? std::string_view{}
                                           : rest.substr(first, last - first + 1);
}

/// Parses a shape such as "(3,)", "()" or "(2, 4, 4)".
std::optional<std::vector<std::uint64_t>> parse_shape(std::string_view text) {
    if (text.size() < 2 || text.front() != '(' || text.back() != ')') {
        return std::nullopt;
    }
    text = text.substr(1, text.size() - 2);
    std::vector<std::uint64_t> shape;
    while (!text.empty()) {
        const std::size_t skip = text.find_first_not_of(" ,");
        if (skip == std::string_view::npos) {
            break;
        }
        text.remove_prefix(skip);
        std::uint64_t size = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
        if (error != std::errc{} || shape.size() == 8) {
            return std::nullopt;
        }
        shape.push_back(size);
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    return shape;
}

Result<NpyHeader> parse_dictionary(std::string_view dictionary) {
    const auto description = value_of(dictionary, "descr");
    const auto order = value_of(dictionary, "fortran_order");
    const auto shape_text = value_of(dictionary, "shape");
    if (!description || !order || !shape_text) {
        return bad_input("a NumPy header without descr, fortran_order and shape");
    }
    NpyHeader header;
    const auto type = std::find_if(types.begin(), types.end(), [&](const TypeName& name) {
        return *description == "'" + std::string(name.text) + "'";
    });
    if (type == types.end()) {
        return bad_input("a NumPy array of type " + std::string(description->substr(0, 40)) +
                         "; convert it to float64 or int64");
    }
    header.type = type->type;
    header.is_fortran = *order == "True";
    const auto shape = parse_shape(*shape_text);
    if (!shape || (!header.is_fortran && *order != "False")) {
        return bad_input("a NumPy header with a damaged shape");
    }
    header.shape = *shape;
    return header;
}

} // namespace

std::size_t size_of(NpyType type) {
    return name_of(type).size;
}

std::string_view to_text(NpyType type) {
    return name_of(type).text;
}

std::uint64_t NpyHeader::count() const {
    std::uint64_t product = 1;
    for (const std::uint64_t size : shape) {
        if (size != 0 && product > ~std::uint64_t{0} / size) {
            return ~std::uint64_t{0};
        }
        product *= size;
    }
    return product;
}

Result<NpyHeader> parse_npy_header(std::span<const std::byte> file) {
    ByteReader in(file);
    const auto start = in.get_array<char>(magic.size());
    if (in.failed() || std::string_view(start.data(), start.size()) != magic) {
        return bad_input("not a NumPy array file");
    }
    const auto major = in.get<std::uint8_t>();
    static_cast<void>(in.get<std::uint8_t>());
    const std::uint32_t size = major == 1 ? in.get<std::uint16_t>() : in.get<std::uint32_t>();
    if (in.failed() || major < 1 || major > 3 || size > header_text_max) {
        return bad_input("a NumPy array file of an unknown version");
    }
    const auto text = in.get_array<char>(size);
    if (in.failed()) {
        return bad_input("a NumPy array file that is cut short in its header");
    }
    auto header = parse_dictionary({text.data(), text.size()});
    if (header) {
        header.value().data_offset = file.size() - in.remaining();
    }
    return header;
}

Bytes make_npy_header(NpyType type, std::span<const std::uint64_t> shape) {
    std::string text =
        "{'descr': '" + std::string(to_text(type)) + "', 'fortran_order': False, 'shape': (";
    for (const std::uint64_t size : shape) {
        text += std::to_string(size) + ", ";
    }
    text.resize(text.size() - (shape.size() > 1 ? 2 : shape.empty() ? 0 : 1));
    text += "), }";
    const std::size_t before_text = magic.size() + 4;
    text.resize(npy_header_bytes - before_text - 1, ' ');
    text += '\n';
    ByteWriter out;
    out.put_array(std::span<const char>(magic.data(), magic.size()));
    out.put(std::uint8_t{1});
    out.put(std::uint8_t{0});
    out.put(static_cast<std::uint16_t>(text.size()));
    out.put_array(std::span<const char>(text.data(), text.size()));
    return out.take();
}

} // namespace cd

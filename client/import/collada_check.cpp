#include "client/import/collada_check.hpp"

#include "client/import/mesh_words.hpp"
#include "common/core/limits.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace cd {

namespace {

/// One piece of an XML file.
struct Piece {
    enum class Kind { Begin, End, Text, Nothing };
    Kind kind = Kind::Nothing;
    std::string_view text;       ///< Of an element that begins, its name.
    std::string_view attributes; ///< Of an element that begins.
    bool is_whole = false;       ///< Of an element that begins: it ends as well.
};

/// Cuts an XML file into pieces. What is not well-formed ends it: the importer says so.
class XmlPieces {
  public:
    explicit XmlPieces(std::string_view text) : rest_(text) {}

    std::optional<Piece> next() {
        if (rest_.empty()) {
            return std::nullopt;
        }
        if (!rest_.starts_with('<')) {
            const auto text = rest_.substr(0, rest_.find('<'));
            rest_.remove_prefix(text.size());
            return Piece{Piece::Kind::Text, text, {}, false};
        }
        if (rest_.starts_with("<!--")) {
            return until("-->", 4, Piece::Kind::Nothing);
        }
        if (rest_.starts_with("<![CDATA[")) {
            return until("]]>", 9, Piece::Kind::Text);
        }
        if (rest_.starts_with("<?")) {
            return until("?>", 2, Piece::Kind::Nothing);
        }
        if (rest_.starts_with("<!")) {
            return until(">", 2, Piece::Kind::Nothing);
        }
        return rest_.starts_with("</") ? until(">", 2, Piece::Kind::End) : element();
    }

  private:
    std::optional<Piece> until(std::string_view end, std::size_t begin, Piece::Kind kind) {
        const std::size_t at = rest_.find(end, begin);
        if (at == rest_.npos) {
            return std::nullopt;
        }
        const std::string_view text = rest_.substr(begin, at - begin);
        rest_.remove_prefix(at + end.size());
        return Piece{kind, text, {}, false};
    }

    std::optional<Piece> element() {
        char quote = 0;
        for (std::size_t i = 1; i < rest_.size(); ++i) {
            const char c = rest_[i];
            if (quote != 0) {
                quote = c == quote ? '\0' : quote;
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '>') {
                Piece piece{Piece::Kind::Begin, rest_.substr(1, i - 1), {}, false};
                rest_.remove_prefix(i + 1);
                piece.is_whole = piece.text.ends_with('/');
                piece.text.remove_suffix(piece.is_whole ? 1 : 0);
                const std::size_t name =
                    std::min(piece.text.find_first_of(" \t\r\n"), piece.text.size());
                piece.attributes = piece.text.substr(name);
                piece.text = piece.text.substr(0, name);
                return piece;
            }
        }
        return std::nullopt;
    }

    std::string_view rest_;
};

struct Attribute {
    std::string_view name;
    std::string_view value;
};

/// The first of the attributes, which is taken off them.
std::optional<Attribute> next_attribute(std::string_view& attributes) {
    const std::size_t equals = attributes.find('=');
    const std::size_t begin =
        equals == attributes.npos ? equals : attributes.find_first_of("\"'", equals);
    if (begin == attributes.npos) {
        return std::nullopt;
    }
    const std::size_t end = attributes.find(attributes[begin], begin + 1);
    if (end == attributes.npos) {
        return std::nullopt;
    }
    const Attribute attribute{Words(attributes.substr(0, equals)).next(),
                              attributes.substr(begin + 1, end - begin - 1)};
    attributes.remove_prefix(end + 1);
    return attribute;
}

/// An element whose text is numbers.
struct NumberElement {
    std::string_view name;
    std::uint64_t count; ///< Of its numbers; 0 for any.
    bool is_whole;       ///< Its numbers are indices or counts.
};

constexpr std::array<NumberElement, 9> number_elements{{
    {"float_array", 0, false},
    {"matrix", 16, false},
    {"translate", 3, false},
    {"rotate", 4, false},
    {"scale", 3, false},
    {"skew", 7, false},
    {"lookat", 9, false},
    {"p", 0, true},
    {"vcount", 0, true},
}};

/// The importer keeps indices in an int.
bool is_index(std::string_view word) {
    const auto value = to_whole(word);
    return value && *value <= std::numeric_limits<int>::max();
}

/// What reads an array of numbers: `count` elements, `stride` apart, of which each has `params`.
struct Accessor {
    std::string_view place; ///< In the file.
    std::string_view array; ///< Empty where it names none.
    std::uint64_t count = 0;
    std::uint64_t offset = 0;
    std::uint64_t stride = 1;
    std::uint64_t params = 0;

    /// Indices are ints, so nothing here overflows.
    [[nodiscard]] std::uint64_t numbers() const {
        return count == 0 ? 0 : offset + (count - 1) * stride + std::max(stride, params);
    }
};

class ColladaCheck {
  public:
    ColladaCheck(const std::filesystem::path& path, std::string_view text)
        : path_(path), text_(text) {}

    Status run() {
        XmlPieces pieces(text_);
        for (auto piece = pieces.next(); piece; piece = pieces.next()) {
            if (Status status = check(*piece); !status) {
                return status;
            }
        }
        return check_accessors();
    }

  private:
    Status check(const Piece& piece) {
        switch (piece.kind) {
        case Piece::Kind::Begin:
            return begin(piece);
        case Piece::Kind::End:
            depth_ -= depth_ > 0 ? 1 : 0;
            extra_depth_ = depth_ < extra_depth_ ? 0 : extra_depth_;
            numbers_.reset();
            in_accessor_ = in_accessor_ && piece.text != "accessor";
            return Done{};
        case Piece::Kind::Text:
            return numbers_ ? check_words(piece.text) : Status(Done{});
        case Piece::Kind::Nothing:
            break;
        }
        return Done{};
    }

    Status begin(const Piece& piece) {
        if (numbers_) {
            return bad(piece.text, in_element() + "an element among its numbers");
        }
        depth_ += piece.is_whole ? 0 : 1;
        if (depth_ > limits::mesh_file_depth_max) {
            return bad(piece.text,
                       "elements nested more than " + std::to_string(limits::mesh_file_depth_max) +
                           " deep");
        }
        if (extra_depth_ > 0 || piece.is_whole) {
            return extra_depth_ > 0 ? Status(Done{}) : check_attributes(piece);
        }
        if (piece.text == "extra" || piece.text == "technique") { // Not read, or not for meshes.
            extra_depth_ = depth_;
            return Done{};
        }
        const auto* const found =
            std::find_if(number_elements.begin(),
                         number_elements.end(),
                         [&](const NumberElement& element) { return element.name == piece.text; });
        if (found != number_elements.end()) {
            numbers_ = *found;
            has_text_ = false;
        }
        return check_attributes(piece);
    }

    Status check_attributes(const Piece& piece) {
        std::string_view rest = piece.attributes;
        for (auto attribute = next_attribute(rest); attribute; attribute = next_attribute(rest)) {
            const auto& [name, value] = *attribute;
            const bool is_whole = name == "count" || name == "offset" || name == "stride";
            const bool is_meter = name == "meter" && piece.text == "unit";
            if ((is_whole && !is_index(value)) || (is_meter && !to_number(value))) {
                return bad(value,
                           std::string(name) + " is '" + std::string(value) + "', which is not a " +
                               (is_whole ? "whole " : "") + "number");
            }
            if (numbers_ && numbers_->name == "float_array" && name == "count") {
                numbers_->count = *to_whole(value);
            }
        }
        note_array_or_accessor(piece);
        return Done{};
    }

    void note_array_or_accessor(const Piece& piece) {
        std::map<std::string_view, std::string_view> values;
        std::string_view rest = piece.attributes;
        for (auto attribute = next_attribute(rest); attribute; attribute = next_attribute(rest)) {
            values.emplace(attribute->name, attribute->value);
        }
        const auto number = [&](std::string_view name, std::uint64_t otherwise) {
            const auto found = values.find(name);
            return found == values.end() ? otherwise : to_whole(found->second).value_or(otherwise);
        };
        if (piece.text == "float_array") {
            arrays_[values["id"]] = number("count", 0);
        } else if (piece.text == "accessor") {
            const std::string_view source = values["source"];
            accessors_.push_back({piece.text,
                                  source.substr(source.starts_with('#') ? 1 : 0),
                                  number("count", 0),
                                  number("offset", 0),
                                  number("stride", 1)});
            in_accessor_ = !piece.is_whole;
        } else if (piece.text == "param" && in_accessor_) {
            ++accessors_.back().params;
        }
    }

    /// The importer reads beyond the array's end.
    Status check_accessors() const {
        for (const Accessor& accessor : accessors_) {
            const auto array = arrays_.find(accessor.array);
            if (array != arrays_.end() && accessor.numbers() > array->second) {
                return bad(accessor.place,
                           "an accessor of " + std::to_string(accessor.numbers()) +
                               " numbers to an array that counts " + std::to_string(array->second));
            }
        }
        return Done{};
    }

    Status check_words(std::string_view text) {
        Words words(text);
        std::uint64_t count = 0;
        std::string_view last;
        for (auto word = words.next(); !word.empty(); word = words.next()) {
            if (numbers_->is_whole ? !is_index(word) : !to_number(word)) {
                return bad(word,
                           in_element() + "'" + std::string(word) + "' is not " +
                               (numbers_->is_whole ? "an index" : "a number"));
            }
            last = word;
            ++count;
        }
        if (count == 0) {
            return Done{};
        }
        if (has_text_) {
            return bad(last, in_element() + "the importer reads its text up to here only");
        }
        has_text_ = true;
        if (numbers_->count != 0 && count != numbers_->count) {
            return bad(last,
                       in_element() + std::to_string(count) + " numbers in place of " +
                           std::to_string(numbers_->count));
        }
        return Done{};
    }

    [[nodiscard]] std::string in_element() const {
        return "in <" + std::string(numbers_->name) + ">, ";
    }

    /// `place` is a part of the file's text.
    [[nodiscard]] Error bad(std::string_view place, const std::string& detail) const {
        const auto line = 1 + std::count(text_.data(), place.data(), '\n');
        return {ErrorCode::BadInput, path_.string() + ":" + std::to_string(line) + ": " + detail};
    }

    const std::filesystem::path& path_;
    std::string_view text_;
    std::size_t depth_ = 0;
    std::size_t extra_depth_ = 0; ///< Of an element of extras that is open, or 0.
    std::optional<NumberElement> numbers_;
    bool has_text_ = false;                            ///< `numbers_` had words already.
    std::map<std::string_view, std::uint64_t> arrays_; ///< Their counts, by id.
    std::vector<Accessor> accessors_;
    bool in_accessor_ = false;
};

} // namespace

bool is_collada(const std::string& text) {
    return text.find("<COLLADA") != std::string::npos;
}

Status check_collada(const std::filesystem::path& path, const std::string& text) {
    return ColladaCheck(path, text).run();
}

} // namespace cd

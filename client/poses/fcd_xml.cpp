#include "client/poses/csv_columns.hpp"
#include "client/poses/fcd_file.hpp"
#include "client/poses/traffic_builder.hpp"
#include "common/core/errors.hpp"
#include "common/core/limits/client.hpp"

#include <expat.h>

#include <algorithm>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <utility>

namespace cd {

namespace {

constexpr std::size_t bytes_at_once = 1u << 16;

struct FreesParser {
    void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

/// Returns the value of an attribute; nothing if the element has none of that name. `attributes`
/// has names and values in turn, and ends with null.
std::optional<std::string_view> attribute(const XML_Char** attributes, std::string_view name) {
    for (; *attributes != nullptr; attributes += 2) {
        if (name == attributes[0]) {
            return attributes[1];
        }
    }
    return std::nullopt;
}

/// Parses a document piece by piece. Expat is C, so no exception passes through its calls.
class FcdParsing {
  public:
    explicit FcdParsing(const FcdSpec& spec) : builder_(spec), parser_(XML_ParserCreate(nullptr)) {
        if (parser_ == nullptr) {
            throw std::bad_alloc();
        }
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), on_start, on_end);
        XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
    }

    Result<RoadTraffic> run(std::istream& in) {
        std::string piece(bytes_at_once, '\0');
        bool is_last = false;
        while (!is_last) {
            in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
            if (in.bad()) {
                return Error{ErrorCode::Io, "cannot be read beyond line " + std::to_string(line())};
            }
            is_last = in.eof();
            CD_TRY(parse(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount())),
                         is_last));
        }
        return builder_.finish();
    }

  private:
    static void on_start(void* self, const XML_Char* name, const XML_Char** attributes) {
        auto& parsing = *static_cast<FcdParsing*>(self);
        parsing.guard([&] { return parsing.start(name, attributes); });
    }
    static void on_end(void* self, const XML_Char* /*name*/) {
        --static_cast<FcdParsing*>(self)->depth_;
    }
    static void on_doctype(void* self,
                           const XML_Char* /*name*/,
                           const XML_Char* /*system_id*/,
                           const XML_Char* /*public_id*/,
                           int /*has_internal_subset*/) {
        auto& parsing = *static_cast<FcdParsing*>(self);
        parsing.guard([&] {
            return Status(error_in_line(parsing.line(), "has a document type, and FCD has none"));
        });
    }

    /// Does the work of a handler. After an error, no further handler is called.
    template <class Work>
    void guard(const Work& work) {
        try {
            if (const Status done = work(); !done) {
                stop(done.error());
            }
        } catch (const std::bad_alloc&) {
            stop({ErrorCode::TooLarge, {}});
        }
    }

    void stop(Error error) {
        error_ = std::move(error);
        XML_StopParser(parser_.get(), XML_FALSE);
    }

    [[nodiscard]] std::uint64_t line() const { return XML_GetCurrentLineNumber(parser_.get()); }

    Status start(std::string_view name, const XML_Char** attributes) {
        const std::size_t depth = depth_++;
        if (depth >= limits::fcd_depth_max) {
            return error_in_line(line(), "elements are nested too deep for FCD");
        }
        if (depth == 0 && name != "fcd-export") {
            return error_in_line(line(),
                                 "is no FCD of SUMO, whose first element is fcd-export; write one "
                                 "with sumo --fcd-output");
        }
        if (depth == 1) {
            is_in_step_ = name == "timestep";
            return is_in_step_ ? start_step(attributes) : Status(Done{});
        }
        return depth == 2 && is_in_step_ && name == "vehicle" ? add_vehicle(attributes)
                                                              : Status(Done{});
    }

    Status start_step(const XML_Char** attributes) {
        const auto time = attribute(attributes, "time");
        return time ? builder_.begin_step(*time, line())
                    : Status(error_in_line(line(), "a timestep without time"));
    }

    Status add_vehicle(const XML_Char** attributes) {
        FcdTexts texts;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            texts[i] = attribute(attributes, fcd_attributes[i]);
        }
        return builder_.add(texts, line());
    }

    Status parse(std::string_view piece, bool is_last) {
        bytes_ += piece.size();
        const XML_Status status =
            XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()), is_last);
        if (error_) {
            if (error_->code == ErrorCode::TooLarge) {
                throw std::bad_alloc();
            }
            return *error_;
        }
        if (status != XML_STATUS_OK) {
            return problem();
        }
        // Expat keeps what it cannot yet parse: a tag or comment without its end.
        const XML_Index parsed = std::max<XML_Index>(0, XML_GetCurrentByteIndex(parser_.get()));
        if (!is_last && bytes_ - static_cast<std::uint64_t>(parsed) >
                            bytes_at_once + limits::fcd_markup_bytes_max) {
            return error_in_line(line(), "a tag or comment is too long for FCD");
        }
        return Done{};
    }

    [[nodiscard]] Error problem() const {
        const XML_Error code = XML_GetErrorCode(parser_.get());
        if (code == XML_ERROR_NO_MEMORY) {
            throw std::bad_alloc();
        }
        return error_in_line(line(),
                             std::string("is not well-formed XML: ") + XML_ErrorString(code));
    }

    TrafficBuilder builder_;
    std::unique_ptr<XML_ParserStruct, FreesParser> parser_;
    std::uint64_t bytes_ = 0;    ///< Bytes that the parser was given.
    std::size_t depth_ = 0;      ///< Elements that are open.
    bool is_in_step_ = false;    ///< The open element below the root is a step.
    std::optional<Error> error_; ///< The error of a handler.
};

} // namespace

Result<RoadTraffic> read_fcd_xml(std::istream& in, const FcdSpec& spec) {
    return FcdParsing(spec).run(in);
}

} // namespace cd

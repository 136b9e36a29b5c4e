#include "library/errors.hpp"

#include "common/core/version.hpp"
#include "library/include/cdcluster/cdcluster.hpp"

namespace cdcluster {

namespace {

ErrorCode code_of(cd::ErrorCode code) {
    switch (code) {
    case cd::ErrorCode::NotFound:
        return ErrorCode::NotFound;
    case cd::ErrorCode::Io:
        return ErrorCode::Io;
    case cd::ErrorCode::TooLarge:
        return ErrorCode::TooLarge;
    case cd::ErrorCode::Interrupted:
        return ErrorCode::Interrupted;
    case cd::ErrorCode::BadInput:
    case cd::ErrorCode::BadFrame:
    case cd::ErrorCode::Timeout:
    case cd::ErrorCode::Disconnected:
    case cd::ErrorCode::Refused:
    case cd::ErrorCode::Incomplete:
        break;
    }
    return ErrorCode::BadInput;
}

} // namespace

std::string_view version() {
    return cd::version;
}

Error::Error(ErrorCode code, const std::string& detail) : std::runtime_error(detail), code_(code) {}

Error::~Error() = default;

void throw_error(const cd::Error& error) {
    throw Error(code_of(error.code), error.detail);
}

} // namespace cdcluster

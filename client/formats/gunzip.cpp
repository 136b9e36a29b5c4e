#include "client/formats/gunzip.hpp"

#include "client/formats/output_file.hpp"

#include <zlib.h>

#include <memory>
#include <string_view>
#include <vector>

namespace cd {

namespace {

struct Close {
    void operator()(gzFile file) const { gzclose(file); }
};

} // namespace

Status gunzip(const std::filesystem::path& from, const std::filesystem::path& to) {
    const std::unique_ptr<gzFile_s, Close> in(gzopen(from.c_str(), "rb"));
    if (!in) {
        return Error{ErrorCode::Io, from.string() + ": cannot be opened"};
    }
    auto out = OutputFile::create(to);
    if (!out) {
        return out.error();
    }
    std::vector<char> buffer(1u << 20);
    int size = 0;
    while ((size = gzread(in.get(), buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
        const std::string_view text(buffer.data(), static_cast<std::size_t>(size));
        if (Status written = out.value().write(text); !written) {
            return written;
        }
    }
    // A truncated file ends without an error; only the stream's state reveals it.
    int state = Z_OK;
    const char* message = gzerror(in.get(), &state);
    if (size < 0 || state != Z_OK) {
        return Error{ErrorCode::BadInput, from.string() + ": damaged (" + message + ")"};
    }
    return out.value().commit();
}

} // namespace cd

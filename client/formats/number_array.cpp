#include "client/formats/number_array.hpp"

#include "common/core/check.hpp"

#include <string_view>

namespace cd {

Status write_numbers(const NumberArray& array, OutputFile& file, const StopCheck& stop) {
    if (array.count == 0) {
        return Done{};
    }
    std::uint64_t written = 0;
    CD_TRY(array.produce([&](std::span<const std::byte> bytes) -> Status {
        if (stop && stop()) {
            return interrupted();
        }
        written += bytes.size();
        return file.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }));
    CD_CHECK(written == array.bytes());
    return Done{};
}

} // namespace cd

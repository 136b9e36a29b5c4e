#include "client/formats/csv_rows.hpp"

#include "common/core/errors.hpp"
#include "common/core/words.hpp"

#include <utility>

namespace cd {

PartFields::PartFields(const std::shared_ptr<const Mesh>& mesh) : parts_(mesh) {
    for (const Part& part : parts_.parts()) {
        fields_.push_back(csv_field(part.name));
    }
}

std::string_view PartFields::of(std::uint32_t triangle) {
    const auto part = parts_.find(triangle);
    return part ? std::string_view(fields_[*part]) : std::string_view();
}

Result<RowFile> RowFile::create(const std::filesystem::path& path, std::string_view header) {
    auto created = CD_TRY(OutputFile::create(path));
    RowFile file(std::move(created));
    CD_TRY(file.add(header));
    return file;
}

Status RowFile::commit() {
    Status written = write();
    return written ? file_.commit() : written;
}

Status RowFile::write() {
    Status written = file_.write(rows_.text());
    rows_.clear();
    return written;
}

} // namespace cd

// Files of a few lines, for tests of the importer.
#pragma once

#include "client/import/mesh_import.hpp"
#include "tests/support/process.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace cd::tests {

inline Result<ImportedMesh> import_text(const std::string& name, const std::string& text) {
    const TemporaryFolder folder;
    write_text(folder / name, text);
    return import_mesh(folder / name, {});
}

/// Returns the mesh of a file that must have been accepted.
inline const Mesh& mesh_of(const Result<ImportedMesh>& imported) {
    if (!imported) {
        throw std::runtime_error(imported.error().detail);
    }
    return *imported.value().mesh;
}

/// Returns the one line with which the file is refused.
inline std::string error_of(const std::string& name, const std::string& text) {
    const auto imported = import_text(name, text);
    if (imported) {
        return "was taken";
    }
    EXPECT_EQ(imported.error().code, ErrorCode::BadInput);
    EXPECT_THAT(imported.error().detail, testing::HasSubstr(name));
    EXPECT_EQ(imported.error().detail.find('\n'), std::string::npos);
    return imported.error().detail;
}

} // namespace cd::tests

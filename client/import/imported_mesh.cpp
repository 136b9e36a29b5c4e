#include "client/import/imported_mesh.hpp"

#include "client/base/units.hpp"

namespace cd {

double factor_of(const ImportOptions& options, const DeclaredFrame& declared) {
    if (declared.metres > 0 && !options.declared_unit_to.empty()) {
        return unit_factor_of_metres(declared.metres, options.declared_unit_to)
            .value_or(options.unit_factor);
    }
    return options.unit_factor;
}

std::vector<std::string>
import_notes(const ImportedMesh& imported, const std::string& unit, bool is_y_up) {
    const DeclaredFrame& declared = imported.declared;
    std::vector<std::string> notes;
    if (!declared.unit.empty()) {
        notes.push_back(unit.empty()
                            ? "unit " + declared.unit + ", from the file"
                            : "unit " + unit + ", as asked; the file says " + declared.unit);
    }
    if (is_y_up) {
        notes.emplace_back("turned from y up to z up");
    } else if (!declared.up.empty()) {
        notes.push_back("up axis " + declared.up + ", from the file; not turned");
    }
    if (imported.is_rounded) {
        notes.emplace_back("coordinates rounded to floats, as asked");
    }
    if (imported.is_by_assimp) {
        notes.emplace_back("read by assimp: coordinates within one float step of the file's");
    }
    return notes;
}

} // namespace cd

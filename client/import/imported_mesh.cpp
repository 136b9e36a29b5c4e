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

} // namespace cd

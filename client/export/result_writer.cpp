#include "client/export/result_writer.hpp"

namespace cd {

void ExportContext::describe(const Query& query) {
    level = query.level;
    tolerance = query.tolerance;
    map_pairs = query.maps ? 0 : query.limit_pairs;
}

std::string_view pair_class_name(PairClass kind) {
    switch (kind) {
    case PairClass::Separate:
        return "separate";
    case PairClass::Touch:
        return "touch";
    case PairClass::Coplanar:
        return "coplanar";
    case PairClass::Proper:
        return "proper";
    }
    return "unknown";
}

} // namespace cd

#include "client/poses/fcd_file.hpp"

#include "common/core/errors.hpp"

#include <filesystem>
#include <fstream>
#include <new>
#include <utility>

namespace cd {

namespace {

Result<RoadTraffic> read_by_ending(const FcdSpec& spec) {
    const std::string ending = spec.path.extension().string();
    if (ending != ".xml" && ending != ".csv") {
        return bad_input("the ending '" + ending + "' is not one of .xml, .csv");
    }
    if (std::filesystem::is_directory(spec.path)) {
        return bad_input("is a folder; a file of FCD is needed");
    }
    std::ifstream in(spec.path, std::ios::binary);
    if (!in) {
        return bad_input("cannot be opened");
    }
    return ending == ".xml" ? read_fcd_xml(in, spec) : read_fcd_csv(in, spec);
}

} // namespace

Result<RoadTraffic> read_fcd_file(const FcdSpec& spec) {
    const std::string name = spec.path.string();
    try {
        auto traffic = CD_TRY(within(name + ": ", read_by_ending(spec)));
        for (std::string& warning : traffic.warnings) {
            warning = name + ": " + warning;
        }
        traffic.name = name;
        return traffic;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::TooLarge, name + ": too little memory to read it"};
    }
}

} // namespace cd

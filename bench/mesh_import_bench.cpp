// Measures the import of mesh files: repeats each and prints the median.
//
//   mesh_import_bench [MESH...] [--text-stl MB] [--rounds 5]
//
// Prints a row per file: triangles, megabytes, and milliseconds of this thread's own time, since
// other processes may run. `--text-stl` adds a text STL file of that size, made in the folder for
// temporary files.
#include "client/import/mesh_import.hpp"

#include "bench/timed_work.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

namespace cd {

namespace {

constexpr double megabyte = 1e6;

/// Writes facets with nine digits per coordinate, as programs print floats.
void write_text_stl(const std::filesystem::path& path, double megabytes) {
    std::ofstream out(path, std::ios::binary);
    std::mt19937_64 random(1);
    const auto number = [&random] { return static_cast<double>(random()) * 0x1p-63 - 1; };
    out << "solid made\n";
    char line[128];
    while (static_cast<double>(out.tellp()) < megabytes * megabyte) {
        out << "  facet normal 0.000000e+00 0.000000e+00 1.000000e+00\n    outer loop\n";
        for (int corner = 0; corner < 3; ++corner) {
            std::snprintf(
                line, sizeof line, "      vertex %.8e %.8e %.8e\n", number(), number(), number());
            out << line;
        }
        out << "    endloop\n  endfacet\n";
    }
    out << "endsolid made\n";
}

bool print_row(const std::filesystem::path& path, std::size_t rounds) {
    std::vector<double> seconds;
    std::size_t triangles = 0;
    for (std::size_t round = 0; round < rounds; ++round) {
        const double before = bench::processor_seconds();
        const auto imported = import_mesh(path, {});
        seconds.push_back(bench::processor_seconds() - before);
        if (!imported) {
            std::fprintf(stderr, "%s\n", imported.error().detail.c_str());
            return false;
        }
        triangles = imported.value().mesh->triangles().size();
    }
    std::sort(seconds.begin(), seconds.end());
    std::printf("%-28s %9zu %7.1f %9.1f\n",
                path.filename().c_str(),
                triangles,
                static_cast<double>(std::filesystem::file_size(path)) / megabyte,
                1e3 * seconds[seconds.size() / 2]);
    return true;
}

} // namespace

} // namespace cd

int main(int argc, char** argv) {
    CLI::App app("Times the import of mesh files");
    std::vector<std::string> meshes;
    double text_stl_megabytes = 0;
    std::size_t rounds = 5;
    app.add_option("meshes", meshes, "Mesh files");
    app.add_option("--text-stl", text_stl_megabytes, "Megabytes of a text STL file, made and read");
    app.add_option("--rounds", rounds, "Imports of each file")->check(CLI::PositiveNumber);
    CLI11_PARSE(app, argc, argv);
    std::printf("%-28s %9s %7s %9s\n", "file", "triangles", "MB", "ms");
    bool all_read = true;
    for (const std::string& mesh : meshes) {
        all_read = cd::print_row(mesh, rounds) && all_read;
    }
    if (text_stl_megabytes > 0) {
        const auto made = std::filesystem::temp_directory_path() / "mesh_import_bench.stl";
        cd::write_text_stl(made, text_stl_megabytes);
        all_read = cd::print_row(made, rounds) && all_read;
        std::filesystem::remove(made);
    }
    return all_read ? 0 : 1;
}

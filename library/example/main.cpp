// Moves a mesh along x past another one, and prints where they touch.
//   clearances A B FIRST LAST COUNT
#include <cdcluster/cdcluster.hpp>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

int main(int argc, char** argv) {
    if (argc != 6) {
        std::fputs("usage: clearances A B FIRST LAST COUNT\n", stderr);
        return 2;
    }
    try {
        const auto a = cdcluster::Mesh::load(argv[1]);
        const auto b = cdcluster::Mesh::load(argv[2]);
        const double first = std::atof(argv[3]);
        const double last = std::atof(argv[4]);
        const int count = std::atoi(argv[5]);
        std::vector<double> poses;
        for (int i = 0; i < count; ++i) {
            const double x = count == 1 ? first : first + (last - first) * i / (count - 1);
            poses.insert(poses.end(), {x, 0, 0, 0, 0, 0, 1}); // x y z, then no turn.
        }
        cdcluster::Query query;
        query.level = cdcluster::Level::Pairs;
        const auto results =
            cdcluster::find_contacts(a, b, {poses, cdcluster::PoseForm::Xyzw}, query);
        for (std::size_t i = 0; i < results.size(); ++i) {
            if (results.is_hit(i)) {
                std::printf("pose %zu at x = %g: %zu pairs\n",
                            i,
                            poses[7 * i],
                            static_cast<std::size_t>(results.count[i]));
            }
        }
        std::printf("digest %s\n", results.digest.c_str());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "clearances: %s\n", error.what());
        return 2;
    }
    return 0;
}

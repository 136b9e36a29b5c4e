// Prints the verdicts of this host's SIMD target on pairs, one per line, so that two hosts can be
// compared (tests/neon/run): pairs of the corpus and small triangles as vehicles have them.
//
// A line has the pair's name, a hash of its bits, what floats prove, its class, and a hash of its
// shared points. Standard error gets the target and the counts.
#include "common/core/check.hpp"
#include "common/core/files/hash.hpp"
#include "common/geometry/simd_target.hpp"
#include "common/geometry/triangle_blocks.hpp"
#include "common/pair/stages/float/float_triangle_pair.hpp"
#include "common/pair/triangle_pair.hpp"
#include "tests/corpus/fingerprint.hpp"
#include "tests/corpus/pairs.hpp"
#include "tests/support/pair_points.hpp"
#include "tests/support/shapes.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace cd {

// Replaces check.cpp and hash.cpp, which need more libraries for the other processor. Mesh hashes
// do not matter here.
Sha256 sha256(std::span<const std::byte> /*bytes*/) {
    return {};
}

void check_failed(const char* condition, const char* file, int line) {
    std::fprintf(stderr, "broken invariant: %s at=%s:%d\n", condition, file, line);
    std::abort();
}

} // namespace cd

namespace cd::tests {

namespace {

constexpr std::uint64_t pairs_of_corpus = 10'000;
constexpr int vehicle_poses = 12;
constexpr int pairs_of_vehicle_pose = 333; // Not a multiple of any number of lanes.

struct Counts {
    std::array<std::uint64_t, 3> verdicts{};
    std::array<std::uint64_t, 4> classes{};
    std::uint64_t pairs = 0;
};

/// Triangles under one pair of poses, and the pairs to test.
struct Batch {
    std::vector<Vec3> vertices_a;
    std::vector<Vec3> vertices_b;
    std::vector<Triangle> triangles_a;
    std::vector<Triangle> triangles_b;
    std::vector<Candidate> candidates;

    [[nodiscard]] TriangleSpan a() const { return {vertices_a, triangles_a}; }
    [[nodiscard]] TriangleSpan b() const { return {vertices_b, triangles_b}; }
};

/// Makes a batch of one pair in all cyclic corner orders: more than a vector holds.
Batch turned(const PosedPair& pair) {
    Batch batch;
    batch.vertices_a.assign(pair.a.begin(), pair.a.end());
    batch.vertices_b.assign(pair.b.begin(), pair.b.end());
    batch.triangles_a = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
    batch.triangles_b = batch.triangles_a;
    for (std::uint32_t a = 0; a < 3; ++a) {
        for (std::uint32_t b = 0; b < 3; ++b) {
            batch.candidates.push_back({a, b});
        }
    }
    return batch;
}

/// Makes blocks of one triangle: a candidate's position is that in the batch times the block size.
/// Floats are rounded from the batch's numbers.
TriangleBlockArrays blocks_of(const TriangleSpan& span, Precision precision) {
    std::vector<Vec3> vertices(span.vertices.begin(), span.vertices.end());
    if (precision == Precision::Float) {
        for (Vec3& vertex : vertices) {
            vertex = Vec3(vertex.cast<float>().cast<double>());
        }
    }
    TriangleBlockArrays blocks(precision);
    for (const Triangle& triangle : span.triangles) {
        blocks.add(std::span(&triangle, 1), std::array<std::uint32_t, 1>{}, vertices);
    }
    return blocks;
}

/// Returns each candidate's verdicts from the batch's arrays, then from blocks of floats, of
/// doubles, and of both.
std::vector<FloatVerdict> verdicts_of(const PosePair& poses, const Batch& batch, Counts& counts) {
    const std::size_t count = batch.candidates.size();
    std::vector<FloatVerdict> verdicts(4 * count);
    const auto part = [&](std::size_t i) { return std::span(verdicts).subspan(i * count, count); };
    const FloatTrianglePair test(poses);
    test.classify(batch.a(), batch.b(), batch.candidates, part(0));
    std::vector<Candidate> candidates = batch.candidates;
    for (Candidate& candidate : candidates) {
        candidate = {candidate.a * block_size, candidate.b * block_size};
    }
    const auto floats_a = blocks_of(batch.a(), Precision::Float);
    const auto floats_b = blocks_of(batch.b(), Precision::Float);
    const auto doubles_a = blocks_of(batch.a(), Precision::Double);
    const auto doubles_b = blocks_of(batch.b(), Precision::Double);
    test.classify(floats_a.view(), floats_b.view(), candidates, part(1));
    test.classify(doubles_a.view(), doubles_b.view(), candidates, part(2));
    test.classify(floats_a.view(), doubles_b.view(), candidates, part(3));
    for (const FloatVerdict verdict : verdicts) {
        ++counts.verdicts[static_cast<std::size_t>(verdict)];
    }
    return verdicts;
}

std::uint64_t hash_of_points(TrianglePairTest& test, const Corners& a, const Corners& b) {
    Fingerprint hash;
    const auto [origin, points] = points_of(test, a, b);
    for (const double coordinate : origin) {
        hash.add(coordinate);
    }
    for (const Vec3& point : points) {
        for (const double coordinate : point) {
            hash.add(coordinate);
        }
    }
    return hash.value();
}

void print(const std::string& name,
           const PosedPair& pair,
           std::span<const FloatVerdict> verdicts,
           PairClass kind,
           TrianglePairTest& test,
           Counts& counts) {
    ++counts.pairs;
    ++counts.classes[static_cast<std::size_t>(kind)];
    Fingerprint input;
    input.add(pair);
    std::string digits;
    for (const FloatVerdict verdict : verdicts) {
        digits += std::to_string(static_cast<int>(verdict));
    }
    std::printf("%s %016llx %s %d %016llx\n",
                name.c_str(),
                static_cast<unsigned long long>(input.value()),
                digits.c_str(),
                static_cast<int>(kind),
                static_cast<unsigned long long>(hash_of_points(test, pair.a, pair.b)));
}

void print_corpus(Counts& counts) {
    const std::vector<std::string>& categories = pair_categories();
    for (std::uint64_t i = 0; i < pairs_of_corpus; ++i) {
        const std::string& category = categories[i % categories.size()];
        const std::uint64_t seed = i / categories.size();
        const PosedPair pair = corpus_pair(category, seed);
        const Batch batch = turned(pair);
        TrianglePairTest test(pair.poses);
        const PairClass kind = test.classify(batch.a(), batch.b(), batch.candidates).front();
        const std::string name = category + " " + std::to_string(seed);
        print(name, pair, verdicts_of(pair.poses, batch, counts), kind, test, counts);
    }
}

/// Makes triangles with edges of centimetres on bodies of metres; unit: metres.
Corners small_corners(std::mt19937_64& random, const Vec3& centre) {
    Corners corners;
    for (Vec3& corner : corners) {
        corner = centre + random_point(random, 0.03);
    }
    return corners;
}

void add(Batch& batch, const Corners& a, const Corners& b) {
    const auto place = static_cast<std::uint32_t>(batch.triangles_a.size());
    batch.vertices_a.insert(batch.vertices_a.end(), a.begin(), a.end());
    batch.vertices_b.insert(batch.vertices_b.end(), b.begin(), b.end());
    batch.triangles_a.push_back({3 * place, 3 * place + 1, 3 * place + 2});
    batch.triangles_b.push_back(batch.triangles_a.back());
    batch.candidates.push_back({place, place});
}

/// Prints one batch of pairs whose centres are centimetres apart in the world.
void print_vehicles(std::uint64_t seed, Counts& counts) {
    std::mt19937_64 random(seed);
    const PosePair poses{make_pose(random, 100), make_pose(random, 100)};
    Batch batch;
    for (int i = 0; i < pairs_of_vehicle_pose; ++i) {
        const Vec3 centre_a = random_point(random, 2.5);
        const Vec3 beside = random_point(random, 0.03);
        const Vec3 from_b = poses.a.apply(centre_a) + beside - poses.b.translation();
        const Vec3 centre_b = poses.b.rotation().transpose() * from_b;
        const Corners a = small_corners(random, centre_a);
        add(batch, a, small_corners(random, centre_b));
    }
    const std::vector<FloatVerdict> verdicts = verdicts_of(poses, batch, counts);
    TrianglePairTest test(poses);
    const auto found = test.classify(batch.a(), batch.b(), batch.candidates);
    const std::vector<PairClass> kinds(found.begin(), found.end());
    for (std::uint32_t i = 0; i < kinds.size(); ++i) {
        const PosedPair pair{batch.a().corners_at(i), batch.b().corners_at(i), poses};
        const std::string name = "vehicle " + std::to_string(seed) + " " + std::to_string(i);
        const std::size_t count = kinds.size();
        const std::array of_pair{
            verdicts[i], verdicts[count + i], verdicts[2 * count + i], verdicts[3 * count + i]};
        print(name, pair, of_pair, kinds[i], test, counts);
    }
}

int print_all() {
    const Status status = check_simd_environment();
    if (!status) {
        std::fprintf(stderr, "%s\n", status.error().detail.c_str());
        return 2;
    }
    Counts counts;
    print_corpus(counts);
    for (std::uint64_t seed = 0; seed < vehicle_poses; ++seed) {
        print_vehicles(seed, counts);
    }
    std::string line = "target=" + std::string(to_text(simd_target()));
    line += " pairs=" + std::to_string(counts.pairs) + " unknown,separate,proper in floats=";
    for (const std::uint64_t count : counts.verdicts) {
        line += std::to_string(count) + " ";
    }
    line += "separate,touch,coplanar,proper=";
    for (const std::uint64_t count : counts.classes) {
        line += std::to_string(count) + " ";
    }
    std::fprintf(stderr, "%s\n", line.c_str());
    return 0;
}

} // namespace

} // namespace cd::tests

int main() {
    return cd::tests::print_all();
}

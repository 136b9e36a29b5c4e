// Proves that NumPy's files are read as written, that NumPy can read ours, and that damaged or
// hostile bytes are refused without allocating what they only claim.
#include "client/formats/npy.hpp"

#include "client/formats/npz.hpp"
#include "tests/support/npz_arrays.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <vector>

namespace cd::tests {

namespace {

std::atomic<ino_t> last_synced = 0; ///< The inode of the file that was last synced.

using testing::HasSubstr;

std::span<const std::byte> bytes_of(const std::string& text) {
    return std::as_bytes(std::span(text));
}

/// Returns a file with this dictionary as its header.
std::string npy(const std::string& dictionary, const std::string& data, char version = 1) {
    std::string text = "\x93NUMPY";
    text += version;
    text += '\0';
    text += static_cast<char>(dictionary.size() & 0xff);
    text += static_cast<char>(dictionary.size() >> 8);
    text += version == 1 ? "" : std::string(2, '\0');
    return text + dictionary + data;
}

std::string header(const std::string& type, const std::string& order, const std::string& shape) {
    return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }\n";
}

template <class T>
std::string raw(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

std::vector<double> doubles_of(const std::string& file) {
    const auto array = parse_npy(bytes_of(file));
    EXPECT_TRUE(array) << array.error().detail;
    return array ? array.value().to_doubles() : std::vector<double>{};
}

void write_archive(const std::filesystem::path& path) {
    NpzWriter writer(path);
    const auto ids = writer.add_array({"ids", NpyType::U4});
    const auto points = writer.add_array({"points", NpyType::F8, 3});
    for (std::uint32_t i = 0; i < 1000; ++i) {
        EXPECT_TRUE(writer.append(ids, std::span<const std::uint32_t>(&i, 1)));
        const std::vector<double> point{0.1 * i, 2, -1.0 / (i + 1)};
        EXPECT_TRUE(writer.append(points, std::span<const double>(point)));
    }
    ASSERT_TRUE(writer.finish());
}

} // namespace

TEST(Npy, ReadsEveryTypeAndVersion) {
    const std::vector<double> expected{1, 2, 3};
    EXPECT_EQ(doubles_of(npy(header("<f8", "False", "(3,)"), raw<double>({1, 2, 3}))), expected);
    EXPECT_EQ(doubles_of(npy(header("<f4", "False", "(3,)"), raw<float>({1, 2, 3}), 2)), expected);
    EXPECT_EQ(doubles_of(npy(header("<i8", "False", "(3,)"), raw<std::int64_t>({1, 2, 3}), 3)),
              expected);
    EXPECT_EQ(doubles_of(npy(header("<i4", "False", "(3,)"), raw<std::int32_t>({1, 2, 3}))),
              expected);
    EXPECT_EQ(doubles_of(npy(header("<u8", "False", "(3,)"), raw<std::uint64_t>({1, 2, 3}))),
              expected);
    EXPECT_EQ(doubles_of(npy(header("<u4", "False", "(3,)"), raw<std::uint32_t>({1, 2, 3}))),
              expected);
    EXPECT_EQ(doubles_of(npy(header("|u1", "False", "(3,)"), "\x01\x02\x03")), expected);
}

TEST(Npy, PutsFortranOrderIntoOurs) {
    // The array [[1, 2, 3], [4, 5, 6]], column by column.
    EXPECT_EQ(
        doubles_of(npy(header("<i4", "True", "(2, 3)"), raw<std::int32_t>({1, 4, 2, 5, 3, 6}))),
        (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST(Npy, RefusesWhatItCannotTake) {
    const auto error = [](const std::string& file) {
        const auto array = parse_npy(bytes_of(file));
        return array ? "was taken" : array.error().detail;
    };
    EXPECT_THAT(error(npy(header(">f8", "False", "(1,)"), raw<double>({1}))), HasSubstr(">f8"));
    EXPECT_THAT(error(npy(header("|O", "False", "(1,)"), raw<double>({1}))), HasSubstr("float64"));
    EXPECT_NE(error(npy(header("<f8", "Maybe", "(1,)"), raw<double>({1}))), "was taken");
    EXPECT_NE(error(npy(header("<f8", "False", "(-1,)"), raw<double>({1}))), "was taken");
    EXPECT_NE(error(npy(header("<f8", "False", "(2,)"), raw<double>({1}))), "was taken");
    EXPECT_NE(error(npy(header("<f8", "False", "(1,)"), raw<double>({1}) + "x")), "was taken");
    // The product of the sizes wraps around to the right number of bytes.
    EXPECT_NE(error(npy(header("<f8", "False", "(4294967296, 4294967296)"), "")), "was taken");
    EXPECT_NE(error(npy(header("<f8", "False", "(2305843009213693953,)"), raw<double>({1}))),
              "was taken");
    EXPECT_NE(error(npy(header("<f8", "False", "(99999999999999999999,)"), "")), "was taken");
    EXPECT_NE(error(npy("{}", "")), "was taken");
}

TEST(Npy, SurvivesEveryTruncationAndEveryFlippedBit) {
    const std::string good = npy(header("<f8", "False", "(2, 1)"), raw<double>({1, 2}));
    for (std::size_t size = 0; size < good.size(); ++size) {
        const std::string cut = good.substr(0, size);
        EXPECT_FALSE(parse_npy(bytes_of(cut))) << size;
    }
    std::size_t refused = 0;
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        std::string bent = good;
        bent[bit / 8] = static_cast<char>(bent[bit / 8] ^ (1 << (bit % 8)));
        refused += parse_npy(bytes_of(bent)) ? 0u : 1u;
    }
    EXPECT_GT(refused, good.size());
}

TEST(Npy, IntegersThatDoNotFitAreRefused) {
    const auto big =
        parse_npy(bytes_of(npy(header("<u8", "False", "(1,)"), raw<std::uint64_t>({~0ull}))));
    ASSERT_TRUE(big);
    EXPECT_FALSE(big.value().to_integers());
    const auto real = parse_npy(bytes_of(npy(header("<f8", "False", "(1,)"), raw<double>({1}))));
    ASSERT_TRUE(real);
    EXPECT_FALSE(real.value().to_integers());
}

TEST(Npz, WhatIsWrittenInPiecesIsReadBack) {
    const TemporaryFolder folder;
    write_archive(folder / "a.npz");
    const auto arrays = read_npz(folder / "a.npz");
    ASSERT_TRUE(arrays) << arrays.error().detail;
    ASSERT_EQ(arrays.value().size(), 2u);
    const NpyArray& points = arrays.value().at("points");
    EXPECT_EQ(points.shape, (std::vector<std::uint64_t>{1000, 3}));
    EXPECT_EQ(points.to_doubles()[3 * 7], 0.1 * 7);
    EXPECT_EQ(arrays.value().at("ids").to_integers().value()[999], 999);
}

TEST(Npz, EqualArraysMakeEqualFilesAndLeaveNothingElse) {
    const TemporaryFolder folder;
    write_archive(folder / "a.npz");
    write_archive(folder / "b.npz");
    EXPECT_EQ(read_text(folder / "a.npz"), read_text(folder / "b.npz"));
    {
        NpzWriter abandoned(folder / "c.npz");
        static_cast<void>(abandoned.add_array({"x", NpyType::F8}));
    }
    const std::filesystem::directory_iterator files(folder.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 2);
}

TEST(Npz, AnArchiveIsOnTheDiskBeforeItHasItsName) {
    const TemporaryFolder folder;
    last_synced = 0;
    write_archive(folder / "a.npz");
    struct stat facts {};
    ASSERT_EQ(::stat((folder / "a.npz").c_str(), &facts), 0);
    EXPECT_EQ(last_synced, facts.st_ino);
}

TEST(Npz, NumPyReadsOursAndWeReadNumPys) {
    const TemporaryFolder folder;
    write_archive(folder / "ours.npz");
    const std::string program =
        "import sys\n"
        "try:\n    import numpy as np\nexcept ImportError:\n    sys.exit(77)\n"
        "d = sys.argv[1]\n"
        "a = np.load(d + '/ours.npz')\n"
        "assert a['points'].shape == (1000, 3) and a['points'].dtype == np.float64\n"
        "assert a['ids'].dtype == np.uint32 and a['ids'][7] == 7\n"
        "x = np.arange(24, dtype=np.float32).reshape(2, 3, 4)\n"
        "np.savez(d + '/stored.npz', x=x, f=np.asfortranarray(x))\n"
        "np.savez_compressed(d + '/deflated.npz', x=x, f=np.asfortranarray(x))\n";
    const Ran ran = run({"/usr/bin/python3", "-c", program, folder.path().string()});
    if (ran.exit_code == 77) {
        ASSERT_FALSE(skips_are_failures()) << "CI is set and NumPy is missing: python3-numpy";
        GTEST_SKIP() << "no NumPy; install python3-numpy";
    }
    ASSERT_EQ(ran.exit_code, 0) << ran.errors;
    for (const char* name : {"stored.npz", "deflated.npz"}) {
        const auto arrays = read_npz(folder / name);
        ASSERT_TRUE(arrays) << arrays.error().detail;
        const auto x = arrays.value().at("x").to_doubles();
        EXPECT_EQ(x[23], 23);
        EXPECT_EQ(arrays.value().at("f").to_doubles(), x);
    }
}

TEST(Npz, SurvivesTruncationDamageAndClaims) {
    const TemporaryFolder folder;
    write_archive(folder / "good.npz");
    const std::string good = read_text(folder / "good.npz");
    for (std::size_t size = 0; size < good.size(); size += 211) {
        write_text(folder / "cut.npz", good.substr(0, size));
        EXPECT_FALSE(read_npz(folder / "cut.npz")) << size;
    }
    // Damaged data fails its checksum.
    std::string bent = good;
    bent[200] = static_cast<char>(bent[200] ^ 1);
    write_text(folder / "bent.npz", bent);
    EXPECT_FALSE(read_npz(folder / "bent.npz"));
    // Both records of an array claim 4 GiB unpacked; the reader must not even request as much.
    std::string claim = good;
    for (const auto& [mark, offset] :
         {std::pair("PK\x03\x04", 22u), std::pair("PK\x01\x02", 24u)}) {
        const std::size_t place = claim.find(std::string(mark, 4));
        ASSERT_NE(place, std::string::npos);
        claim.replace(place + offset, 4, "\xf0\xff\xff\xff");
    }
    write_text(folder / "claim.npz", claim);
    EXPECT_FALSE(read_npz(folder / "claim.npz"));
}

} // namespace cd::tests

/// Replaces the C library's function in this program.
extern "C" int fdatasync(int descriptor) {
    struct stat facts {};
    if (::fstat(descriptor, &facts) == 0) {
        cd::tests::last_synced = facts.st_ino;
    }
    return static_cast<int>(::syscall(SYS_fdatasync, descriptor));
}

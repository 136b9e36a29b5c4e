// Proves that a mesh is built and encoded only once, even over restarts; that its blocks are its
// tree's subtrees; and that hostile uploads and damaged files cause a clear error or a rebuild of
// the right geometry, never wrong geometry.

#include "master/geometry/geometry_store.hpp"

#include "common/core/files/compress.hpp"
#include "common/core/limits/engine.hpp"
#include "common/core/limits/master.hpp"
#include "common/tree/wire/subtree_block.hpp"
#include "master/geometry/mesh_file.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace cd::tests {
namespace {

using testing::HasSubstr;

class GeometryStoreTest : public testing::Test {
  protected:
    void SetUp() override { open(); }

    void open() {
        store_.reset(); // A store locks its directory.
        auto opened = GeometryStore::open(folder_.path(), pool_);
        ASSERT_TRUE(opened) << opened.error().detail;
        store_ = std::move(opened.value());
    }

    Status upload(const Bytes& bytes, const Sha256& name, std::size_t piece = 1000) {
        auto upload = store_->begin_upload(name, "a.stl", bytes.size());
        if (!upload) {
            return upload.error();
        }
        for (std::size_t i = 0; i < bytes.size(); i += piece) {
            const auto run = std::span(bytes).subspan(i, std::min(piece, bytes.size() - i));
            if (Status status = upload.value()->append(i, run); !status) {
                return status;
            }
        }
        return store_->finish_upload(std::move(upload.value()));
    }
    Sha256 upload(const Mesh& mesh) {
        const Status status = upload(mesh.canonical_bytes(), mesh.hash());
        EXPECT_TRUE(status) << status.error().detail;
        return mesh.hash();
    }

    std::vector<std::filesystem::path> files(const std::string& folder) const {
        std::vector<std::filesystem::path> found;
        for (const auto& file : std::filesystem::directory_iterator(folder_ / folder)) {
            found.push_back(file.path());
        }
        std::sort(found.begin(), found.end());
        return found;
    }
    std::filesystem::path only_file(const std::string& folder, const std::string& suffix) const {
        for (const auto& path : files(folder)) {
            if (path.extension() == suffix) {
                return path;
            }
        }
        ADD_FAILURE() << "no " << suffix << " in " << folder;
        return {};
    }
    static void flip_byte(const std::filesystem::path& path, std::size_t from_end) {
        std::string text = read_text(path);
        ASSERT_GT(text.size(), from_end);
        text[text.size() - 1 - from_end] ^= 0x20;
        write_text(path, text);
    }

    std::vector<ObbNode> nodes() const {
        const auto nodes = store_->tree(sphere_.hash()).value()->nodes();
        return {nodes.begin(), nodes.end()};
    }
    /// Cuts the stored mesh; returns the file of its blocks.
    std::filesystem::path cut_into_blocks() {
        EXPECT_TRUE(store_->cut(sphere_.hash(), 3));
        return only_file("blocks", ".blocks");
    }

    TemporaryFolder folder_;
    ThreadPool pool_{2};
    std::unique_ptr<GeometryStore> store_;
    Mesh sphere_ = make_sphere(4);
};

class StoredMesh : public GeometryStoreTest {
  protected:
    void SetUp() override {
        open();
        upload(sphere_);
    }
};

TEST_F(GeometryStoreTest, AMeshUploadedInPiecesIsStored) {
    EXPECT_FALSE(store_->has(sphere_.hash()));
    EXPECT_EQ(store_->missing(std::vector{sphere_.hash(), sphere_.hash()}),
              std::vector{sphere_.hash()});

    upload(sphere_);

    EXPECT_TRUE(store_->has(sphere_.hash()));
    EXPECT_TRUE(store_->missing(std::vector{sphere_.hash()}).empty());
    const auto tree = store_->tree(sphere_.hash());
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree.value()->mesh().hash(), sphere_.hash());
    const std::vector<MeshStatus> meshes = store_->meshes();
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].name, "a.stl");
    EXPECT_EQ(meshes[0].triangles, sphere_.triangles().size());
    EXPECT_EQ(meshes[0].bytes, sphere_.canonical_bytes().size());
}

TEST_F(StoredMesh, TheBlocksOfACutAreTheSubtreesOfTheTree) {
    const auto tree = store_->tree(sphere_.hash()).value();
    const auto cut = store_->cut(sphere_.hash(), 5).value();

    const std::vector<std::uint32_t> nodes = cut_nodes(*tree, 5);
    ASSERT_EQ(cut->root_count(), nodes.size());
    ASSERT_EQ(cut->top().nodes, cut_tree(*tree, 5).nodes);
    for (RootIndex root = 0; root < cut->root_count(); ++root) {
        const SubtreeBlock block = cut->block(root);
        EXPECT_EQ(block.root, root);
        EXPECT_EQ(block.compressed.size(), cut->compressed_bytes(root));
        const auto bytes = decompress(block.compressed, limits::subtree_block_bytes_max);
        ASSERT_TRUE(bytes);
        EXPECT_EQ(sha256(bytes.value()), block.hash);
        EXPECT_EQ(cut->hash(root), block.hash);
        const Subtree expected = extract_subtree(*tree, nodes[root], SubtreeForm::Wide);
        EXPECT_EQ(bytes.value(), encode_subtree(expected));
    }
}

TEST_F(StoredMesh, BothFormsOfACutStandSideBySide) {
    const auto wide = store_->cut(sphere_.hash(), 2, SubtreeForm::Wide).value();
    const auto binary = store_->cut(sphere_.hash(), 2, SubtreeForm::Binary).value();
    EXPECT_EQ(wide->form(), SubtreeForm::Wide);
    EXPECT_EQ(binary->form(), SubtreeForm::Binary);
    EXPECT_EQ(wide->top().nodes, binary->top().nodes);
    EXPECT_NE(wide->hash(0), binary->hash(0));
    EXPECT_LT(3 * wide->bytes_total(), binary->bytes_total());
    open();
    EXPECT_EQ(store_->cut(sphere_.hash(), 2, SubtreeForm::Binary).value()->hash(0),
              binary->hash(0));
}

TEST_F(StoredMesh, ARestartFindsEverythingAndMakesNothingAgain) {
    const auto before = store_->cut(sphere_.hash(), 3).value();
    const auto block_before = before->block(0);
    const std::vector<ObbNode> nodes_before = nodes();
    const auto tree_time = last_write_time(only_file("trees", ".tree"));
    const auto blocks_time = last_write_time(only_file("blocks", ".blocks"));

    open();
    const auto after = store_->cut(sphere_.hash(), 3);

    ASSERT_TRUE(after) << after.error().detail;
    EXPECT_EQ(after.value()->block(0).compressed, block_before.compressed);
    EXPECT_EQ(nodes(), nodes_before);
    EXPECT_EQ(last_write_time(only_file("trees", ".tree")), tree_time);
    EXPECT_EQ(last_write_time(only_file("blocks", ".blocks")), blocks_time);
    const std::vector<MeshStatus> meshes = store_->meshes();
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].name, "a.stl");
    EXPECT_EQ(meshes[0].triangles, sphere_.triangles().size());
    EXPECT_EQ(meshes[0].build_seconds, 0);
}

TEST_F(StoredMesh, TheSameMeshTwiceIsOneMesh) {
    const auto time = last_write_time(only_file("trees", ".tree"));
    upload(sphere_);

    EXPECT_EQ(store_->meshes().size(), 1u);
    EXPECT_EQ(last_write_time(only_file("trees", ".tree")), time);
}

TEST_F(StoredMesh, ThreadsThatWantTheSameCutShareIt) {
    std::vector<std::shared_ptr<const CutGeometry>> cuts(4);
    std::vector<std::thread> threads;
    for (auto& cut : cuts) {
        threads.emplace_back([&] { cut = store_->cut(sphere_.hash(), 4).value(); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    for (const auto& cut : cuts) {
        EXPECT_EQ(cut, cuts[0]);
    }
}

TEST_F(GeometryStoreTest, AMeshThatIsRemovedWhileItIsCutIsMissingAndLeavesNothing) {
    const Mesh mesh = make_torus(2, 0.5, 40, 20);
    for (int round = 0; round < 50; ++round) {
        const Sha256 hash = upload(mesh);
        std::atomic<bool> begins = false;
        std::thread cutting([&] {
            begins = true;
            const auto cut = store_->cut(hash, 4, SubtreeForm::Binary);
            EXPECT_TRUE(cut || cut.error().code == ErrorCode::NotFound) << cut.error().detail;
        });
        while (!begins) {
            std::this_thread::yield();
        }
        const auto freed = store_->remove(hash);
        cutting.join();
        EXPECT_TRUE(freed) << freed.error().detail;
        EXPECT_EQ(files("blocks").size(), 0u);
    }
}

TEST_F(GeometryStoreTest, OneDirectoryServesOneProcess) {
    const auto second = GeometryStore::open(folder_.path(), pool_);
    ASSERT_FALSE(second);
    EXPECT_THAT(second.error().detail, HasSubstr("in use"));
}

TEST_F(StoredMesh, HalfWrittenFilesOfAKilledRunAreDeleted) {
    write_text(folder_ / "meshes/abc.mesh.tmp-Xy12Zz", "half");
    open();
    EXPECT_FALSE(std::filesystem::exists(folder_ / "meshes/abc.mesh.tmp-Xy12Zz"));
    EXPECT_TRUE(store_->has(sphere_.hash()));
}

TEST_F(GeometryStoreTest, AnUnknownMeshAndAnAbsurdDepthAreErrors) {
    EXPECT_EQ(store_->tree(sphere_.hash()).error().code, ErrorCode::NotFound);
    EXPECT_EQ(store_->cut(sphere_.hash(), 3).error().code, ErrorCode::NotFound);
    upload(sphere_);
    EXPECT_EQ(store_->cut(sphere_.hash(), limits::distribution_depth_max + 1).error().code,
              ErrorCode::TooLarge);
}

// ---- Damage ---------------------------------------------------------------------------------

TEST_F(StoredMesh, ADamagedTreeIsSetAsideAndBuiltAnew) {
    const std::vector<ObbNode> nodes_before = nodes();
    const auto path = only_file("trees", ".tree");
    const std::string whole = read_text(path);
    flip_byte(path, whole.size() / 2);

    open();
    EXPECT_EQ(nodes(), nodes_before);
    EXPECT_EQ(read_text(path), whole);
    EXPECT_TRUE(std::filesystem::exists(path.string() + ".damaged-1"));
    EXPECT_GT(store_->meshes()[0].build_seconds, 0);
}

TEST_F(StoredMesh, ADamagedFileOfBlocksIsSetAsideAndMadeAgain) {
    const auto path = cut_into_blocks();
    const std::string whole = read_text(path);
    std::vector<std::string> damaged{"", whole.substr(0, 10), whole.substr(0, whole.size() - 1)};
    for (const std::size_t at : {std::size_t{69}, whole.size() - 4}) { // Index and last block.
        damaged.push_back(whole);
        damaged.back()[at] ^= 0x20;
    }
    for (std::size_t i = 0; i < damaged.size(); ++i) {
        open();
        write_text(path, damaged[i]);
        ASSERT_TRUE(store_->cut(sphere_.hash(), 3));
        EXPECT_EQ(read_text(path), whole);
        EXPECT_TRUE(std::filesystem::exists(path.string() + ".damaged-" + std::to_string(i + 1)));
    }
}

TEST_F(StoredMesh, BlocksThatAreDamagedInUseAreWrittenAnewOnce) {
    const auto cut = store_->cut(sphere_.hash(), 3).value();
    const RootIndex last = cut->root_count() - 1;
    const SubtreeBlock sound = cut->block(last);
    const auto path = only_file("blocks", ".blocks");
    const std::string whole = read_text(path);
    flip_byte(path, 3); // In the last block.

    EXPECT_EQ(cut->read(last).error().code, ErrorCode::Io);
    EXPECT_EQ(cut->block(last).compressed, sound.compressed);
    EXPECT_EQ(read_text(path), whole);
    ASSERT_TRUE(cut->read(last)) << "from the new file";
    EXPECT_EQ(cut->read(last).value().compressed, sound.compressed);
    EXPECT_EQ(files("blocks"),
              (std::vector<std::filesystem::path>{path, path.string() + ".damaged-1"}));
}

TEST_F(StoredMesh, DamagedBlocksAreServedThoughTheDiskHasNoRoomForNewOnes) {
    const auto cut = store_->cut(sphere_.hash(), 3).value();
    const SubtreeBlock sound = cut->block(0);
    const auto path = only_file("blocks", ".blocks");
    write_text(path, std::string(read_text(path).size(), 'x'));
    {
        const FileSizeLimit full(1000);
        EXPECT_EQ(cut->block(0).compressed, sound.compressed);
        EXPECT_FALSE(std::filesystem::exists(path));
    }
    EXPECT_EQ(cut->block(0).compressed, sound.compressed);
}

TEST_F(StoredMesh, AMeshIsNeededWhileItIsHeldAndCanBeRemovedAfterwards) {
    auto hold = store_->hold({sphere_.hash()});
    EXPECT_TRUE(store_->meshes().front().is_needed);
    EXPECT_EQ(store_->remove(sphere_.hash()).error().code, ErrorCode::Refused);
    hold.reset();
    EXPECT_FALSE(store_->meshes().front().is_needed);
    EXPECT_GT(store_->remove(sphere_.hash()).value(), 0u);
    EXPECT_TRUE(store_->meshes().empty());
}

TEST_F(StoredMesh, ADamagedMeshIsAnErrorThatNamesTheFileAndNothingIsDeleted) {
    const auto path = only_file("meshes", ".mesh");
    flip_byte(path, 100);

    open();
    const auto tree = store_->tree(sphere_.hash());

    ASSERT_FALSE(tree);
    EXPECT_EQ(tree.error().code, ErrorCode::Io);
    EXPECT_THAT(tree.error().detail, HasSubstr(path.string()));
    EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(StoredMesh, ALostDescriptionCostsTheNameAlone) {
    flip_byte(only_file("meshes", ".info"), 0);

    open();
    ASSERT_TRUE(store_->tree(sphere_.hash()));
    EXPECT_EQ(store_->meshes()[0].name, "");
    EXPECT_EQ(store_->meshes()[0].triangles, sphere_.triangles().size());
}

// ---- A full disk ----------------------------------------------------------------------------

TEST_F(StoredMesh, BlocksThatHaveNoRoomMayBeTriedAgainAndOtherErrorsMayNot) {
    {
        const FileSizeLimit full(1000);
        const auto cut = store_->cut(sphere_.hash(), 5);
        ASSERT_FALSE(cut);
        EXPECT_TRUE(cut.is_unwritten());
        EXPECT_THAT(cut.error().detail, HasSubstr(".blocks"));
        EXPECT_TRUE(files("blocks").empty()) << files("blocks")[0];
    }
    EXPECT_TRUE(store_->cut(sphere_.hash(), 5));
    const auto absurd = store_->cut(sphere_.hash(), limits::distribution_depth_max + 1);
    EXPECT_FALSE(absurd.is_unwritten());

    flip_byte(only_file("meshes", ".mesh"), 100);
    open();
    const auto damaged = store_->cut(sphere_.hash(), 5);
    ASSERT_FALSE(damaged);
    EXPECT_FALSE(damaged.is_unwritten());
}

TEST_F(StoredMesh, DamagedBlocksStayWhereTheyAreUntilTheyCanBeSetAside) {
    const auto path = cut_into_blocks();
    flip_byte(path, read_text(path).size() - 1);
    const std::string bad = read_text(path);
    open();
    {
        const FileSizeLimit full(1000);
        EXPECT_TRUE(store_->cut(sphere_.hash(), 3).is_unwritten());
    }
    EXPECT_EQ(read_text(path.string() + ".damaged-1"), bad);
    EXPECT_TRUE(store_->cut(sphere_.hash(), 3));
}

TEST_F(StoredMesh, ATreeThatHasNoRoomIsUsedAllTheSame) {
    const auto path = only_file("trees", ".tree");
    std::filesystem::remove(path);
    open();
    {
        const FileSizeLimit full(1000);
        const auto tree = store_->tree(sphere_.hash());
        ASSERT_TRUE(tree) << tree.error().detail;
    }
    EXPECT_FALSE(std::filesystem::exists(path));
    open();
    EXPECT_TRUE(store_->tree(sphere_.hash()));
    EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(GeometryStoreTest, AMeshWhoseTreeHasNoRoomIsNotTaken) {
    {
        const FileSizeLimit full(sphere_.canonical_bytes().size());
        const Status status = upload(sphere_.canonical_bytes(), sphere_.hash());
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().code, ErrorCode::Io);
    }
    EXPECT_TRUE(store_->meshes().empty());
    upload(sphere_);
}

// ---- No more files may be open --------------------------------------------------------------

/// Allows no more open files than there are now.
class NoMoreFiles {
  public:
    NoMoreFiles() {
        getrlimit(RLIMIT_NOFILE, &before_);
        const rlimit limited{static_cast<rlim_t>(first_free()), before_.rlim_max};
        setrlimit(RLIMIT_NOFILE, &limited);
    }
    ~NoMoreFiles() { setrlimit(RLIMIT_NOFILE, &before_); }
    NoMoreFiles(const NoMoreFiles&) = delete;
    NoMoreFiles& operator=(const NoMoreFiles&) = delete;

  private:
    static int first_free() {
        const int descriptor = ::dup(0);
        ::close(descriptor);
        return descriptor;
    }
    rlimit before_{};
};

TEST_F(StoredMesh, AFileThatCannotBeOpenedForWantOfDescriptorsIsNotDamaged) {
    cut_into_blocks();
    open();
    const auto tree = store_->tree(sphere_.hash()).value(); // In memory from now on.
    {
        const NoMoreFiles none;
        const auto cut = store_->cut(sphere_.hash(), 3);
        ASSERT_FALSE(cut);
        EXPECT_TRUE(cut.is_unwritten()) << "it may be tried again";
    }
    EXPECT_EQ(files("blocks").size(), 1u);
    EXPECT_TRUE(store_->cut(sphere_.hash(), 3));
    EXPECT_EQ(only_file("blocks", ".blocks"), files("blocks").at(0)) << "nothing was set aside";
}

// ---- Hostile uploads ------------------------------------------------------------------------

class HostileUploads : public GeometryStoreTest {
  protected:
    void expect_refused(const Status& status, const std::string& why) {
        ASSERT_FALSE(status);
        EXPECT_EQ(status.error().code, ErrorCode::BadInput);
        EXPECT_THAT(status.error().detail, HasSubstr(why));
        expect_nothing_left();
    }
    void expect_nothing_left() {
        EXPECT_TRUE(store_->meshes().empty());
        for (const char* folder : {"meshes", "trees", "blocks"}) {
            EXPECT_TRUE(files(folder).empty()) << files(folder)[0];
        }
    }
};

TEST_F(HostileUploads, AnotherHashIsRefused) {
    expect_refused(upload(sphere_.canonical_bytes(), make_sphere(1).hash()), "hash");
    EXPECT_FALSE(store_->has(make_sphere(1).hash()));
}

TEST_F(HostileUploads, BytesThatAreNoMeshAreRefused) {
    const Bytes bytes(5000, std::byte{7});
    expect_refused(upload(bytes, sha256(bytes)), "not a mesh");
    expect_refused(upload({}, sha256({})), "not a mesh");
}

TEST_F(HostileUploads, AnIndexOutOfRangeIsRefused) {
    Bytes bytes = make_box({1, 1, 1}).canonical_bytes();
    bytes.back() = std::byte{0x7f}; // Last index of a mesh without parts.
    expect_refused(upload(bytes, sha256(bytes)), "triangle 11");
}

TEST_F(HostileUploads, AnotherWayToWriteTheSameMeshIsRefused) {
    const Mesh mesh = make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    Bytes bytes = mesh.canonical_bytes();
    // Sign of the first vertex's x, after magic, precision and three counts.
    bytes[8 + 1 + 8 + 8 + 4 + 7] = std::byte{0x80};
    expect_refused(upload(bytes, sha256(bytes)), "canonical");
}

TEST_F(HostileUploads, GapsRepetitionsAndSurplusAreRefused) {
    const Bytes bytes = sphere_.canonical_bytes();
    const auto piece = std::span(bytes).first(100);
    auto upload = store_->begin_upload(sphere_.hash(), "", 250);
    ASSERT_TRUE(upload);
    ASSERT_TRUE(upload.value()->append(0, piece));
    EXPECT_FALSE(upload.value()->append(0, piece));
    EXPECT_FALSE(upload.value()->append(101, piece));
    EXPECT_FALSE(upload.value()->append(~std::uint64_t{0}, piece));
    ASSERT_TRUE(upload.value()->append(100, piece));
    EXPECT_FALSE(upload.value()->append(200, piece));
    EXPECT_FALSE(upload.value()->is_complete());
    expect_refused(store_->finish_upload(std::move(upload.value())), "not complete");
}

TEST_F(HostileUploads, TooLargeAndTooManyUploadsAreRefused) {
    EXPECT_EQ(store_->begin_upload(sphere_.hash(), "", limits::mesh_bytes_max + 1).error().code,
              ErrorCode::TooLarge);
    std::vector<std::unique_ptr<MeshUpload>> uploads;
    for (std::size_t i = 0; i < limits::mesh_uploads_max; ++i) {
        uploads.push_back(std::move(store_->begin_upload(sphere_.hash(), "", 10).value()));
    }
    EXPECT_EQ(store_->begin_upload(sphere_.hash(), "", 10).error().code, ErrorCode::TooLarge);
    uploads.clear();
    expect_nothing_left();
    upload(sphere_);
    EXPECT_TRUE(store_->has(sphere_.hash()));
}

TEST_F(GeometryStoreTest, TheNumberOfStoredMeshesIsBounded) {
    store_.reset();
    store_ = std::move(GeometryStore::open(folder_.path(), pool_, 1).value());
    const Mesh first = make_sphere(1);
    const Mesh second = make_sphere(2);
    const Bytes bytes = second.canonical_bytes();
    auto early = store_->begin_upload(second.hash(), "early", bytes.size());
    ASSERT_TRUE(early);
    ASSERT_TRUE(early.value()->append(0, bytes));
    upload(first);
    EXPECT_EQ(store_->finish_upload(std::move(early.value())).error().code, ErrorCode::TooLarge);
    const Status late = upload(bytes, second.hash());
    EXPECT_EQ(late.error().code, ErrorCode::TooLarge);
    EXPECT_THAT(late.error().detail, HasSubstr("1 meshes are stored"));
    EXPECT_FALSE(store_->has(second.hash()));
    upload(first); // The mesh is stored and may be uploaded again.
    EXPECT_EQ(store_->meshes().size(), 1u);
}

} // namespace
} // namespace cd::tests

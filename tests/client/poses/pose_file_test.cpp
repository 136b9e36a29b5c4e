// Proves that poses of every format are read as the exact numbers of their file, and that a pose
// that is not rigid, not finite or missing is refused by its row.
#include "client/poses/pose_file.hpp"

#include "client/formats/npz.hpp"
#include "client/poses/label_file.hpp"
#include "client/poses/text_poses.hpp"
#include "tests/support/memory_bound.hpp"
#include "tests/support/process.hpp"
#include "tests/support/shapes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zip.h>

#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cd::tests {

namespace {

using testing::HasSubstr;

class PoseFile : public testing::Test {
  protected:
    PoseFileSpec spec(const std::string& name) {
        PoseFileSpec s;
        s.path = folder_ / name;
        return s;
    }

    std::vector<Scenario> read_all(const PoseFileSpec& s) {
        auto opened = open_pose_file(s);
        if (!opened) {
            ADD_FAILURE() << opened.error().detail;
            return {};
        }
        warnings_ = opened.value().warnings;
        return opened.value().source->read(0, opened.value().source->count()).value();
    }

    std::vector<Scenario> read_text_file(const std::string& name, const std::string& text) {
        write_text(folder_ / name, text);
        return read_all(spec(name));
    }

    std::string error_of(const PoseFileSpec& s) {
        auto opened = open_pose_file(s);
        return opened ? "was taken" : opened.error().detail;
    }

    std::string error_of_text(const std::string& name, const std::string& text) {
        write_text(folder_ / name, text);
        return error_of(spec(name));
    }

    void write_npy(const std::string& name,
                   const std::vector<std::uint64_t>& shape,
                   const std::vector<double>& values) {
        const Bytes header = make_npy_header(NpyType::F8, shape);
        std::string text(reinterpret_cast<const char*>(header.data()), header.size());
        text.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
        write_text(folder_ / name, text);
    }

    TemporaryFolder folder_;
    std::vector<std::string> warnings_;
};

const std::vector<double> turned{0, -1, 0, 1.5, 1, 0, 0, -2, 0, 0, 1, 0.25, 0, 0, 0, 1};

} // namespace

TEST_F(PoseFile, CsvColumnsMayStandInAnyOrder) {
    const auto scenarios = read_text_file("p.csv",
                                          "# a comment\nqw,qx,qy,qz,z,y,x,id\n\n"
                                          "0.6,0.8,0,0,3,2,1,7\n 1, 0,0,0, 6,5,4, 8\n");
    ASSERT_EQ(scenarios.size(), 2u);
    EXPECT_EQ(scenarios[0].poses.b, Pose::from_quaternion({0.6, 0.8, 0, 0}, {1, 2, 3}));
    EXPECT_EQ(scenarios[1].poses.b.translation(), Vec3(4, 5, 6));
    EXPECT_EQ(scenarios[1].index, 1u);
    EXPECT_EQ(scenarios[0].poses.a, Pose());
}

TEST_F(PoseFile, IdsAndTimesAreTakenAlong) {
    const auto labels_of = [&](const std::string& name, const std::string& text, bool both) {
        write_text(folder_ / name, text);
        PoseFileSpec s = spec(name);
        s.of_both_bodies = both;
        auto opened = open_pose_file(s);
        return opened ? opened.value().labels
                      : (ADD_FAILURE() << opened.error().detail, PoseLabels());
    };
    EXPECT_EQ(labels_of("i.csv", "id,x,T\n7,1,0.1\n-3,2,1e3\n", false),
              (PoseLabels{{7, -3}, {}, {0.1, 1000}}));
    EXPECT_EQ(labels_of("t.csv", "x,id\n1,7\n2,\"a, b\"\n3,8\n", false),
              (PoseLabels{{}, {"7", "a, b", "8"}, {}}));
    EXPECT_EQ(labels_of("zero.csv", "x,id\n1,7\n2,007\n", false),
              (PoseLabels{{}, {"7", "007"}, {}}))
        << "nothing is lost of an id";
    EXPECT_EQ(labels_of("both.csv",
                        "scenario,body,x,id,t\n1,b,4,9,9\n0,a,1,5,0.5\n1,a,3,6,0.25\n0,b,2,9,9\n",
                        true),
              (PoseLabels{{5, 6}, {}, {0.5, 0.25}}))
        << "those of body a, in the order of the scenarios";
    EXPECT_EQ(labels_of("p.tum", "1.5 1 0 0 0 0 0 1\n2.5 1 0 0 0 0 0 1\n", false),
              (PoseLabels{{}, {}, {1.5, 2.5}}));
    EXPECT_TRUE(labels_of("none.csv", "x,name,time\n1,a,noon\n", false).is_empty());
    EXPECT_THAT(error_of_text("bad.csv", "x,t\n1,noon\n"),
                HasSubstr("line 2: t is 'noon', not a number"));
    EXPECT_THAT(error_of_text("long.csv", "x,id\n1," + std::string(257, 'a') + "\n"),
                HasSubstr("line 2: the id is longer than 256 bytes"));
}

TEST_F(PoseFile, VelocitiesAreTakenInTheJobsUnit) {
    const auto rates_of = [&](const std::string& text, bool both = false) {
        write_text(folder_ / "v.csv", text);
        PoseFileSpec s = spec("v.csv");
        s.of_both_bodies = both;
        s.length_factor = 0.5;
        auto opened = open_pose_file(s);
        return opened ? opened.value().rates
                      : (ADD_FAILURE() << opened.error().detail, std::vector<PoseRates>());
    };
    const auto rates = rates_of("vz,x,VX,vy,wx,wy,wz\n3,9,1,2,0.1,0.2,0.3\n6,9,4,5,0,0,0\n");
    ASSERT_EQ(rates.size(), 2u);
    EXPECT_EQ(rates[0].velocity, Vec3(0.5, 1, 1.5));
    EXPECT_EQ(rates[0].acceleration, Vec3(0, 0, 0));
    EXPECT_EQ(rates[0].spin, Vec3(0.1, 0.2, 0.3));
    EXPECT_EQ(rates[1].velocity, Vec3(2, 2.5, 3));
    const auto turned = rates_of("x,ax,ay,az,wx_deg,wy_deg,wz_deg\n9,2,4,6,0,0,180\n");
    ASSERT_EQ(turned.size(), 1u);
    EXPECT_EQ(turned[0].acceleration, Vec3(1, 2, 3));
    EXPECT_NEAR(turned[0].spin.z(), 3.14159265358979323846, 1e-15);
    const auto of_both = rates_of("scenario,body,x,vx,vy,vz\n0,b,1,2,0,0\n0,a,1,4,0,0\n", true);
    ASSERT_EQ(of_both.size(), 2u);
    EXPECT_EQ(of_both[0].velocity, Vec3(2, 0, 0));
    EXPECT_EQ(of_both[1].velocity, Vec3(1, 0, 0));
    EXPECT_TRUE(rates_of("x,y\n1,2\n").empty());
    // The poses themselves stay as they are.
    const auto poses = read_text_file("p.csv", "vx,vy,vz,x,y\n7,8,9,1,2\n");
    ASSERT_EQ(poses.size(), 1u);
    EXPECT_EQ(poses[0].poses.b.translation(), Vec3(1, 2, 0));
}

TEST_F(PoseFile, HalfAVelocityIsRefusedByItsColumn) {
    EXPECT_THAT(error_of_text("h.csv", "# log\nx,vx,vz\n1,2,3\n"),
                HasSubstr("h.csv: line 2: column 'vx' needs column 'vy' as well"));
    EXPECT_THAT(error_of_text("h.csv", "x,wz_deg\n1,2\n"),
                HasSubstr("line 1: column 'wz_deg' needs column 'wx_deg' as well"));
    EXPECT_THAT(error_of_text("h.csv", "x,wx,wy,wz,wx_deg,wy_deg,wz_deg\n1,2,3,4,5,6,7\n"),
                HasSubstr("line 1: columns 'wx' and 'wx_deg' are one spin"));
    EXPECT_THAT(error_of_text("h.csv", "x,vx,vy,vz\n1,2,3,4\n1,2,fast,4\n"),
                HasSubstr("line 3: vy is 'fast', not a number"));
    EXPECT_THAT(error_of_text("h.csv", "x,vx,vy,vz\n1,nan,3,4\n"),
                HasSubstr("line 2: vx is 'nan', not a number"));
    EXPECT_THAT(error_of_text("h.csv", "vx,vy,vz\n1,2,3\n"),
                HasSubstr("there is no column of a pose"));
}

TEST_F(PoseFile, AFileOfLabelsGivesThemBack) {
    const auto path = folder_ / "ids";
    for (const PoseLabels& labels :
         {PoseLabels{{1, -2}, {}, {}},
          PoseLabels{{}, {"", "a,b", "say \"x\"\nand y"}, {0.1, 2, -1e300}},
          PoseLabels{{}, {}, {0.1}},
          PoseLabels{{}, {"", ""}, {}}}) {
        ASSERT_TRUE(write_labels(path, labels));
        EXPECT_LE(std::filesystem::file_size(path), label_bytes(labels));
        const auto read = read_labels(path);
        ASSERT_TRUE(read) << read.error().detail;
        EXPECT_EQ(read.value(), labels);
    }
    for (const char* text :
         {"", "id,t\n1\n", "t\nnoon\n", "t,id\n1,1\n", "x\n1\n", "t\nnan\n", "t\ninf\n"}) {
        write_text(path, text);
        EXPECT_FALSE(read_labels(path)) << text;
    }
    EXPECT_EQ(read_labels(folder_ / "missing").error().code, ErrorCode::NotFound);
}

TEST_F(PoseFile, CsvTakesMatricesAndEulerAngles) {
    const auto matrices = read_text_file(
        "m.csv", "m00,m01,m02,m03,m10,m11,m12,m13,m20,m21,m22,m23\n0,-1,0,5,1,0,0,6,0,0,1,7\n");
    ASSERT_EQ(matrices.size(), 1u);
    EXPECT_EQ(matrices[0].poses.b.kind(), Pose::Kind::Matrix);
    EXPECT_EQ(matrices[0].poses.b.apply(Vec3(1, 0, 0)), Vec3(5, 7, 7));

    const auto euler = read_text_file("e.csv", "x,y,z,roll_deg,pitch_deg,yaw_deg\n0,0,0,0,0,90\n");
    ASSERT_EQ(euler.size(), 1u);
    EXPECT_EQ(euler[0].poses.b.kind(), Pose::Kind::Quaternion);
    EXPECT_LT((euler[0].poses.b.apply(Vec3(1, 0, 0)) - Vec3(0, 1, 0)).norm(), 1e-15);
}

TEST_F(PoseFile, ScenariosAreNamedByTheirPlace) {
    const auto place_of = [&](const std::string& name, bool both) {
        PoseFileSpec s = spec(name);
        s.of_both_bodies = both;
        auto opened = open_pose_file(s);
        return opened ? opened.value().source->place_of(1) : opened.error().detail;
    };
    write_text(folder_ / "p.csv", "# a comment\nx,y\n\n1,2\n\n3,4\n");
    EXPECT_EQ(place_of("p.csv", false), "line 6");
    write_text(folder_ / "both.csv", "scenario,body,x\n1,b,4\n0,a,1\n1,a,3\n0,b,2\n");
    EXPECT_EQ(place_of("both.csv", true), "lines 4 and 2");
    std::vector<double> twice = turned;
    twice.insert(twice.end(), turned.begin(), turned.end());
    write_npy("p.npy", {2, 4, 4}, twice);
    EXPECT_EQ(place_of("p.npy", false), "row 1");
}

TEST_F(PoseFile, CsvOfBothBodiesComesInAnyOrder) {
    write_text(folder_ / "both.csv",
               "scenario,body,x,y,z,qx,qy,qz,qw\n1,b,4,0,0,0,0,0,1\n0,a,1,0,0,0,0,0,1\n"
               "1,a,3,0,0,0,0,0,1\n0,b,2,0,0,0,0,0,1\n");
    PoseFileSpec s = spec("both.csv");
    s.of_both_bodies = true;
    const auto scenarios = read_all(s);
    ASSERT_EQ(scenarios.size(), 2u);
    EXPECT_EQ(scenarios[0].poses.a.translation().x(), 1);
    EXPECT_EQ(scenarios[0].poses.b.translation().x(), 2);
    EXPECT_EQ(scenarios[1].poses.b.translation().x(), 4);

    write_text(folder_ / "both.csv", "scenario,body,x,y,z,qx,qy,qz,qw\n0,a,1,0,0,0,0,0,1\n");
    EXPECT_THAT(error_of(s), HasSubstr("no pose of body b"));
}

TEST_F(PoseFile, TumIsTimePositionQuaternion) {
    const auto scenarios =
        read_text_file("p.tum", "# timestamp tx ty tz qx qy qz qw\n0.5 1 2 3  0 0 0 1\n");
    ASSERT_EQ(scenarios.size(), 1u);
    EXPECT_EQ(scenarios[0].poses.b, Pose::from_quaternion({1, 0, 0, 0}, {1, 2, 3}));
}

TEST_F(PoseFile, NpyTakesMatricesOfThreeShapes) {
    const std::vector<double> upper(turned.begin(), turned.begin() + 12);
    write_npy("a.npy", {1, 4, 4}, turned);
    write_npy("b.npy", {1, 3, 4}, upper);
    write_npy("c.npy", {1, 12}, upper);
    for (const char* name : {"a.npy", "b.npy", "c.npy"}) {
        const auto scenarios = read_all(spec(name));
        ASSERT_EQ(scenarios.size(), 1u) << name;
        EXPECT_EQ(scenarios[0].poses.b.apply(Vec3(1, 0, 0)), Vec3(1.5, -1, 0.25)) << name;
    }
}

TEST_F(PoseFile, ABareQuaternionArrayNeedsItsOrder) {
    write_npy("q.npy", {1, 7}, {1, 2, 3, 0.6, 0.8, 0, 0});
    PoseFileSpec s = spec("q.npy");
    EXPECT_THAT(error_of(s), HasSubstr("quat_order"));
    s.quat_order = "wxyz";
    EXPECT_EQ(read_all(s)[0].poses.b.quaternion(), (Quaternion{0.6, 0.8, 0, 0}));
    s.quat_order = "xyzw";
    EXPECT_EQ(read_all(s)[0].poses.b.quaternion(), (Quaternion{0, 0.6, 0.8, 0}));
}

TEST_F(PoseFile, NpzHoldsAnArrayCalledPoses) {
    NpzWriter writer(folder_ / "p.npz");
    const auto other = writer.add_array({"other", NpyType::F8});
    const auto poses = writer.add_array({"poses", NpyType::F8, 12});
    EXPECT_TRUE(writer.append(other, std::span<const double>(turned)));
    EXPECT_TRUE(writer.append(poses, std::span<const double>(turned).first(12)));
    ASSERT_TRUE(writer.finish());
    EXPECT_EQ(read_all(spec("p.npz")).size(), 1u);
}

TEST_F(PoseFile, ATextArrayBesideThePosesIsIgnored) {
    const std::string labels = "\x93NUMPY\x01\x00 is of a type that is not read";
    NpzWriter writer(folder_ / "p.npz");
    ASSERT_TRUE(writer.append(writer.add_array({"poses", NpyType::F8, 12}),
                              std::span<const double>(turned).first(12)));
    ASSERT_TRUE(writer.finish());
    zip_t* const archive = zip_open((folder_ / "p.npz").c_str(), 0, nullptr);
    ASSERT_NE(archive, nullptr);
    zip_file_add(archive,
                 "labels.npy",
                 zip_source_buffer(archive, labels.data(), labels.size(), 0),
                 ZIP_FL_ENC_UTF_8);
    ASSERT_EQ(zip_close(archive), 0);
    EXPECT_EQ(read_all(spec("p.npz")).size(), 1u);
}

TEST_F(PoseFile, RefusesByRowAndValueWhatIsNotRigid) {
    const std::string columns = "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n";
    EXPECT_THAT(error_of_text("n.csv", columns + "0,0,0,0,0,0,1.01\n"),
                testing::AllOf(HasSubstr("line 3"), HasSubstr("0.01"), HasSubstr("tolerance")));
    EXPECT_THAT(error_of_text("z.csv", columns + "0,0,0,0,0,0,0\n"), HasSubstr("zero"));
    EXPECT_THAT(error_of_text("f.csv", columns + "nan,0,0,0,0,0,1\n"), HasSubstr("line 3"));
    EXPECT_THAT(error_of_text("w.csv", columns + "a,0,0,0,0,0,1\n"), HasSubstr("line 3"));
    EXPECT_THAT(error_of_text("s.csv", columns + "0,0,0,0,0,1\n"), HasSubstr("line 3"));
    EXPECT_THAT(error_of_text("c.csv", "x,y,z,qx,qy,qz\n"), HasSubstr("qw"));
    EXPECT_THAT(error_of_text("e.csv", columns.substr(0, 18)), HasSubstr("no poses"));

    std::vector<double> mirrored = turned;
    mirrored[10] = -1;
    write_npy("mirror.npy", {1, 4, 4}, mirrored);
    EXPECT_THAT(error_of(spec("mirror.npy")), HasSubstr("determinant"));
    std::vector<double> projective = turned;
    projective[15] = 2;
    write_npy("last.npy", {1, 4, 4}, projective);
    EXPECT_THAT(error_of(spec("last.npy")), HasSubstr("0 0 0 1"));
    std::vector<double> bent = turned;
    bent[0] = 1e-4;
    write_npy("bent.npy", {1, 4, 4}, bent);
    PoseFileSpec s = spec("bent.npy");
    EXPECT_THAT(error_of(s), HasSubstr("row 0"));
    s.rigid_tolerance = 1e-3;
    EXPECT_EQ(read_all(s).size(), 1u);
}

TEST_F(PoseFile, WarnsOfFewDecimalsNamingTheWorstRow) {
    const auto scenarios = read_text_file("w.csv",
                                          "x,y,z,qx,qy,qz,qw\n0,0,0,0,0,0,1\n"
                                          "0,0,0,0.70711,0,0,0.70711\n0,0,0,0.7071,0,0,0.7071\n");
    EXPECT_EQ(scenarios.size(), 3u);
    ASSERT_EQ(warnings_.size(), 1u);
    EXPECT_THAT(warnings_[0], testing::AllOf(HasSubstr("2 poses"), HasSubstr("line 4")));
}

TEST_F(PoseFile, RefusesDamagedArrays) {
    write_npy("good.npy", {1, 4, 4}, turned);
    const std::string good = read_text(folder_ / "good.npy");
    for (std::size_t length = 0; length < good.size(); ++length) {
        ASSERT_NE(error_of_text("cut.npy", good.substr(0, length)), "was taken") << length;
    }
    std::string hostile = good;
    hostile.replace(hostile.find("(1, 4, 4)"), 9, "(9999999999999,)");
    EXPECT_NE(error_of_text("big.npy", hostile), "was taken");
    EXPECT_NE(error_of_text("more.npy", good + "x"), "was taken");
    EXPECT_NE(error_of_text("no.xyz", "1 2 3"), "was taken");
}

TEST_F(PoseFile, CsvAnglesOfAnySizeAreRigid) {
    const auto scenarios = read_text_file("e.csv",
                                          "x,y,z,roll_deg,pitch_deg,yaw_deg\n0,0,0,90,180,-90\n"
                                          "1,2,3,30,-45,60\n0,0,0,720,0,1e-3\n");
    EXPECT_EQ(scenarios.size(), 3u);
    EXPECT_TRUE(warnings_.empty());
    EXPECT_THAT(error_of_text("n.csv", "x,y,z,roll_deg,pitch_deg,yaw_deg\n0,0,0,nan,0,0\n"),
                HasSubstr("line 2"));
    EXPECT_THAT(error_of_text("r.csv", "x,y,z,roll_grad,pitch_deg,yaw_deg\n0,0,0,0,0,0\n"),
                HasSubstr("roll"));
}

TEST_F(PoseFile, NumbersThatBecomeInfiniteInAnotherUnitAreRefused) {
    EXPECT_THAT(error_of_text("a.csv", "yaw_rad\n0\n1e308\n"),
                HasSubstr("line 3: yaw is '1e308', not a number"));
    std::vector<double> far = turned;
    far[11] = 1e308;
    write_npy("far.npy", {1, 4, 4}, far);
    write_text(folder_ / "far.csv", "x,y,z,qx,qy,qz,qw\n0,-1e308,0,0,0,0,1\n");
    for (const auto& [name, place] : {std::pair("far.npy", "row 0"), {"far.csv", "line 2"}}) {
        PoseFileSpec in_km = spec(name);
        EXPECT_EQ(read_all(in_km).size(), 1u);
        in_km.length_factor = 1000;
        EXPECT_THAT(error_of(in_km),
                    testing::AllOf(HasSubstr(place), HasSubstr("too large in the job's unit")));
    }
}

TEST_F(PoseFile, QuotesInAnIdAreThoseOfTheFile) {
    write_text(folder_ / "ids.csv", "id,x\n\"a \"\"b\"\"\",0\n\"x, y\",1\n\" 7 \",\"2\"\n");
    const auto opened = open_pose_file(spec("ids.csv"));
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_EQ(opened.value().labels.texts, (std::vector<std::string>{"a \"b\"", "x, y", "7"}));
}

/// Text whose reading fails at its end.
class BrokenText : public std::stringbuf {
  public:
    using std::stringbuf::stringbuf;

  protected:
    int_type underflow() override {
        const int_type next = std::stringbuf::underflow();
        return traits_type::eq_int_type(next, traits_type::eof()) ? throw std::runtime_error("gone")
                                                                  : next;
    }
};

TEST_F(PoseFile, WhatCannotBeReadToItsEndIsRefused) {
    BrokenText csv("x\n1\n2\n");
    std::istream csv_in(&csv);
    const auto of_csv = read_csv_poses(csv_in, false);
    ASSERT_FALSE(of_csv);
    EXPECT_EQ(of_csv.error().detail, "cannot be read beyond line 3");
    BrokenText tum("0 0 0 0 0 0 0 1\n");
    std::istream tum_in(&tum);
    const auto of_tum = read_tum_poses(tum_in);
    ASSERT_FALSE(of_tum);
    EXPECT_EQ(of_tum.error().detail, "cannot be read beyond line 1");
}

TEST_F(PoseFile, CsvAnglesSayTheirUnit) {
    const auto degrees =
        read_text_file("d.csv", "x,y,z,roll_deg,pitch_deg,yaw_deg\n1,2,3,90,0,45\n");
    const auto radians = read_text_file(
        "r.csv",
        "x,y,z,Roll_rad,pitch_deg,yaw_rad\n1,2,3,1.5707963267948966,0,0.7853981633974483\n");
    EXPECT_EQ(radians, degrees);
    EXPECT_EQ(error_of_text("b.csv", "x,y,yaw\n0,0,0\n"),
              (folder_ / "b.csv").string() +
                  ": line 1: column 'yaw' does not say its unit: name it yaw_deg or yaw_rad");
    EXPECT_THAT(error_of_text("t.csv", "x,yaw_deg,yaw_rad\n0,0,0\n"), HasSubstr("are one angle"));
}

TEST_F(PoseFile, CsvNumbersThatAreLeftOutAreZero) {
    const auto whole = read_text_file("w.csv", "x,y,z,roll_deg,pitch_deg,yaw_deg\n1,2,0,0,0,45\n");
    const auto some = read_text_file("s.csv", "yaw_deg,x,y\n45,1,2\n");
    EXPECT_EQ(some, whole);
    const auto opened = open_pose_file(spec("s.csv"));
    EXPECT_EQ(opened.value().zeros, (std::vector<std::string>{"z", "roll", "pitch"}));
    EXPECT_EQ(read_text_file("p.csv", "x,y,z\n1,2,3\n")[0].poses.b.translation(), Vec3(1, 2, 3));
    EXPECT_THAT(error_of_text("n.csv", "id,t\n0,0\n"), HasSubstr("no column of a pose"));
    EXPECT_THAT(error_of_text("q.csv", "x,y,z,qz,qw\n0,0,0,0,1\n"), HasSubstr("no column 'qx'"));
}

TEST_F(PoseFile, TranslationsAreMultipliedByTheLengthFactor) {
    write_text(folder_ / "mm.csv", "x,y,z,yaw_deg\n1500,-250,0,90\n");
    PoseFileSpec in_mm = spec("mm.csv");
    in_mm.length_factor = 0.001;
    const Pose pose = read_all(in_mm)[0].poses.b;
    EXPECT_EQ(pose.translation(), Vec3(1.5, -0.25, 0));
    EXPECT_EQ(pose.apply(Vec3(1, 0, 0)), Vec3(1.5, 0.75, 0));
    write_npy("m.npy", {1, 4, 4}, turned);
    PoseFileSpec matrix = spec("m.npy");
    matrix.length_factor = 2;
    EXPECT_EQ(read_all(matrix)[0].poses.b.translation(), Vec3(3, -4, 0.5));
}

TEST_F(PoseFile, AFolderIsNamed) {
    EXPECT_EQ(error_of(spec("")),
              spec("").path.string() + ": is a folder; a file of poses is needed");
}

TEST_F(PoseFile, CsvSaysWhoseEachPoseIs) {
    const std::string columns = "body,x,y,z,qx,qy,qz,qw\n";
    EXPECT_EQ(read_text_file("b.csv", columns + "b,0,0,0,0,0,0,1\n").size(), 1u);
    EXPECT_THAT(error_of_text("a.csv", columns + "a,0,0,0,0,0,0,1\n"), HasSubstr("both"));
    EXPECT_THAT(error_of_text("s.csv", "scenario," + columns + "0,b,0,0,0,0,0,0,1\n"),
                HasSubstr("both"));
}

TEST_F(PoseFile, CsvOfSpreadsheetsIsUnderstood) {
    const auto scenarios = read_text_file("s.csv",
                                          "\xEF\xBB\xBF\"X\",y,z,qx,qy,qz,qw,name\r\n"
                                          "\"1.5\",+2,3e0,0,0,0,1,\"left, front\"\r\n");
    ASSERT_EQ(scenarios.size(), 1u);
    EXPECT_EQ(scenarios[0].poses.b.translation(), Vec3(1.5, 2, 3));
}

TEST_F(PoseFile, AFileThatChangesWhileItIsReadIsAnError) {
    write_npy("p.npy", {1, 7}, {0, 0, 0, 0, 0, 0, 1});
    PoseFileSpec s = spec("p.npy");
    s.quat_order = "xyzw";
    auto opened = open_pose_file(s);
    ASSERT_TRUE(opened) << opened.error().detail;
    write_npy("p.npy", {1, 7}, {0, 0, 0, 0, 0, 0, 0});
    const auto read = opened.value().source->read(0, 1);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().detail, testing::StartsWith(s.path.string() + ": row 0: "));
}

TEST_F(PoseFile, AScenarioOfBothBodiesIsAWholeNumber) {
    for (const char* scenario : {"0.5", "nan", "-1", "inf", ""}) {
        write_text(folder_ / "both.csv",
                   "scenario,body,x\n" + std::string(scenario) + ",a,0\n0,b,0\n");
        PoseFileSpec s = spec("both.csv");
        s.of_both_bodies = true;
        EXPECT_THAT(error_of(s),
                    HasSubstr("line 2: scenario '" + std::string(scenario) +
                              "', body 'a': a count from 0, and a or b are expected"));
    }
}

TEST_F(PoseFile, ANumberBelowAllDoublesIsZero) {
    write_text(folder_ / "tiny.csv", "x,y\n1e-400,+2\n");
    EXPECT_EQ(error_of(spec("tiny.csv")), "was taken");
}

TEST_F(PoseFile, PosesOfBothBodiesAreFoundByTheirLines) {
    const std::string columns = "scenario,body,x,y,z,qx,qy,qz,qw\n";
    const std::string rows = "1,b,0,0,0,0,0,0,1\n0,b,0,0,0,0,0,0,1\n0,a,0,0,0,0,0,0,1\n";
    write_text(folder_ / "both.csv", columns + rows + "1,a,0,0,0,0,0,0,2\n");
    PoseFileSpec s = spec("both.csv");
    s.of_both_bodies = true;
    EXPECT_THAT(error_of(s), HasSubstr("both.csv: line 5: the quaternion's norm"));
    write_text(folder_ / "both.csv", columns + rows + "1,a,0,0,0,0,0,0,1.0001\n");
    const auto opened = open_pose_file(s);
    ASSERT_TRUE(opened) << opened.error().detail;
    EXPECT_THAT(opened.value().warnings,
                testing::ElementsAre(testing::AllOf(
                    HasSubstr("the worst is line 5, off by 0.0001"),
                    HasSubstr("A matrix is taken as it is, a quaternion is scaled to length 1"))));
    write_npy("both.npy", {2, 2, 7}, {0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1,
                                      0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 3});
    s = spec("both.npy");
    s.of_both_bodies = true;
    s.quat_order = "xyzw";
    EXPECT_THAT(error_of(s), HasSubstr("row 1, body b: the quaternion's norm"));
}

TEST_F(PoseFile, TooLittleMemoryNamesTheFile) {
    if (!MemoryBound::is_enforced) {
        GTEST_SKIP() << "memory cannot be bounded under sanitizers";
    }
    std::string rows = "x\n";
    for (int i = 0; i < 1'000'000; ++i) {
        rows += "0\n";
    }
    write_text(folder_ / "many.csv", rows);
    const MemoryBound bound(32u << 20); // Half of the numbers' size.
    EXPECT_EQ(error_of(spec("many.csv")),
              (folder_ / "many.csv").string() + ": too little memory to read it");
}

TEST_F(PoseFile, ReadsRunsOfALargeArray) {
    std::vector<double> values;
    for (int i = 0; i < 10'000; ++i) {
        values.insert(values.end(), {1.0 * i, 0, 0, 0, 0, 0, 1});
    }
    write_npy("large.npy", {10'000, 7}, values);
    PoseFileSpec s = spec("large.npy");
    s.quat_order = "xyzw";
    auto opened = open_pose_file(s);
    ASSERT_TRUE(opened) << opened.error().detail;
    const auto run = opened.value().source->read(7'000, 3).value();
    ASSERT_EQ(run.size(), 3u);
    EXPECT_EQ(run[2].index, 7'002u);
    EXPECT_EQ(run[2].poses.b.translation().x(), 7'002);
}

} // namespace cd::tests

// SPDX-License-Identifier: Apache-2.0
// Models that are damaged, hostile or very large, folded out by the program: a clear error with its line, or a drawing and a note
// of what was left out. tests/tactics/readers/vrml/hostile_test.cpp has what the reader alone makes of them.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "tests/cli/converting.h"
#include "tests/sanitized.h"

namespace tactics::hostile_model_test {
namespace {

using namespace tests;

const std::string kVrml97 = "#VRML V2.0 utf8\n";
const std::string kBox = "Shape { geometry Box { } }";

// Binary STL, little-endian (the only one that there is).
class Stl {
public:
    void add(std::initializer_list<double> corners) {
        ++count_;
        bytes_.append(12, '\0');  // the normal
        for (const double value : corners) put(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
        bytes_.append(2, '\0');
    }
    std::string bytes() const {
        std::string head(80, '\0');
        for (int i = 0; i < 4; ++i) head += static_cast<char>(count_ >> 8 * i & 255);
        return head + bytes_;
    }

private:
    void put(std::uint32_t value) {
        for (int i = 0; i < 4; ++i) bytes_ += static_cast<char>(value >> 8 * i & 255);
    }
    std::uint32_t count_ = 0;
    std::string bytes_;
};

class HostileModel : public Convert {
protected:
    Ending fold(const std::string& name, const std::string& bytes) {
        write_bytes(folder / name, bytes);
        return convert({name, "--model", "fold-out", "-o", "page.svg"});
    }
    void expect_drawn(const std::string& bytes, const std::string& note, const std::string& name = "a.wrl") {
        const Ending ending = fold(name, bytes);
        EXPECT_EQ(ending.code, 0) << ending.err;
        EXPECT_TRUE(holds(ending.err, note)) << ending.err;
        EXPECT_TRUE(holds(bytes_of(folder / "page.svg"), "<path")) << "nothing is drawn";
        std::filesystem::remove(folder / "page.svg");
    }
    void expect_refused(const std::string& bytes, const std::string& why, const std::string& name = "a.wrl") {
        const Ending ending = fold(name, bytes);
        EXPECT_EQ(ending.code, 2) << ending.err;
        EXPECT_TRUE(holds(ending.err, why)) << ending.err;
        EXPECT_EQ(lines_in(ending.err), 1u) << ending.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "page.svg"));
    }
};

TEST_F(HostileModel, WhatHasNoEndIsLeftOutOrRefused) {
    expect_drawn(kVrml97 + "DEF A Group { children [ " + kBox + "\nUSE A ] }", "left out: USE of \"A\" within itself");
    std::string deep = kVrml97;
    for (int i = 0; i < 8000; ++i) deep += "Transform { children [\n";
    expect_refused(deep, "a.wrl:258: nodes are nested over 256 deep");
}

TEST_F(HostileModel, OtherFilesAreNotRead) {
    write_bytes(folder / "other.wrl", kVrml97 + kBox);
    for (const std::string name : {"a.wrl", "other.wrl", "no.wrl", "/etc/passwd"}) {
        expect_drawn(kVrml97 + kBox + "\nInline { url \"" + name + "\" }", "Inline of \"" + name + "\": no other file is read");
        expect_refused(kVrml97 + "Inline { url \"" + name + "\" }", "no other file is read; take it by itself (line 2)");
    }
}

TEST_F(HostileModel, BadFacesAreLeftOutAndTold) {
    const std::string points = "coord Coordinate { point [ 0 0 0, 1 0 0, 1 1 0, 0 1 0, .5 0 0 ] }";
    const auto faces = [&](const std::string& index) {
        return kVrml97 + "DEF Thing Shape { geometry IndexedFaceSet { " + points + " coordIndex [ " + index + " ] } }";
    };
    // Twice, from the other side, without area, with one corner twice, with a corner that is missing.
    const std::string bad = "0 1 2 3 -1, 3 2 1 0 -1, 0 4 1 -1, 0 0 1 -1, 0 1 9 -1";
    expect_drawn(faces("0 1 2 3 -1, " + bad), "2 faces without area, or that were there twice, are left out");
    expect_drawn(faces("0 1 2 3 -1, " + bad), "a corner that is not there (3 times, first in line 2)");
    expect_refused(faces("0 4 1 -1"), "has no faces");
    expect_refused(kVrml97 + "Shape { geometry Sphere {\nradius NaN } }", "a.wrl:3: \"NaN\" is no number");
    Stl stl;
    stl.add({0, 0, 0, 1, 0, 0, 0, 1, 0});
    stl.add({0, 0, 0, 1, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0});
    expect_refused(stl.bytes(), "a corner that is no number, in triangle 2", "a.stl");
    expect_refused(stl.bytes().substr(0, 150), "is cut short", "a.stl");
    const Ending nobody = convert({"a.stl", "--object", "Table/Top", "-o", "page.svg"});
    EXPECT_NE(nobody.code, 0);
}

TEST_F(HostileModel, ATextIsNoModel) {
    expect_refused("Dear reader, this is no model.\n", "looks like a text file");
    expect_refused(kVrml97 + "Dear reader, this is no model.\n", "a.wrl:2: \"reader\" stands where \"{\" should");
    expect_refused("", "is empty");
}

// A box of that many squares a side, each cut into two.
TEST_F(HostileModel, MillionsOfTrianglesAreMadeFewerAndTold) {
    const int squares = TACTICS_SANITIZED ? 140 : 409;
    Stl stl;
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, squares})
            for (int i = 0; i < squares; ++i)
                for (int j = 0; j < squares; ++j) {
                    double at[4][3];
                    for (int k = 0; k < 4; ++k) {
                        at[k][axis] = side;
                        at[k][(axis + 1) % 3] = i + (k == 1 || k == 2);
                        at[k][(axis + 2) % 3] = j + (k >= 2);
                    }
                    for (const int k : {1, 2}) {
                        const auto &a = at[0], &b = at[k], &c = at[k + 1];
                        stl.add({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
                    }
                }
    write_bytes(folder / "a.stl", stl.bytes());
    const Ending told = convert({"a.stl", "--model", "fold-out", "--json", "-o", "page.svg"});
    EXPECT_EQ(told.code, 0) << told.err;
    EXPECT_TRUE(holds(told.out, "of " + std::to_string(12 * squares * squares) + " faces ")) << told.out;
    // A top with four sides, however many triangles they were.
    EXPECT_TRUE(holds(told.out, "\"form\":\"solid\",\"fate\":\"drawn\"")) << told.out;
    EXPECT_TRUE(holds(told.out, "\"kept\":1,\"folded\":4")) << told.out;
}

TEST_F(HostileModel, TwentyThousandPiecesAreOneOutline) {
    const int side = TACTICS_SANITIZED ? 50 : 142;
    Stl stl;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double x = 10 * i, y = 10 * j, z = 37 * i % 100 + 53 * j % 100;
            stl.add({x, y, z, x + 6, y + 1, z + 2, x + 1, y + 6, z - 2});
        }
    expect_drawn(stl.bytes(), std::to_string(side * side) + " pieces, too many to be told apart", "a.stl");
}

// Their outline has no height from the side, and so there is nothing there to hold a rod by.
TEST_F(HostileModel, AFlatCrowdHoldsNoRod) {
    std::string points, index;
    for (int i = 0; i < 2500; ++i) {
        const int x = i % 50, z = i / 50;
        for (const auto& [dx, dz] : {std::pair{0.0, 0.0}, {0.5, 0.0}, {0.0, 0.5}})
            points += std::to_string(x + dx) + " 0 " + std::to_string(z + dz) + " ";
        index += std::to_string(3 * i) + " " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " -1 ";
    }
    expect_drawn(kVrml97 + "Transform { children [ DEF Dots Shape { geometry IndexedFaceSet { coord Coordinate { point [ " +
                     points + "] } coordIndex [ " + index +
                     "] } } Transform { translation 25 -10 25 children DEF Leg Shape { geometry Box { size 0.5 20 0.5 } } } ] }",
                 "outline");
}

TEST_F(HostileModel, OfThousandsOfNamesThoseWithRoomAreSet) {
    std::string crowd = kVrml97;
    for (int i = 0; i < 2000; ++i)
        crowd += "DEF Box" + std::to_string(i) + " Transform { translation " + std::to_string(i % 45) + " 0 " +
                 std::to_string(i / 45) + " children Shape { geometry Box { size 0.8 " + std::to_string(1 + i % 7) +
                 " 0.8 } } }\n";
    expect_drawn(crowd, "only the 100 largest of ");
}

}  // namespace
}  // namespace tactics::hostile_model_test

// SPDX-License-Identifier: Apache-2.0
// People's names for things, for files from any program.
#include "tactics/text/plain_name.h"

#include <gtest/gtest.h>

#include "tactics/model.h"

namespace tactics::plain_name_test {
namespace {

TEST(PlainName, MarksOfExportersAreNotSpoken) {
    EXPECT_EQ(plain_name("OB_Chair"), "Chair");  // Blender, VRML 97
    EXPECT_EQ(plain_name("ME_MeshWieza"), "MeshWieza");
    EXPECT_EQ(plain_name("OB_Wieza4_004"), "Wieza4");  // a copy, where ids have no points
    EXPECT_EQ(plain_name("group_ME_wheel"), "wheel");
    EXPECT_EQ(plain_name("Chair_TRANSFORM"), "Chair");  // Blender, X3D
    EXPECT_EQ(plain_name("Chair_002_TRANSFORM"), "Chair");
    EXPECT_EQ(plain_name("planche02-FACES"), "planche02");  // 3ds Max
    EXPECT_EQ(plain_name("Chair.001"), "Chair");            // Blender's copies
    EXPECT_EQ(plain_name("Chair.1042"), "Chair");
    EXPECT_EQ(plain_name("Chair (2)"), "Chair");  // Unity's
}

TEST(PlainName, WhatAPersonWroteStays) {
    for (const char* name : {"Chair", "Leg1", "Shelf_001", "Version 1.5", "Chair.12", "LegShape", "OBSERVER", "Room (north)",
                             "group_of_chairs", "(2)", "OB_", ".001", "", "T\xc3\xbcr", "\xe6\xa4\x85\xe5\xad\x90"})
        EXPECT_EQ(plain_name(name), name);
}

TEST(PlainName, AShapeIsKnownByItsThing) {
    EXPECT_TRUE(names_shape_of("ME_MeshWieza", "OB_Wieza4_004"));
    EXPECT_TRUE(names_shape_of("planche02-FACES", "planche02"));
    EXPECT_TRUE(names_shape_of("Chair", "Chair_TRANSFORM"));
    EXPECT_TRUE(names_shape_of("pCubeShape1", "pCube1"));  // Maya
    EXPECT_TRUE(names_shape_of("barShape", "bar"));
    EXPECT_TRUE(names_shape_of("bar1Shape", "bar1") || names_shape_of("barShape1", "bar1"));
    EXPECT_TRUE(names_shape_of("Chair_Shape", "Chair"));
    EXPECT_FALSE(names_shape_of("LegShape", "Table"));
    EXPECT_FALSE(names_shape_of("ME_Top", "Table"));
    EXPECT_FALSE(names_shape_of("Top", "Table"));
}

TEST(PlainName, WordsStandApartWhereThatIsClear) {
    EXPECT_EQ(name_as_words("table_top"), "table top");
    EXPECT_EQ(name_as_words("__table__top_"), "table top");
    EXPECT_EQ(name_as_words("TableTop"), "Table Top");
    EXPECT_EQ(name_as_words("Drawer24CaseTop"), "Drawer24 Case Top");
    EXPECT_EQ(name_as_words("T\xc3\xbcrGriff"), "T\xc3\xbcr Griff");
    for (const char* name : {"McDonald", "iPhone", "LegP", "USBPort", "Le Corbusier_LC4 TableTop", "\xe6\xa4\x85\xe5\xad\x90"})
        EXPECT_EQ(name_as_words(name), name);
}

TEST(PlainName, TheNearestNameAroundIsSpoken) {
    Model model;
    const auto add = [&](const std::string& name, int parent) {
        model.objects.emplace_back();
        model.objects.back().name = name;
        model.objects.back().parent = parent;
        return static_cast<int>(model.objects.size()) - 1;
    };
    const int chair = add("OB_Chair_001", -1), mesh = add("ME_Sitting", chair), bare = add("", mesh),
              other = add("Cushion", chair);
    for (const int one : {chair, mesh, bare}) EXPECT_EQ(spoken_name(model, static_cast<std::size_t>(one)), "Chair");
    EXPECT_EQ(spoken_name(model, static_cast<std::size_t>(other)), "Cushion");
    EXPECT_EQ(spoken_name(model, static_cast<std::size_t>(add("", -1))), "");
}

}  // namespace
}  // namespace tactics::plain_name_test

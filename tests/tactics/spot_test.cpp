// SPDX-License-Identifier: Apache-2.0
// Places in a picture as a person writes them.
#include "tactics/spot.h"

#include <gtest/gtest.h>

#include "tactics/error.h"
#include "tactics/option.h"

namespace tactics::spot_test {
namespace {

std::string error_of(std::string_view text) {
    try {
        parse_spots(text, "here", "subject");
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(Spot, BoxesAndPointsAreRead) {
    EXPECT_EQ(parse_spots("20%,30%-70%,90%", "", ""), (std::vector<Spot>{{0.2, 0.3, 0.7, 0.9}}));
    EXPECT_EQ(parse_spots("40%,50%", "", ""), (std::vector<Spot>{{0.4, 0.5, 0.4, 0.5}}));
    EXPECT_EQ(parse_spots("0%,0%-100%,12.5%;40%,50%", "", ""), (std::vector<Spot>{{0, 0, 1, 0.125}, {0.4, 0.5, 0.4, 0.5}}));
    EXPECT_TRUE(parse_spots("", "", "").empty());
}

TEST(Spot, SwappedCornersAreMended) {
    const std::vector<Spot> box = parse_spots("20%,30%-70%,90%", "", "");
    EXPECT_EQ(parse_spots("70%,90%-20%,30%", "", ""), box);
    EXPECT_EQ(parse_spots("70%,30%-20%,90%", "", ""), box);
}

TEST(Spot, WhatIsWrittenIsReadBack) {
    for (const std::string text : {"20%,30%-70%,90%", "40%,50%", "0.000001%,33.333333%-66.666667%,100%;7%,7%"})
        EXPECT_EQ(to_text(parse_spots(text, "", "")), text);
}

TEST(Spot, WhatIsNoPlaceIsToldWithAnExample) {
    for (const char* text :
         {"middle", "40%", "40,50", "40%,50", "20%,30%-70%", "20%,30%-", "-", "10mm,20mm", "nan%,1%", "1%,1%;;2%,2%", "1%,2%,3%"})
        EXPECT_NE(error_of(text).find("; a box is two corners such as 20%,30%-70%,90%, a point 40%,50%"), std::string::npos)
            << text << ": " << error_of(text);
    for (const char* text : {"-1%,50%", "40%,100.1%", "20%,30%-170%,90%", "20%,-30%-70%,90%"})
        EXPECT_NE(error_of(text).find("; the picture is from 0% to 100%, and this is outside of it"), std::string::npos)
            << text << ": " << error_of(text);
    for (const char* text : {"20%,30%-20%,90%", "20%,30%-70%,30%", "5%,5%-5%,5%"})
        EXPECT_NE(error_of(text).find("it is a box without size"), std::string::npos) << text << ": " << error_of(text);
    std::string many;
    for (std::size_t i = 0; i <= kMostSpots; ++i) many += "1%,1%;";
    EXPECT_NE(error_of(many).find("over 100 places"), std::string::npos);
}

constexpr Option kPlaces[] = {
    {.name = "any", .type = Option::Type::spots, .unit = "", .summary = "places", .choices = ""},
    {.name = "boxes", .type = Option::Type::spots, .unit = "", .summary = "boxes", .choices = kBoxesOnly},
};

TEST(Spot, AnOptionKeepsThem) {
    Settings settings(kPlaces);
    EXPECT_EQ(settings.to_text(), "");
    settings.set("any", "70%,90%-20%,30%;1%,2%", "", "filter");
    settings.set("boxes", "1%,1%-2%,2%", "", "filter");
    EXPECT_EQ(settings.to_text(), "any=20%,30%-70%,90%;1%,2% boxes=1%,1%-2%,2%");
    EXPECT_EQ(settings.spots("any").size(), 2u);
    settings.set("any", "", "", "filter");
    EXPECT_EQ(settings.to_text(), "boxes=1%,1%-2%,2%");
    EXPECT_THROW(settings.set("boxes", "1%,1%", "", "filter"), Error);
}

}  // namespace
}  // namespace tactics::spot_test

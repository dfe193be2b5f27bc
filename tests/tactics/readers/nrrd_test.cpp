// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/nrrd.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tactics/error.h"

namespace tactics::nrrd_test {
namespace {

Voxels read(const std::string& bytes) {
    Source source = memory_source({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()}, "scene.nrrd");
    EXPECT_TRUE(is_nrrd(source));
    return read_nrrd(source);
}

std::string fault_of(const std::string& bytes) {
    try {
        read(bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

std::string head(const std::string& type, const std::string& sizes, const std::string& encoding, int dimension = 3) {
    return "NRRD0004\n# by hand\ntype: " + type + "\ndimension: " + std::to_string(dimension) + "\nsizes: " + sizes +
           "\nspacings: 1 1 2\nkey:=value\nendian: little\nencoding: " + encoding + "\n\n";
}

TEST(NrrdReader, TakesBytesAndTextInTheirOrder) {
    const Voxels voxels = read(head("unsigned char", "3 2 2", "raw") + std::string("\x00\x01\x02\xFF\x10\x11 abcdef", 12));
    EXPECT_EQ(voxels.columns, 3);
    EXPECT_EQ(voxels.rows, 2);
    EXPECT_EQ(voxels.slices, 2);
    EXPECT_EQ(voxels.components, 1);
    EXPECT_EQ(voxels.levels, 256);
    EXPECT_EQ(voxels.lowest, 0);
    EXPECT_EQ(voxels.values, (std::vector<double>{0, 1, 2, 255, 16, 17, 32, 97, 98, 99, 100, 101}));
    EXPECT_EQ(read(head("int16", "2 1 1", "ascii") + "-5 3000\n").values, (std::vector<double>{-5, 3000}));
    EXPECT_EQ(read(head("int16", "2 1 1", "ascii") + "-5 3000\n").lowest, -32768);
    EXPECT_EQ(read(head("float", "1 2 1", "text") + "1.5,\n-2e3").levels, 0);
}

TEST(NrrdReader, TakesEachTypeInBothOrders) {
    const auto big = [](std::string text) { return text.replace(text.find("little"), 6, "big"); };
    EXPECT_EQ(read(head("short", "1 1 2", "raw") + std::string("\xFE\xFF\x01\x02", 4)).values, (std::vector<double>{-2, 513}));
    EXPECT_EQ(read(big(head("short", "1 1 2", "raw")) + std::string("\xFF\xFE\x02\x01", 4)).values,
              (std::vector<double>{-2, 513}));
    EXPECT_EQ(read(head("uint", "1 1 1", "raw") + std::string("\xFF\xFF\xFF\xFF", 4)).values,
              (std::vector<double>{4294967295.0}));
    for (const double value : {0.0, -1.25, 6.5e20}) {
        std::string bytes(8, '\0');
        std::memcpy(bytes.data(), &value, 8);  // this machine is a little one, as is the file
        EXPECT_EQ(read(head("double", "1 1 1", "raw") + bytes).values, std::vector<double>{value});
    }
}

TEST(NrrdReader, TakesVectorsOfThree) {
    const Voxels voxels = read(head("float", "3 1 1 2", "ascii", 4) + "1 2 3 4 5 6");
    EXPECT_EQ(voxels.components, 3);
    EXPECT_EQ(voxels.columns, 1);
    EXPECT_EQ(voxels.slices, 2);
    EXPECT_EQ(voxels.values.size(), 6u);
}

TEST(NrrdReader, RefusesTextThatItsTypeCannotHold) {
    const auto fault = [](const std::string& type, const std::string& text) {
        return fault_of(head(type, "3 1 1", "ascii") + text);
    };
    EXPECT_EQ(fault("uchar", "0 7 255"), "");
    for (const std::string bad : {"300.5", "256", "-1", "0.5"}) {
        const std::string told = fault("uchar", "0 " + bad + " 255");
        EXPECT_NE(told.find("scene.nrrd: value 2 is " + bad + ", and type uchar is whole numbers from 0 to 255;"),
                  std::string::npos)
            << told;
    }
    EXPECT_EQ(fault("int8", "-128 0 127"), "");
    EXPECT_NE(fault("int8", "-129 0 0"), "");
    EXPECT_NE(fault("int8", "0 0 128"), "");
    EXPECT_EQ(fault("uint", "0 1 4294967295"), "");
    EXPECT_NE(fault("uint", "0 1 4294967296"), "");
    EXPECT_EQ(fault("float", "0.5 -1 300.5"), "");
}

TEST(NrrdReader, RefusesWhatItCannotBe) {
    const auto with = [](const std::string& part, const std::string& faults) {
        EXPECT_TRUE(faults.find(part) != std::string::npos) << faults;
    };
    with("it is cut short", fault_of(head("uchar", "3 2 2", "raw") + "abc"));
    with("it is cut short", fault_of(head("uchar", "3 2 2", "ascii") + "1 2 3"));
    with("its head is cut short", fault_of("NRRD0004\ntype: uchar"));
    with("million numbers are read", fault_of(head("uchar", "100000 100000 100000", "raw")));
    with("million numbers are read", fault_of(head("uchar", "0 1 1", "raw")));
    with("is no whole number", fault_of(head("uchar", "many 1 1", "raw")));
    with("not as many sizes", fault_of(head("uchar", "1 1", "raw")));
    with("no lattice", fault_of(head("uchar", "1 1", "raw", 2)));
    with("no lattice", fault_of(head("uchar", "2 1 1 1", "raw", 4) + "ab"));
    with("its type is \"block\"", fault_of(head("block", "1 1 1", "raw") + "a"));
    with("its encoding is \"bzip2\"", fault_of(head("uchar", "1 1 1", "bzip2") + "a"));
    with("not a number", fault_of(head("float", "1 1 1", "ascii") + "nan"));
    with("not a number", fault_of(head("float", "1 1 1", "raw") + std::string("\x00\x00\xC0\x7F", 4)));
    with("value 2, \"nan\", is not a number", fault_of(head("float", "2 1 1", "ascii") + "1 nan"));
    with("another file", fault_of("NRRD0004\ntype: uchar\ndata file: x.raw\n\n"));
    with("endian", fault_of("NRRD0004\ntype: short\ndimension: 3\nsizes: 1 1 1\nencoding: raw\n\nab"));
    const std::string whole = head("short", "2 2 2", "raw") + std::string(16, 'x');
    for (std::size_t size = 8; size < whole.size(); ++size) EXPECT_NE(fault_of(whole.substr(0, size)), "") << size;
    EXPECT_EQ(fault_of(whole), "");
}

}  // namespace
}  // namespace tactics::nrrd_test

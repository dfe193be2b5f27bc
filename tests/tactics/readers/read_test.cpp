// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/read.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/tactics/readers/pictures.h"

namespace tactics::read_test {
namespace {

class Files : public testing::Test {
protected:
    Files() {
        std::string name = (std::filesystem::temp_directory_path() / "tactics-read-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~Files() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const Bytes& bytes) const {
        const std::string path = folder_ + "/" + name;
        std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
        return path;
    }

    static std::string failure(const std::string& path) {
        try {
            Source source = open_source(path);
            read_picture(source, {});
            return "";
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::failed);
            return error.what();
        }
    }

    std::string folder_;
};

TEST_F(Files, TheNameDoesNotMatter) {
    const Image image = noise_picture(10, 8, 1);
    for (const char* name : {"picture.pdf", "picture", "picture.jpg", ".png", "ümlaut \n.txt"}) {
        Source source = open_source(write(name, png_of(image)));
        EXPECT_EQ(inspect_picture(source).format, "PNG");
        EXPECT_EQ(largest_difference(read_picture(source, {}), image), 0);
        EXPECT_EQ(inspect_picture(source).width, 10);
    }
}

TEST_F(Files, OpenImageIoReadsFilesAsWellAsMemory) {
    Bytes pgm = {'P', '5', '\n', '2', ' ', '1', '\n', '2', '5', '5', '\n', 7, 200};
    Source source = open_source(write("a.jpg", pgm));
    EXPECT_EQ(read_picture(source, {}).pixels, (std::vector<std::uint8_t>{7, 200}));
    EXPECT_EQ(read_picture(source, {}).pixels, (std::vector<std::uint8_t>{7, 200}));
}

TEST_F(Files, WhatCannotBeOpenedIsNamed) {
    EXPECT_EQ(failure(folder_ + "/no.jpg"), folder_ + "/no.jpg: there is no such file; see what is there with: ls " + folder_);
    EXPECT_EQ(failure(folder_), folder_ + ": is a folder; name the pictures in it");
    EXPECT_EQ(failure(write("empty.jpg", {})), folder_ + "/empty.jpg: is empty; get a complete copy of it");
    EXPECT_TRUE(has(failure("/dev/null"), "is a device, not a file"));
    if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
    const std::string locked = write("locked.jpg", {1});
    chmod(locked.c_str(), 0);
    EXPECT_TRUE(has(failure(locked), "may not be read"));
}

TEST_F(Files, APipeIsReadLikeAFile) {
    const Image image = noise_picture(100, 80, 3);
    const std::string path = folder_ + "/pipe";
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    std::thread writer([&] {
        const Bytes bytes = png_of(image);
        std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
    });
    Source source = open_source(path);
    writer.join();
    EXPECT_EQ(inspect_picture(source).width, 100);
    EXPECT_EQ(largest_difference(read_picture(source, {.longest = 0, .colour = true}), image), 0);
}

TEST_F(Files, StandardInputIsReadMoreThanOnce) {
    const Image image = noise_picture(30, 20, 1);
    const std::string path = write("input", png_of(image));
    ASSERT_NE(std::freopen(path.c_str(), "rb", stdin), nullptr);
    Source source = open_source("-");
    EXPECT_EQ(source.name, "standard input");
    EXPECT_EQ(inspect_picture(source).height, 20);
    EXPECT_EQ(largest_difference(read_picture(source, {}), image), 0);
    EXPECT_EQ(failure("-"), "standard input: is empty; get a complete copy of it");  // all of it was taken
    ASSERT_NE(std::freopen("/dev/null", "rb", stdin), nullptr);
}

TEST(Lookalikes, AreNamed) {
    const auto said = [](const std::string& text) { return complaint(Bytes(text.begin(), text.end())); };
    using namespace std::string_literals;
    const std::pair<std::string, const char*> cases[] = {
        {"%PDF-1.7\n%\xE2\xE3\xCF\xD3\n", "a PDF document"},
        {"\0\0%PDF-1.4"s, "a PDF document"},
        {"%!PS-Adobe-3.0\n", "a PostScript document"},
        {"<?xml version=\"1.0\"?>\n<!-- drawn -->\n<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "an SVG drawing"},
        {"\xEF\xBB\xBF  <!DOCTYPE HTML><html></html>", "an HTML page"},
        {"<?xml version=\"1.0\"?><feed/>", "an XML file"},
        {"PK\3\4....word/document.xml", "a Word document (docx)"},
        {"PK\3\4....ppt/slides", "a PowerPoint file (pptx)"},
        {"PK\3\4....xl/workbook.xml", "an Excel sheet (xlsx)"},
        {"PK\3\4....mimetypeapplication/vnd.oasis.opendocument.textPK", "an OpenDocument text (odt)"},
        {"PK\3\4....photo.jpg", "a ZIP archive"},
        {"\x1F\x8B\x08\0\0"s, "a gzip archive"},
        {"{\"a\": 1}", "JSON data"},
        {"year;rain\n2001;12\n", "a table of data (CSV)"},
        {"Dear all,\nhere is the picture\n", "a text file"},
        {" \n\t ", "a text file with nothing but blanks"},
        {"\0\0\0\x20"
         "ftypisom\0\0\2\0isom"s,
         "a video"},
        {"\x7F"
         "ELF\2\1\1\0"s,
         "a program"},
        {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "an old Word, Excel or PowerPoint file"},
    };
    for (const auto& [text, what] : cases) {
        EXPECT_TRUE(has(said(text), "test: looks like "s + what + ", not a picture; ")) << said(text);
    }
    for (const std::string& text : {"II*\0\x10\0\0\0CR\2\0"s, "\0\0\0\x0CjP  \r\n\x87\n"s, "\xFF\x0A rest"s, "gimp xcf v011"s})
        EXPECT_TRUE(has(said(text), ", which is not read; ")) << said(text);
    EXPECT_TRUE(has(said(std::string(5000, '\0')), "nothing but zero bytes"));
    EXPECT_TRUE(has(said("\x81\x82\x83\x01\x02 rubbish"), "is not a picture of a known kind"));
    EXPECT_TRUE(has(said(""), "is empty"));
    EXPECT_TRUE(has(said("\xFF\1"), "is not a picture"));
}

TEST(Readers, DescribeThemselves) {
    for (const Reader* reader : readers()) {
        EXPECT_FALSE(reader->name.empty());
        EXPECT_FALSE(reader->summary.empty());
        EXPECT_FALSE(reader->extensions.empty());
        EXPECT_FALSE(reader->recognises({}));
    }
    EXPECT_EQ(openimageio().name, "OpenImageIO");
}

TEST(Readers, AnswerGreyOrColourAsAsked) {
    const Image grey = noise_picture(12, 9, 1), colour = noise_picture(12, 9, 3);
    for (const auto& bytes : {jpeg_of(grey), png_of(grey), tiff_of(grey)}) EXPECT_EQ(read_bytes(bytes).channels, 1);
    for (const auto& bytes : {jpeg_of(colour), png_of(colour), tiff_of(colour)}) {
        EXPECT_EQ(read_bytes(bytes, {.longest = 5, .colour = true}).channels, 3);
        EXPECT_EQ(read_bytes(bytes, {.longest = 5, .colour = false}).channels, 1);
    }
}

TEST(Readers, ServeManyThreadsAtOnce) {
    const Image image = test_picture(60, 40, 3);
    const std::array files = {jpeg_of(image), png_of(image),
                              tiff_of(image, {.compression = COMPRESSION_JPEG, .rows_per_strip = 8})};
    std::array<int, 4> wrong{};
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < wrong.size(); ++t)
        threads.emplace_back([&, t] {
            for (std::size_t i = 0; i < 12; ++i) {
                const Bytes& whole = files[(i + t) % files.size()];
                wrong[t] += largest_difference(read_bytes(whole), image) > 20;
                Bytes hurt = whole;  // every thread hears of its own file's faults only
                std::fill(hurt.begin() + static_cast<long>(hurt.size() / 2), hurt.end(), 0xFF);
                wrong[t] += complaint(hurt).empty();
            }
        });
    for (auto& thread : threads) thread.join();
    for (const int count : wrong) EXPECT_EQ(count, 0);
}

TEST(Readers, ReadOnePixel) {
    const Image dot = noise_picture(1, 1, 3);
    for (const auto& bytes : {jpeg_of(dot), png_of(dot), tiff_of(dot)})
        for (const int longest : {0, 1, 1000})
            EXPECT_LE(largest_difference(read_bytes(bytes, {.longest = longest, .colour = true}), dot), 4);
}

}  // namespace
}  // namespace tactics::read_test

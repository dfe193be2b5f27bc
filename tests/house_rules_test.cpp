// SPDX-License-Identifier: Apache-2.0
// The rules of the house (CONTRIBUTING.md), checked by reading the tree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/patterns.h"
#include "tests/tree.h"

namespace tactics::house_rules_test {
namespace {

using namespace tests;

TEST(HouseRules, TheTreeIsRead) {
    ASSERT_GT(tree().size(), 30u);
    EXPECT_TRUE(std::any_of(tree().begin(), tree().end(), [](const SourceFile& f) { return f.path == "tactics/image.h"; }));
}

// The folders are rooms, told from the ground up: a room sees itself and, of the rooms told before it, those that are named. So
// there is no circle between rooms.
TEST(HouseRules, FoldersIncludeOnlyWhatTheyMay) {
    struct Room {
        std::string_view folder;
        std::vector<std::string_view> sees;
    };
    const std::vector<Room> rooms = {
        {"tactics/text/", {}},
        {"tactics/", {"tactics/text/"}},
        {"tactics/geometry/", {"tactics/text/", "tactics/"}},
        {"tactics/coding/", {"tactics/text/", "tactics/"}},
        {"tactics/transport/", {"tactics/text/", "tactics/"}},
        {"tactics/braille/", {"tactics/text/", "tactics/", "tactics/transport/"}},
        {"tactics/layout/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/braille/"}},
        {"tactics/description/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/layout/"}},
        {"tactics/readers/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/coding/", "tactics/transport/"}},
        {"tactics/relief/", {"tactics/text/", "tactics/", "tactics/readers/", "tactics/coding/"}},
        {"tactics/readers/svg/",
         {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/layout/", "tactics/transport/", "tactics/readers/"}},
        {"tactics/solid/", {"tactics/text/", "tactics/", "tactics/geometry/"}},
        {"tactics/rules/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/layout/"}},
        {"tactics/repair/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/rules/"}},
        {"tactics/lettering/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/transport/"}},
        {"tactics/measure/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/readers/"}},
        {"tactics/haptics/",
         {"tactics/text/", "tactics/", "tactics/transport/", "tactics/readers/", "tactics/coding/", "tactics/relief/",
          "tactics/measure/"}},
        {"filters/net/", {"tactics/", "tactics/transport/", "tactics/readers/"}},
        {"filters/", {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/layout/", "tactics/readers/", "filters/net/"}},
        {"print/machines/", {"tactics/text/", "tactics/", "tactics/readers/"}},  // what an encoder does is none of theirs
        {"print/",
         {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/braille/", "tactics/layout/", "tactics/description/",
          "tactics/transport/", "tactics/readers/", "tactics/coding/", "tactics/relief/", "print/machines/"}},
        {"tactics/information/",
         {"tactics/text/", "tactics/", "tactics/coding/", "tactics/relief/", "tactics/measure/", "tactics/haptics/", "print/"}},
        {"tactics/job/",
         {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/braille/", "tactics/layout/", "tactics/transport/",
          "tactics/readers/", "tactics/readers/svg/", "tactics/relief/", "tactics/rules/", "tactics/repair/",
          "tactics/lettering/", "tactics/solid/", "filters/", "print/", "tactics/information/"}},
        {"studies/",
         {"tactics/text/", "tactics/", "tactics/geometry/", "tactics/layout/", "tactics/readers/", "tactics/rules/",
          "tactics/measure/", "filters/", "print/", "tactics/job/"}},
        {"cli/report/", {"tactics/text/", "tactics/", "tactics/transport/", "tactics/job/"}},
        {"cli/",
         {"tactics/text/", "tactics/", "tactics/braille/", "tactics/layout/", "tactics/readers/", "tactics/transport/",
          "tactics/solid/", "filters/", "print/", "tactics/job/", "cli/report/"}},
        {"cli/help/",
         {"tactics/text/", "tactics/", "tactics/braille/", "tactics/transport/", "tactics/readers/", "tactics/rules/",
          "tactics/haptics/", "tactics/solid/", "filters/", "print/", "tactics/job/", "cli/report/", "cli/"}},
        {"cli/verbs/",
         {"tactics/text/",
          "tactics/",
          "tactics/geometry/",
          "tactics/coding/",
          "tactics/braille/",
          "tactics/layout/",
          "tactics/description/",
          "tactics/transport/",
          "tactics/readers/",
          "tactics/relief/",
          "tactics/readers/svg/",
          "tactics/rules/",
          "tactics/haptics/",
          "filters/",
          "print/",
          "tactics/information/",
          "tactics/job/",
          "studies/",
          "cli/report/",
          "cli/",
          "cli/help/"}},
        {"cli/printer_app/",
         {"tactics/text/", "tactics/", "tactics/transport/", "tactics/readers/", "print/", "tactics/job/", "cli/report/", "cli/",
          "cli/verbs/"}},
        {"tactics/c/", {"tactics/", "tactics/readers/", "tactics/job/", "cli/", "cli/report/"}},
        {"samples/draw/", {"tactics/"}},
        {"samples/", {"tactics/job/"}},
    };
    // The innermost: that with the longest name.
    const auto room_of = [&](std::string_view path) {
        const Room* found = nullptr;
        for (const Room& room : rooms)
            if (path.starts_with(room.folder) && (found == nullptr || room.folder.size() > found->folder.size())) found = &room;
        return found;
    };
    for (const Room& room : rooms)
        for (const auto sees : room.sees) {
            const auto seen = std::find_if(rooms.begin(), rooms.end(), [&](const Room& other) { return other.folder == sees; });
            ASSERT_NE(seen, rooms.end()) << room.folder << " sees " << sees << ", which is no room";
            EXPECT_LT(&*seen, &room) << room.folder << " sees " << sees << ", which is told after it";
        }
    for (const SourceFile& file : tree()) {
        if (!is_source(file)) continue;
        const bool test = file.path.starts_with("tests/");  // sees everything
        const Room* room = room_of(file.path);
        ASSERT_TRUE(test || room != nullptr) << file.path << " is in no room of the house";
        for (const auto& included : includes_of(file, '"')) {
            const Room* from = room_of(included);
            EXPECT_TRUE(test || from == room ||
                        (from != nullptr && std::find(room->sees.begin(), room->sees.end(), from->folder) != room->sees.end()))
                << file.path << " must not include \"" << included << "\"";
            EXPECT_TRUE(fs::exists(fs::path(TACTICS_SOURCE_DIR) / included))
                << file.path << ": \"" << included << "\" is not written from the top of the tree";
        }
    }
}

// A module is a header with its source of the same name. A list and one of its entries may know each other; more that do are one
// thing in several files, which none of them can be understood without.
TEST(HouseRules, ModulesFormNoCircle) {
    const auto module_of = [](const std::string& path) { return path.substr(0, path.rfind('.')); };
    std::map<std::string, std::set<std::string>> sees;
    for (const SourceFile& file : tree())
        if (is_source(file) && !file.path.starts_with("tests/"))
            for (const auto& included : includes_of(file, '"'))
                if (included.ends_with(".h") && module_of(included) != module_of(file.path))
                    sees[module_of(file.path)].insert(module_of(included));
    const auto reached_from = [&](const std::string& module) {
        std::set<std::string> reached;
        for (std::vector<std::string> next = {module}; !next.empty();) {
            const std::string at = next.back();
            next.pop_back();
            for (const auto& seen : sees[at])
                if (reached.insert(seen).second) next.push_back(seen);
        }
        return reached;
    };
    std::map<std::string, std::set<std::string>> reached;
    for (const auto& [module, seen] : std::map(sees)) reached[module] = reached_from(module);
    for (const auto& one : reached) {
        const auto in_circle = std::count_if(one.second.begin(), one.second.end(),
                                             [&](const auto& other) { return reached[other].contains(one.first); });
        EXPECT_LE(in_circle, 2) << one.first << " is one of a circle of " << in_circle;
    }
}

TEST(HouseRules, TheNounsAreFew) {
    int files = 0;
    for (const SourceFile& file : tree())
        files += is_source(file) && file.path.starts_with("tactics/") && file.path.find('/', 8) == std::string::npos;
    EXPECT_LT(files, 32) << "tactics/ keeps the nouns; what is about one of them has a room";
}

// A foreign library comes in by one door, so that it can be replaced and so that no start of the program pays for it twice.
TEST(HouseRules, ForeignHeadersComeInByTheirDoors) {
    struct Door {
        std::string_view header;
        std::vector<std::string_view> files;
    };
    const std::vector<Door> doors = {
        {"png.h", {"tactics/readers/", "tactics/relief/", "samples/draw/files.cpp"}},
        {"jpeglib.h", {"tactics/readers/", "samples/draw/files.cpp"}},
        {"jerror.h", {"tactics/readers/", "samples/draw/files.cpp"}},
        {"tiff", {"tactics/readers/", "tactics/relief/", "print/fax.cpp"}},
        {"zlib.h", {"print/", "tactics/readers/gzip.cpp"}},
        {"ft2build.h", {"print/letters.cpp"}},
        {"fontconfig/", {"print/letters.cpp"}},
        {"OpenImageIO/", {"tactics/readers/caged/"}},
        {"assimp/", {"tactics/readers/caged/assimp.cpp"}},
        {"libheif/", {"tactics/readers/caged/heif.cpp"}},
        {"liblouis/", {"tactics/braille/louis.cpp"}},
        {"opencv2/", {"filters/opencv.h", "filters/opencv.cpp"}},
        {"expat.h", {"tactics/readers/xml.cpp"}},
        {"rapidjson/", {"tactics/readers/json_cells.cpp", "tactics/haptics/devices/inverse3_messages.cpp"}},
        {"brlapi.h", {"tactics/transport/brlapi.cpp"}},
        {"libusb.h", {"tactics/transport/usb.cpp"}},
        {"hidapi.h", {"tactics/transport/hid.cpp"}},
        {"libevdev/", {"tactics/transport/evdev.cpp"}},
        {"pappl/", {"cli/printer_app/"}},
        {"boost/", {"tactics/transport/web_socket.cpp"}},
    };
    // Of the system, without a library to link.
    const std::vector<std::string_view> system = {"unistd.h",    "spawn.h",     "pthread.h", "stddef.h", "fcntl.h", "malloc.h",
                                                  "netdb.h",     "dlfcn.h",     "poll.h",    "sched.h",  "time.h",  "signal.h",
                                                  "grp.h",       "pwd.h",       "termios.h", "errno.h",  "linux/",  "sys/",
                                                  "emmintrin.h", "immintrin.h", "arm_neon.h"};
    for (const SourceFile& file : tree()) {
        if (!is_source(file) || file.path.starts_with("tests/")) continue;
        for (const auto& included : includes_of(file, '<')) {
            if (!whole_fit(included, "[a-z0-9_]+").empty() || starts_with_any(included, system)) continue;
            const auto door =
                std::find_if(doors.begin(), doors.end(), [&](const Door& d) { return included.starts_with(d.header); });
            ASSERT_NE(door, doors.end()) << file.path << " includes <" << included
                                         << ">, which has no door; name it in this test and in CONTRIBUTING.md";
            EXPECT_TRUE(starts_with_any(file.path, door->files)) << file.path << " must not include <" << included << ">";
        }
        for (const auto& included : includes_of(file, '"')) {
            if (included == "filters/opencv.h") {
                EXPECT_TRUE(file.path.starts_with("filters/") && file.path.ends_with(".cpp"))
                    << file.path << " must not show OpenCV to others";
            }
        }
    }
}

// Two types of one name are one type to the linker, whatever they hold. Tests have a namespace of their own.
TEST(HouseRules, ATypeOfAHeaderHasItsNameForItself) {
    std::map<std::string, std::string> homes;
    for (const SourceFile& file : tree()) {
        if (!file.path.ends_with(".h") || file.path.starts_with("samples/")) continue;
        const std::string space = file.path.starts_with("tests/") ? "tests::" : "";
        for (const Fit& type : all_fits(file.text, R"(^(?:struct|class|enum class) ([A-Z][A-Za-z]+)(?: :[^;{]*| final)? \{)")) {
            const auto [known, fresh] = homes.try_emplace(space + type[1], file.path);
            EXPECT_TRUE(fresh) << type[1] << " is in " << known->second << " and in " << file.path;
        }
    }
    EXPECT_GT(homes.size(), 50u);
}

TEST(HouseRules, FilesAreShort) {
    constexpr auto kMostLines = 410;
    for (const SourceFile& file : tree())
        if (is_source(file)) {
            EXPECT_LE(std::count(file.text.begin(), file.text.end(), '\n'), kMostLines)
                << file.path << " is too long; cut it in two";
        }
}

// In the layout that clang-format gives, a brace alone ends what begins in the last line before it that is as far to the left:
// a function, or of a class one of its own. Lists of entries end with a semicolon.
TEST(HouseRules, FunctionsAreShort) {
    constexpr std::size_t kMost = 60;  // lines
    std::size_t seen = 0;
    for (const SourceFile& file : tree()) {
        if (!is_source(file) || file.path.starts_with("tests/")) continue;
        std::map<std::size_t, std::size_t> begun;  // by how far to the left: the last line
        std::istringstream text(file.text);
        std::string line;
        for (std::size_t number = 1; std::getline(text, line); ++number) {
            const std::size_t indent = line.find_first_not_of(' ');
            if (indent == std::string::npos || line[indent] == '#') continue;
            if (indent <= 4 && line.substr(indent) == "}" && begun.contains(indent)) {
                ++seen;
                EXPECT_LE(number - begun[indent] + 1, kMost) << file.path << ":" << begun[indent] << ": split this function";
            }
            begun[indent] = number;
        }
    }
    EXPECT_GT(seen, 2000u);
}

TEST(HouseRules, NamesSayWhatIsInside) {
    const std::set<std::string> empty_words = {"util", "utils", "common", "misc", "helper", "helpers", "manager"};
    for (const SourceFile& file : tree()) {
        std::string word;
        for (const char c : file.path + "/") {
            if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
                word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
                continue;
            }
            EXPECT_FALSE(empty_words.contains(word)) << file.path << ": \"" << word << "\" says nothing";
            word.clear();
        }
    }
}

// FILTER(kmeans) -> kmeans; SCENE(draw_map, "map", ...) and MEDIUM("swell", ...) -> the word in quotes.
std::vector<std::string> entries_of(const SourceFile& list) {
    std::vector<std::string> names;
    for (const Fit& entry : all_fits(list.text, R"re(^[A-Z]+\((?:([a-z0-9_]+)\)|(?:[a-z0-9_]+, )?"([^"]+)"))re"))
        names.push_back(!entry[1].empty() ? entry[1] : entry[2]);
    return names;
}

bool has_word(std::string_view text, std::string_view word) {
    const auto is_part = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const bool left = at > 0 && is_part(text[at - 1]),
                   right = at + word.size() < text.size() && is_part(text[at + word.size()]);
        if (!left && !right) return true;
    }
    return false;
}

// The tests that read the lists cover every entry; this one asks for a test that knows the entry by its name.
TEST(HouseRules, EveryEntryOfAListIsTestedByName) {
    std::string tests;
    for (const SourceFile& file : tree())
        if ((file.path.starts_with("tests/") && file.path.ends_with("_test.cpp")) || file.path == "tests/rules/rule_pages.cpp")
            tests += file.path + "\n" + file.text;
    std::transform(tests.begin(), tests.end(), tests.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    int entries = 0;
    for (const SourceFile& list : tree()) {
        if (!list.path.ends_with(".inc") || list.path.starts_with("samples/") || list.path.starts_with("tests/")) continue;
        for (const auto& name : entries_of(list)) {
            std::string dashed = name;
            std::replace(dashed.begin(), dashed.end(), '_', '-');
            EXPECT_TRUE(has_word(tests, name) || has_word(tests, dashed)) << list.path << ": no test knows " << name;
            ++entries;
        }
    }
    EXPECT_GT(entries, 10);
}

TEST(HouseRules, EveryFilterAndSampleHasItsGoldenImage) {
    std::set<std::string> golden;
    for (const SourceFile& file : tree())
        if (file.path.starts_with("tests/golden/")) golden.insert(file.path);
    for (const SourceFile& list : tree()) {
        const bool filters = list.path == "filters/list.inc", samples = list.path == "samples/draw/list.inc";
        if (!filters && !samples) continue;
        for (auto name : entries_of(list)) {
            std::replace(name.begin(), name.end(), '_', '-');
            EXPECT_TRUE(golden.contains((filters ? "tests/golden/filters/" : "tests/golden/samples/") + name + ".png"))
                << list.path << ": no golden image of " << name;
        }
    }
    for (const auto& path : golden) {
        if (!path.ends_with(".png")) continue;
        EXPECT_LE(fs::file_size(fs::path(TACTICS_SOURCE_DIR) / path), 40'000u) << path << " is too large for a golden image";
    }
}

// Paths of the machine that a file was written on mean nothing elsewhere.
// The library names wishes (tactics/error.h, spelled); only the command line knows that its users write them as options.
TEST(HouseRules, NoMessageOfTheLibraryNamesAnOption) {
    const std::string option = R"x("([^"\\]|\\.)*--[a-z]([^"\\]|\\.)*")x";
    for (const SourceFile& file : tree()) {
        if (!is_source(file) || !starts_with_any(file.path, {"tactics/", "filters/", "print/"})) continue;
        if (file.path == "tactics/lettering/tesseract.cpp") continue;  // options of another program
        std::istringstream lines(file.text);
        for (std::string line; std::getline(lines, line);) {
            const std::string code = line.substr(0, line.find("//"));
            if (code.find("static_assert") != std::string::npos) continue;
            EXPECT_TRUE(first_fit(code, option).empty()) << file.path << ": " << line;
        }
    }
}

TEST(HouseRules, NoPathOfABuildMachine) {
    // Written in two parts, or this file would break its own rule.
    const std::vector<std::string> machine = {std::string("/ho") + "me/", std::string("/ro") + "ot/", std::string("/Us") + "ers/",
                                              std::string("/wo") + "rk/", std::string("/tm") + "p/"};
    for (const SourceFile& file : tree())
        for (const auto& path : machine)
            EXPECT_EQ(file.text.find(path), std::string::npos) << file.path << " names a path below " << path;
}

// Where a comment can stand, the licence stands in the first line, or below the line that names an interpreter.
TEST(HouseRules, FilesTellTheirLicence) {
    const std::string licence = std::string("SPDX-License-") + "Identifier: Apache-2.0\n";
    for (const SourceFile& file : tree()) {
        const bool script = file.text.starts_with("#!") || file.path.ends_with(".py") || file.path.ends_with("CMakeLists.txt");
        if (!is_source(file) && !script) continue;
        const std::size_t first = file.text.starts_with("#!") ? file.text.find('\n') + 1 : 0;
        EXPECT_EQ(file.text.find((script ? "# " : "// ") + licence, first), first) << file.path;
    }
}

TEST(HouseRules, HeadersSayWhatTheyAreFor) {
    for (const SourceFile& file : tree()) {
        if (!file.path.ends_with(".h")) continue;
        EXPECT_EQ(file.text.find("// ", 3), file.text.find('\n') + 1) << file.path << " has no comment that says what it is for";
        EXPECT_NE(file.text.find("#pragma once"), std::string::npos) << file.path;
    }
}

TEST(HouseRules, TextIsPlain) {
    for (const SourceFile& file : tree()) {
        if (!is_source(file)) continue;
        EXPECT_EQ(file.text.find('\t'), std::string::npos) << file.path << " has a tab";
        EXPECT_EQ(file.text.find('\r'), std::string::npos) << file.path << " has a carriage return";
        EXPECT_EQ(file.text.find("\n<<<<<<< "), std::string::npos) << file.path << " was left in the middle of a merge";
        EXPECT_EQ(file.text.find(" \n"), std::string::npos) << file.path << " has blanks at the end of a line";
        EXPECT_TRUE(file.text.ends_with("\n")) << file.path << " does not end its last line";
    }
}

}  // namespace
}  // namespace tactics::house_rules_test

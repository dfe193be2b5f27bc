// SPDX-License-Identifier: Apache-2.0
// How much `tactics convert` tells: from nothing but errors to everything, each a part of the next; and --strict.
#include <algorithm>
#include <set>
#include <sstream>

#include "tactics/rules/rule.h"
#include "tests/cli/converting.h"

namespace tactics::how_much_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

std::set<std::string> lines_of(const std::string& text) {
    std::set<std::string> lines;
    std::istringstream all(text);
    for (std::string line; std::getline(all, line);) lines.insert(line);
    return lines;
}

// Times differ from run to run.
std::set<std::string> without_times(const std::string& text) {
    std::set<std::string> lines;
    for (const std::string& line : lines_of(text)) lines.insert(line.ends_with(" s") ? line.substr(0, line.rfind("; ")) : line);
    return lines;
}

class HowMuchIsTold : public Convert {
protected:
    HowMuchIsTold() {
        write_bytes(folder / "dot.tif", grey_picture(1, 1, [](int, int) { return 128; }));
        write_bytes(folder / "bad.tif", "no picture\n");
        write_bytes(
            folder / "figure.svg",
            "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='80mm' viewBox='0 0 100 80'><path d='M10 10 H90 V70' "
            "stroke='black' fill='none'/><text x='30' y='500'>Rain</text></svg>");
    }
    Ending batch(Words words) {
        words.insert(words.begin(),
                     {"disc.tif", "dot.tif", "figure.svg", "bad.tif", "-o", "pages/", "-j", "1", "--progress", "none"});
        return convert(words);
    }
};

TEST_F(HowMuchIsTold, EachSaysMoreThanTheOneBefore) {
    const Ending quiet = batch({"-q"}), warnings = batch({"--warnings"}), usual = batch({}), all = batch({"-v"});
    for (const Ending* one : {&quiet, &warnings, &usual, &all}) EXPECT_EQ(one->code, 2);
    EXPECT_TRUE(holds(quiet.err, "tactics: bad.tif: ") && !holds(quiet.err, "dot.tif") && !holds(quiet.err, "figure.svg"))
        << quiet.err;
    // What must be acted on, a line each, and nothing else.
    const std::string told = warnings.err;
    EXPECT_EQ(lines_in(told), 3u) << told;
    EXPECT_TRUE(holds(told, "dot.tif: nothing was drawn: ") &&
                holds(told, "figure.svg: the words \"Rain\" are left out: they lie outside of the drawing\n") &&
                holds(told, "tactics: bad.tif: "))
        << told;
    const auto behind_its_name = [](const std::string& line) { return line.substr(line.find(": ") + 2); };
    for (const std::string& line : lines_of(told)) EXPECT_TRUE(holds(usual.err, behind_its_name(line))) << line;
    // A line for each picture, and the three lines of the end.
    EXPECT_EQ(lines_in(usual.err), 4u + 3u) << usual.err;
    EXPECT_TRUE(holds(usual.err, " s; the words \"Rain\" are left out: they lie outside of the drawing\n")) << usual.err;
    EXPECT_FALSE(holds(usual.err, "change with --recipe")) << usual.err;
    EXPECT_TRUE(holds(usual.err, "3 of 4 pictures done, 3 files written")) << usual.err;
    const auto most = without_times(all.err);
    for (const std::string& line : without_times(usual.err))
        EXPECT_TRUE(holds(line, " pictures done, ") ||
                    std::any_of(most.begin(), most.end(), [&](const std::string& one) { return line.starts_with(one); }))
            << line << "\n"
            << all.err;
    EXPECT_TRUE(holds(all.err, "disc.tif: recipe ") && holds(all.err, "; change with --recipe\n")) << all.err;
}

TEST_F(HowMuchIsTold, OfOnePictureEverythingIsTold) {
    EXPECT_TRUE(holds(convert({"disc.tif", "-o", "a.svg"}).err, "; change with --recipe\n"));
    EXPECT_EQ(convert({"disc.tif", "-o", "a.svg", "--warnings"}).err, "");
    EXPECT_EQ(convert({"disc.tif", "-o", "a.svg", "-q", "-v"}).code, 1);
    EXPECT_EQ(convert({"disc.tif", "-o", "a.svg", "--warnings", "-v"}).err,
              "tactics: --verbose: give this or --warnings, not both\n");
    // Notes of both kinds: settings that do nothing are to be known, words that are left out to be acted on.
    const Ending one = convert({"figure.svg", "-o", "a.svg", "-r", "photo"});
    EXPECT_TRUE(holds(one.err, "do nothing to it") && holds(one.err, "the words \"Rain\" are left out")) << one.err;
    EXPECT_EQ(convert({"figure.svg", "-o", "a.svg", "-r", "photo", "--warnings"}).err,
              "figure.svg: the words \"Rain\" are left out: they lie outside of the drawing\n");
    const std::string json = convert({"figure.svg", "-o", "a.svg", "-r", "photo", "--json"}).out;
    EXPECT_TRUE(holds(json, "\"warnings\":[\"the words \\\"Rain\\\" are left out: they lie outside of the drawing\"]")) << json;
}

// A page is strict where check finds it so.
TEST_F(HowMuchIsTold, StrictIsAsCheckIs) {
    write_bytes(folder / "near.tif",
                grey_picture(200, 200, [](int x, int y) { return x > 20 && x < 180 && y % 4 == 2 ? 0 : 255; }));
    int broken = 0;
    // What the page was made for and its margins are as it tells them.
    const std::vector<Words> ways{{},
                                  {"--as-drawn"},
                                  {"--medium", "embosser"},
                                  {"--medium", "thermoform", "--as-drawn"},
                                  {"--embosser", "index-v4"},
                                  {"--margin", "2mm"}};
    for (const std::string picture : {"disc.tif", "near.tif", "figure.svg", "dot.tif"})
        for (const Words& way : ways) {
            Words words{picture, "-f", "threshold", "-f", "trace shortest=0", "-o", "page.svg", "--strict", "--title", "A"};
            words.insert(words.end(), way.begin(), way.end());
            fs::remove(folder / "page.svg");
            const Ending made = convert(words);
            const Ending checked = run_tactics(folder, {"check", "page.svg", "--strict"});
            EXPECT_EQ(made.code, checked.code) << picture << made.err << checked.out;
            EXPECT_EQ(holds(made.err, picture + ": hard rules are broken on page.svg: "), made.code == 3) << made.err;
            EXPECT_TRUE(fs::exists(folder / "page.svg"));
            broken += made.code == 3 ? 1 : 0;
        }
    EXPECT_GE(broken, 1);
    const Words near{"near.tif", "disc.tif", "-f", "threshold", "-f", "trace shortest=0", "--as-drawn", "-o", "pages/"};
    Words strict = near, failing = near;
    strict.insert(strict.end(), {"--strict", "--warnings"});
    failing.insert(failing.end(), {"--strict", "bad.tif"});
    EXPECT_EQ(convert(near).code, 0);
    const Ending told = convert(strict);
    EXPECT_EQ(told.code, 3);
    EXPECT_TRUE(holds(told.err, "near.tif: hard rules are broken on pages/near.pdf: ") && holds(told.err, "gap at ")) << told.err;
    EXPECT_EQ(convert(failing).code, 2);
    strict.back() = "--json";
    EXPECT_TRUE(holds(convert(strict).out, "\"broken_rules\":[{\"rule\":\"")) << convert(strict).out;
}

// Each rule that a page breaks, also one that it only should keep, is said; with as many places as check finds on the file.
TEST_F(HowMuchIsTold, NoRuleIsBrokenWithoutSayingSo) {
    write_bytes(folder / "cross.svg",
                "<svg xmlns='http://www.w3.org/2000/svg' width='120mm' height='90mm' viewBox='0 0 120 90'><path fill='none' "
                "stroke='black' d='M10 10L110 80M10 80L110 10M20 45L24 45'/></svg>");
    std::size_t broken = 0;
    for (const char* picture : {"cross.svg", "disc.tif"}) {
        const Ending made = convert({picture, "--as-drawn", "-o", "page.svg"});
        const Ending checked = run_tactics(folder, {"check", "page.svg", "--json"});
        const std::string told = convert({picture, "--as-drawn", "--json", "-o", "page.svg"}).out;
        for (const Rule* rule : rules()) {
            const auto at = checked.out.find("{\"rule\":\"" + std::string(rule->name) + "\"");
            const auto next = checked.out.find("{\"rule\":\"", at == std::string::npos ? at : at + 1);
            const bool breaks =
                at != std::string::npos && checked.out.substr(at, next - at).find("\"message\"") != std::string::npos;
            EXPECT_EQ(holds(made.err, " " + std::string(rule->name) + " at "), breaks) << picture << rule->name << made.err;
            EXPECT_EQ(holds(told, "{\"rule\":\"" + std::string(rule->name) + "\",\"hard\":" + (rule->hard ? "true" : "false")),
                      breaks)
                << picture << rule->name << told;
            broken += breaks ? 1 : 0;
        }
    }
    EXPECT_GE(broken, 1u);
    const std::string lines = convert({"cross.svg", "disc.tif", "--as-drawn", "-o", "pages/"}).err;
    EXPECT_TRUE(holds(lines, "; 2 places break rules that are not hard")) << lines;
}

}  // namespace
}  // namespace tactics::how_much_test

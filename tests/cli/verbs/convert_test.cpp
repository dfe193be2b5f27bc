// SPDX-License-Identifier: Apache-2.0
// `tactics convert` as the user meets it: the real program, real files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/cli/converting.h"
#include "tests/filters/weights.h"
#include "tests/sanitized.h"

namespace tactics::convert_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;
TEST_F(Convert, WritesAPageAndSaysSo) {
    const Ending ending = convert({"disc.tif", "-o", "disc.svg"});
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(ending.out, "");
    ASSERT_EQ(lines_in(ending.err), 2u) << ending.err;
    EXPECT_TRUE(ending.err.starts_with("disc.tif: recipe diagram (drawn: ")) << ending.err;
    EXPECT_TRUE(holds(ending.err, "; change with --recipe\ndisc.tif: disc.svg: ")) << ending.err;
    EXPECT_EQ(names(), "disc.svg disc.tif");
    EXPECT_EQ(convert({"disc.tif", "-o", "disc.svg", "--quiet"}).err, "");
}

TEST_F(Convert, WhoNamesASubjectGetsOutlines) {
    SKIP_WITHOUT_WEIGHTS();
    const Ending ending = convert({"disc.tif", "--subject", "50%,50%", "-o", "disc.svg"});
    EXPECT_EQ(ending.code, 0);
    EXPECT_TRUE(ending.err.starts_with(
        "disc.tif: recipe photo (what matters in it is named); change with --recipe\ndisc.tif: subject: found"))
        << ending.err;
    EXPECT_EQ(convert({"disc.tif", "--subject", "50%,50%", "-r", "diagram", "-o", "disc.svg"}).code, 1);
}

TEST_F(Convert, BytesDependOnNothingElse) {
    const Ending all = convert({"disc.tif", "-q", "-o", "all.svg", "-o", "all.pdf", "-o", "all.brf", "-o", "pdf:-"});
    ASSERT_EQ(all.out, bytes_of(folder / "all.pdf"));
    for (const std::string ending : {"svg", "pdf", "brf"}) {
        ASSERT_EQ(convert({"disc.tif", "-q", "-o", "one." + ending}).code, 0);
        EXPECT_EQ(bytes_of(folder / ("one." + ending)), bytes_of(folder / ("all." + ending))) << ending;
        EXPECT_NE(bytes_of(folder / ("one." + ending)), "");
    }
    EXPECT_EQ(convert({"-", "-q", "-o", "pdf:-"}, bytes_of(folder / "disc.tif")).out, bytes_of(folder / "all.pdf"));
    // Another locale, another number of workers.
    EXPECT_EQ(
        run_tool(folder, {"env", "LC_ALL=de_DE.UTF-8", TACTICS_PROGRAM, "convert", "disc.tif", "-q", "-o", "pdf:-", "-j", "7"})
            .out,
        bytes_of(folder / "all.pdf"));
}

TEST_F(Convert, ALongSearchPathForBrailleTablesIsRefused) {
    const auto with = [&](std::size_t bytes) {
        return run_tool(folder, {"env", "LOUIS_TABLEPATH=/" + std::string(bytes - 1, 'x'), TACTICS_PROGRAM, "convert", "disc.tif",
                                 "-q", "--title", "A disc", "-o", "disc.pdf"});
    };
    EXPECT_EQ(with(1500).code, 0);
    for (const std::size_t bytes : {1501u, 2100u, 100'000u}) {
        const Ending refused = with(bytes);
        EXPECT_EQ(refused.code, 1);
        EXPECT_TRUE(holds(refused.err, "LOUIS_TABLEPATH: is longer than liblouis bears")) << refused.err;
    }
}

// The limit ends a run that would not end on its own.
TEST_F(Convert, WhatTheSurroundingsNameIsNotReadWithoutEnd) {
    const auto with = [&](const std::string& setting, const std::string& table) {
        return run_tool(folder, {"prlimit", "--cpu=20", "env", setting, TACTICS_PROGRAM, "convert", "disc.tif", "-q", "--title",
                                 "A disc", "--braille", table, "-o", "disc.pdf"});
    };
    if (!has_tool("prlimit")) GTEST_SKIP() << "prlimit is missing (package util-linux)";
    const Ending fonts = with("FONTCONFIG_FILE=/dev/full", "none");
    EXPECT_EQ(fonts.code, 2);
    EXPECT_TRUE(holds(fonts.err, "FONTCONFIG_FILE: is a device, not a file of fontconfig")) << fonts.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "disc.pdf"));
    EXPECT_EQ(with("FONTCONFIG_FILE=/dev/null", "none").code, 0);
    // A table that is not there is looked for by names alone.
    ASSERT_EQ(symlink("/dev/full", (folder / "endless.ctb").c_str()), 0);
    const Ending tables = with("LOUIS_TABLEPATH=" + folder.path().string(), "en-ueb-g2.cbt");
    EXPECT_EQ(tables.code, 1);
    EXPECT_TRUE(holds(tables.err, "there is no braille table \"en-ueb-g2.cbt\" (en-ueb-g2.ctb?)")) << tables.err;
}

TEST_F(Convert, TightLimitsAreTold) {
    if (!has_tool("prlimit")) GTEST_SKIP() << "prlimit is missing (package util-linux)";
    const auto within = [&](const std::string& limit, Words words) {
        words.insert(words.begin(), {"prlimit", limit, TACTICS_PROGRAM, "convert", "disc.tif", "-q", "-o", "disc.pdf"});
        return run_tool(folder, words);
    };
    // The words for a table of one's own lie in a file in memory.
    write_bytes(folder / "own.ctb", "include en-ueb-g1.ctb\n");
    const Words title{"--title", std::string(4000, 'a'), "--braille", "./own.ctb"};
    for (const bool of_files : {false, true}) {
        // UBSan looks at memory through a pipe, which takes two more files.
        if (of_files && TACTICS_SANITIZED) break;
        const Ending ending = of_files ? within("--nofile=4", {}) : within("--fsize=2000", title);
        EXPECT_EQ(ending.code, 2) << ending.err;
        EXPECT_EQ(ending.err.find("tactics: "), 0u) << ending.err;
        EXPECT_FALSE(holds(ending.err, "should not happen")) << ending.err;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "disc.pdf"));
}

TEST_F(Convert, ASavedRecipeGivesTheSameBytes) {
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "a.svg", "--save-recipe", "auto.recipe"}).code, 0);
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "b.svg", "--recipe", "auto.recipe", "--save-recipe", "again.recipe"}).code, 0);
    EXPECT_EQ(bytes_of(folder / "a.svg"), bytes_of(folder / "b.svg"));
    EXPECT_EQ(bytes_of(folder / "auto.recipe"), bytes_of(folder / "again.recipe"));
    // One's own recipe with its comments is not written over.
    EXPECT_EQ(convert({"disc.tif", "-o", "b.svg", "--recipe", "auto.recipe", "--save-recipe", "./auto.recipe"}).code, 1);
}

TEST_F(Convert, BatchGoesOnAfterABadFile) {
    for (int i = 0; i < 8; ++i) write_bytes(folder / ("d" + std::to_string(i) + ".tif"), disc_picture(60 + i * 10, 60));
    write_bytes(folder / "bad.tif", "no picture\n");
    Words words{"d0.tif", "bad.tif", "d1.tif", "d2.tif", "missing.tif", "d3.tif",
                "d4.tif", "d5.tif",  "d6.tif", "d7.tif", "-t",          "svg"};
    Words one = words, many = words;
    one.insert(one.end(), {"-o", "one/", "-j", "1"});
    many.insert(many.end(), {"-o", "many/", "-j", "4", "--title-from-name"});
    const Ending ending = convert(one);
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "\n8 of 10 pictures done, 8 files written, ")) << ending.err;
    // Told at once and at the end, in the order of the words.
    const auto last = ending.err.find("2 of 10 failed:\n  bad.tif: ");
    ASSERT_NE(last, std::string::npos) << ending.err;
    EXPECT_TRUE(holds(ending.err.substr(last), "\n  missing.tif: "));
    EXPECT_TRUE(holds(ending.err.substr(0, last), "tactics: bad.tif: ") &&
                holds(ending.err.substr(0, last), "tactics: missing.tif: "));
    EXPECT_EQ(names("one"), "d0.svg d1.svg d2.svg d3.svg d4.svg d5.svg d6.svg d7.svg");
    many.pop_back();
    ASSERT_EQ(convert(many).code, 2);
    for (int i = 0; i < 8; ++i) {
        const std::string name = "d" + std::to_string(i) + ".svg";
        EXPECT_EQ(bytes_of(folder / ("one/" + name)), bytes_of(folder / ("many/" + name))) << name;
    }
}

TEST_F(Convert, TellsAllInJson) {
    if (!has_tool("python3")) GTEST_SKIP() << "python3 is missing";
    const std::string odd = "caf\xe9 \"\n.tif";
    write_bytes(folder / odd, disc_picture());
    write_bytes(folder / "check.py",
                "import sys, json, os\n"
                "odd, bad, disc = [json.loads(line) for line in sys.stdin.buffer]\n"
                "assert os.fsencode(odd['input']) == b'caf\\xe9 \"\\n.tif', odd\n"
                "assert 'error' in bad and bad['input'] == 'bad.tif', bad\n"
                "assert disc['width'] == 240 and disc['height'] == 160 and disc['seconds'] >= 0 and disc['steps'], disc\n"
                "for out in disc['outputs'] + odd['outputs']:\n"
                "    assert os.path.getsize(os.fsencode(out['path'])) == out['bytes'], out\n"
                "    assert 0 < out['drawing_width_mm'] <= out['page_width_mm'], out\n"
                "assert [out['format'] for out in disc['outputs']] == ['svg', 'brf'], disc\n"
                "assert disc['outputs'][1]['medium'] == 'embosser', disc\n");
    const Ending ending = convert({odd, "bad.tif", "disc.tif", "-o", "out/", "-t", "svg", "-t", "brf", "--json", "-j", "3"});
    EXPECT_EQ(ending.code, 2);
    const Ending python = run_tool(folder, {"python3", "check.py"}, ending.out);
    EXPECT_EQ(python.code, 0) << python.err << ending.out;
    EXPECT_TRUE(holds(ending.err, "tactics: bad.tif: ")) << ending.err;
}

TEST_F(Convert, UpdateLeavesOutWhatIsDone) {
    const Words words{"disc.tif", "-r", "own.recipe", "-o", "out/", "-t", "svg", "-t", "pdf", "--update"};
    write_bytes(folder / "own.recipe", "threshold\n");
    EXPECT_FALSE(holds(convert(words).err, "up to date"));
    EXPECT_EQ(convert(words).err, "disc.tif: up to date\n");
    const auto later = fs::last_write_time(folder / "out/disc.svg") + std::chrono::seconds(1);
    fs::last_write_time(folder / "own.recipe", later);
    EXPECT_TRUE(holds(convert(words).err, "up to date")) << "the same recipe";
    write_bytes(folder / "own.recipe", "invert\nthreshold\n");
    EXPECT_TRUE(holds(convert(words).err, "; made anew: --recipe own.recipe ("));
    EXPECT_TRUE(holds(convert(words).err, "up to date"));
    fs::last_write_time(folder / "disc.tif", later);
    EXPECT_TRUE(holds(convert(words).err, "; made anew: the picture is another\n"));
    fs::remove(folder / "out/disc.pdf");
    EXPECT_TRUE(holds(convert(words).err, "; made anew: out/disc.pdf is not there\n"));
    EXPECT_TRUE(fs::exists(folder / "out/disc.pdf"));
    EXPECT_TRUE(holds(convert(words).err, "up to date"));
}

TEST_F(Convert, BarePngHasThePixelsOfThePicture) {
    const auto size_of = [&](const Words& words) {
        Words all{"disc.tif", "-q", "--bare", "-o", "bare.png"};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_EQ(convert(all).code, 0);
        const std::string png = bytes_of(folder / "bare.png");
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            for (std::size_t i = 0; i < 4 && png.size() > 24; ++i) value = value << 8 | static_cast<unsigned char>(png[at + i]);
            return value;
        };
        return std::pair{number(16), number(20)};  // PNG, IHDR
    };
    const std::pair whole{240u, 160u};
    EXPECT_EQ(size_of({"-r", "none"}), whole);
    EXPECT_EQ(size_of({"-r", "photo", "--set", "resample.dpi=30"}), whole);
    EXPECT_EQ(size_of({"-r", "photo", "--paper", "60x80mm"}), whole);
    EXPECT_EQ(size_of({"-f", "crop left=50", "-f", "sobel", "-f", "trace"}), (std::pair{120u, 160u}));
}

TEST_F(Convert, RefusesBeforeWork) {
    struct Case {
        Words words;
        std::string message;
    };
    const Case cases[] = {
        {{"-o", "a.svg"}, "tactics: convert: no picture is named; "},
        {{"disc.tif"}, "tactics: convert: where to write is missing; add for example -o disc.pdf\n"},
        {{"disc.tif", "-o", "a.svg", "--margin", "300"}, "tactics: "},
        {{"disc.tif", "-o", "a.svg", "--margin", "-1"}, "tactics: --margin: it cannot be \"-1\"; "},
        {{"disc.tif", "-o", "a.svg", "--width", "wide"}, "tactics: --width: it cannot be \"wide\"; "},
        {{"disc.tif", "-o", "a.svg", "--paper", "a44"}, "tactics: --paper: there is no paper \"a44\" (a4?); "},
        {{"disc.tif", "-o", "a.svg", "--medium", "swel"}, "tactics: --medium: there is no medium \"swel\" (swell?); "},
        {{"disc.tif", "-o", "a.svg", "--orientation", "up"}, "tactics: --orientation: it cannot be \"up\"; "},
        {{"disc.tif", "-o", "a.svg", "--jobs", "0"}, "tactics: --jobs: it cannot be \"0\"; "},
        {{"disc.tif", "-o", "a.svg", "--dpi", "300"}, "tactics: --dpi: no output is made of pixels"},
        {{"disc.tif", "-o", "a.svg", "--set", "png.dpi=300"}, "tactics: --set 1: no output is png"},
        {{"disc.tif", "-o", "a.png", "--dpi", "1"}, "tactics: --dpi: png dpi=1 is out of range; "},
        {{"disc.tif", "-o", "a.svg", "--title", "x", "--title-from-name"}, "tactics: --title-from-name: "},
        {{"disc.tif", "-o", "a.svg", "--title", "x", "--bare"}, "tactics: --bare: "},
        {{"disc.tif", "-o", "a.svg", "--title", "x", "--braille", "nosuch.ctb"}, "tactics: --braille: there is no "},
        {{"disc.tif", "-o", "a.svg", "--braille", "nosuch.ctb"}, "tactics: --braille: there is no "},
        {{"disc.tif", "-o", "a.svg", "--title", "\xFF"}, "tactics: --title: the text for braille is not UTF-8; "},
        {{"disc.tif", "-o", "a.svg", "--title", "Disc 日"},
         "tactics: --title: braille table \"en-ueb-g2.ctb\" has no cells for \"日\" "},
        {{"disc.tif", "-o", "svg:-", "--json"}, "tactics: standard output: only one "},
        {{"disc.tif", "-o", "svg:disc.tif"}, "tactics: disc.tif: this would replace the picture"},
        {{"disc.tif", "-o", "a.svg", "--save-recipe", "./a.svg"}, "tactics: --save-recipe: "},
        {{"disc.tif", "-", "-o", "out/", "--save-recipe", "x.recipe"}, "tactics: --save-recipe: auto may choose another "},
        {{"disc.tif", "-o", "a.svg", "-f", "trace", "-f", "sobel"}, "tactics: --filter 2: sobel does not work on a drawing"},
    };
    for (const Case& bad : cases) {
        const Ending ending = convert(bad.words);
        EXPECT_EQ(ending.code, 1) << bad.message;
        EXPECT_TRUE(ending.err.starts_with(bad.message)) << ending.err << "instead of " << bad.message;
        EXPECT_EQ(lines_in(ending.err), 1u) << ending.err;
        EXPECT_EQ(ending.out, "");
        EXPECT_EQ(names(), "disc.tif") << bad.message;
    }
}

TEST_F(Convert, FailsWithOneLineAndNoFile) {
    write_bytes(folder / "empty.tif", "");
    write_bytes(folder / "cut.tif", disc_picture().substr(0, 5000));
    write_bytes(folder / "text.jpg", "These are words.\n");
    fs::create_directory(folder / "folder");
    const std::string before = names();
    for (const std::string input : {"empty.tif", "cut.tif", "text.jpg", "folder", "missing.jpg"}) {
        const Ending ending = convert({input, "-r", "none", "-o", "a.svg"});
        EXPECT_EQ(ending.code, 2) << input;
        EXPECT_EQ(lines_in(ending.err), 1u) << ending.err;
        EXPECT_TRUE(ending.err.starts_with("tactics: " + input + ": ")) << ending.err;
        EXPECT_EQ(names(), before) << input;
    }
    // An input's name is told even if another file's name begins with it.
    fs::copy_file(folder / "disc.tif", folder / "n");
    const Ending begins = convert({"n", "-q", "-o", "nowhere/a.svg"});
    EXPECT_TRUE(begins.err.starts_with("tactics: n: nowhere/a.svg: ")) << begins.err;
    fs::remove(folder / "n");
    const Ending nowhere = convert({"disc.tif", "-q", "-o", "nowhere/a.svg"});
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_TRUE(nowhere.err.starts_with("tactics: disc.tif: nowhere/a.svg: ")) << nowhere.err;
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "a.pdf", "-o", "nowhere/a.svg", "-o", "b.svg"}).code, 2);
    EXPECT_EQ(names(), before);
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "disc.tif/sub/"}).code, 2);
}

TEST_F(Convert, AReaderThatGoesAwayIsNoNews) {
    const Ending ending =
        run_tool(folder, {"sh", "-c", "\"$0\" list | true; \"$0\" convert disc.tif -q -o svg:- | true", TACTICS_PROGRAM});
    EXPECT_EQ(ending.err, "");
    if (access("/dev/full", W_OK) == 0) {
        const Ending full = run_tool(folder, {"sh", "-c", "\"$0\" list > /dev/full", TACTICS_PROGRAM});
        EXPECT_EQ(full.code, 2);
        EXPECT_TRUE(full.err.starts_with("tactics: standard output: ")) << full.err;
    }
}

TEST_F(Convert, ANameThatCannotBeSetInBrailleStopsNoOther) {
    fs::copy_file(folder / "disc.tif", folder / "日.tif");
    const std::string message =
        "tactics: 日.tif: --title-from-name: braille table \"en-ueb-g2.ctb\" has no cells for \"日\" (U+65E5); ";
    const Ending batch = convert({"日.tif", "disc.tif", "-o", "out/", "-t", "svg", "--title-from-name"});
    EXPECT_EQ(batch.code, 2);
    EXPECT_TRUE(holds(batch.err, message)) << batch.err;
    EXPECT_EQ(names("out"), "disc.svg");
    const Ending one = convert({"日.tif", "-o", "a.svg", "--title-from-name"});
    EXPECT_EQ(one.code, 1);
    EXPECT_TRUE(one.err.starts_with(message)) << one.err;
    EXPECT_EQ(convert({"日.tif", "-o", "a.svg", "--title-from-name", "--braille", "none"}).code, 0);
}

// A batch is stopped in the middle: what is there is whole, and --update goes on from there.
TEST_F(Convert, CtrlCLeavesNothingHalfWritten) {
    Words words{TACTICS_PROGRAM, "convert", "-r", "none", "-o", "out/", "-t", "svg"};
    for (int i = 0; i < 400; ++i) {
        words.push_back("d" + std::to_string(i) + ".tif");
        fs::create_hard_link(folder / "disc.tif", folder / words.back());
    }
    const Folder streams;
    const pid_t id = start(folder, words, streams.path(), "");
    ASSERT_GT(id, 0);
    for (int i = 0; i < 2000 && !fs::exists(folder / "out/d0.svg"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(id, SIGINT);
    const Ending ending = end_of(id, streams.path());
    if (ending.code == 0) GTEST_SKIP() << "it was done before it could be stopped";
    EXPECT_EQ(ending.code, 128 + SIGINT);
    EXPECT_TRUE(holds(ending.err, "tactics: stopped; ") && holds(ending.err, "no file is half written; add --update"))
        << ending.err;
    const std::string whole = bytes_of(folder / "out/d0.svg");
    for (const auto& entry : fs::directory_iterator(folder / "out")) {
        if (entry.is_directory()) continue;  // of records
        EXPECT_EQ(entry.path().extension(), ".svg");
        EXPECT_EQ(bytes_of(entry.path()), whole) << entry.path();
    }
    words.insert(words.end(), {"--update", "-q"});
    EXPECT_EQ(run_tool(folder, words).code, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "out"), {}), 401);
}

// Ctrl-C ends it even if nobody reads its output.
TEST_F(Convert, AFullPipeDoesNotKeepItAlive) {
    const std::string pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int end = open(pipe.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(end, 0);
    while (write(end, "x", 1) == 1) {
    }
    const Folder streams;
    const pid_t id = start(folder, {"sh", "-c", "exec \"$0\" convert disc.tif -r none -o a.svg --json > pipe", TACTICS_PROGRAM},
                           streams.path(), "");
    ASSERT_GT(id, 0);
    const auto wait_for = [](const auto& done) {
        for (int i = 0; i < 2000 && !done(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    };
    wait_for([&] { return fs::exists(folder / "a.svg"); });
    kill(id, SIGTERM);
    siginfo_t ended{};
    wait_for(
        [&] { return waitid(P_PID, static_cast<id_t>(id), &ended, WEXITED | WNOHANG | WNOWAIT) != 0 || ended.si_pid == id; });
    kill(id, SIGKILL);
    EXPECT_EQ(end_of(id, streams.path()).code, 128 + SIGTERM);
    close(end);
}

}  // namespace
}  // namespace tactics::convert_test

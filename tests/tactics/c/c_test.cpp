// SPDX-License-Identifier: Apache-2.0
// The library for C: it makes what the program makes, says what the program says, and bears what callers do.
#ifdef TACTICS_HAS_C  // it is not built where sanitizers watch
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tactics/c/tactics.h"
#include "tests/cli/pdf_files.h"
#include "tests/cli/picture.h"
#include "tests/cli/tool.h"
#include "tests/patterns.h"

namespace tactics::c_test {
namespace {

using namespace tests;

using OwnJob = std::unique_ptr<tactics_job, decltype(&tactics_free)>;

class LibraryForC : public testing::Test {
protected:
    LibraryForC() { write_bytes(folder / "line.pdf", pdf_that_says("")); }

    std::string path(const std::string& name) const { return (folder / name).string(); }

    OwnJob job(const std::string& output) const {
        OwnJob fresh(tactics_new(), &tactics_free);
        EXPECT_EQ(tactics_input(fresh.get(), path("line.pdf").c_str()), TACTICS_DONE);
        EXPECT_EQ(tactics_output(fresh.get(), path(output).c_str()), TACTICS_DONE);
        return fresh;
    }

    const Folder folder;
};

std::string without_seconds(const std::string& json) { return without(json, R"("seconds": ?[0-9.e-]+)"); }

TEST_F(LibraryForC, MakesAndTellsWhatTheProgramDoes) {
    if (!has_tool("pdftocairo")) GTEST_SKIP() << "pdftocairo (poppler-utils) is not installed";
    const auto own = job("own.svg");
    ASSERT_EQ(tactics_option(own.get(), "title",
                             "Stra\xc3\x9f"
                             "e"),
              TACTICS_DONE);
    ASSERT_EQ(tactics_option(own.get(), "label", "10%,10%=a"), TACTICS_DONE);
    ASSERT_EQ(tactics_option(own.get(), "label", "80%,20%=b"), TACTICS_DONE);
    ASSERT_EQ(tactics_run(own.get()), TACTICS_DONE) << tactics_message(own.get());
    const std::vector<std::string> words = {"convert",
                                            path("line.pdf"),
                                            "--title",
                                            "Stra\xc3\x9f"
                                            "e",
                                            "--label",
                                            "10%,10%=a",
                                            "--label",
                                            "80%,20%=b",
                                            "-o",
                                            path("same.svg")};
    const Ending program = run_tactics(folder, words);
    ASSERT_EQ(program.code, 0) << program.err;
    EXPECT_EQ(bytes_of(folder / "own.svg"), bytes_of(folder / "same.svg"));
    std::string told;
    for (std::size_t i = 0; i < tactics_told_count(own.get()); ++i) told += tactics_told(own.get(), i) + std::string("\n");
    // The library's caller has options, no command line.
    const auto plain = [](const std::string& text) { return without(without(text, "[0-9.]+ s$"), "same|own|--(?=[a-z])"); };
    EXPECT_EQ(plain(told), plain(program.err));

    std::vector<std::string> for_json = words;
    for_json.back() = path("own.svg");
    for_json.push_back("--json");
    EXPECT_EQ(without_seconds(tactics_json(own.get()) + std::string("\n")), without_seconds(run_tactics(folder, for_json).out));
}

TEST_F(LibraryForC, TakesBytesAndForgetsThem) {
    if (!has_tool("pdftocairo")) GTEST_SKIP() << "pdftocairo (poppler-utils) is not installed";
    std::string bytes = bytes_of(folder / "line.pdf");
    const auto own = job("own.pdf");
    ASSERT_EQ(tactics_input_bytes(own.get(), bytes.data(), bytes.size(), "a line"), TACTICS_DONE);
    bytes.assign(bytes.size(), 'x');
    for (const char* round : {"first", "again"}) {
        ASSERT_EQ(tactics_run(own.get()), TACTICS_DONE) << round << ": " << tactics_message(own.get());
        EXPECT_TRUE(holds(tactics_told(own.get(), 0), "a line: ")) << tactics_told(own.get(), 0);
    }
    const auto other = job("other.pdf");
    ASSERT_EQ(tactics_run(other.get()), TACTICS_DONE);
    EXPECT_EQ(bytes_of(folder / "own.pdf"), bytes_of(folder / "other.pdf"));
    EXPECT_EQ(tactics_input_bytes(own.get(), nullptr, 0, "nothing"), TACTICS_USAGE);
}

TEST_F(LibraryForC, SaysWhatIsWrongAndStaysUsable) {
    const auto own = job("own.pdf");
    const auto says = [&](std::string_view part) {
        EXPECT_TRUE(holds(tactics_message(own.get()), part)) << tactics_message(own.get());
    };
    EXPECT_EQ(tactics_option(own.get(), "titel", "x"), TACTICS_USAGE);
    EXPECT_STREQ(tactics_message(own.get()), "titel: a job has no such option (title?)");
    EXPECT_EQ(tactics_option(own.get(), "jobs", "2"), TACTICS_USAGE) << "it is about several pictures";
    EXPECT_EQ(tactics_option(own.get(), "strict", "yes"), TACTICS_USAGE);
    EXPECT_EQ(tactics_option(own.get(), "title", nullptr), TACTICS_USAGE);
    says("TEXT");
    EXPECT_EQ(tactics_option(own.get(), nullptr, nullptr), TACTICS_USAGE);
    EXPECT_EQ(tactics_output(own.get(), "pdf:-"), TACTICS_USAGE);
    EXPECT_EQ(tactics_input(own.get(), "-"), TACTICS_USAGE);
    EXPECT_EQ(tactics_input(own.get(), ""), TACTICS_USAGE);
    EXPECT_EQ(tactics_option(own.get(), "paper", "a44"), TACTICS_DONE) << "values are looked at later";
    EXPECT_STREQ(tactics_message(own.get()), "");
    EXPECT_EQ(tactics_run(own.get()), TACTICS_USAGE);
    says("paper: there is no paper");
    EXPECT_FALSE(holds(tactics_message(own.get()), "--")) << tactics_message(own.get());
    EXPECT_EQ(tactics_option(own.get(), "paper", "a4"), TACTICS_DONE) << "the last one counts";
    EXPECT_EQ(tactics_input(own.get(), path("missing\xff\n.png").c_str()), TACTICS_DONE);
    EXPECT_EQ(tactics_run(own.get()), TACTICS_FAILED);
    says("missing\\xff\\x0a.png");
    EXPECT_STREQ(tactics_json(own.get()), "");
    EXPECT_EQ(tactics_told_count(own.get()), 0u);
    EXPECT_STREQ(tactics_told(own.get(), 7), "");
    EXPECT_EQ(tactics_told_asks(own.get(), 7), 0);

    EXPECT_EQ(tactics_run(nullptr), TACTICS_USAGE);
    EXPECT_EQ(tactics_input(nullptr, "a"), TACTICS_USAGE);
    EXPECT_STREQ(tactics_json(nullptr), "");
    EXPECT_STREQ(tactics_message(nullptr), "there is no job");
    tactics_cancel(nullptr);
    tactics_on_step(nullptr, nullptr, nullptr);
    tactics_free(nullptr);
    const OwnJob empty(tactics_new(), &tactics_free);
    EXPECT_EQ(tactics_run(empty.get()), TACTICS_USAGE);
}

TEST_F(LibraryForC, IsGivenUpFromWithinAndFromOutside) {
    write_bytes(folder / "disc.tif", disc_picture());
    for (const bool within : {true, false}) {
        const auto own = job("own.svg");
        ASSERT_EQ(tactics_input(own.get(), path("disc.tif").c_str()), TACTICS_DONE);
        struct Seen {
            tactics_job* job;
            bool within;
            std::vector<tactics_step> steps;
        } seen{own.get(), within, {}};
        tactics_on_step(
            own.get(),
            [](tactics_step step, void* user) {
                auto& its = *static_cast<Seen*>(user);
                its.steps.push_back(step);
                if (step != TACTICS_DRAWING) return 0;
                if (!its.within) std::thread([&] { tactics_cancel(its.job); }).join();
                return its.within ? 1 : 0;
            },
            &seen);
        EXPECT_EQ(tactics_run(own.get()), TACTICS_CANCELLED);
        EXPECT_EQ(seen.steps, (std::vector<tactics_step>{TACTICS_READING, TACTICS_DRAWING}));
        EXPECT_FALSE(std::filesystem::exists(folder / "own.svg"));
        tactics_on_step(own.get(), nullptr, nullptr);
        EXPECT_EQ(tactics_run(own.get()), TACTICS_DONE) << "it is given up once: " << tactics_message(own.get());
        std::filesystem::remove(folder / "own.svg");
    }
}

TEST_F(LibraryForC, ABrokenRuleIsACodeOfItsOwn) {
    // Lines half a millimetre apart, unchanged.
    std::string lines = R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100" width="100mm" height="100mm">)";
    for (int i = 0; i < 20; ++i)
        lines += "<path fill='none' stroke='black' stroke-width='0.5' d='M10 " + std::to_string(40 + i) + "H90'/>";
    write_bytes(folder / "lines.svg", lines + "</svg>");
    const auto own = job("own.pdf");
    tactics_input(own.get(), path("lines.svg").c_str());
    tactics_option(own.get(), "as-drawn", nullptr);
    EXPECT_EQ(tactics_run(own.get()), TACTICS_DONE) << tactics_message(own.get());
    tactics_option(own.get(), "strict", nullptr);
    EXPECT_EQ(tactics_run(own.get()), TACTICS_RULE_BROKEN);
    bool asks = false;
    for (std::size_t i = 0; i < tactics_told_count(own.get()); ++i) asks = asks || tactics_told_asks(own.get(), i) == 1;
    EXPECT_TRUE(asks);
    EXPECT_TRUE(std::filesystem::exists(folder / "own.pdf"));
}

TEST_F(LibraryForC, ManyThreadsHaveAJobEach) {
    write_bytes(folder / "disc.tif", disc_picture());
    std::vector<std::thread> threads;
    std::atomic<int> done = 0;
    for (int i = 0; i < 8; ++i)
        threads.emplace_back([&, i] {
            const auto own = job("page" + std::to_string(i) + ".svg");
            tactics_input(own.get(), path("disc.tif").c_str());
            if (tactics_run(own.get()) == TACTICS_DONE) ++done;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(done, 8);
    for (int i = 1; i < 8; ++i)
        EXPECT_EQ(bytes_of(folder / ("page" + std::to_string(i) + ".svg")), bytes_of(folder / "page0.svg")) << i;
}

}  // namespace
}  // namespace tactics::c_test
#endif

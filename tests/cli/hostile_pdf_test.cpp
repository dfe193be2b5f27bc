// SPDX-License-Identifier: Apache-2.0
// PDF files that were made to harm: they cost themselves, and leave no program behind.
#include <signal.h>
#include <sys/wait.h>

#include "tactics/readers/svg/pdf.h"
#include "tactics/transport/child.h"
#include "tests/cli/converting.h"
#include "tests/cli/pdf_files.h"
#include "tests/cli/print_user.h"
#include "tests/tactics/transport/processes.h"

namespace tactics::hostile_pdf_test {
namespace {

using namespace tests;

TEST(PdfPages, AreThoseThatPdfinfoCounted) {
    EXPECT_EQ(pages_told("Title: x\nPages:           3\nEncrypted:       no\n"), 3);
    EXPECT_EQ(pages_told("Title: x\nPages: 7\nEncrypted: no\nForm: none\nPages:   1\nEncrypted: no\n"), 1);
    EXPECT_EQ(pages_told("A: b\nPages: 1000000\nEncrypted: no\n"), kMostPdfPages);
    for (const char* none :
         {"", "Pages: 3\nEncrypted: no\n", "\nPages: 3", "\nPages: \nEncrypted: no", "\nPages: 0\nEncrypted: no",
          "\nPages: -1\nEncrypted: no", "\nPages: 1000001\nEncrypted: no", "\nPages: 99999999999999999999\nEncrypted: no",
          "\nPages: 1e3\nEncrypted: no", "\nPages: 3\nTitle: x\nEncrypted: no"})
        EXPECT_FALSE(pages_told(none)) << none;
}

class HostilePdf : public Convert {
protected:
    void SetUp() override {
        if (!has_tool("pdftocairo") || !has_tool("pdfinfo")) GTEST_SKIP() << "poppler-utils is missing";
    }
};

TEST_F(HostilePdf, ItsWordsDoNotCountItsPages) {
    const std::string lie = "(x\\nPages:           5\\nEncrypted:       no\\n)";
    for (const char* key : {"Title", "Subject", "Keywords", "Author", "Creator", "Producer", "CreationDate", "ModDate", "Else"}) {
        write_bytes(folder / "lie.pdf", pdf_that_says("/" + std::string(key) + " " + lie));
        EXPECT_EQ(pages_of_pdf(open_source((folder / "lie.pdf").string())), 1) << key;
    }
    EXPECT_TRUE(holds(convert({"lie.pdf", "--page", "2", "-o", "a.svg"}).err, "there is no page 2, but pages 1 to 1"));
    // More pages than any file has: the page tree claims so and must not be believed.
    write_bytes(folder / "many.pdf",
                pdf_of({"<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [4 0 R] /Count 99999999999 >>", "<< >>",
                        "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 9 9] >>"}));
    const Ending many = convert({"many.pdf", "--page", "900000", "-o", "a.svg"});
    EXPECT_NE(many.code, 0);
    EXPECT_TRUE(holds(many.err, "many.pdf: ")) << many.err;
}

TEST_F(HostilePdf, EndsAtItsLimits) {
    write_bytes(folder / "bomb.pdf", pdf_bomb());
    const Source bomb = open_source((folder / "bomb.pdf").string());
    for (const Words& kind : {Words{"-svg"}, Words{"-png", "-singlefile"}}) {
        Words words = {"pdftocairo", "/dev/fd/0", "-"};
        words.insert(words.begin() + 1, kind.begin(), kind.end());
        const ChildAnswer answer =
            run_caged({.words = words, .file = fileno(bomb.file.get()), .limits = {std::chrono::milliseconds(500), 1u << 20}});
        EXPECT_EQ(answer.end, ChildAnswer::End::too_long) << kind[0];
    }
}

// Whatever ends the program, and a print job with it.
TEST_F(HostilePdf, LeavesNoProgramBehind) {
    write_bytes(folder / "bomb.pdf", pdf_bomb());
    std::filesystem::create_symlink(TACTICS_PROGRAM, folder / "tacticstoembosser");
    write_bytes(folder / "e.ppd", run_tactics(folder, {"ppd", "index-v4"}).out);
    const Words convert = {TACTICS_PROGRAM, "convert", "bomb.pdf", "-o", "bomb.svg"},
                print = {"env", "PPD=e.ppd", "./tacticstoembosser", "1", "me", "title", "1", "", "bomb.pdf"};
    std::vector<Words> all = {convert};
    if (print_user_reaches(TACTICS_PROGRAM)) all.push_back(print);
    for (const auto& words : all)
        for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGKILL}) {
            const Folder streams;
            const pid_t program = start(folder, words, streams.path(), "");
            const pid_t child = wait_for_child(program, "pdftotext");
            ASSERT_NE(child, 0) << words[0];
            kill(program, number);
            EXPECT_EQ(end_of(program, streams.path()).code, 128 + number) << words[0];
            EXPECT_TRUE(wait_until_gone(child)) << words[0] << " " << number;
        }
    EXPECT_EQ(names(), "bomb.pdf disc.tif e.ppd tacticstoembosser");
}

}  // namespace
}  // namespace tactics::hostile_pdf_test

// SPDX-License-Identifier: Apache-2.0
// tactics-printer-app as a user meets it: a server of its own, printers whose machine is a folder, and jobs of every kind.
#include <arpa/inet.h>
#include <signal.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "print/embosser.h"
#include "print/format.h"
#include "tactics/text/words.h"
#include "tests/cli/converting.h"
#include "tests/cli/pdf_files.h"
#include "tests/cli/print_user.h"

namespace tactics::printer_app_test {
namespace {

using namespace tests;
namespace fs = std::filesystem;

const std::string kProgram = TACTICS_BINARY_DIR "/tactics-printer-app";

int free_port() {
    const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    if (bind(socket, reinterpret_cast<sockaddr*>(&address), size) != 0) return 0;
    getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
    close(socket);
    return ntohs(address.sin_port);
}

class PrinterApp : public Convert {
protected:
    void SetUp() override {
        Convert::SetUp();
        if (!fs::exists(kProgram)) GTEST_SKIP() << "it is built where PAPPL is installed";
        if (!print_user_reaches(kProgram.c_str())) GTEST_SKIP() << "the user of print jobs may not enter the build folder";
        fs::create_directories(folder / "machine");
        if (geteuid() == 0) {  // what root's server keeps would be the system's
            for (const fs::path& path : {folder.path(), folder / "machine"})
                ASSERT_EQ(chown(path.c_str(), print_user()->pw_uid, print_user()->pw_gid), 0);
        }
        port_ = free_port();
        server_ = start(folder,
                        as_user({"server", "-o", "server-port=" + std::to_string(port_), "-o", "log-level=info", "-o",
                                 "file-devices=yes", "-o", "log-file=" + (folder / "log").string()}),
                        streams_.path(), "");
        ASSERT_TRUE(becomes([&] { return app({"status"}).out.starts_with("Running"); })) << bytes_of(folder / "log");
        ASSERT_EQ(add("Everest", "everest-d-v5").code, 0) << bytes_of(folder / "log");
    }
    void TearDown() override {
        if (server_ <= 0) return;
        kill(server_, SIGTERM);
        end_of(server_, streams_.path());
    }
    Words as_user(Words words) {
        Words all;
        if (geteuid() == 0)
            all = {"setpriv", "--reuid=" + std::to_string(print_user()->pw_uid),
                   "--regid=" + std::to_string(print_user()->pw_gid), "--clear-groups"};
        // The server listens for its user in the folder of temporary files, too.
        for (const char* name : {"HOME", "TMPDIR"}) {
            if (all.empty() || !holds(all.back(), "HOME=")) all.push_back("env");
            all.push_back(std::string(name) + "=" + folder.path().string());
        }
        all.push_back(kProgram);
        all.insert(all.end(), words.begin(), words.end());
        return all;
    }
    Ending app(const Words& words) { return run_tool(folder, as_user(words)); }
    Ending add(const std::string& name, const std::string& driver) {
        return app({"add", "-d", name, "-m", driver, "-v", "file://" + (folder / "machine").string()});
    }
    template <class Condition>
    static bool becomes(const Condition& condition) {
        for (int i = 0; i < 600; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(100)))
            if (condition()) return true;
        return false;
    }
    // Prints a file, waits until that is over, and gives what the machine received.
    std::string printed(const std::string& title, Words words, const std::string& printer = "Everest") {
        const Words begin{"submit", "-d", printer, "-t", title};
        words.insert(words.begin(), begin.begin(), begin.end());
        const Ending sent = app(words);
        EXPECT_EQ(sent.code, 0) << sent.err;
        EXPECT_TRUE(becomes([&] {
            const std::string jobs = app({"jobs", "-d", printer}).out;
            return !holds(jobs, "pending") && !holds(jobs, "processing");
        }));
        return bytes_of(folder / ("machine/" + title + ".prn"));
    }
    std::string made(Words words) {
        words.insert(words.end(), {"-q", "-o", "everest-d-v5:-"});
        return convert(words).out;
    }
    std::string log() const { return bytes_of(folder / "log"); }

    int port_ = 0;

private:
    pid_t server_ = -1;
    Folder streams_;
};

TEST(PrinterAppDrivers, AreAllEmbossersAndTheirModels) {
    if (!fs::exists(kProgram)) GTEST_SKIP() << "it is built where PAPPL is installed";
    const Folder folder;
    const std::string listed = "\n" + run_tool(folder, {kProgram, "drivers"}).out;
    for (const Format* format : formats()) {
        if (format->embosser == nullptr) continue;
        const bool offered = format->embosser->display == nullptr && format->name != "viewplus";
        EXPECT_EQ(holds(listed, "\n" + std::string(format->name) + ": " + std::string(format->summary) + "\n"), offered)
            << format->name;
        for (const std::string_view model : words_of(format->embosser->called))
            EXPECT_EQ(holds(listed, "\n" + std::string(model) + ": as " + std::string(format->name) + "\n"), offered) << model;
    }
    // A model brings its settings.
    const std::string romeo = run_tool(folder, {kProgram, "choices", "-m", "romeo"}).out;
    EXPECT_TRUE(holds(romeo, "tactics-model=romeo;")) << romeo;
    EXPECT_TRUE(holds(run_tool(folder, {kProgram, "choices", "-m", "juliet-pro-60"}).out, "tactics-model=juliet-pro60;"));
    EXPECT_TRUE(holds(romeo, "tactics-recipe=auto; choices: auto ") &&
                holds(romeo, "tactics-title=none; choices: job none, or any words"));
    EXPECT_EQ(run_tool(folder, {kProgram, "choices", "-m", "nothing"}).code, 1);
}

TEST_F(PrinterApp, GivesTheBytesOfConvert) {
    const std::string plain = made({"disc.tif"});
    ASSERT_FALSE(plain.empty());
    EXPECT_EQ(printed("plain", {"disc.tif"}), plain) << log();
    EXPECT_EQ(printed("copies", {"-o", "copies=2", "disc.tif"}), plain + plain);
    EXPECT_EQ(printed("chosen", {"-o", "tactics-recipe=diagram", "-o", "tactics-pitch=2.0", "-o", "media=na_letter_8.5x11in",
                                 "-o", "tactics-language=de", "-o", "tactics-title='Schöne Größe'", "-o",
                                 "tactics-label='5%,5%=Ring'", "disc.tif"}),
              made({"disc.tif", "-r", "diagram", "--set", "index-v4.pitch=2.0", "--paper", "letter", "--language", "de",
                    "--title", "Schöne Größe", "--label", "5%,5%=Ring"}));
    write_bytes(folder / "note.txt", "A note.\nIts second line.\n");
    EXPECT_EQ(printed("text", {"note.txt"}), made({"note.txt", "--text"}));
    // What is set for the printer holds for jobs that do not say otherwise.
    ASSERT_EQ(app({"modify", "-d", "Everest", "-o", "tactics-title-default=job"}).code, 0);
    EXPECT_EQ(printed("disc", {"disc.tif"}), made({"disc.tif", "--title", "disc"}));
    EXPECT_EQ(printed("untitled", {"-o", "tactics-title=none", "disc.tif"}), plain);
    // Bytes that are ready go through, those of another machine do not.
    write_bytes(folder / "ready.prn", plain);
    EXPECT_EQ(printed("ready", {"-o", "document-format=application/vnd.tactics", "ready.prn"}), plain);
    write_bytes(folder / "other.prn", convert({"disc.tif", "-q", "-o", "romeo:-"}).out);
    EXPECT_EQ(printed("other", {"-o", "document-format=application/vnd.tactics", "other.prn"}), "");
    EXPECT_TRUE(holds(log(), "other: these bytes are for enabling")) << log();
    ASSERT_EQ(add("Romeo", "romeo").code, 0);
    EXPECT_EQ(printed("romeo", {"disc.tif"}, "Romeo"), bytes_of(folder / "other.prn"));
}

// Whoever lists the processes of the computer sees that a job is converted, and none of its words.
TEST_F(PrinterApp, KeepsTheWordsOfAJobFromTheListOfProcesses) {
    std::string lists;
    std::atomic<bool> over = false;
    std::thread looking([&] {
        while (!over)
            for (const auto& entry : fs::directory_iterator("/proc")) {
                try {
                    const std::string words = bytes_of(entry.path() / "cmdline");
                    if (holds(words, "convert-job")) lists += words + "\n";
                } catch (const std::ios_base::failure&) {  // the process has ended
                }
            }
    });
    printed("secret", {"-o", "tactics-title='Hidden words'", "-o", "tactics-label='5%,5%=Hidden ring'", "disc.tif"});
    over = true;
    looking.join();
    EXPECT_TRUE(holds(lists, "convert-job"));
    EXPECT_FALSE(holds(lists, "secret") || holds(lists, "Hidden")) << lists;
}

TEST_F(PrinterApp, TakesThePagesOfAPdfThatAreAskedFor) {
    if (!has_tool("pdftocairo")) GTEST_SKIP() << "poppler-utils is missing";
    write_bytes(folder / "two.pdf", pdf_pages({"2 w 60 60 100 100 re S", "2 w 60 60 280 180 re S"}));
    const std::string first = made({"two.pdf"}), second = made({"two.pdf", "--page", "2"});
    EXPECT_NE(first, second);
    EXPECT_EQ(printed("both", {"two.pdf"}), first + second) << log();
    EXPECT_EQ(printed("second", {"-o", "page-ranges=2-9", "two.pdf"}), second);
    EXPECT_EQ(printed("none", {"-o", "page-ranges=3-9", "two.pdf"}), "");
    EXPECT_TRUE(holds(log(), "page-ranges: the document has none of these pages; its last is page 2")) << log();
}

TEST_F(PrinterApp, SaysWhatIsWrongInTheWordsOfItsOptions) {
    EXPECT_EQ(printed("recipe", {"-o", "tactics-recipe=diagrm", "disc.tif"}), "");
    EXPECT_TRUE(holds(log(), "tactics-recipe: this printer has no choice \\\"diagrm\\\" (diagram?)")) << log();
    EXPECT_EQ(printed("label", {"-o", "tactics-label=secret", "disc.tif"}), "");
    EXPECT_TRUE(holds(log(), "tactics-label 1: it is a place with words")) << log();
    write_bytes(folder / "cut.tif", disc_picture().substr(0, 300));
    EXPECT_EQ(printed("cut", {"-o", "document-format=image/tiff", "cut.tif"}), "");
    EXPECT_TRUE(holds(log(), "] cut: ")) << log();
    EXPECT_EQ(add("Nothing", "nothing").code, 1);
    EXPECT_EQ(printed("good", {"disc.tif"}), made({"disc.tif"})) << "the server goes on";
}

// Whoever may add a printer must not choose a file by it, however the file is written.
TEST_F(PrinterApp, SendsToMachinesOnly) {
    for (const std::string& device :
         {(folder / "machine").string(), (folder / "machine?ext=sh").string(), std::string("ipp://localhost/"),
          std::string("serial:/dev/null"), std::string("http://localhost/")})
        EXPECT_NE(app({"add", "-d", "Other", "-m", "everest-d-v5", "-v", device}).code, 0) << device;
    EXPECT_FALSE(holds(app({"printers"}).out, "Other"));
}

// A page is so short that it is written at the end only.
TEST_F(PrinterApp, SaysThatAMachineTakesNothing) {
    ASSERT_EQ(app({"add", "-d", "Full", "-m", "everest-d-v5", "-v", "file:///dev/full"}).code, 0);
    ASSERT_EQ(app({"submit", "-d", "Full", "disc.tif"}).code, 0);
    EXPECT_TRUE(becomes([&] {
        return holds(app({"jobs", "-d", "Full"}).out, "1 aborted");
    })) << app({"jobs", "-d", "Full"}).out
        << log();
}

TEST_F(PrinterApp, RefusesADefaultThatIsNoChoice) {
    app({"modify", "-d", "Everest", "-o", "tactics-recipe-default=phto"});
    app({"submit", "-d", "Everest", "disc.tif"});
    EXPECT_TRUE(becomes([&] { return holds(log(), "tactics-recipe-default: this printer has no choice"); })) << log();
}

TEST_F(PrinterApp, EndsAJobThatIsCancelled) {
    ASSERT_EQ(app({"submit", "-d", "Everest", "-t", "many", "-o", "copies=900", "disc.tif"}).code, 0);
    ASSERT_TRUE(becomes([&] { return holds(app({"jobs", "-d", "Everest"}).out, "1 processing"); }));
    EXPECT_EQ(app({"cancel", "-d", "Everest", "-j", "1"}).code, 0);
    EXPECT_TRUE(becomes([&] { return holds(app({"jobs", "-d", "Everest"}).out, "1 canceled"); })) << log();
    EXPECT_EQ(bytes_of(folder / "machine/many.prn"), "") << "no sheet had been sent";
    EXPECT_EQ(printed("next", {"disc.tif"}), made({"disc.tif"}));
}

// By another client: what it offers, and a page that was made into pixels (PWG raster).
TEST_F(PrinterApp, IsAnIppEverywherePrinter) {
    if (!has_tool("ipptool")) GTEST_SKIP() << "cups-ipp-utils is missing";
    const std::string uri = "ipp://localhost:" + std::to_string(port_) + "/ipp/print/Everest";
    const std::string told = run_tool(folder, {"ipptool", "-tv", uri, "get-printer-attributes.test"}).out;
    EXPECT_TRUE(holds(told, "[PASS]")) << told;
    for (const char* line :
         {"ipp-features-supported (keyword) = ipp-everywhere\n", "media-default (keyword) = iso_a4_210x297mm\n",
          "na_letter_8.5x11in", "application/pdf", "text/plain",
          "printer-make-and-model (textWithoutLanguage) = TACTICS everest-d-v5, tactile graphics\n"})
        EXPECT_TRUE(holds(told, line)) << line << told;
    if (!has_tool("gs")) GTEST_SKIP() << "Ghostscript is missing";
    write_bytes(folder / "box.pdf", pdf_page("2 w 60 60 100 100 re S"));
    run_tool(folder, {"gs", "-q", "-dNOPAUSE", "-dBATCH", "-sDEVICE=pwgraster", "-r300", "-sColorConversionStrategy=Gray",
                      "-dcupsColorSpace=18", "-dcupsBitsPerColor=8", "-dcupsBitsPerPixel=8", "-sOutputFile=box.pwg", "box.pdf"});
    EXPECT_EQ(
        run_tool(folder, {"gs", "-q", "-dNOPAUSE", "-dBATCH", "-sDEVICE=pnggray", "-r300", "-sOutputFile=box.png", "box.pdf"})
            .code,
        0);
    EXPECT_EQ(printed("raster", {"-o", "document-format=image/pwg-raster", "box.pwg"}), made({"box.png"})) << log();
}

}  // namespace
}  // namespace tactics::printer_app_test

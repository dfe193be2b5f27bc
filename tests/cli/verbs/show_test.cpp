// SPDX-License-Identifier: Apache-2.0
// `tactics show`: the real program, and a display that is pretended on the other end of a line.
#include <poll.h>
#include <stdlib.h>

#include <atomic>
#include <thread>

#include "tests/cli/converting.h"
#include "tests/cli/schemas.h"

namespace tactics::show_test {
namespace {

using namespace tests;

// Answers as a Dot Pad does, and keeps what it was sent but the questions.
class PretendedPad {
public:
    struct Manners {
        bool answers = true;
        int refuses_row = -1;
        int waits_at = -1;       // that row it does not take the first time
        bool stands = true;      // says when pins stand
        int gone_after = -1;     // pulled out behind that row
        int presses_after = -1;  // behind that row a key goes down, in two pieces, and up again
        int columns = 24, rows = 12, features = 0xC0;
    };
    explicit PretendedPad(Manners manners) : manners_(manners), line_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        grantpt(line_);
        unlockpt(line_);
        path = ptsname(line_);
        // Open on both sides, or the line hangs up when a program ends.
        other_ = open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
        reader_ = std::thread([this] { run(); });
    }
    ~PretendedPad() {
        over_ = true;
        reader_.join();
        if (other_ >= 0) close(other_);
        if (line_ >= 0) close(line_);
    }
    std::string shown() {
        over_ = true;
        while (!ended_) std::this_thread::yield();
        return shown_;
    }

    std::string path;

private:
    static std::string packet(int row, int command, const std::string& data) {
        std::string bytes{'\xAA',
                          '\x55',
                          0,
                          static_cast<char>(5 + data.size()),
                          static_cast<char>(row),
                          static_cast<char>(command >> 8),
                          static_cast<char>(command),
                          0};
        bytes += data;
        char sum = '\xA5';
        for (const char c : bytes.substr(4)) sum = static_cast<char>(sum ^ c);
        return bytes + sum;
    }
    void say(const std::string& bytes) {
        EXPECT_EQ(write(line_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    void run() {
        std::string heard;
        while (!over_) {
            pollfd ready{line_, POLLIN, 0};
            if (poll(&ready, 1, 10) <= 0) continue;
            char block[512];
            const ssize_t count = read(line_, block, sizeof block);
            if (count > 0) heard.append(block, static_cast<std::size_t>(count));
            while (heard.size() > 4 && heard.size() >= 4u + static_cast<unsigned char>(heard[3])) {
                const std::size_t size = 4u + static_cast<unsigned char>(heard[3]);
                take(heard.substr(0, size));
                heard.erase(0, size);
            }
        }
        ended_ = true;
    }
    void take(const std::string& sent) {
        const int row = sent[4], command = sent[5] * 256 + sent[6];
        if (!manners_.answers) return;
        if (command == 0x0110)
            return say(packet(0, 0x0111,
                              {static_cast<char>(manners_.features), 1, 25, 4, 1, 20, 0, 5, static_cast<char>(manners_.rows),
                               static_cast<char>(manners_.columns), 0, 5}));
        if (row == manners_.waits_at) {
            manners_.waits_at = -1;
            return say(packet(row, 0x0201, "\2"));
        }
        shown_ += sent;
        if (row != 1) say(packet(row - 1, 0x0202, std::string(1, '\0')));  // once more, late, of the row before
        say(packet(row, 0x0201, std::string(1, row == manners_.refuses_row ? '\1' : '\0')));
        if (manners_.stands) say(packet(row, 0x0202, std::string(1, '\0')));
        if (row == manners_.gone_after) {
            close(other_);
            close(line_);
            other_ = line_ = -1;
            over_ = true;
        }
        if (row == manners_.presses_after) {
            const std::string down = packet(0, 0x0332, std::string(1, '\x40'));
            say(down.substr(0, 4));
            std::this_thread::sleep_for(std::chrono::milliseconds{30});
            say(down.substr(4) + packet(0, 0x0332, "\x60") + packet(0, 0x0332, "\x20") + packet(0, 0x0332, std::string(1, '\0')));
        }
    }

    Manners manners_;
    int line_ = -1, other_ = -1;
    std::string shown_;
    std::atomic<bool> over_ = false, ended_ = false;
    std::thread reader_;
};

class Show : public Convert {
protected:
    Ending show(Words words) {
        words.insert(words.begin(), "show");
        return run_tactics(folder, words);
    }
};

TEST_F(Show, AsksTheDisplayAndSetsItsPins) {
    PretendedPad pad({});
    const Ending ending = show({"disc.tif", "--on", "dot-pad:" + pad.path, "--title", "A disc", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "dot-pad:" + pad.path + ": part 1 of 1")) << ending.err;
    EXPECT_TRUE(holds(ending.out, "\"width_mm\":120,\"height_mm\":120,\"parts\":1,\"part\":1")) << ending.out;
    if (has_json_schema()) {
        EXPECT_EQ(schema_faults("show", ending.out), "");
    }
    // What convert writes for a display of that size, byte for byte.
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "dot-pad:same.bin", "--title", "A disc", "--set", "dot-pad.columns=48", "--set",
                       "dot-pad.rows=48"})
                  .code,
              0);
    EXPECT_EQ(pad.shown(), bytes_of(folder / "same.bin"));
    const Ending seen = run_tactics(
        folder, {"preview", "same.bin", "-e", "dot-pad", "--set", "dot-pad.columns=48", "--set", "dot-pad.rows=48", "--unicode"});
    EXPECT_EQ(seen.code, 0);
    EXPECT_TRUE(seen.out.starts_with("\u2820\u2801\u2800")) << seen.out;  // the title, on its own line
}

TEST_F(Show, ShowsAPartOfALargerDrawing) {
    PretendedPad pad({});
    const Ending ending = show({"disc.tif", "--on", "dot-pad:" + pad.path, "--zoom", "3", "--part", "5"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "part 5 of 9")) << ending.err;
    // Its dots are those of the middle of a page three times as large.
    const std::string pins = pad.shown();
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "dot-pad:whole.bin", "--set", "dot-pad.columns=144", "--set", "dot-pad.rows=144",
                       "--set", "dot-pad.text=0"})
                  .code,
              0);
    const std::string whole = bytes_of(folder / "whole.bin");
    // A packet of the whole has 72 cells behind 9 bytes and before one, one of the part 24.
    for (std::size_t row = 0; row < 12; ++row)
        EXPECT_EQ(pins.substr(row * 34 + 9, 24), whole.substr((12 + row) * 82 + 9 + 24, 24)) << row;
    EXPECT_EQ(show({"disc.tif", "--on", "dot-pad:" + pad.path, "--zoom", "9"}).code, 1);
}

TEST_F(Show, SaysWhatIsWrong) {
    {
        PretendedPad mute({.answers = false});
        const Ending ending = show({"disc.tif", "--on", "dot-pad:" + mute.path});
        EXPECT_EQ(ending.code, 2);
        EXPECT_TRUE(holds(ending.err, mute.path + ": no answer as of dot-pad; switch it on")) << ending.err;
    }
    {
        PretendedPad other({.refuses_row = 3});
        const Ending ending = show({"disc.tif", "--on", "dot-pad:" + other.path});
        EXPECT_EQ(ending.code, 2);
        EXPECT_TRUE(holds(ending.err, "the display refused what it was sent")) << ending.err;
    }
    const Ending unknown = show({"disc.tif", "--on", "dotpad:/dev/ttyUSB0"});
    EXPECT_EQ(unknown.code, 1);
    EXPECT_TRUE(holds(unknown.err, "there is no display \"dotpad\" (dot-pad?)")) << unknown.err;
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "dot-pad:/dev/ttyUSB99"}).err, "there is no such device"));
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "dot-pad-320:/dev/ttyUSB99"}).err, "there is no such device")) << "a model";
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "dot-pad-302:/dev/ttyUSB99"}).err, "(dot-pad-320?)"));
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "everest:/dev/ttyUSB99"}).err, "there is no display \"everest\""));
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "graphiti:"}).err, "say which line it is on"));
    EXPECT_TRUE(holds(show({"disc.tif"}).err, "name the display"));
    EXPECT_EQ(show({"disc.tif", "--on", "brlapi:127.0.0.1:999"}).code, 2);
    PretendedPad pad({});
    EXPECT_TRUE(holds(show({"missing.png", "--on", "dot-pad:" + pad.path}).err, "there is no such file"));
}

TEST_F(Show, SendsAgainWhatTheDisplayCouldNotTake) {
    PretendedPad pad({.waits_at = 4});
    EXPECT_EQ(show({"disc.tif", "--on", "dot-pad:" + pad.path, "-q"}).code, 0);
    ASSERT_EQ(
        convert({"disc.tif", "-q", "-o", "dot-pad:same.bin", "--set", "dot-pad.columns=48", "--set", "dot-pad.rows=48"}).code, 0);
    EXPECT_EQ(pad.shown(), bytes_of(folder / "same.bin"));
}

TEST_F(Show, AKeyOfTheDisplayGoesOn) {
    PretendedPad pad({.presses_after = 0});
    const Ending ending = show({"disc.tif", "--on", "dot-pad:" + pad.path, "--zoom", "2", "--for", "30"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    // One press, of however many keys at a time, is one part; behind the last part all ends.
    EXPECT_TRUE(holds(ending.err, "part 1 of 4") && holds(ending.err, "part 2 of 4") && holds(ending.err, "part 3 of 4") &&
                holds(ending.err, "part 4 of 4"))
        << ending.err;
}

TEST_F(Show, UnpluggedIsTold) {
    for (const int row : {3, 0}) {  // in the middle, and behind the last packet
        PretendedPad pad({.gone_after = row});
        const Ending ending = show({"disc.tif", "--on", "dot-pad:" + pad.path, "--for", "20"});
        EXPECT_EQ(ending.code, 2) << row << ending.err;
        EXPECT_TRUE(holds(ending.err, pad.path + ": the display is gone")) << ending.err;
    }
}

TEST_F(Show, EndsWithItsTime) {
    PretendedPad pad({});
    EXPECT_EQ(show({"disc.tif", "--on", "dot-pad:" + pad.path, "--for", "0.2", "-q"}).code, 0);
    EXPECT_EQ(show({"disc.tif", "--on", "dot-pad:" + pad.path, "--for", "soon", "--json"}).out, "");
}

TEST_F(Show, TellsWhatCannotBeFelt) {
    PretendedPad pad({});
    write_bytes(folder / "white.tif", grey_picture(90, 60, [](int, int) { return 255; }));
    EXPECT_TRUE(holds(show({"white.tif", "--on", "dot-pad:" + pad.path}).err, "nothing can be felt of it on dot-pad:"));
    const Ending longer = show({"disc.tif", "--on", "dot-pad:" + pad.path, "--title", "A title that is longer than the line"});
    EXPECT_EQ(longer.code, 0);
    EXPECT_TRUE(holds(longer.err, "the display shows the first 20 of the ")) << longer.err;
}

TEST_F(Show, SizesThatNoDisplayHasAreRefused) {
    PretendedPad huge({.columns = 255});
    const Ending ending = show({"disc.tif", "--on", "dot-pad:" + huge.path});
    EXPECT_EQ(ending.code, 2);
    EXPECT_TRUE(holds(ending.err, "the display tells of 510 x 48 pins, which none has")) << ending.err;
    PretendedPad text({.features = 0x40});
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "dot-pad:" + text.path}).err, "the display has cells for text but no pins"));
    PretendedPad pad({});
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "dot-pad:" + pad.path, "--set", "dot-pad.columns=30"}).err,
                      "the display itself tells its columns"));
    EXPECT_TRUE(
        holds(show({"disc.tif", "--on", "dot-pad:" + pad.path, "--part", "5"}).err, "there is one part; --zoom makes more"));
}

// Names that have no room at their things go into a key, whose pages are as large as the display at any zoom.
TEST_F(Show, KeysAreReadPartByPart) {
    PretendedPad pad({});
    Words words{"disc.tif", "--on", "dot-pad:" + pad.path, "--zoom", "2"};
    for (const std::string label :
         {"45%,50%=a very long name of a thing here", "50%,50%=another name that is long", "55%,50%=and a third one of them"}) {
        words.push_back("--label");
        words.push_back(label);
    }
    const Ending ending = show(words);
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "part 1 of 5") || holds(ending.err, "part 1 of 6") || holds(ending.err, "part 1 of 4"))
        << ending.err;
}

TEST_F(Show, DisplaysHaveOneSize) {
    const Ending ending = convert({"disc.tif", "-o", "graphiti:disc.bin", "--paper", "a4"});
    EXPECT_EQ(ending.code, 1);
    EXPECT_TRUE(holds(ending.err, "graphiti is a display, all of which is used")) << ending.err;
    EXPECT_EQ(convert({"disc.tif", "-q", "-o", "graphiti:disc.bin"}).code, 0);
    const Ending seen = run_tactics(folder, {"preview", "disc.bin", "-e", "graphiti", "-o", "disc.png"});
    EXPECT_EQ(seen.code, 0) << seen.err;
    EXPECT_EQ(seen.err, "");
    EXPECT_FALSE(holds(seen.out, "beside")) << seen.out;
}

}  // namespace
}  // namespace tactics::show_test

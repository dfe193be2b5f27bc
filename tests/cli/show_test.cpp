// `tactics show`: the real program, and a display that is pretended on the other end of a line.
#include <poll.h>
#include <stdlib.h>

#include <atomic>
#include <thread>

#include "tests/cli/converting.h"

namespace tactics {
namespace {

using namespace tests;

// Answers as a Dot Pad does, and keeps what it was sent but the questions.
class PretendedPad {
public:
    struct Manners {
        bool answers = true;
        int refuses_row = -1;
    };
    explicit PretendedPad(Manners manners) : manners_(manners), line_(posix_openpt(O_RDWR | O_NOCTTY)) {
        grantpt(line_);
        unlockpt(line_);
        path = ptsname(line_);
        // Open on both sides, or the line hangs up when a program ends.
        other_ = open(path.c_str(), O_RDWR | O_NOCTTY);
        reader_ = std::thread([this] { run(); });
    }
    ~PretendedPad() {
        over_ = true;
        reader_.join();
        close(other_);
        close(line_);
    }
    std::string shown() {
        over_ = true;
        while (!ended_) std::this_thread::yield();
        return shown_;
    }

    std::string path;

private:
    static std::string packet(int row, int command, const std::string& data) {
        std::string bytes{'\xAA', '\x55', 0, static_cast<char>(5 + data.size()), static_cast<char>(row), static_cast<char>(command >> 8), static_cast<char>(command), 0};
        bytes += data;
        char sum = '\xA5';
        for (const char c : bytes.substr(4)) sum = static_cast<char>(sum ^ c);
        return bytes + sum;
    }
    void say(const std::string& bytes) { EXPECT_EQ(write(line_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size())); }
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
        if (command == 0x0110) return say(packet(0, 0x0111, {'\xC0', 1, 25, 4, 1, 20, 0, 5, 12, 24, 0, 5}));
        shown_ += sent;
        say(packet(row, 0x0201, std::string(1, row == manners_.refuses_row ? '\1' : '\0')));
        say(packet(row, 0x0202, std::string(1, '\0')));
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
    // What convert writes for a display of that size, byte for byte.
    ASSERT_EQ(convert({"disc.tif", "-q", "-o", "dot-pad:same.bin", "--title", "A disc", "--set", "dot-pad.columns=48", "--set", "dot-pad.rows=48"}).code, 0);
    EXPECT_EQ(pad.shown(), bytes_of(folder / "same.bin"));
    const Ending seen = run_tactics(folder, {"preview", "same.bin", "-e", "dot-pad", "--set", "dot-pad.columns=48", "--set", "dot-pad.rows=48", "--unicode"});
    EXPECT_EQ(seen.code, 0);
    EXPECT_TRUE(seen.out.starts_with("\u2820\u2801\u2800")) << seen.out;  // the title, on its own line
}

TEST_F(Show, ShowsAPartOfALargerDrawing) {
    PretendedPad pad({});
    const Ending ending = show({"disc.tif", "--on", "dot-pad:" + pad.path, "--zoom", "3", "--part", "5"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "part 5 of 9")) << ending.err;
    EXPECT_GT(pad.shown().size(), 300u);
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
    EXPECT_TRUE(holds(show({"disc.tif", "--on", "graphiti:"}).err, "say which line it is on"));
    EXPECT_TRUE(holds(show({"disc.tif"}).err, "name the display"));
    EXPECT_EQ(show({"disc.tif", "--on", "brlapi:127.0.0.1:999"}).code, 2);
    PretendedPad pad({});
    EXPECT_TRUE(holds(show({"missing.png", "--on", "dot-pad:" + pad.path}).err, "there is no such file"));
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
}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
// A finger that `tactics play` leads over a plot on a simulated arm, what it says and what it sounds like, through the program.
#include <fcntl.h>
#include <signal.h>
#include <termios.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "tests/cli/converting.h"

namespace tactics::play_guidance_test {
namespace {

using namespace tests;

class PlayGuidance : public Convert {
protected:
    PlayGuidance() {
        std::string csv = "time (s),speed (m/s),who\n";
        for (int i = 0; i <= 100; ++i) csv += row(i, 10 + 6 * std::sin(0.12 * i), "car");
        for (int i = 0; i <= 100; ++i)
            csv += i > 40 && i < 60 ? std::to_string(i * 0.1) + ",,bus\n" : row(i, 8 + 0.06 * i, "bus");
        write_bytes(folder / "data.csv", csv);
    }
    static std::string row(int i, double y, const std::string& who) {
        return std::to_string(i * 0.1) + "," + std::to_string(y) + "," + who + "\n";
    }
    Ending play(Words words) {
        words.insert(words.begin(), {"play", "data.csv", "--group", "who", "--device", "arm"});
        return run_tactics(folder, words);
    }
    // All numbers of that name.
    static std::vector<double> numbers(const std::string& json, const std::string& name) {
        std::vector<double> all;
        const std::string key = "\"" + name + "\":";
        for (auto at = json.find(key); at != std::string::npos; at = json.find(key, at + 1))
            all.push_back(std::stod(json.substr(at + key.size())));
        return all;
    }
    // Without the seconds.
    std::string words_spoken() {
        std::istringstream lines(bytes_of(folder / "words.txt"));
        std::string text;
        for (std::string line; std::getline(lines, line);) text += line.substr(line.find(' ') + 1) + "\n";
        return text;
    }
};

TEST_F(PlayGuidance, SaysWhatSurfaceIsUnderTheFinger) {
    std::string csv = "east (m),north (m),height (m)\n";
    for (int y = 0; y <= 20; ++y)
        for (int x = 0; x <= 30; ++x)
            csv += std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(100 + 2 * x) + "\n";
    write_bytes(folder / "slope.csv", csv);
    const auto said = [&](const char* parts) {
        const Ending ending = run_tactics(folder, {"play", "slope.csv", "--z", "height", "--device", "arm", "--guide", "under",
                                                   "--speak", "recording:words.txt", "--seconds", "20", "-q", "--feel", parts});
        EXPECT_EQ(ending.code, 0) << ending.err;
        return words_spoken();
    };
    const std::string felt = said("wall,axes,surface");
    EXPECT_TRUE(felt.starts_with("surface, height 1")) << felt;
    EXPECT_TRUE(holds(felt, " m, gentle slope, rising with east\n")) << felt;
    EXPECT_FALSE(said("wall,axes").starts_with("surface"));
}

TEST_F(PlayGuidance, LeadsAFingerOnEveryArmAndSaysWhereItIs) {
    for (const char* arm : {"omni", "desktop", "phantom"}) {
        const Ending ending = play({"--arm", arm, "--guide", "start,start,start,extremum,extremum,follow,compare", "--speak",
                                    "recording:words.txt", "--seconds", "300", "--json"});
        ASSERT_EQ(ending.code, 0) << ending.err;
        const auto off = numbers(ending.out, "off_mm");
        EXPECT_EQ(off.size(), 7u) << ending.out;
        for (const double one : off) EXPECT_LE(one, 0.5) << arm;
        const auto rms = numbers(ending.out, "rms_mm"), p95 = numbers(ending.out, "p95_mm");
        EXPECT_EQ(rms.size(), 3u);
        for (const double one : rms) EXPECT_LE(one, 0.5) << arm;
        for (const double one : p95) EXPECT_LE(one, 1) << arm;
        EXPECT_FALSE(holds(ending.out, "resisted") || holds(ending.out, "left")) << ending.out;
        const std::string words = words_spoken();
        EXPECT_EQ(words.substr(0, words.find("at time")),
                  "beginning of the curve car, time 0 s, speed 10 m/s\n"
                  "beginning of the curve bus, time 0 s, speed 8 m/s\n"
                  "beginning of the curve car, time 0 s, speed 10 m/s\n"
                  "maximum of car, time 1.3 s, speed 16 m/s\n"
                  "minimum of car, time 3.9 s, speed 4 m/s\n"
                  "end of the curve car, time 10 s, speed 6.78 m/s\n");
        EXPECT_TRUE(holds(words, "bus 14 m/s, bus 7.2") || holds(words, "bus 13.9")) << words;
    }
}

// The bus is not known for two seconds: the way goes over that.
TEST_F(PlayGuidance, LeadsOverAGap) {
    const Ending ending = play({"--guide", "start,start,follow", "--speak", "recording:words.txt", "--seconds", "100", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(words_spoken(), "end of the curve bus, time 10 s, speed 14 m/s\n")) << words_spoken();
}

// Two keys are enough: the second chooses, the first does it.
TEST_F(PlayGuidance, IsReachedWithTwoKeys) {
    const Ending ending =
        play({"--guide", "choose,choose,choose,do,do", "--speak", "recording:words.txt", "--seconds", "60", "--json"});
    ASSERT_EQ(ending.code, 0) << ending.err;
    EXPECT_EQ(numbers(ending.out, "off_mm").size(), 2u);
    EXPECT_TRUE(words_spoken().starts_with("nearest\nunder\nstart\nbeginning of the curve ")) << words_spoken();
}

TEST_F(PlayGuidance, RefusesWhatDoesNotFit) {
    const auto told = [&](Words words, const char* what) {
        const Ending ending = play(std::move(words));
        EXPECT_EQ(ending.code, 1) << ending.err;
        EXPECT_TRUE(holds(ending.err, what)) << ending.err;
    };
    told({"--guide", "strat"}, "no key is called \"strat\" (start?)");
    told({"--guide", ""}, "name a key");
    told({"--guide", "start", "--hand", "trace"}, "only the hand that is led");
    told({"--tones", "loud"}, "it is alsa");
    write_bytes(folder / "way.csv", "time_s,x_mm,y_mm,z_mm\n0,1,1,1\n1,2,2,1\n");
    const Ending recorded =
        run_tactics(folder, {"play", "data.csv", "--device", "recorded:way.csv", "--arm", "omni", "--guide", "start"});
    EXPECT_EQ(recorded.code, 1);
    EXPECT_TRUE(holds(recorded.err, "--guide: only a simulated hand")) << recorded.err;
    const Ending mouse = run_tactics(folder, {"play", "data.csv", "--tones", "alsa"});
    EXPECT_EQ(mouse.code, 1);
    EXPECT_TRUE(holds(mouse.err, "--tones: it is about an arm")) << mouse.err;
    EXPECT_EQ(play({"--tones", "missing/a.wav"}).code, 2);
}

struct Sound {
    std::vector<std::int16_t> left, right;
};
Sound sound_of(const std::string& bytes) {
    Sound sound;
    const auto sample = [&](std::size_t at) {
        return static_cast<std::int16_t>(static_cast<unsigned char>(bytes[at]) | static_cast<unsigned char>(bytes[at + 1]) << 8);
    };
    for (std::size_t at = 44; at + 3 < bytes.size(); at += 4) {
        sound.left.push_back(sample(at));
        sound.right.push_back(sample(at + 2));
    }
    return sound;
}

// Hz, by the upward crossings of zero in so many samples; 0: silence.
double pitch_of(const std::vector<std::int16_t>& ear, std::size_t from, std::size_t count) {
    std::size_t first = 0, last = 0;
    int crossings = -1;
    for (std::size_t i = from; i + 1 < std::min(from + count, ear.size()); ++i)
        if (ear[i] < 0 && ear[i + 1] >= 0) {
            if (++crossings == 0) first = i;
            last = i;
        }
    return crossings > 0 ? 44'100.0 * crossings / static_cast<double>(last - first) : 0;
}

// The places of the log beside the sound at the same time: the pitch is the height, the louder ear the side.
TEST_F(PlayGuidance, TonesAreTheHeightOfTheCurve) {
    const Words words{"--guide", "start,follow", "--tones", "way.wav", "--csv", "ticks.csv", "--seconds", "60", "-q"};
    ASSERT_EQ(play(words).code, 0);
    const std::string bytes = bytes_of(folder / "way.wav");
    const Sound sound = sound_of(bytes);
    std::istringstream rows(bytes_of(folder / "ticks.csv"));
    std::string row;
    std::getline(rows, row);
    constexpr std::size_t kWindow = 2205;  // 50 ms
    std::vector<std::pair<double, double>> heard;
    double left_side = 0, right_side = 0;
    for (std::size_t tick = 0; std::getline(rows, row); ++tick) {
        if (tick % 50 != 25) continue;
        double time = 0, x = 0, y = 0;
        ASSERT_EQ(std::sscanf(row.c_str(), "%lf,%lf,%lf", &time, &x, &y), 3);
        const auto middle = static_cast<std::size_t>(time * 44'100);
        if (middle < kWindow || middle + kWindow > sound.left.size()) continue;
        const double left = pitch_of(sound.left, middle - kWindow / 2, kWindow),
                     right = pitch_of(sound.right, middle - kWindow / 2, kWindow);
        if (std::max(left, right) > 0) heard.emplace_back(y, std::max(left, right));
        if (x < 20) left_side += std::abs(sound.left[middle]) - std::abs(sound.right[middle]);
        if (x > 120) right_side += std::abs(sound.right[middle]) - std::abs(sound.left[middle]);
    }
    ASSERT_GT(heard.size(), 80u);
    EXPECT_GT(left_side, 0);
    EXPECT_GT(right_side, 0);
    // Higher on the field, which is downwards in y, is a higher pitch, and equal steps are equal intervals.
    std::sort(heard.begin(), heard.end());
    const double span = heard.back().first - heard.front().first;
    ASSERT_GT(span, 30);
    const double per_mm = std::log(heard.front().second / heard.back().second) / span;
    EXPECT_GT(per_mm, 0.02);
    std::size_t near = 0;
    for (const auto& [y, pitch] : heard) {
        const double expected = heard.back().second * std::exp(per_mm * (heard.back().first - y));
        near += std::abs(std::log(pitch / expected)) < 0.15 ? 1 : 0;
        EXPECT_GE(pitch, 100);
        EXPECT_LE(pitch, 1800);
    }
    EXPECT_GE(near, heard.size() * 95 / 100);
    ASSERT_EQ(play(words).code, 0);
    EXPECT_TRUE(bytes_of(folder / "way.wav") == bytes);
    EXPECT_FALSE(std::filesystem::exists(folder / "way.wav.part"));
}

TEST_F(PlayGuidance, WithoutALoudspeakerItIsPlayedAllTheSame) {
    setenv("ALSA_CONFIG_PATH", "/nowhere", 1);
    const Ending ending = play({"--guide", "start", "--tones", "alsa"});
    unsetenv("ALSA_CONFIG_PATH");
    EXPECT_EQ(ending.code, 0) << ending.err;
    EXPECT_TRUE(holds(ending.err, "tones") && holds(ending.err, "start: the finger arrived")) << ending.err;
}

// A terminal of the test's own, at which keys are pressed.
class Terminal {
public:
    Terminal() : number_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
        if (number_ >= 0 && grantpt(number_) == 0 && unlockpt(number_) == 0) name_ = ptsname(number_);
    }
    ~Terminal() { close(number_); }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    const std::string& name() const { return name_; }
    void type(const char* keys) { EXPECT_EQ(write(number_, keys, std::strlen(keys)), static_cast<ssize_t>(std::strlen(keys))); }
    bool echoes() const {
        termios now{};
        return tcgetattr(number_, &now) != 0 || (now.c_lflag & (ECHO | ICANON)) == (ECHO | ICANON);
    }
    bool comes_to_echo(bool echo) const {
        for (int i = 0; i < 1000 && echoes() != echo; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return echoes() == echo;
    }

private:
    int number_;
    std::string name_;
};

class PlayTerminal : public PlayGuidance {
protected:
    // In a session of its own, whose terminal is this one. setsid(1) takes standard input for it.
    pid_t start_play(const Folder& streams, const std::string& terminal) {
        return start(
            folder,
            {"sh", "-c",
             "exec setsid --ctty --wait \"$0\" play data.csv --group who --device arm --hand led --real-time --seconds 60 "
             "--speak recording:words.txt <" +
                 terminal,
             TACTICS_PROGRAM},
            streams.path(), "");
    }
    bool is_spoken(const std::string& words) {
        for (int i = 0; i < 2000 && !holds(words_spoken(), words); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        return holds(words_spoken(), words);
    }
};

TEST_F(PlayTerminal, TheKeyboardHasTheSameKeysAndIsGivenBack) {
    if (!has_tool("setsid")) GTEST_SKIP() << "setsid is not installed";
    for (const char* end : {"\x03", "\x1c"}) {  // Ctrl-C, Ctrl-backslash
        Terminal terminal;
        if (terminal.name().empty()) GTEST_SKIP() << "there are no pseudo-terminals here";
        EXPECT_TRUE(terminal.echoes());
        const Folder streams;
        const pid_t play = start_play(streams, terminal.name());
        EXPECT_TRUE(terminal.comes_to_echo(false));
        terminal.type("p");
        EXPECT_TRUE(is_spoken("time "));
        terminal.type("?22");
        EXPECT_TRUE(is_spoken("under")) << words_spoken();
        terminal.type("2S");
        // A machine that is too busy to push it lets it go.
        EXPECT_TRUE(is_spoken("beginning of the curve") || holds(words_spoken(), "let go")) << words_spoken();
        terminal.type(end);
        const Ending ending = end_of(play, streams.path());
        EXPECT_TRUE(terminal.comes_to_echo(true));
        EXPECT_EQ(ending.code, *end == '\x03' ? 0 : 128 + SIGQUIT) << ending.err;
        EXPECT_TRUE(holds(ending.err, "the keyboard has the keys of the arm")) << ending.err;
    }
}

}  // namespace
}  // namespace tactics::play_guidance_test

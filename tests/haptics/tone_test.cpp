// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/tone.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>
#include <vector>

#include "tactics/error.h"
#include "tactics/haptics/voice/tone_track.h"
#include "tactics/haptics/voice/toning.h"
#include "tactics/transport/child.h"

namespace tactics::tone_test {
namespace {

namespace fs = std::filesystem;

std::vector<std::int16_t> rendered(ToneSynthesiser& synthesiser, const Tone& tone, double seconds) {
    std::vector<std::int16_t> samples(2 * static_cast<std::size_t>(seconds * kToneRate));
    synthesiser.render(tone, samples);
    return samples;
}

// Upward crossings of zero a second, of what one ear hears between two times, counted between the first and the last.
double crossings(const std::vector<std::int16_t>& samples, std::size_t ear, double from, double to) {
    std::size_t first = 0, last = 0;
    int count = -1;
    for (auto i = static_cast<std::size_t>(from * kToneRate); i + 1 < static_cast<std::size_t>(to * kToneRate); ++i)
        if (samples[2 * i + ear] < 0 && samples[2 * i + 2 + ear] >= 0) {
            if (++count == 0) first = i;
            last = i;
        }
    return count <= 0 ? 0 : count * static_cast<double>(kToneRate) / static_cast<double>(last - first);
}

double power(const std::vector<std::int16_t>& samples, std::size_t ear) {
    double sum = 0;
    for (std::size_t i = ear; i < samples.size(); i += 2) sum += static_cast<double>(samples[i]) * samples[i];
    return sum;
}

TEST(Tone, EqualStepsAreEqualIntervals) {
    EXPECT_NEAR(tone_frequency(0), 440 * std::pow(2, (45 - 69) / 12.0), 1e-9);  // MIDI notes, 69 is 440 Hz
    EXPECT_NEAR(tone_frequency(1), 440 * std::pow(2, (93 - 69) / 12.0), 1e-9);
    for (double value = 0; value < 0.9; value += 0.1)
        EXPECT_NEAR(tone_frequency(value + 0.1) / tone_frequency(value), std::pow(16, 0.1), 1e-9);
    EXPECT_EQ(tone_frequency(-3), tone_frequency(0));
    EXPECT_EQ(tone_frequency(7), tone_frequency(1));
}

TEST(Tone, ItsPitchIsItsValue) {
    for (const std::uint8_t series : {std::uint8_t{0}, std::uint8_t{1}})
        for (const double value : {0.0, 0.25, 0.5, 1.0}) {
            ToneSynthesiser synthesiser;
            const auto samples = rendered(synthesiser, {value, 0.5, series, true}, 0.5);
            EXPECT_NEAR(crossings(samples, 0, 0.05, 0.5) / tone_frequency(value), 1, 0.002) << value;
            EXPECT_NEAR(crossings(samples, 1, 0.05, 0.5) / tone_frequency(value), 1, 0.002) << value;
        }
}

TEST(Tone, ItsSideIsWhereTheFingerIs) {
    double all = 0;
    for (const double side : {0.0, 0.25, 0.5, 1.0}) {
        ToneSynthesiser synthesiser;
        const auto samples = rendered(synthesiser, {0.5, side, 0, true}, 0.2);
        const double left = power(samples, 0), right = power(samples, 1);
        if (all == 0) all = left + right;
        EXPECT_NEAR((left + right) / all, 1, 0.01);
        EXPECT_NEAR(std::atan2(std::sqrt(right), std::sqrt(left)) / std::acos(0), side, 0.01);
    }
}

// Whatever is told next, no sample is farther from the one before than the steepest wave of that pitch goes: a jump of the phase,
// the loudness or the side would be.
TEST(Tone, NothingClicks) {
    const double steepest = 32'767 * 0.3 * (3 / 0.94) * 2 * std::acos(-1) * tone_frequency(0.5) / kToneRate;
    ToneSynthesiser synthesiser;
    std::int16_t before[2] = {0, 0};
    int most = 0;
    for (int i = 0; i < 400; ++i) {
        const Tone tone{(i * 37 % 50) / 100.0, (i * 53 % 101) / 100.0, static_cast<std::uint8_t>(i / 3 % 2), i % 4 != 3};
        for (const auto samples = rendered(synthesiser, tone, 0.003 + i % 5 * 0.007); std::size_t k : {0u, 1u})
            for (std::size_t n = k; n < samples.size(); n += 2) {
                most = std::max(most, std::abs(samples[n] - before[k]));
                before[k] = samples[n];
            }
    }
    EXPECT_LT(most, steepest * 1.02);
    EXPECT_GT(most, steepest / 4);
    // It has faded to silence after the time that it swells in.
    const auto end = rendered(synthesiser, {}, 0.05);
    EXPECT_TRUE(std::all_of(end.begin() + 2 * kToneRate / 50, end.end(), [](int sample) { return sample == 0; }));
    const auto fault = rendered(synthesiser, {NAN, 0.5, 0, true}, 0.01);
    EXPECT_TRUE(std::all_of(fault.begin(), fault.end(), [](int sample) { return sample == 0; }));
}

TEST(Tone, PiecesAreTheWhole) {
    ToneSynthesiser whole, pieces;
    const Tone tone{0.7, 0.2, 1, true};
    const auto expected = rendered(whole, tone, 0.1);
    std::vector<std::int16_t> samples(expected.size());
    for (std::size_t at = 0; at < samples.size();) {
        const std::size_t size = std::min<std::size_t>(2 * (at % 97 + 1), samples.size() - at);
        pieces.render(tone, std::span(samples).subspan(at, size));
        at += size;
    }
    EXPECT_EQ(samples, expected);
}

class ToneFiles : public testing::Test {
protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("tactics-tone-" + std::to_string(getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_;
};

// Python's module wave is another's reader.
TEST_F(ToneFiles, AWavIsReadByOthers) {
    const std::string file = (folder_ / "tones.wav").string();
    ToneSynthesiser synthesiser;
    auto samples = rendered(synthesiser, {0.5, 0.3, 0, true}, 0.25);
    const auto faded = rendered(synthesiser, {}, 0.02);
    samples.insert(samples.end(), faded.begin(), faded.end());
    std::vector<Tone> tones(25, Tone{0.5, 0.3, 0, true});
    WavFile(file).finish(tones);
    const ChildAnswer answer = run_child({"python3", "-c",
                                          "import wave,sys,struct\nw=wave.open(sys.argv[1])\nb=w.readframes(9999999)\n"
                                          "print(w.getnchannels(),w.getsampwidth(),w.getframerate(),w.getnframes(),"
                                          "sum(i*s for i,s in enumerate(struct.unpack('<%dh'%(len(b)//2),b))))",
                                          file},
                                         "", {});
    if (answer.end == ChildAnswer::End::missing) GTEST_SKIP() << "python3 is not installed";
    long long sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) sum += static_cast<long long>(i) * samples[i];
    EXPECT_EQ(answer.out, "2 2 44100 " + std::to_string(samples.size() / 2) + " " + std::to_string(sum) + "\n") << answer.err;
}

TEST_F(ToneFiles, AFileIsThereWhenItIsWhole) {
    const fs::path file = folder_ / "tones.wav";
    { const WavFile unfinished(file.string()); }
    EXPECT_TRUE(fs::is_empty(folder_));
    std::ofstream(file) << "what was there before";
    {
        WavFile wav(file.string());
        EXPECT_EQ(fs::file_size(file), 21u);
        EXPECT_TRUE(fs::exists(folder_ / "tones.wav.part"));
        wav.finish({});
    }
    EXPECT_EQ(fs::file_size(file), 44 + 2 * 441 * 4u);
    EXPECT_FALSE(fs::exists(folder_ / "tones.wav.part"));
    EXPECT_THROW(WavFile((folder_ / "missing" / "a.wav").string()), Error);
}

TEST(ToneTrack, SoundsAsLongAsItWasFelt) {
    for (const double rate : {100.0, 777.0, 1000.0, 5000.0}) {
        ToneTrack track(2);
        for (int i = 0; i < static_cast<int>(rate * 1.5); ++i) track.add({i / rate / 1.5, 0, 0, true}, 1 / rate);
        ASSERT_NEAR(static_cast<double>(track.tones().size()), 150, 1) << rate;
        for (std::size_t k = 0; k < track.tones().size(); ++k)
            ASSERT_NEAR(track.tones()[k].value, static_cast<double>(k) / 150, 0.02) << rate;
        EXPECT_FALSE(track.lost());
    }
    ToneTrack small(0.1);
    for (int i = 0; i < 1000; ++i) small.add({}, i % 7 == 0 ? NAN : 0.001);
    EXPECT_TRUE(small.lost());
    EXPECT_LE(small.tones().size(), 12u);
}

// ALSA's own library, whose plug-in "file" keeps what a card would be sent.
TEST_F(ToneFiles, AlsaIsSentTheSamples) {
    const std::string raw = (folder_ / "raw").string();
    std::ofstream(folder_ / "asound.conf") << "pcm.nowhere { type null }\npcm.!default { type file slave.pcm nowhere file \""
                                           << raw << "\" format raw }\n";
    setenv("ALSA_CONFIG_PATH", (folder_ / "asound.conf").c_str(), 1);
    OpenedTones opened = open_tones();
    unsetenv("ALSA_CONFIG_PATH");
    if (!opened.note.empty()) GTEST_SKIP() << opened.note.english();
    EXPECT_TRUE(opened.sink->has_beat());
    ToneSynthesiser synthesiser;
    const auto samples = rendered(synthesiser, {0.5, 0.3, 0, true}, 0.25);
    opened.sink->take(samples);
    EXPECT_TRUE(opened.sink->trouble().empty());
    opened.sink.reset();
    std::ifstream file(raw, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    ASSERT_GE(bytes.size(), samples.size() * 2);
    for (std::size_t i = 0; i < samples.size(); ++i)
        ASSERT_EQ(static_cast<std::int16_t>(static_cast<unsigned char>(bytes[2 * i]) | bytes[2 * i + 1] << 8), samples[i]) << i;
}

struct Kept {
    std::mutex guard;
    std::vector<std::int16_t> samples;
    bool closed = false;
};

class Keeper : public ToneSink {
public:
    explicit Keeper(std::shared_ptr<Kept> kept) : kept_(std::move(kept)) {}
    ~Keeper() override {
        const std::lock_guard lock(kept_->guard);
        kept_->closed = true;
    }
    void take(std::span<const std::int16_t> samples) override {
        const std::lock_guard lock(kept_->guard);
        kept_->samples.insert(kept_->samples.end(), samples.begin(), samples.end());
    }
    Phrase trouble() override { return "a trouble"; }

private:
    std::shared_ptr<Kept> kept_;
};

TEST(Toning, SoundsWhatWasToldLast) {
    const auto kept = std::make_shared<Kept>();
    Toning toning(std::make_unique<Keeper>(kept));
    const auto comes = [&](std::size_t more) {
        std::size_t before = 0;
        for (int i = 0; i < 1000; ++i) {
            {
                const std::lock_guard lock(kept->guard);
                if (before == 0) before = kept->samples.size() + 1;
                if (kept->samples.size() + 1 >= before + more) return true;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return false;
    };
    toning.tell({0.1, 0, 0, true});
    toning.tell({0.5, 1, 3, true});
    ASSERT_TRUE(comes(2 * kToneRate / 4));
    EXPECT_TRUE(toning.finish());
    EXPECT_TRUE(kept->closed);
    EXPECT_EQ(toning.note().english(), "a trouble");
    const double seconds = static_cast<double>(kept->samples.size()) / 2 / kToneRate;
    EXPECT_NEAR(crossings(kept->samples, 1, seconds - 0.15, seconds - 0.03) / tone_frequency(0.5), 1, 0.01);
    EXPECT_EQ(kept->samples.back(), 0) << "it did not fade";
}

}  // namespace
}  // namespace tactics::tone_test

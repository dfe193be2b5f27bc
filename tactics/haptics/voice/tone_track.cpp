// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/tone_track.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "tactics/error.h"

namespace tactics {

namespace {

constexpr std::size_t kFramesOfTone = kToneRate / kTonesPerSecond;
constexpr double kPeriod = 1.0 / kTonesPerSecond;

}  // namespace

ToneTrack::ToneTrack(double seconds) {
    tones_.reserve(static_cast<std::size_t>(std::clamp(seconds, 0.0, WavFile::kMostSeconds) * kTonesPerSecond) + 1);
}

void ToneTrack::add(const Tone& tone, double dt) noexcept {
    constexpr double kMost = 0.1, kRounding = 1e-9;  // s
    if (dt > 0) time_ += std::min(dt, kMost);
    for (; time_ >= kPeriod - kRounding; time_ -= kPeriod) {
        if (tones_.size() < tones_.capacity())
            tones_.push_back(tone);
        else
            lost_ = true;
    }
}

WavFile::WavFile(std::string path) : path_(std::move(path)) {
    std::error_code fault;
    const auto target = std::filesystem::canonical(path_, fault);  // of a link the target is written
    if (!fault) path_ = target.string();
    part_ = path_ + ".part";
    file_.open(part_, std::ios::binary | std::ios::trunc);
    if (!file_) throw Error(Fault::failed, path_, phrase("cannot be written; see that its folder is there and yours"));
}

WavFile::~WavFile() {
    std::error_code fault;
    if (!finished_) std::filesystem::remove(part_, fault);
}

void WavFile::write_head(std::uint32_t bytes) {
    constexpr std::uint32_t kHead = 44, kFrame = 4;  // bytes
    std::string head;
    const auto number = [&](std::uint32_t value, int size) {
        for (int i = 0; i < size; ++i) head += static_cast<char>(value >> (8 * i) & 0xFF);
    };
    head += "RIFF";
    number(kHead - 8 + bytes, 4);
    head += "WAVEfmt ";
    number(16, 4);
    number(1, 2);  // PCM
    number(2, 2);  // ears
    number(kToneRate, 4);
    number(kToneRate * kFrame, 4);
    number(kFrame, 2);
    number(16, 2);  // bits
    head += "data";
    number(bytes, 4);
    file_.write(head.data(), static_cast<std::streamsize>(head.size()));
}

void WavFile::finish(const std::vector<Tone>& tones) {
    constexpr std::size_t kFade = 2;  // tones of silence
    write_head(static_cast<std::uint32_t>((tones.size() + kFade) * kFramesOfTone * 4));
    ToneSynthesiser synthesiser;
    std::array<std::int16_t, 2 * kFramesOfTone> samples{};
    std::string bytes;
    for (std::size_t i = 0; i < tones.size() + kFade; ++i) {
        synthesiser.render(i < tones.size() ? tones[i] : Tone{}, samples);
        bytes.clear();
        for (const std::int16_t sample : samples) {
            bytes += static_cast<char>(sample & 0xFF);
            bytes += static_cast<char>((sample >> 8) & 0xFF);
        }
        file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    file_.close();
    if (!file_) throw Error(Fault::failed, path_, phrase("the tones cannot be written; make room on the disk"));
    std::error_code fault;
    std::filesystem::rename(part_, path_, fault);
    if (fault) throw Error(Fault::failed, path_, phrase("cannot take its name ({0}); name another file", fault.message()));
    finished_ = true;
}

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
// Tones as a WAV file: RIFF with 16 bits of PCM for each ear (Microsoft and IBM, "Multimedia Programming Interface and Data
// Specifications 1.0", 1991). Its head, which tells its length, is written again at the end.
#include <fstream>
#include <string>

#include "tactics/error.h"
#include "tactics/haptics/voice/tone.h"
#include "tactics/haptics/voice/tone_sink.h"

namespace tactics {

namespace {

constexpr std::uint32_t kHead = 44, kMost = 0xFFFFFF00u - kHead;  // bytes of sound: its length is told in 32 bits

class Wav : public ToneSink {
public:
    explicit Wav(const std::string& path) : path_(path), file_(path, std::ios::binary | std::ios::trunc) {
        write_head();
        if (!file_) throw Error(Fault::failed, path, "cannot be written; see that its folder is there and yours");
    }
    ~Wav() override {
        file_.seekp(0);
        write_head();
    }
    Wav(const Wav&) = delete;
    Wav& operator=(const Wav&) = delete;

    void take(std::span<const std::int16_t> samples) override {
        std::string bytes;
        for (const std::int16_t sample : samples) {
            bytes += static_cast<char>(sample & 0xFF);
            bytes += static_cast<char>((sample >> 8) & 0xFF);
        }
        if (bytes.size() > kMost - written_) return;
        file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (file_) written_ += static_cast<std::uint32_t>(bytes.size());
    }
    std::string trouble() override {
        if (!file_) return path_ + ": tones can no longer be written there; make room on the disk";
        return "";
    }

private:
    void write_head() {
        std::string head;
        const auto number = [&](std::uint32_t value, int bytes) {
            for (int i = 0; i < bytes; ++i) head += static_cast<char>(value >> (8 * i) & 0xFF);
        };
        constexpr std::uint32_t kFrame = 4;  // bytes
        head += "RIFF";
        number(kHead - 8 + written_, 4);
        head += "WAVEfmt ";
        number(16, 4);
        number(1, 2);  // PCM
        number(2, 2);  // ears
        number(kToneRate, 4);
        number(kToneRate * kFrame, 4);
        number(kFrame, 2);
        number(16, 2);  // bits
        head += "data";
        number(written_, 4);
        file_.write(head.data(), static_cast<std::streamsize>(head.size()));
    }
    std::string path_;
    std::ofstream file_;
    std::uint32_t written_ = 0;
};

}  // namespace

std::unique_ptr<ToneSink> open_wav(const std::string& path) { return std::make_unique<Wav>(path); }

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
// Tones by ALSA's library, libasound 1.2 (its reference, "PCM Interface"). It is opened only on demand (LGPL-2.1+), so that the
// program builds and runs without it.
#include "tactics/error.h"
#include "tactics/haptics/voice/tone.h"
#include "tactics/haptics/voice/tone_sink.h"
#include "tactics/transport/shared_library.h"

namespace tactics {

namespace {

// As pcm.h and error.h of 1.2.8 declare them; enumerations are int.
constexpr int kPlayback = 0, kNonblock = 1, kInterleaved = 3, kSigned16LittleEndian = 2;
constexpr unsigned kLatency = 40'000;  // us, what is rendered before it is heard
struct Library {
    int (*open)(void** pcm, const char* name, int stream, int mode) = nullptr;
    int (*nonblock)(void* pcm, int nonblock) = nullptr;
    int (*set)(void* pcm, int format, int access, unsigned channels, unsigned rate, int resample, unsigned latency) = nullptr;
    long (*write)(void* pcm, const void* frames, unsigned long count) = nullptr;
    int (*recover)(void* pcm, int fault, int silent) = nullptr;
    int (*close)(void* pcm) = nullptr;
    const char* (*words)(int fault) = nullptr;
    int (*tell)(void (*handler)(const char*, int, const char*, int, const char*, ...)) = nullptr;
};

void say_nothing(const char*, int, const char*, int, const char*, ...) {}

Library open_library() {
    static const std::string kNames[] = {"libasound.so.2"};
    const SharedLibrary shared(kNames, "tones", "the library of ALSA is not there; install libasound2");
    Library library;
    shared.find(library.open, "snd_pcm_open");
    shared.find(library.nonblock, "snd_pcm_nonblock");
    shared.find(library.set, "snd_pcm_set_params");
    shared.find(library.write, "snd_pcm_writei");
    shared.find(library.recover, "snd_pcm_recover");
    shared.find(library.close, "snd_pcm_close");
    shared.find(library.words, "snd_strerror");
    shared.find(library.tell, "snd_lib_error_set_handler");
    return library;
}

class Alsa : public ToneSink {
public:
    Alsa(const Library& library, void* pcm) : library_(library), pcm_(pcm) {}
    ~Alsa() override { library_.close(pcm_); }
    Alsa(const Alsa&) = delete;
    Alsa& operator=(const Alsa&) = delete;

    bool has_beat() const override { return trouble_.empty(); }
    void take(std::span<const std::int16_t> samples) override {
        while (samples.size() >= 2 && trouble_.empty()) {
            long taken = library_.write(pcm_, samples.data(), samples.size() / 2);
            // It ran dry, or the machine slept.
            if (taken < 0) taken = library_.recover(pcm_, static_cast<int>(taken), 1);
            if (taken < 0)
                trouble_ = phrase("tones are no longer heard: {0}; see that the sound card is there",
                                  library_.words(static_cast<int>(taken)));
            else
                samples = samples.subspan(2 * static_cast<std::size_t>(taken));
        }
    }
    Phrase trouble() override { return trouble_; }

private:
    Library library_;
    void* pcm_;
    Phrase trouble_;
};

}  // namespace

std::unique_ptr<ToneSink> open_alsa(Phrase& note) {
    Library library;
    try {
        library = open_library();
    } catch (const Error& error) {
        note = error.told();
        return nullptr;
    }
    library.tell(&say_nothing);  // it would write on the terminal
    void* pcm = nullptr;
    int fault = library.open(&pcm, "default", kPlayback, kNonblock);  // a card that is taken is not waited for
    if (fault >= 0) {
        fault = library.set(pcm, kSigned16LittleEndian, kInterleaved, 2, kToneRate, 1, kLatency);
        if (fault >= 0) fault = library.nonblock(pcm, 0);
        if (fault < 0) library.close(pcm);
    }
    if (fault >= 0) return std::make_unique<Alsa>(library, pcm);
    note = phrase("no tones: {0}; see that another program is heard", library.words(fault));
    return nullptr;
}

}  // namespace tactics

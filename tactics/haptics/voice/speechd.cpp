// SPDX-License-Identifier: Apache-2.0
// The speech service of screen readers: speech-dispatcher, through its C library, libspeechd 0.11 ("Speech Dispatcher" manual, "C
// API"). The library (LGPL-2.1+) is opened only on demand, so that the program builds and runs without it. SPEECHD_ADDRESS names
// another server than the user's own, which the library starts if need be.
#include <pthread.h>
#include <signal.h>
#include <time.h>

#include <chrono>
#include <cstdlib>
#include <future>
#include <thread>

#include "tactics/error.h"
#include "tactics/haptics/voice/voice.h"
#include "tactics/transport/shared_library.h"

namespace tactics {

namespace {

// As speechd_types.h and libspeechd.h of 0.11.4 declare them; enumerations are int.
constexpr int kModeSingle = 0;  // SPD_MODE_SINGLE: the library starts no thread
constexpr int kText = 3;        // SPD_TEXT: speaks when nothing more important does
using Open2 = void* (*)(const char* client, const char* connection, const char* user, int mode, const void* address,
                        int autospawn, char** error);
using Say = int (*)(void* connection, int priority, const char* text);
using Cancel = int (*)(void* connection);
using Close = void (*)(void* connection);
using SetText = int (*)(void* connection, const char* value);
using SetNumber = int (*)(void* connection, int value);

struct SpeechdLibrary {
    Open2 open = nullptr;
    Say say = nullptr;
    Cancel cancel = nullptr;
    Close close = nullptr;
    SetText language = nullptr;
    SetNumber rate = nullptr;
};

SpeechdLibrary open_library_speechd() {
    static const std::string kNames[] = {"libspeechd.so.2"};
    const SharedLibrary shared(kNames, "speech-dispatcher", "its library is not there; install speech-dispatcher");
    SpeechdLibrary library;
    shared.find(library.open, "spd_open2");
    shared.find(library.say, "spd_say");
    shared.find(library.cancel, "spd_cancel");
    shared.find(library.close, "spd_close");
    shared.find(library.language, "spd_set_language");
    shared.find(library.rate, "spd_set_voice_rate");
    return library;
}

// -100 to 100, whose ends are the slowest and the quickest that a synthesiser has, and 0 its usual.
int rate_of(int words) {
    const int span = words < kUsualRate ? kUsualRate - kLeastRate : kMostRate - kUsualRate;
    return (words - kUsualRate) * 100 / span;
}

// The library writes into a socket whose other end may be gone: SIGPIPE is held back from this thread, and one that came is
// taken.
class HeldPipes {
public:
    HeldPipes() {
        sigemptyset(&set_);
        sigaddset(&set_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &set_, &before_);
    }
    ~HeldPipes() {
        const timespec none{};
        if (sigismember(&before_, SIGPIPE) == 0) sigtimedwait(&set_, nullptr, &none);
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    HeldPipes(const HeldPipes&) = delete;
    HeldPipes& operator=(const HeldPipes&) = delete;

private:
    sigset_t set_, before_;
};

class Dispatcher : public Voice {
public:
    Dispatcher(const SpeechdLibrary& library, void* connection) : library_(library), connection_(connection) {}
    ~Dispatcher() override {
        const HeldPipes held;
        library_.cancel(connection_);
        library_.close(connection_);
    }
    Dispatcher(const Dispatcher&) = delete;
    Dispatcher& operator=(const Dispatcher&) = delete;
    std::string_view name() const override { return "speechd"; }
    void say(const std::string& text) override {
        if (lost_) return;
        const HeldPipes held;
        stop();
        lost_ = lost_ || library_.say(connection_, kText, text.c_str()) < 0;
    }
    void stop() override {
        const HeldPipes held;
        lost_ = lost_ || library_.cancel(connection_) < 0;
    }
    Phrase trouble() override {
        if (!lost_) return {};
        return phrase("speech-dispatcher is gone; see that \"spd-say hello\" is heard, then play again");
    }

private:
    SpeechdLibrary library_;
    void* connection_;
    bool lost_ = false;
};

// Connects, and starts the server, on a separate thread, which is abandoned if the server stalls.
std::unique_ptr<Voice> connect(const SpeechdLibrary& library, const VoiceWish& wish, std::chrono::milliseconds patience,
                               bool& stalled) {
    std::packaged_task<std::unique_ptr<Voice>()> task([library, wish]() -> std::unique_ptr<Voice> {
        const HeldPipes held;
        char* error = nullptr;
        void* connection = library.open("tactics", "haptics", nullptr, kModeSingle, nullptr, 1, &error);
        std::free(error);  // ours to free, as the library has it from malloc
        if (connection == nullptr) return nullptr;
        library.language(connection, wish.language.c_str());
        if (wish.rate != 0) library.rate(connection, rate_of(wish.rate));
        return std::make_unique<Dispatcher>(library, connection);
    });
    auto voice = task.get_future();
    std::thread(std::move(task)).detach();
    stalled = voice.wait_for(patience) != std::future_status::ready;
    return stalled ? nullptr : voice.get();
}

std::unique_ptr<Voice> open_speechd(const VoiceWish& wish, const std::string&, Phrase& note) {
    SpeechdLibrary library;
    try {
        library = open_library_speechd();
    } catch (const Error& error) {
        note = error.told();
        return nullptr;
    }
    bool stalled = false;
    auto voice = connect(library, wish, std::chrono::seconds(3), stalled);
    if (voice == nullptr)
        note = stalled
                   ? phrase("speech-dispatcher does not answer; see that \"spd-say hello\" is heard")
                   : phrase("speech-dispatcher does not run; install speech-dispatcher and see that \"spd-say hello\" is heard");
    return voice;
}

}  // namespace

extern const VoiceKind speechd_voice;
const VoiceKind speechd_voice{.name = "speechd",
                              .summary = "speech-dispatcher, through which screen readers speak",
                              .automatic = true,
                              .open = &open_speechd};

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/toning.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "tactics/haptics/voice/bounded_thread.h"

namespace tactics {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kFrames = 441;           // 10 ms: the interval between looks at the current tone
constexpr std::chrono::milliseconds kRest{1};  // even if a sound card takes all at once
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

// A tone in one word: 24 bits of its value, 24 of its side, 8 of its series, and whether it sounds.
constexpr double kFine = (1 << 24) - 1;

std::uint64_t packed(const Tone& tone) noexcept {
    if (!tone.sounds || !std::isfinite(tone.value) || !std::isfinite(tone.side)) return 0;
    const auto share = [](double value) { return static_cast<std::uint64_t>(std::clamp(value, 0.0, 1.0) * kFine + 0.5); };
    return share(tone.value) | share(tone.side) << 24 | std::uint64_t{tone.series} << 48 | std::uint64_t{1} << 56;
}

Tone unpacked(std::uint64_t word) {
    constexpr std::uint64_t kShare = (1 << 24) - 1;
    return {static_cast<double>(word & kShare) / kFine, static_cast<double>(word >> 24 & kShare) / kFine,
            static_cast<std::uint8_t>(word >> 48 & 0xFF), (word >> 56 & 1) != 0};
}

}  // namespace

struct Toning::Shared {
    std::atomic<std::uint64_t> tone{0};
    std::atomic<bool> over{false};
    std::mutex guard;
    Phrase note;  // guarded
    std::unique_ptr<ToneSink> sink;
};

struct Toning::Thread : BoundedThread {
    using BoundedThread::BoundedThread;
};

// A sink that does not run in real time gets as many samples as time has passed.
void Toning::work(Shared& shared) {
    ToneSynthesiser synthesiser;
    std::array<std::int16_t, 2 * kFrames> samples{};
    const auto sound = [&](const Tone& tone) {
        synthesiser.render(tone, samples);
        shared.sink->take(samples);
        const Phrase trouble = shared.sink->trouble();
        if (trouble.empty()) return;
        const std::lock_guard lock(shared.guard);
        if (shared.note.empty()) shared.note = trouble;
    };
    try {
        auto next = Clock::now();
        while (!shared.over.load(std::memory_order_acquire)) {
            sound(unpacked(shared.tone.load(std::memory_order_relaxed)));
            next += std::chrono::microseconds(1'000'000 * kFrames / kToneRate);
            if (!shared.sink->has_beat()) std::this_thread::sleep_until(next);
            std::this_thread::sleep_for(kRest);
        }
        for (int i = 0; i < 2; ++i) sound({});  // it fades
    } catch (const std::exception& fault) {
        const std::lock_guard lock(shared.guard);
        shared.note = phrase("tones ended: {0}", fault.what());
    }
    shared.sink.reset();
}

Toning::Toning(std::unique_ptr<ToneSink> sink) : shared_(std::make_shared<Shared>()) {
    shared_->sink = std::move(sink);
    thread_ = std::make_unique<Thread>([shared = shared_] { work(*shared); });
}

Toning::~Toning() { finish(); }

void Toning::tell(const Tone& tone) noexcept { shared_->tone.store(packed(tone), std::memory_order_relaxed); }

bool Toning::finish() {
    shared_->over.store(true, std::memory_order_release);
    if (thread_->ends_within(std::chrono::seconds(1))) return true;
    const std::lock_guard lock(shared_->guard);
    if (shared_->note.empty()) shared_->note = phrase("the sound card does not take any more tones");
    return false;
}

Phrase Toning::note() const {
    const std::lock_guard lock(shared_->guard);
    return shared_->note;
}

}  // namespace tactics

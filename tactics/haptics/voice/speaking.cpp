// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/voice/speaking.h"

#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "tactics/haptics/voice/bounded_thread.h"

namespace tactics {

namespace {

// The loop wakes no thread, because that would be a system call; a synthesiser takes longer than this to begin.
constexpr std::chrono::milliseconds kNap{5};
constexpr int kNapsBetweenLooks = 20;  // whether the voice has trouble

// One thread puts, another takes.
class Queue {
public:
    bool put(const Announcement& one) noexcept {
        const std::uint64_t at = put_.load(std::memory_order_relaxed);
        if (at - taken_.load(std::memory_order_acquire) == kSize) return false;
        slots_[at % kSize] = one;
        put_.store(at + 1, std::memory_order_release);
        return true;
    }
    std::optional<Announcement> take() noexcept {
        const std::uint64_t at = taken_.load(std::memory_order_relaxed);
        if (at == put_.load(std::memory_order_acquire)) return std::nullopt;
        const Announcement one = slots_[at % kSize];
        taken_.store(at + 1, std::memory_order_release);
        return one;
    }

private:
    static constexpr std::uint64_t kSize = 64;
    std::array<Announcement, kSize> slots_{};
    alignas(64) std::atomic<std::uint64_t> put_{0};
    alignas(64) std::atomic<std::uint64_t> taken_{0};
};

}  // namespace

struct Speaking::Shared {
    Queue queue;
    std::atomic<bool> over{false};
    std::atomic<std::uint64_t> said{0}, overtaken{0}, dropped{0};
    std::mutex guard;
    Phrase note;  // guarded
    std::unique_ptr<Voice> voice;
    Words words;

    void say(const Announcement& one) {
        if (one.telling == Telling::hush) {
            voice->stop();
            return;
        }
        const std::string text = spoken_line(words(one));
        if (text.empty()) return;
        voice->say(text);
        said.fetch_add(1, std::memory_order_relaxed);
    }
    // All that wait, or the newest alone. False: nothing did.
    bool say_what_waits() {
        std::optional<Announcement> newest;
        while (const auto one = queue.take()) {
            if (newest) overtaken.fetch_add(1, std::memory_order_relaxed);
            newest.reset();
            if (voice->takes_turns())
                say(*one);
            else
                newest = one;
        }
        if (newest) say(*newest);
        return newest.has_value();
    }
    void remember(const Phrase& trouble) {
        const std::lock_guard lock(guard);
        if (note.empty()) note = trouble;
    }
};

struct Speaking::Thread : BoundedThread {
    using BoundedThread::BoundedThread;
};

void Speaking::work(Shared& shared) {
    try {
        for (int naps = 0; !shared.over.load(std::memory_order_acquire); ++naps) {
            if (shared.say_what_waits() || naps % kNapsBetweenLooks == 0) shared.remember(shared.voice->trouble());
            std::this_thread::sleep_for(kNap);
        }
        if (shared.voice->takes_turns()) shared.say_what_waits();
        shared.remember(shared.voice->trouble());
        shared.voice->stop();
    } catch (const std::exception& fault) {
        shared.remember(phrase("speech ended: {0}", fault.what()));
    }
    shared.voice.reset();
}

Speaking::Speaking(std::unique_ptr<Voice> voice, Words words) : shared_(std::make_shared<Shared>()) {
    shared_->voice = std::move(voice);
    shared_->words = std::move(words);
    thread_ = std::make_unique<Thread>([shared = shared_] { work(*shared); });
}

Speaking::~Speaking() { finish(); }

bool Speaking::ask(const Announcement& announcement) noexcept {
    if (shared_->queue.put(announcement)) return true;
    shared_->dropped.fetch_add(1, std::memory_order_relaxed);
    return false;
}

bool Speaking::finish() {
    shared_->over.store(true, std::memory_order_release);
    if (thread_->ends_within(std::chrono::milliseconds(kFarewell))) return true;
    shared_->remember(phrase("the voice does not answer any more; what was asked last may not have been spoken"));
    return false;
}

SpokenCounts Speaking::counts() const noexcept {
    return {shared_->said.load(std::memory_order_relaxed), shared_->overtaken.load(std::memory_order_relaxed),
            shared_->dropped.load(std::memory_order_relaxed)};
}

Phrase Speaking::note() const {
    const std::lock_guard lock(shared_->guard);
    return shared_->note;
}

}  // namespace tactics

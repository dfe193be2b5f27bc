// SPDX-License-Identifier: Apache-2.0
// A mouse with an overlay. Opening and closing take milliseconds and memory, so they are a thread's; with the ticks it shares two
// pointers.
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "tactics/error.h"
#include "tactics/haptics/sensing/touch_overlay.h"

namespace tactics {

namespace {

constexpr std::chrono::milliseconds kAgain{200};

class OverlaidMouse : public HapticDevice {
public:
    OverlaidMouse(std::unique_ptr<HapticDevice> mouse, std::function<std::unique_ptr<Overlay>()> open,
                  std::function<void(bool)> told)
        : mouse_(std::move(mouse)), open_(std::move(open)), told_(std::move(told)), overlay_(open_()), watcher_([this] {
              watch();
          }) {}
    ~OverlaidMouse() override {
        {
            const std::lock_guard lock(ending_);
            ended_ = true;
        }
        end_.notify_all();
        watcher_.join();
        delete dead_.load();
        delete fresh_.load();
    }
    OverlaidMouse(const OverlaidMouse&) = delete;
    OverlaidMouse& operator=(const OverlaidMouse&) = delete;

    State read(HapticSample& sample, double dt) noexcept override {
        const State state = mouse_->read(sample, dt);
        sample.has_overlay = false;
        if (overlay_ == nullptr) overlay_.reset(fresh_.exchange(nullptr));
        if (overlay_ == nullptr) return state;
        const Overlay::State told = overlay_->read(sample.overlay);
        sample.has_overlay = told == Overlay::State::sample;
        if (told == Overlay::State::gone) dead_.store(overlay_.release());
        return state;
    }
    bool push(const Point3& force) noexcept override { return mouse_->push(force); }
    bool reopen(std::string& why) override { return mouse_->reopen(why); }
    void let_go() noexcept override { mouse_->let_go(); }
    bool is_real() const override { return mouse_->is_real(); }

private:
    void watch() {
        bool missing = false;
        std::unique_lock lock(ending_);
        while (!end_.wait_for(lock, kAgain, [this] { return ended_; })) {
            if (const std::unique_ptr<Overlay> gone(dead_.exchange(nullptr)); gone != nullptr) {
                missing = true;
                lock.unlock();
                told_(false);
                lock.lock();
            }
            if (!missing) continue;
            try {
                std::unique_ptr<Overlay> back = open_();
                lock.unlock();
                told_(true);
                lock.lock();
                fresh_.store(back.release());
                missing = false;
            } catch (const std::exception&) {
                // Not yet.
            }
        }
    }

    std::unique_ptr<HapticDevice> mouse_;
    std::function<std::unique_ptr<Overlay>()> open_;
    std::function<void(bool)> told_;
    std::unique_ptr<Overlay> overlay_;      // of the ticks
    std::atomic<Overlay*> dead_{nullptr};   // from the ticks to the watcher
    std::atomic<Overlay*> fresh_{nullptr};  // from the watcher to the ticks
    std::mutex ending_;
    std::condition_variable end_;
    bool ended_ = false;
    std::thread watcher_;  // the last, as it needs the others
};

}  // namespace

std::unique_ptr<HapticDevice> mouse_with_overlay(std::unique_ptr<HapticDevice> mouse,
                                                 std::function<std::unique_ptr<Overlay>()> open,
                                                 std::function<void(bool there)> told) {
    return std::make_unique<OverlaidMouse>(std::move(mouse), std::move(open), std::move(told));
}

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/sensing/touch_overlay.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/units.h"

namespace tactics {

namespace {

constexpr int kMostFrames = 256;                     // taken in one tick
constexpr double kSmallest = 10, kLargest = 10'000;  // mm, of a field
// The possible movement of a finger since it was seen: a contact farther away is another one, as long as the finger is not seen.
constexpr double kNear = 20;            // mm
constexpr double kFastestFinger = 500;  // mm/s
// The kernel reports only changes, and nothing for a resting finger: its position is repeated this long after the last report.
constexpr double kStill = 0.1;  // s

double mm_per_unit(const TouchAxis& axis, double wished, const std::string& path) {
    const double units = static_cast<double>(axis.most) - static_cast<double>(axis.least);
    if (wished > 0) return wished / units;
    if (!(axis.per_mm > 0))
        throw Error(Fault::failed, path,
                    phrase("the overlay does not tell how large it is; measure the field that it sees, and give its width and "
                           "height: {0} 600x340mm",
                           spelled("overlay-size")));
    const double size = units / axis.per_mm;
    if (size < kSmallest || size > kLargest)
        throw Error(Fault::failed, path,
                    phrase("the overlay says that one of its sides is {0} mm, which cannot be; measure the field that it sees, "
                           "and give its width and height: {1} 600x340mm",
                           numeral(size), spelled("overlay-size")));
    return 1 / axis.per_mm;
}

class TouchOverlay : public Overlay {
public:
    TouchOverlay(std::unique_ptr<TouchDevice> device, const OverlayPlace& place, const std::string& path,
                 double (*now)() noexcept)
        : device_(std::move(device)),
          now_(now),
          x_(device_->x()),
          y_(device_->y()),
          map_at_(place.map_at),
          mm_x_(mm_per_unit(x_, place.width, path)),
          mm_y_(mm_per_unit(y_, place.height, path)) {}

    State read(OverlaySample& sample) noexcept override {
        State state = State::nothing;
        TouchFrame frame;
        for (int i = 0; i < kMostFrames; ++i) {
            const TouchDevice::State told = device_->read(frame);
            if (told == TouchDevice::State::gone) return State::gone;
            if (told == TouchDevice::State::nothing) break;
            here_ = find(frame);
            if (!here_) continue;
            sample = {frame.time, last_};
            state = State::sample;
        }
        if (state == State::nothing && here_) {
            const double now = now_();
            if (now - told_ < kStill) return state;
            sample = {now, last_};
            state = State::sample;
        }
        if (state == State::sample) told_ = sample.time;
        return state;
    }

private:
    Point place_of(const TouchContact& contact) const noexcept {
        // The kernel allows values outside the range, even 2^31 units.
        return {(static_cast<double>(contact.x) - x_.least) * mm_x_ - map_at_.x,
                (static_cast<double>(contact.y) - y_.least) * mm_y_ - map_at_.y};
    }

    bool find(const TouchFrame& frame) noexcept {
        const auto contacts = frame.contacts;
        if (contacts.empty()) {
            seen_ = false;
            return false;
        }
        const auto found = std::min_element(contacts.begin(), contacts.end(), [&](const TouchContact& a, const TouchContact& b) {
            return seen_ ? distance(place_of(a), last_) < distance(place_of(b), last_) : a.order > b.order;
        });
        const Point at = place_of(*found);
        const bool same = seen_ && found->order == order_;
        if (seen_ && !same && distance(at, last_) > kNear + kFastestFinger * std::max(0.0, frame.time - time_)) return false;
        seen_ = true;
        order_ = found->order;
        last_ = at;
        time_ = frame.time;
        return true;
    }

    std::unique_ptr<TouchDevice> device_;
    double (*now_)() noexcept;
    TouchAxis x_, y_;
    Point map_at_;
    double mm_x_, mm_y_;
    bool here_ = false;  // it is among what is down now
    bool seen_ = false;  // the finger, and then:
    Point last_;
    double time_ = 0;
    std::uint64_t order_ = 0;
    double told_ = 0;
};

}  // namespace

std::unique_ptr<Overlay> touch_overlay(std::unique_ptr<TouchDevice> device, const OverlayPlace& place, const std::string& path,
                                       double (*now)() noexcept) {
    return std::make_unique<TouchOverlay>(std::move(device), place, path, now);
}

}  // namespace tactics

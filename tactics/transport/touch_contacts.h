// SPDX-License-Identifier: Apache-2.0
// Which contacts are on a touch device, by the events that the kernel sends of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tactics {

struct TouchContact {
    int x = 0, y = 0;         ///< in the units of its axes
    std::uint64_t order = 0;  ///< the higher, the later it came down
};

/// The kernel's protocol B: each contact has a slot, and only changes of a slot are reported, even from one contact to the next
/// in it. Accepts any numbers; nothing allocates.
class TouchContacts {
public:
    void slot(int number) noexcept { slot_ = number; }
    /// For the slot: a contact comes down, or (-1) goes up. A different number without -1 before it is a new contact.
    void tracking(int id) noexcept {
        if (!has_slot()) return;
        Slot& slot = slots_[static_cast<std::size_t>(slot_)];
        if (id >= 0 && id != slot.id) slot.order = ++newest_;
        slot.id = id < 0 ? -1 : id;
    }
    void x(int value) noexcept {
        if (has_slot()) slots_[static_cast<std::size_t>(slot_)].x = value;
    }
    void y(int value) noexcept {
        if (has_slot()) slots_[static_cast<std::size_t>(slot_)].y = value;
    }
    /// Those that are down now. Holds until the next call.
    std::span<const TouchContact> down() noexcept {
        std::size_t count = 0;
        for (const Slot& slot : slots_)
            if (slot.id >= 0) down_[count++] = {slot.x, slot.y, slot.order};
        return std::span(down_).first(count);
    }

    static constexpr int kMost = 64;  ///< slots; events of further slots are ignored

private:
    struct Slot {
        int id = -1, x = 0, y = 0;
        std::uint64_t order = 0;
    };
    bool has_slot() const noexcept { return slot_ >= 0 && slot_ < kMost; }

    std::array<Slot, kMost> slots_{};
    std::array<TouchContact, kMost> down_{};
    int slot_ = 0;
    std::uint64_t newest_ = 0;
};

}  // namespace tactics

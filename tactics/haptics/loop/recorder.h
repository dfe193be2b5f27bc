// SPDX-License-Identifier: Apache-2.0
// What was felt, tick by tick: kept in memory that was taken before the first.
#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

#include "tactics/haptics/sensing/fusion.h"
#include "tactics/point3.h"

namespace tactics {

struct TickRecord {
    double time = 0;         ///< s since the first
    Point at;                ///< of the fingertip, mm
    double finger = 0;       ///< its height, mm
    double surface = 0;      ///< height of the map there, mm
    double reference = 0;    ///< what the force follows, mm
    Point3 force;            ///< N
    Point truth = kNoPlace;  ///< where the fingertip truly was, mm
};

/// A ring: when it is full the oldest go. One thread adds; another may look meanwhile, as long as it keeps within `most` of what
/// is added.
class Recorder {
public:
    explicit Recorder(std::size_t most) : records_(most) {}
    void add(const TickRecord& record) noexcept;
    std::size_t most() const noexcept { return records_.size(); }
    std::size_t added() const noexcept { return added_.load(std::memory_order_acquire); }
    /// The one that was added as number `index`, from 0.
    const TickRecord& at(std::size_t index) const noexcept { return records_[index % records_.size()]; }
    std::vector<TickRecord> records() const;  ///< those that are left, the oldest first
    bool lost() const noexcept { return added() > records_.size(); }

private:
    std::vector<TickRecord> records_;
    std::atomic<std::size_t> added_ = 0;
};

/// What a log tells besides what all have.
struct TickColumns {
    bool truth = false;    ///< where the finger truly was: true_x_mm,true_y_mm
    bool spatial = false;  ///< the whole force: force_x_n,force_y_n
};
/// A header line: time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n (that upwards), and what else is told.
std::string csv_header(const TickColumns& columns);
/// And a line for each tick, added to `text`.
void add_csv(std::string& text, const TickRecord& record, const TickColumns& columns);

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
// Records what was felt, tick by tick, in memory reserved before the first tick.
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
    double reference = 0;    ///< reference of the force, mm
    Point3 force;            ///< N
    Point truth = kNoPlace;  ///< true position of the fingertip, mm
};

/// A ring: when it is full, the oldest records are overwritten. One thread adds; another may read at the same time, as long as it
/// stays within `most` of the newest.
class Recorder {
public:
    explicit Recorder(std::size_t most) : records_(most) {}
    void add(const TickRecord& record) noexcept;
    std::size_t most() const noexcept { return records_.size(); }
    std::size_t added() const noexcept { return added_.load(std::memory_order_acquire); }
    /// The record number `index`, from 0, in order of adding.
    const TickRecord& at(std::size_t index) const noexcept { return records_[index % records_.size()]; }
    std::vector<TickRecord> records() const;  ///< the records still there, the oldest first
    bool lost() const noexcept { return added() > records_.size(); }

private:
    std::vector<TickRecord> records_;
    std::atomic<std::size_t> added_ = 0;
};

/// Optional columns of a log.
struct TickColumns {
    bool truth = false;    ///< true position of the finger: true_x_mm,true_y_mm
    bool spatial = false;  ///< the whole force: force_x_n,force_y_n
};
/// A header line: time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n (upwards), and the optional columns.
std::string csv_header(const TickColumns& columns);
/// Appends a line for each tick to `text`.
void add_csv(std::string& text, const TickRecord& record, const TickColumns& columns);

}  // namespace tactics

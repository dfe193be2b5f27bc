// What was felt, tick by tick: kept in memory that was taken before the first, written when all is over.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tactics/haptics/fusion.h"

namespace tactics {

struct TickRecord {
    double time = 0;       ///< s since the first
    Point at;              ///< of the fingertip, mm
    double finger = 0;     ///< its height, mm
    double surface = 0;    ///< height of the map there, mm
    double reference = 0;  ///< what the force follows, mm
    double force = 0;      ///< N, upwards
    Point truth = kNowhere;  ///< where the fingertip truly was, mm
};

/// A ring: when it is full the oldest go.
class Recorder {
public:
    explicit Recorder(std::size_t most) : records_(most) {}
    void add(const TickRecord& record) noexcept;
    std::vector<TickRecord> records() const;  ///< the oldest first
    bool lost() const noexcept { return added_ > records_.size(); }

private:
    std::vector<TickRecord> records_;
    std::size_t added_ = 0;
};

/// A header line and a line for each: time_s,x_mm,y_mm,finger_mm,surface_mm,reference_mm,force_n, and true_x_mm,true_y_mm where `at` was
/// put together from sensors of which the truth is known.
std::string csv_of(const std::vector<TickRecord>& records);
/// Whether the truth of some record is known, and another than what was told.
bool tells_truth(const std::vector<TickRecord>& records) noexcept;

}  // namespace tactics

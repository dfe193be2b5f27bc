// SPDX-License-Identifier: Apache-2.0
// Positions of a braille display's cells in the reports sent to it, and of its keys in the reports received, from its report
// descriptor (HID 1.11, 6.2.2; HID Usage Tables 1.4, page 41h). Reliable for one row, as in the drivers of screen readers;
// several rows are read by the standard, one collection each, and were not tested on a device.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

namespace tactics {

struct BrailleReports {
    struct Line {
        int report = 0;         ///< its id; 0: reports have none
        std::size_t begin = 0;  ///< bytes of the report before it, without the id
    };
    std::vector<Line> lines;  ///< empty: it is no display of whole bytes for cells
    int columns = 0;          ///< of every line
    int dots = 8;
    struct Bits {
        std::size_t begin = 0, end = 0;  ///< of the report without its id, from the lowest of its first byte
    };
    std::map<int, std::vector<Bits>> keys;  ///< a bit each, by the report that the display sends
    std::map<int, std::size_t> sizes;       ///< of each report that has lines, in bytes without the id
    bool numbered = false;                  ///< reports begin with their id, those from the device as well
};

/// Accepts any bytes. A line is a contiguous part of a row in a report; without rows, any contiguous part. If lines differ in
/// length, the longest ones form the display; the others show its status.
BrailleReports braille_reports(std::span<const std::uint8_t> descriptor);

/// Follows which keys are down.
class KeyWatch {
public:
    explicit KeyWatch(const BrailleReports& reports) : keys_(reports.keys), numbered_(reports.numbered) {}
    /// Whether none was down before and one is now. `report` is as the display sent it, with its id if it has one.
    bool pressed(std::span<const std::uint8_t> report);

private:
    std::map<int, std::vector<BrailleReports::Bits>> keys_;
    bool numbered_;
    std::set<int> down_;  // reports
};

}  // namespace tactics

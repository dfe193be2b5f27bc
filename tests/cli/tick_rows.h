// SPDX-License-Identifier: Apache-2.0
// What play --csv has written, read by a reader of the tests' own.
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace tactics::tests {

/// The numbers of each line below the first.
inline std::vector<std::vector<double>> tick_rows(const std::string& csv) {
    std::vector<std::vector<double>> ticks;
    std::istringstream rows(csv);
    std::string row;
    std::getline(rows, row);
    while (std::getline(rows, row)) {
        std::istringstream cells(row);
        ticks.emplace_back();
        for (std::string cell; std::getline(cells, cell, ',');) ticks.back().push_back(std::stod(cell));
    }
    return ticks;
}

}  // namespace tactics::tests

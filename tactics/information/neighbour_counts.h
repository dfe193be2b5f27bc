// SPDX-License-Identifier: Apache-2.0
// What is counted of a grid for codes that look at the cells around each: the exact values of neighbours, and errors of
// prediction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tactics/information/adaptive_code.h"
#include "tactics/information/counted_rows.h"
#include "tactics/information/grid.h"

namespace tactics {

/// The values that occur, numbered from 0: a picture of two greys is a picture of two levels.
struct Ranks {
    std::vector<std::uint16_t> of;
    int levels = 0;
    double bits = 0;  ///< to say which occur
};
/// `seen`: how often each level is in the grid.
Ranks ranks_of(const std::vector<std::uint64_t>& seen);

/// How an error of prediction, modulo the levels, is counted: its class, and how many bits tell where in that it is.
struct ErrorClasses {
    std::vector<std::uint16_t> of;
    std::vector<int> rest;  ///< bits, of each class
};

/// What is counted of a part of the rows; parts are added up.
struct NeighbourCounts {
    std::vector<std::uint32_t> near;    ///< by the neighbours, the nearest counting least, then by the value
    std::vector<std::uint32_t> errors;  ///< by roughness, then by class

    void add(const NeighbourCounts& other);
};

/// A neighbour that comes before: so many rows up, 3 the row of the slice before, and columns to the side.
struct Neighbour {
    int up, aside;
};

class NeighbourCounting {
public:
    /// All must outlive it.
    NeighbourCounting(const CountedRows& rows, const Ranks& ranks);

    std::size_t neighbours() const { return neighbours_.size(); }
    std::size_t levels() const { return levels_; }
    const ErrorClasses& classes() const { return classes_; }

    /// In two threads from a million cells on, with the same result.
    NeighbourCounts count_all() const;

    /// Tells, row by row, what the counter of each cell of these rows that counts costs: of the values behind so many neighbours,
    /// or of the errors.
    void tell_near_costs(std::span<const float> costs, std::size_t used, std::span<const RowRange> parts,
                         const TakeCosts& take) const;
    void tell_error_costs(std::span<const float> costs, std::span<const RowRange> parts, const TakeCosts& take) const;

    /// The row as numbers of its levels. `to` has room for the columns.
    void load(std::uint16_t* to, std::size_t row) const;
    /// So many columns from `first` on, each from the top, one after the other; of one slice and at most 256 levels.
    void load_columns(std::uint8_t* to, std::size_t first, std::size_t count) const;

private:
    template <typename Take>
    void walk(RowRange part, const Take& take) const;
    NeighbourCounts count(RowRange part) const;
    void choose_the_one();
    void find_places(const std::uint16_t* const (&rows)[4], std::uint16_t* places) const;
    template <std::size_t kUsed, typename Take>
    void each_near(const std::uint16_t* const (&rows)[4], std::size_t used, const Take& take) const;

    const CountedRows& rows_;
    const LevelGrid& grid_;
    const Ranks& ranks_;
    std::size_t levels_;
    ErrorClasses classes_;
    std::span<const Neighbour> neighbours_;
};

}  // namespace tactics

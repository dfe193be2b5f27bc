// SPDX-License-Identifier: Apache-2.0
// What information is measured on: whole numbers on a grid. Pictures, height maps, pages of dots, a component of forces on
// voxels, and a component of a recorded stream, which is one row.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "tactics/image.h"
#include "tactics/point3.h"
#include "tactics/relief/heightmap.h"

namespace tactics {

inline constexpr int kMostLevels = 65536;

/// Whole numbers in order: bytes where nobody needs more, so that a picture stays as it was read.
class Cells {
public:
    Cells() = default;
    Cells(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}
    Cells(std::vector<std::uint16_t> words) : words_(std::move(words)) {}
    Cells(std::initializer_list<std::uint16_t> words) : words_(words) {}

    std::size_t size() const { return std::max(bytes_.size(), words_.size()); }
    std::uint16_t operator[](std::size_t i) const { return words_.empty() ? bytes_[i] : words_[i]; }
    /// Calls `work` with a pointer to the first, of either kind.
    template <typename Work>
    decltype(auto) visit(const Work& work) const {
        return words_.empty() ? work(bytes_.data()) : work(words_.data());
    }
    bool operator==(const Cells& other) const;

private:
    std::vector<std::uint8_t> bytes_;
    std::vector<std::uint16_t> words_;
};

/// Row by row from the top, slice by slice. Each value is below `levels`.
struct LevelGrid {
    int columns = 0, rows = 0, slices = 1;
    int levels = 256;  ///< 2 to kMostLevels
    Cells values;

    std::size_t count() const { return values.size(); }
};

/// Rows of all slices, from the first up to, not with, the second.
using RowRange = std::pair<std::size_t, std::size_t>;

/// Along x, y and z: 0, 1 and 2.
inline double component(const Point3& force, int index) { return index == 0 ? force.x : index == 1 ? force.y : force.z; }

/// Throws std::logic_error: sizes or values that do not fit each other.
void check_grid(const LevelGrid& grid);

/// cells * log2(levels): what can be written on it at all (equation 2 of K. Moustakas, "Handling haptics as a stand-alone
/// medium", WSCG 2013, for values that are all as likely: 5 x 5 x 5 voxels of 256 levels are 1000 bits).
double raw_bits(double cells, double levels);
double raw_bits(const LevelGrid& grid);

/// Grey as it is, 256 levels.
LevelGrid grid_of(Image grey);
/// Heights from `low` to `high` (over it, mm) in so many levels; what is outside is cut. Throws Error(failed): one of them is not
/// a number, and no sample. `name` is the file's, for messages.
LevelGrid grid_of(const HeightMap& map, double low, double high, int levels, std::string_view name);

/// The levels put together into fewer, each of as many neighbours as evenly as it goes. With as many or more, the grid as it is.
LevelGrid with_levels(const LevelGrid& grid, int levels);

/// Forces on the corners of a lattice of voxels, N; between them the force is trilinear (section 3.1 of the paper).
struct ForceField {
    int columns = 0, rows = 0, slices = 0;
    double pitch = 1;            ///< mm, from one to the next; the first is at the origin
    std::vector<Point3> forces;  ///< row by row, slice by slice

    /// What is outside has the force of the nearest place inside. N.
    Point3 at(const Point3& place) const;
};

/// The same space sampled elsewhere: at so many places along each axis, from the first voxel to the last.
ForceField resampled(const ForceField& field, int columns, int rows, int slices);

/// A component from -most to most (N) in so many levels, the middle one of them zero where they are odd. Components are 0, 1, 2.
/// Throws Error(failed): no sample, or a force that is not a number.
LevelGrid component_of(const ForceField& field, int component, double most, int levels, std::string_view name);
/// The same of a recorded stream, a sample after the other.
LevelGrid component_of(std::span<const Point3> stream, int component, double most, int levels, std::string_view name);

}  // namespace tactics

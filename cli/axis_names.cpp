#include "cli/axis_names.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tactics {

void place_axis_names(std::vector<PrintPlace>& places, double width) {
    for (PrintPlace& name : places) {
        if (!name.upwards) continue;
        std::optional<Point> top;
        std::size_t above = 0, below = 0;
        for (const PrintPlace& other : places) {
            if (other.upwards || std::abs(other.at.x - name.at.x) > width / 4) continue;
            ++(other.at.y < name.at.y ? above : below);
            if (!top || other.at.y < top->y) top = other.at;
        }
        // An axis has numbers on both sides of the middle, where its name is.
        if (above > 0 && below > 0) name.at = {(name.at.x + top->x) / 2, top->y - 2 * name.height};
    }
    for (PrintPlace& name : places) {
        if (name.upwards || name.number) continue;
        // Print stands 1.5 to 3 letters below the numbers; braille of that size in print would need about twice that.
        constexpr double kNear = 3, kLower = 2;
        const auto numbers = std::count_if(places.begin(), places.end(), [&](const PrintPlace& other) {
            const double down = name.at.y - other.at.y;
            return other.number && down > 0 && down < kNear * name.height;
        });
        constexpr int kRow = 3;
        if (numbers >= kRow) name.at.y += kLower * name.height;
    }
    for (PrintPlace& one : places) one.at.y = std::max(one.at.y, 0.0);
}

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tactics/repair/repair.h"
#include "tactics/units.h"

namespace tactics {

namespace {

std::string tenths(double mm) { return to_text(std::round(mm * 10) / 10) + " mm"; }

}  // namespace

std::vector<std::string> notes_of(const Repaired& repaired) {
    std::vector<std::string> notes;
    // "2 ends of lines were ..."; `what` for one, `many` for more.
    const auto tell = [&](Mend::Kind kind, std::string_view one, std::string_view many, std::string_view amount) {
        std::size_t count = 0;
        double most = 0, sum = 0;
        for (const Mend& change : repaired.changes)
            if (change.kind == kind) {
                ++count;
                most = std::max(most, change.mm);
                sum += change.mm;
            }
        if (count == 0) return;
        std::string text = std::to_string(count) + " " + std::string(count == 1 ? one : many);
        if (amount == "most") text += tenths(most);
        if (amount == "sum") text += tenths(sum);
        notes.push_back(text + (amount == "sum" && count > 1 ? " together." : "."));
    };
    using Kind = Mend::Kind;
    tell(Kind::joined, "end of a line was led onto the line that it nearly met, by ",
         "ends of lines were led onto the lines that they nearly met, by up to ", "most");
    tell(Kind::moved, "line was bent away from another that was too close, by up to ",
         "lines were bent away from others that were too close, by up to ", "most");
    tell(Kind::outlined, "area is drawn as its outline, being too close to another or too black",
         "areas are drawn as their outlines, being too close to others or too black", "");
    tell(Kind::merged, "line that ran along another was left out there, for ",
         "lines that ran along others were left out there, for ", "sum");
    tell(Kind::broken, "gap was left in a line where another comes near or crosses, ",
         "gaps were left in lines where others come near or cross, ", "sum");
    tell(Kind::shortened, "line was shortened, by ", "ends of lines were shortened, by ", "sum");
    tell(Kind::left_out, "line or area too close to others was left out, ", "lines or areas too close to others were left out, ",
         "sum");
    return notes;
}

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "tactics/repair/repair.h"
#include "tactics/text/phrase.h"

namespace tactics {

namespace {

Phrase tenths(double mm) { return phrase("{0} mm", numeral(std::round(mm * 10) / 10)); }

struct Sum {
    std::size_t count = 0;
    Phrase most, all;  // mm
};

Sum sum_of(const Repaired& repaired, Mend::Kind kind) {
    Sum sum;
    double most = 0, all = 0;
    for (const Mend& change : repaired.changes)
        if (change.kind == kind) {
            ++sum.count;
            most = std::max(most, change.mm);
            all += change.mm;
        }
    sum.most = tenths(most);
    sum.all = tenths(all);
    return sum;
}

}  // namespace

std::vector<Phrase> notes_of(const Repaired& repaired) {
    std::vector<Phrase> notes;
    using Kind = Mend::Kind;
    const auto tell = [&](Kind kind, auto words) {
        if (const Sum sum = sum_of(repaired, kind); sum.count > 0) notes.push_back(words(sum));
    };
    tell(Kind::joined, [](const Sum& s) {
        return phrases(s.count, "{0} end of a line was led onto the line that it nearly met, by {1}.",
                       "{0} ends of lines were led onto the lines that they nearly met, by up to {1}.", s.most);
    });
    tell(Kind::moved, [](const Sum& s) {
        return phrases(s.count, "{0} line was bent away from another that was too close, by up to {1}.",
                       "{0} lines were bent away from others that were too close, by up to {1}.", s.most);
    });
    tell(Kind::shifted, [](const Sum& s) {
        return phrases(s.count, "{0} point or small area was moved away from another that was too close, by {1}.",
                       "{0} points or small areas were moved away from others that were too close, by up to {1}.", s.most);
    });
    tell(Kind::shrunk, [](const Sum& s) {
        return phrases(s.count, "{0} point or small area was drawn smaller, as others were too close, by {1}.",
                       "{0} points or small areas were drawn smaller, as they were too close, by up to {1}.", s.most);
    });
    tell(Kind::enlarged, [](const Sum& s) {
        return phrases(s.count, "{0} point or small area was drawn larger, as large as a braille dot.",
                       "{0} points or small areas were drawn larger, as large as a braille dot.");
    });
    tell(Kind::outlined, [](const Sum& s) {
        return phrases(s.count, "{0} area is drawn as its outline, being too close to another or too black.",
                       "{0} areas are drawn as their outlines, being too close to others or too black.");
    });
    tell(Kind::merged, [](const Sum& s) {
        return phrases(s.count, "{0} line that ran along another was left out there, for {1}.",
                       "{0} lines that ran along others were left out there, for {1} together.", s.all);
    });
    tell(Kind::broken, [](const Sum& s) {
        return phrases(s.count, "{0} gap was left in a line where another comes near or crosses, {1}.",
                       "{0} gaps were left in lines where others come near or cross, {1} together.", s.all);
    });
    tell(Kind::shortened, [](const Sum& s) {
        return phrases(s.count, "{0} line was shortened, by {1}.", "{0} ends of lines were shortened, by {1} together.", s.all);
    });
    tell(Kind::left_out, [](const Sum& s) {
        return phrases(s.count, "{0} line or area too close to others was left out, {1}.",
                       "{0} lines or areas too close to others were left out, {1} together.", s.all);
    });
    tell(Kind::crowded, [](const Sum& s) {
        return phrases(s.count, "{0} point was left out, as it has no room beside others.",
                       "{0} points were left out, as they have no room beside others.");
    });
    return notes;
}

}  // namespace tactics

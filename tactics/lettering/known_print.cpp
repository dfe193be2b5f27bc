// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/known_print.h"

#include <algorithm>

namespace tactics {

bool is_doubtful(const ReadLine& line) { return !line.words.sure && !line.tell; }

KnownPrint known_print(const std::vector<ReadLine>& lines) {
    KnownPrint known;
    for (const bool likely : {false, true}) {
        if (!known.empty()) break;
        for (const ReadLine& one : lines)
            if (likely ? one.likely : !is_doubtful(one)) known.push_back(&one.line);
    }
    return known;
}

bool as_large_as_print(const MarkShape& shape, const KnownPrint& known) {
    return std::any_of(known.begin(), known.end(), [&](const LetteringLine* other) {
        const double height = other->letter_height;
        return is_words(*other) && shape.side >= kLeastOfKnown * height && shape.side <= kMostOfKnown * height;
    });
}

}  // namespace tactics

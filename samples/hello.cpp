// SPDX-License-Identifier: Apache-2.0
// A page of a photograph through the library:   hello photo.jpg photo.pdf
#include <iostream>

#include "tactics/job/make_pages.h"

int main(int count, char** words) {
    if (count != 3) return 1;
    tactics::Job job;
    job.input = words[1];
    job.outputs = {tactics::output_to(words[2])};
    const tactics::Outcome outcome = tactics::make_pages(job);
    for (const tactics::Note& note : outcome.notes) std::cerr << note.english() << "\n";
    if (!outcome.error.empty()) std::cerr << outcome.error.english() << "\n";
    return outcome.error.empty() ? 0 : 1;
}

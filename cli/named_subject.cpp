// SPDX-License-Identifier: Apache-2.0
#include "cli/named_subject.h"

namespace tactics {

SubjectWish subject_value(const Given& given) {
    SubjectWish wish;
    for (const std::string& text : given.all("--subject")) add_subject(wish, text, "--subject", "it");
    for (const std::string& text : given.all("--leave")) add_leave(wish, text, "--leave", "it");
    if (given.has("--subject-only")) set_only(wish, "--subject-only");
    return wish;
}

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
// The parts of a picture that matter to the user.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tactics/recipe.h"
#include "tactics/spot.h"

namespace tactics {

struct SubjectWish {
    std::vector<Spot> subject;
    std::vector<Spot> leave;
    bool only = false;
    std::string subject_place, leave_place, only_place;  ///< where each was first given: "--subject", "map.labels:3"

    bool empty() const { return subject.empty() && leave.empty() && !only; }
};

/// Equal wishes, wherever they were given.
bool same_wish(const SubjectWish& a, const SubjectWish& b);

/// Adds subject places such as "20%,30%-70%,90%", or boxes to leave out. `place` says where they were given, for messages; `what`
/// begins the message. Throws Error(usage).
void add_subject(SubjectWish& wish, std::string_view text, const std::string& place, std::string_view what);
void add_leave(SubjectWish& wish, std::string_view text, const std::string& place, std::string_view what);
void set_only(SubjectWish& wish, const std::string& place);

/// Whether a line of a label file is about the subject: "subject 20%,30%-70%,90%", "leave 0%,0%-10%,10%" or "subject-only".
bool is_subject_line(std::string_view line);
/// Adds the contents of such a line. Throws Error(usage) at `origin`.
void add_subject_line(SubjectWish& wish, std::string_view line, const std::string& origin);

/// Throws Error(usage) if only the subject is wanted and none is named.
void check_subject(const SubjectWish& wish);

/// The recipe with the wish in its filter outlines. Throws Error(usage) if it has none, and as check_subject does.
Recipe with_subject(Recipe recipe, const SubjectWish& wish);

}  // namespace tactics

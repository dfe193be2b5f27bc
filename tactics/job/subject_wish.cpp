// SPDX-License-Identifier: Apache-2.0
#include "tactics/job/subject_wish.h"

#include <algorithm>

#include "tactics/error.h"
#include "tactics/text/words.h"

namespace tactics {

namespace {

constexpr std::string_view kOutlines = "outlines";  // the filter that draws a subject

std::vector<Spot> boxes_of(std::string_view text, std::string_view place, std::string_view what) {
    std::vector<Spot> boxes = parse_spots(text, place, what);
    for (const Spot& box : boxes)
        if (!box.is_box())
            throw Error(Fault::usage, place,
                        phrase("\"{0}\" is a point; what is left out is a box such as 20%,30%-70%,90%", to_text(box)));
    return boxes;
}

void append(std::vector<Spot>& to, std::string& first_place, const std::vector<Spot>& spots, const std::string& place) {
    to.insert(to.end(), spots.begin(), spots.end());
    if (to.size() > kMostSpots)
        throw Error(Fault::usage, place, phrase("these are over {0} places; name fewer", std::to_string(kMostSpots)));
    if (first_place.empty()) first_place = place;
}

std::string_view first_word(std::string_view line) { return line.substr(0, line.find_first_of(kBlanks)); }

}  // namespace

void add_subject(SubjectWish& wish, std::string_view text, const std::string& place, std::string_view what) {
    const std::vector<Spot> spots = parse_spots(text, place, what);
    if (spots.empty())
        throw Error(Fault::usage, place, phrase("the place is missing; a box is 20%,30%-70%,90%, a point 40%,50%"));
    append(wish.subject, wish.subject_place, spots, place);
}

void add_leave(SubjectWish& wish, std::string_view text, const std::string& place, std::string_view what) {
    const std::vector<Spot> boxes = boxes_of(text, place, what);
    if (boxes.empty()) throw Error(Fault::usage, place, phrase("the box is missing; write for example 20%,30%-70%,90%"));
    append(wish.leave, wish.leave_place, boxes, place);
}

void set_only(SubjectWish& wish, const std::string& place) {
    if (!wish.only) wish.only_place = place;
    wish.only = true;
}

bool same_wish(const SubjectWish& a, const SubjectWish& b) {
    return a.subject == b.subject && a.leave == b.leave && a.only == b.only;
}

bool is_subject_line(std::string_view line) {
    const std::string_view word = first_word(line);
    return word == "subject" || word == "leave" || word == "subject-only";
}

void add_subject_line(SubjectWish& wish, std::string_view line, const std::string& origin) {
    const std::string_view word = first_word(line);
    std::string_view rest = line.substr(word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    if (word == "subject-only") {
        if (!rest.empty())
            throw Error(Fault::usage, origin,
                        phrase("subject-only stands alone on its line; write the place as subject 20%,30%-70%,90%"));
        set_only(wish, origin);
    } else if (word == "leave") {
        add_leave(wish, rest, origin, word);
    } else {
        add_subject(wish, rest, origin, word);
    }
}

void check_subject(const SubjectWish& wish) {
    if (wish.only && wish.subject.empty())
        throw Error(Fault::usage, wish.only_place,
                    phrase("no subject is named; add for example {0} 20%,30%-70%,90%, a box around it", spelled("subject")));
}

Recipe with_subject(Recipe recipe, const SubjectWish& wish) {
    check_subject(wish);
    if (wish.empty()) return recipe;
    bool found = false;
    for (Step& step : recipe.steps) {
        if (step.filter->name != kOutlines) continue;
        if (!wish.subject.empty()) step.settings.set("subject", to_text(wish.subject), wish.subject_place, kOutlines);
        if (!wish.leave.empty()) step.settings.set("leave", to_text(wish.leave), wish.leave_place, kOutlines);
        if (wish.only) step.settings.set("only", "yes", wish.only_place, kOutlines);
        found = true;
    }
    if (!found)
        throw Error(
            Fault::usage, wish.subject.empty() ? wish.leave_place : wish.subject_place,
            wish.subject.empty()
                ? phrase("recipe {0} has no filter outlines, which leaves boxes out; use {1} photo, without {2} contours",
                         recipe.name, spelled("recipe"), spelled("detail"))
                : phrase("recipe {0} has no filter outlines, which draws the subject; use {1} photo, without {2} contours",
                         recipe.name, spelled("recipe"), spelled("detail")));
    return recipe;
}

}  // namespace tactics

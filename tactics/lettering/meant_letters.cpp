// SPDX-License-Identifier: Apache-2.0
#include "tactics/lettering/meant_letters.h"

#include <algorithm>
#include <vector>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr char32_t kGreek = 0x370;    // with what follows, such as signs of formulas
constexpr double kSureAccent = 0.88;  // likeness of a letter with one. A setting

bool is_accented_i(char32_t code) { return (code >= 0xCC && code <= 0xCF) || (code >= 0xEC && code <= 0xEF); }

std::vector<char32_t> bare_letters_of(std::string_view text) {
    std::vector<char32_t> letters;
    while (!text.empty())
        if (const char32_t letter = take_letter(text); letter != ' ') letters.push_back(is_dash(letter) ? U'-' : letter);
    return letters;
}

char32_t plain_raised(char32_t code) {
    switch (code) {
        case 0xB2: return '2';
        case 0xB3: return '3';
        case 0xB9: return '1';
        case 0x207B: return '-';
        default: return code >= 0x2070 && code <= 0x2089 ? '0' + (code & 0xF) : code;
    }
}

// Which of letters that look the same stands between those.
char32_t fitting(const std::vector<char32_t>& choices, char32_t before, char32_t after) {
    const auto all = [&](auto is) {
        return (before == 0 || is(before)) && (after == 0 || is(after)) && (before != 0 || after != 0);
    };
    const auto only = [&](auto is) -> char32_t {
        const auto count = std::count_if(choices.begin(), choices.end(), is);
        return count == 1 ? *std::find_if(choices.begin(), choices.end(), is) : 0;
    };
    if (all(is_digit)) return only(is_digit);
    if (all(is_lower)) return only(is_lower);
    if (before == 0 && after != 0 && is_lower(after)) return only(is_upper);
    if (all(is_upper)) return only(is_upper);
    // After its beginning, a word continues in lower case.
    if (before != 0 && (is_lower(before) || is_upper(before)) && (after == 0 || is_lower(after))) return only(is_lower);
    return 0;
}

// I and l look the same in many fonts, and other readers guess. A word begins with a vowel or goes on with one: "Income" and
// "level"; before an o it may be either, as in "Iowa" and "low", and short words are "ln" and "lbs", too. 0: there is no telling.
// But for "Is", "It" and "If".
char32_t first_of_word(char32_t told, char32_t next, bool is_long) {
    constexpr std::u32string_view kVowels = U"aeiuy", kEndShort = U"stf";
    if (kVowels.find(next) != kVowels.npos) return told == 'l' ? 'l' : 0;
    return next != 'o' && (is_long || kEndShort.find(next) != kEndShort.npos) && told == 'I' ? 'I' : 0;
}

// "lron": no word of three letters and more begins with l and another consonant but "ll" and "lbs".
bool is_no_beginning(char32_t first, char32_t next, char32_t third) {
    constexpr std::u32string_view kGoOn = U"aeiouylAEIOUYL";
    const bool pounds = next == 'b' && third == 's';
    return first == 'l' && is_lower(next) && next < 0x80 && is_lower(third) && kGoOn.find(next) == kGoOn.npos && !pounds;
}

// And if a vowel follows, it is an I that another reader took for an l: "Iron" and "Ice", but there is "lcm", too.
bool begins_with_capital_i(char32_t told, char32_t next, char32_t third) {
    constexpr std::u32string_view kVowels = U"aeiouy";
    return is_no_beginning(told, next, third) && kVowels.find(third) != kVowels.npos;
}

// Words of two letters are "If", "In", "Is" and "It"; others that begin so are "lb", "ln" and "lx". Before a bracket it is "ln",
// too. Of those of three only "lbs" has no vowel.
bool is_no_short_word(char32_t first, char32_t next, char32_t behind, char32_t last) {
    constexpr std::u32string_view kWords = U"fnst";
    if (next == 'b' && behind == 's' && !is_lower(last) && !is_upper(last)) return first == 'I';
    const bool word = kWords.find(next) != kWords.npos;
    if (!is_lower(next) || is_lower(behind) || is_upper(behind)) return false;
    return first == 'I' ? !word || (next == 'n' && behind == '(') : word && next != 'n';
}

// In a text it stands before that letter, which is raised or lowered, and is none itself.
bool is_place_mark(char32_t code, const std::vector<FormLetter>& letters, std::size_t at) {
    return (code == '^' || code == '_') && at < letters.size() && letters[at].code != code;
}

// Which of its letters begin a word.
std::vector<bool> beginnings_of(const FormReading& reading) {
    std::vector<bool> begins;
    std::string_view text = reading.text;
    bool next = true;
    while (!text.empty()) {
        const char32_t code = take_letter(text);
        if (is_place_mark(code, reading.letters, begins.size())) continue;
        const bool space = code == ' ';
        if (!space) begins.push_back(next);
        next = space || code == '(' || code == '[' || code == '"';
    }
    begins.resize(reading.letters.size(), false);
    return begins;
}

// "sizeInFeet": a capital follows small letters, and here another may.
bool may_be_of_joined_words(const std::vector<FormLetter>& letters, const std::vector<bool>& begins, std::size_t at) {
    const auto is_within = [&](std::size_t i) { return i < letters.size() && !begins[i] && is_lower(letters[i].code); };
    if (at == 0 || !is_lower(letters[at - 1].code) || !is_within(at + 1)) return false;
    std::size_t first = at, end = at + 1;
    while (first > 0 && !begins[first]) --first;
    while (end < letters.size() && !begins[end]) ++end;
    for (std::size_t i = first + 1; i < end; ++i)
        if (i != at && is_lower(letters[i - 1].code) && is_upper(letters[i].code) && letters[i].code != 'I') return true;
    return false;
}

// So many letters from the beginning may be what another reader has.
std::size_t letters_in_step(const std::vector<FormLetter>& letters, const std::vector<char32_t>& told) {
    std::size_t count = 0;
    while (count < std::min(letters.size(), told.size()) && letters[count].may_be(told[count])) ++count;
    return count;
}

// What is raised follows something, and a raised minus sign stands before a raised figure; else it is something that is drawn.
bool is_raised_astray(const std::vector<FormLetter>& letters) {
    if (!letters.empty() && letters.front().place != FormLetter::Place::on_line) return true;
    for (std::size_t i = 0; i < letters.size(); ++i)
        if (is_dash(letters[i].code) && letters[i].place == FormLetter::Place::raised &&
            (i + 1 == letters.size() || letters[i + 1].place != FormLetter::Place::raised))
            return true;
    return false;
}

}  // namespace

bool is_lower(char32_t code) {
    return (code >= 'a' && code <= 'z') || (code >= 0xDF && code <= 0xFF) || (code >= 0x3B1 && code <= 0x3C9);
}
bool is_upper(char32_t code) { return (code >= 'A' && code <= 'Z') || (code >= 0xC0 && code <= 0xDE); }

bool same_letters(std::string_view a, std::string_view b) {
    std::vector<char32_t> one = bare_letters_of(a), other = bare_letters_of(b);
    for (auto* letters : {&one, &other}) std::erase(*letters, U'^');
    if (b.find('_') == b.npos) std::erase(one, U'_');  // an index
    std::transform(one.begin(), one.end(), one.begin(), plain_raised);
    std::transform(other.begin(), other.end(), other.begin(), plain_raised);
    return one == other;
}

bool same_but_for_signs(std::string_view a, std::string_view b) {
    constexpr std::size_t kLetters = 3;  // that both say
    const std::vector<char32_t> one = bare_letters_of(a), other = bare_letters_of(b);
    std::size_t same = 0;
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
        const bool within_number = is_digit(other[i]) && i + 1 < one.size() && is_digit(one[i + 1]);
        if (one[i] != other[i] && (one[i] < kGreek || within_number)) return false;
        same += one[i] == other[i] ? 1 : 0;
    }
    return one.size() == other.size() && same >= kLetters;
}

void settle(FormWords& words, const OtherReading& other) {
    std::vector<FormLetter>& letters = words.reading.letters;
    words.settled = !is_raised_astray(letters);
    const std::vector<char32_t> told = bare_letters_of(other.text);
    const std::vector<bool> begins = beginnings_of(words.reading);
    const std::size_t steps = told.size() == letters.size() ? letters.size() : letters_in_step(letters, told);
    for (std::size_t i = 0; i < letters.size(); ++i) {
        FormLetter& letter = letters[i];
        std::vector<char32_t> choices = letter.alike;
        choices.push_back(letter.code);
        // A letter with a mark that hardly shows is the plain one, and a dash is a dash.
        const bool plain = std::any_of(choices.begin(), choices.end(), [](char32_t code) { return code < 0x80; });
        if (plain) std::erase_if(choices, [](char32_t code) { return code >= 0xC0 && code < 0x100; });
        const bool dashes = std::all_of(choices.begin(), choices.end(), is_dash);
        const bool thin = letter.code == 'I' || letter.code == 'l';
        if ((choices.size() < 2 && !thin) || dashes) {
            letter.code = choices.front();
            // In small print an accent is a speck, and the dot of an i may be one: two must have seen it.
            const bool same_place = told.size() == letters.size();
            if (same_place && told[i] == U'i' && is_accented_i(letter.code) && letter.likeness < kSureAccent)
                letter.code = U'i';
            else if (letter.code >= 0xC0 && letter.code <= 0xFF && !(same_place && told[i] == letter.code))
                words.settled = false;
            continue;
        }
        const auto in = [&](char32_t code) { return std::find(choices.begin(), choices.end(), code) != choices.end(); };
        const char32_t before = i > 0 ? letters[i - 1].code : 0;
        const char32_t after = i + 1 < letters.size() && letters[i + 1].alike.empty() ? letters[i + 1].code : 0;
        const bool in_step = i < steps;
        const auto code_at = [&](std::size_t k) {
            return k >= letters.size() || begins[k] ? char32_t{0} : k < steps ? told[k] : letters[k].code;
        };
        const char32_t said = in_step && in(told[i]) ? told[i] : char32_t{0};
        const auto is_either = [](char32_t code) { return code == 'I' || code == 'l'; };
        const bool small = words.reading.em < kSmallPrint && (is_either(letter.code) || is_either(said));
        if (begins[i] && small && is_lower(code_at(i + 1))) {
            const bool is_long = is_lower(code_at(i + 2)) && is_lower(code_at(i + 3));
            if (const char32_t first = first_of_word(said, code_at(i + 1), is_long); first != 0)
                letter.code = first;
            else
                words.settled = false;
        } else if (choices.size() < 2)
            letter.code = choices.front();
        else if (is_either(letter.code) && !begins[i] && may_be_of_joined_words(letters, begins, i))
            words.settled = false;
        else if (begins[i] && in(U'I') && in(U'l') && begins_with_capital_i(said, code_at(i + 1), code_at(i + 2)))
            letter.code = U'I';
        else if (said != 0 && begins[i] && is_either(said) && in(U'I') && in(U'l') &&
                 (is_no_beginning(said, code_at(i + 1), code_at(i + 2)) ||
                  is_no_short_word(said, code_at(i + 1), code_at(i + 2), code_at(i + 3))))
            words.settled = false;
        else if (said != 0)
            letter.code = said;
        else if (const char32_t meant = fitting(choices, before, after); meant != 0)
            letter.code = meant;
        else
            words.settled = false;
    }
}

std::string with_letters(const std::string& text, const FormReading& reading) {
    std::string out;
    std::size_t at = 0;
    for (std::string_view rest = text; !rest.empty();) {
        const char32_t code = take_letter(rest);
        const bool mark = is_place_mark(code, reading.letters, at);
        const bool kept = code == ' ' || mark || at >= reading.letters.size() || code == kMinus || plain_raised(code) != code;
        append_letter(out, kept ? code : reading.letters[at].code);
        at += code == ' ' || mark ? 0 : 1;
    }
    return out;
}

}  // namespace tactics

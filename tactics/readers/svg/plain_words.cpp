// SPDX-License-Identifier: Apache-2.0
#include "tactics/readers/svg/plain_words.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "tactics/text/utf8.h"

namespace tactics {

namespace {

constexpr int kDeepest = 16;  // groups in groups

// clang-format off
constexpr std::pair<std::string_view, std::string_view> kSigns[] = {
    {"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"}, {"varepsilon", "ε"}, {"zeta", "ζ"}, {"eta", "η"},
    {"theta", "θ"}, {"iota", "ι"}, {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"}, {"nu", "ν"}, {"xi", "ξ"}, {"pi", "π"}, {"rho", "ρ"},
    {"sigma", "σ"}, {"tau", "τ"}, {"upsilon", "υ"}, {"phi", "φ"}, {"varphi", "φ"}, {"chi", "χ"}, {"psi", "ψ"}, {"omega", "ω"},
    {"Gamma", "Γ"}, {"Delta", "Δ"}, {"Theta", "Θ"}, {"Lambda", "Λ"}, {"Xi", "Ξ"}, {"Pi", "Π"}, {"Sigma", "Σ"}, {"Phi", "Φ"},
    {"Psi", "Ψ"}, {"Omega", "Ω"}, {"times", "×"}, {"cdot", "·"}, {"pm", "±"}, {"leq", "≤"}, {"le", "≤"}, {"geq", "≥"}, {"ge", "≥"},
    {"neq", "≠"}, {"ne", "≠"}, {"approx", "≈"}, {"sim", "~"}, {"infty", "∞"}, {"degree", "°"}, {"circ", "°"}, {"rightarrow", "→"},
    {"to", "→"}, {"sum", "∑"}, {"int", "∫"}, {"partial", "∂"}, {"sin", "sin "}, {"cos", "cos "}, {"tan", "tan "}, {"log", "log "},
    {"ln", "ln "}, {"exp", "exp "}, {"min", "min"}, {"max", "max"}, {"ldots", "..."}, {"dots", "..."}, {"quad", " "}};
// Of these the group alone is left: how it looks says nothing.
constexpr std::string_view kLooks[] = {"mathdefault", "mathrm", "mathregular", "mathbf", "mathit", "mathsf", "mathtt", "mathcal", "text",
                                       "textbf", "textit", "rm", "bf", "it", "left", "right", "displaystyle"};
// clang-format on

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_number(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

// What is more than a letter or a number needs brackets where TeX has raised or parted it.
std::string in_brackets(std::string text) {
    const std::string_view view = text;
    const bool word = std::all_of(view.begin(), view.end(), is_letter),
               one = !text.empty() && (text[0] & 0x80) != 0 && text.size() <= 3;
    return word || is_number(text) || one ? text : "(" + text + ")";
}

class Formula {
public:
    explicit Formula(std::string_view rest) : rest_(rest) {}

    std::optional<std::string> read(int depth = 0, bool group = false) {
        std::string out;
        while (!rest_.empty()) {
            if (group && rest_.front() == '}') {
                rest_.remove_prefix(1);
                return out;
            }
            const char sign = rest_.front();
            if (sign == '^' || sign == '_') {
                rest_.remove_prefix(1);
                const auto what = argument(depth);
                if (!what) return std::nullopt;
                out += sign == '^' ? above(*what) : below(*what);
                continue;
            }
            const auto next = argument(depth);
            if (!next) return std::nullopt;
            out += *next;
        }
        return group ? std::nullopt : std::optional(out);
    }

private:
    static std::string above(const std::string& what) {
        if (what == "°" || what == "′") return what;
        const std::string power = raised(what);
        return power.empty() ? "^" + in_brackets(what) : power;
    }
    // An index that is a number is read as one behind its letter, as in CO2.
    static std::string below(const std::string& what) { return is_number(what) ? what : "_" + in_brackets(what); }

    // A sign, a command with what belongs to it, or a group.
    std::optional<std::string> argument(int depth) {
        if (rest_.empty() || depth > kDeepest) return std::nullopt;
        if (rest_.front() == '{') {
            rest_.remove_prefix(1);
            return read(depth + 1, true);
        }
        if (rest_.front() == '}') return std::nullopt;
        if (rest_.front() == '\\') return command(depth);
        if (rest_.front() == '-') {
            rest_.remove_prefix(1);
            return "\u2212";
        }
        std::string out;
        append_letter(out, take_letter(rest_));
        return out;
    }

    std::optional<std::string> command(int depth) {
        rest_.remove_prefix(1);
        if (rest_.empty()) return std::nullopt;
        if (!is_letter(rest_.front())) {
            const char sign = rest_.front();
            rest_.remove_prefix(1);
            if (std::string_view("%$#&_{}").find(sign) != std::string_view::npos) return std::string(1, sign);
            if (sign == '!') return "";
            return std::string_view(",;: ").find(sign) != std::string_view::npos ? std::optional<std::string>(" ") : std::nullopt;
        }
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), is_letter);
        const std::string_view name = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
        rest_.remove_prefix(name.size());
        for (const auto& [sign, letter] : kSigns)
            if (sign == name) return std::string(letter);
        if (std::find(std::begin(kLooks), std::end(kLooks), name) != std::end(kLooks)) return "";
        if (name == "sqrt") {
            const auto of = argument(depth + 1);
            return of ? std::optional("√" + in_brackets(*of)) : std::nullopt;
        }
        if (name == "frac" || name == "dfrac") {
            const auto over = argument(depth + 1), under = argument(depth + 1);
            return over && under ? std::optional(in_brackets(*over) + "/" + in_brackets(*under)) : std::nullopt;
        }
        return std::nullopt;
    }

    std::string_view rest_;
};

std::string line_without_markup(std::string_view text) {
    if (std::count(text.begin(), text.end(), '$') < 2) return std::string(text);
    std::string out;
    std::string_view rest = text;
    while (!rest.empty()) {
        const auto open = rest.find('$');
        out += rest.substr(0, open);
        if (open == rest.npos) break;
        rest.remove_prefix(open + 1);
        const auto close = rest.find('$');
        if (close == rest.npos) return std::string(text);
        const auto formula = Formula(rest.substr(0, close)).read();
        if (!formula) return std::string(text);
        out += *formula;
        rest.remove_prefix(close + 1);
    }
    return out;
}

}  // namespace

std::string raised(std::string_view digits) {
    std::string out;
    while (!digits.empty()) {
        const char32_t sign = raised(take_letter(digits));
        if (sign == 0) return {};
        append_letter(out, sign);
    }
    return out;
}

std::string off_line(const std::string& word, bool up) {
    if (up && std::find(kRings.begin(), kRings.end(), word) != kRings.end()) return std::string(kDegree);
    const bool digits = word.find_first_not_of("0123456789") == std::string::npos;
    if (digits && !up) return word;  // of a formula, as braille has it in most languages
    if (const std::string plain = up ? raised(word) : ""; !plain.empty()) return plain;
    const std::string mark = up ? "^" : "_";
    return letters_in(word) == 1 ? mark + word : mark + "(" + word + ")";
}

std::string without_markup(std::string_view text) {
    // A dollar in one line of words does not begin a formula that ends in another.
    std::string out;
    for (auto end = text.find('\n'); end != text.npos; end = text.find('\n')) {
        out += line_without_markup(text.substr(0, end)) + "\n";
        text.remove_prefix(end + 1);
    }
    return out + line_without_markup(text);
}

}  // namespace tactics

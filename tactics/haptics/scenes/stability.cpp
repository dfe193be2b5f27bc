// SPDX-License-Identifier: Apache-2.0
#include "tactics/haptics/scenes/stability.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tactics/units.h"

namespace tactics {

namespace {

constexpr double kSurface = 30;       // mm; in the middle of the way
constexpr double kPush = 0.1;         // mm, the small start
constexpr double kFall = 5;           // mm above the surface, the large one
constexpr double kLast = 1.5;         // s; what still swings after that swings on
constexpr double kWatched = 0.5;      // s at the end
constexpr double kQuiet = 0.1;        // s without a swing are rest: the slowest limit cycle seen was 12 Hz
constexpr double kLimitCycle = 0.09;  // mm from the lowest to the highest of a swing that still counts as rest
constexpr double kTremble = 0.5;      // N from tick to tick: about what a fingertip feels of 30 g at half of 1 kHz
constexpr double kTurn = 0.02;        // mm back from the highest are a turn: more than an encoder's step, less than a limit cycle
constexpr double kLeastStiffness = 0.2;  // N/mm: below, the lever hangs at its stop
constexpr double kMostStiffness = 64;
constexpr double kFactor = 1.02;
constexpr double kSpare = 0.9;
constexpr double kMostDamping = 10;  // N s/m that is offered; above it a count of the encoder is felt as a grain

// The largest way between two turns: a finger that creeps to its place does not count.
class Swings {
public:
    void see(double height, double now) noexcept {
        if (direction_ == 0) {
            direction_ = 1;
            turn_ = extreme_ = height;
            last_turn_ = now;
        }
        if ((height - extreme_) * direction_ > 0) {
            extreme_ = height;
        } else if ((extreme_ - height) * direction_ > kTurn) {
            const double way = std::abs(extreme_ - turn_);
            if (turns_ > 0) largest_ = std::max(largest_, way);
            if (way > kLimitCycle) last_turn_ = now;
            turn_ = extreme_;
            extreme_ = height;
            direction_ = -direction_;
            ++turns_;
        }
    }
    void forget() noexcept { largest_ = turns_ = 0; }
    double largest() const noexcept { return largest_; }
    double last_turn() const noexcept { return last_turn_; }

private:
    double turn_ = 0, extreme_ = 0, largest_ = 0, last_turn_ = 0;
    int direction_ = 0, turns_ = 0;
};

double hang(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger) {
    const double weight = lever.mass_g / 1000 * lever.gravity_m_per_s2 + (finger != nullptr ? finger->preload : 0);
    return law.stiffness > 0 ? weight / law.stiffness : 0;
}

double swing_from(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger, double height) {
    SimulatedLever mouse(lever, finger != nullptr ? std::optional(*finger) : std::nullopt, height);
    const double dt = 1 / lever.rate_hz;
    constexpr int kLooks = 4;  // at the height within a tick
    double before = mouse.height();
    Swings swings;
    bool watched = false;
    double pushed = 0, changes = 0;  // N, a tick, over some time of late
    for (double time = 0; time < kLast;) {
        const double now = mouse.height(), push = force(law, kSurface, now, before, dt);
        mouse.push(push);
        changes += std::min(1.0, dt / kQuiet) * (std::abs(push - pushed) - changes);
        pushed = push;
        before = now;
        for (int look = 0; look < kLooks; ++look) {
            mouse.advance(dt / kLooks);
            time += dt / kLooks;
            swings.see(mouse.true_height(), time);
        }
        if (!watched && time > kLast - kWatched) {
            swings.forget();
            watched = true;
        }
        const LeverState& state = mouse.state();
        if (time - swings.last_turn() > kQuiet && std::abs(state.velocity) < 1 && kSurface > state.height && changes < kTremble)
            return 0;
    }
    return swings.largest() > kLimitCycle || changes >= kTremble ? std::max(swings.largest(), kTurn) : 0;
}

// Five of lever and finger, the height of the tick before, and forces under way.
constexpr std::size_t kBase = 6;
constexpr std::size_t kMostLate = 24;  // ticks; what is later is not sieved
constexpr std::size_t kStates = kBase + kMostLate + 1;
using Matrix = std::array<std::array<double, kStates>, kStates>;

Matrix product(const Matrix& a, const Matrix& b, std::size_t n) {
    Matrix c{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k)
            if (a[i][k] != 0)
                for (std::size_t j = 0; j < n; ++j) c[i][j] += a[i][k] * b[k][j];
    return c;
}

// Column by column: what a tick makes of a deviation in one state.
void add_columns(Matrix& matrix, const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger, std::size_t late,
                 double part) {
    const double dt = 1 / lever.rate_hz;
    const std::size_t n = kBase + late + 1;
    for (std::size_t column = 0; column < n; ++column) {
        std::array<double, kStates> state{};
        state[column] = 1;
        const double pushed = -law.stiffness * state[0] - (law.sign == DampingSign::corrected ? 1 : -1) * law.damping_ns_per_m /
                                                              1000 * (state[0] - state[5]) / dt;
        // Forces wait in a row; the one whose time comes within the tick takes over from the one before it.
        const auto waits = [&](std::size_t ticks) { return ticks == 0 ? pushed : state[kBase + ticks - 1]; };
        const double first = waits(late + (part > 0 ? 1 : 0)), second = waits(late);
        double z = state[0], v = state[1], x = state[2], u = state[3], rest = state[4];
        const int steps = std::max(20, static_cast<int>(std::ceil(dt / 50e-6)));
        for (int i = 0; i < steps; ++i) {
            const double h = dt / steps;
            const double push = (i + 0.5) / steps < part ? first : second;
            const double pad =
                finger == nullptr ? 0 : finger->pad_stiffness * (z - x) + finger->pad_damping_ns_per_m / 1000 * (v - u);
            v += (push - pad - lever.damping_ns_per_m / 1000 * v) / lever.mass_g * 1e6 * h;
            z += v * h;
            if (finger == nullptr) {
                x = u = rest = 0;
                continue;
            }
            u += (pad - finger->stiffness * (x - rest) - finger->damping_ns_per_m / 1000 * u) / finger->mass_g * 1e6 * h;
            x += u * h;
            rest += (x - rest) * h / finger->relaxation;
        }
        const std::array<double, kBase> after = {z, v, x, u, rest, state[0]};
        for (std::size_t row = 0; row < kBase; ++row) matrix[row][column] = after[row];
        for (std::size_t ticks = 0; ticks <= late; ++ticks) matrix[kBase + ticks][column] = waits(ticks);
    }
}

// The highest swing that is left, in mm, after a small push and after a fall: 0 where both come to rest, and the force, too.
// `finger` may be null.
double swing_left(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger) {
    const double rests = std::max(kSurface - hang(law, lever, finger), lever.lowest);
    const double fallen = swing_from(law, lever, finger, kSurface + kFall);
    return fallen > 0 ? fallen : swing_from(law, lever, finger, rests + kPush);
}

LeverSettings without_friction(LeverSettings lever) {
    lever.friction = 0;
    return lever;
}

// The largest stiffness that comes to rest, if that is below `most`; else one that is at least `most`.
double largest_up_to(double most, double damping, DampingSign sign, const LeverSettings& lever,
                     std::span<const FingerSettings> fingers) {
    const auto rests = [&](double stiffness) { return comes_to_rest({stiffness, damping, sign}, lever, fingers); };
    if (!rests(kLeastStiffness)) return 0;
    double good = kLeastStiffness, bad = kLeastStiffness;
    // Up in coarse steps, as the border has no islands below it that were seen; then between the last two.
    constexpr double kCoarse = 1.25;
    while (bad < most && rests(bad * kCoarse)) good = bad *= kCoarse;
    if (bad >= most) return std::min(bad, kMostStiffness);
    for (bad = good * kCoarse; bad / good > kFactor;) {
        const double middle = std::sqrt(good * bad);
        (rests(middle) ? good : bad) = middle;
    }
    return good;
}

double borne_up_to(double most, double damping, DampingSign sign, const LeverSettings& lever,
                   std::span<const FingerSettings> fingers) {
    const LeverSettings loose = without_friction(lever);
    const double free = largest_up_to(most, damping, sign, loose, {});
    return fingers.empty() || free == 0 ? free
                                        : std::min(free, largest_up_to(std::min(most, free), damping, sign, loose, fingers));
}

// As stiff with more damping, so that what is felt stays the same; or else softer: the stiffest that any damping from `law`'s on
// bears. The printed sign is not kept.
StablePoint nearest_borne(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers) {
    constexpr double kMore = 0.5;  // N s/m
    StablePoint best{law.damping_ns_per_m, 0};
    const auto reaches = [&](double damping) {
        const double most = kSpare * borne_up_to(law.stiffness / kSpare, damping, DampingSign::corrected, lever, fingers);
        // Softer in hundredths, the precision of the message.
        if (most > best.stiffness) best = {damping, std::min(std::floor(most * 100) / 100, law.stiffness)};
        return most >= law.stiffness;
    };
    for (double damping = law.damping_ns_per_m; damping <= std::max(law.damping_ns_per_m, kMostDamping);
         damping = kMore * (std::floor(damping / kMore) + 1))
        if (reaches(damping)) return best;
    // So much damping that nothing comes to rest.
    for (double damping = law.damping_ns_per_m / 2; best.stiffness == 0 && damping > 0.1; damping /= 2) reaches(damping);
    return best;
}

Phrase say(double value) { return numeral(std::round(value * 100) / 100); }

Phrase loop_words(double rate_hz, double delay) {
    return delay > 0 ? phrase("{0} Hz and {1} ms of delay", say(rate_hz), say(delay * 1000)) : phrase("{0} Hz", say(rate_hz));
}

// What is left of a swing, mm; held: by a finger.
Phrase motion_words(double left, bool held) {
    if (!(left > 0)) return phrase("comes to rest by chance, and not on a softer surface,");
    if (left > kLimitCycle)
        return held ? phrase("swings on by {0} mm", say(left))
                    : phrase("swings on by {0} mm once the finger is lifted,", say(left));
    return held ? phrase("trembles from tick to tick") : phrase("trembles from tick to tick once the finger is lifted,");
}

}  // namespace

double growth(const ForceLaw& law, const LeverSettings& lever, const FingerSettings* finger) {
    const double ticks = std::clamp(lever.delay, 0.0, kMostDelay) * lever.rate_hz;
    const auto late = static_cast<std::size_t>(std::min(ticks, static_cast<double>(kMostLate - 1)));
    Matrix power{};
    add_columns(power, law, lever, finger, late, std::clamp(ticks - static_cast<double>(late), 0.0, 1.0));
    const std::size_t n = kBase + late + 1;
    // Gelfand: the n-th root of the norm of the n-th power. Squared twenty times, scaled so that nothing overflows.
    constexpr int kSquares = 20;
    double logarithm = 0;
    for (int square = 0; square <= kSquares; ++square) {
        if (square > 0) {
            power = product(power, power, n);
            logarithm *= 2;
        }
        double norm = 0;
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) norm = std::max(norm, std::abs(power[i][j]));
        if (!(norm > 0)) return 0;
        for (auto& row : power)
            for (double& value : row) value /= norm;
        logarithm += std::log(norm);
    }
    return std::exp(logarithm / std::exp2(kSquares));
}

bool comes_to_rest(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers) {
    if (fingers.empty()) return swing_left(law, lever, nullptr) == 0;
    return std::all_of(fingers.begin(), fingers.end(),
                       [&](const FingerSettings& finger) { return swing_left(law, lever, &finger) == 0; });
}

double largest_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever,
                         std::span<const FingerSettings> fingers) {
    return largest_up_to(kMostStiffness, damping_ns_per_m, sign, lever, fingers);
}

double borne_stiffness(double damping_ns_per_m, DampingSign sign, const LeverSettings& lever,
                       std::span<const FingerSettings> fingers) {
    return borne_up_to(kMostStiffness, damping_ns_per_m, sign, lever, fingers);
}

std::vector<StablePoint> stable_region(double most_damping_ns_per_m, int count, DampingSign sign, const LeverSettings& lever,
                                       std::span<const FingerSettings> fingers) {
    std::vector<StablePoint> border;
    for (int i = 0; i < count; ++i) {
        const double damping = count > 1 ? most_damping_ns_per_m * i / (count - 1) : 0;
        border.push_back({damping, borne_stiffness(damping, sign, lever, fingers)});
    }
    return border;
}

namespace {

bool is_borne(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers) {
    constexpr double kOne = 1 + 1e-9;
    return growth(law, lever, nullptr) <= kOne &&
           std::all_of(fingers.begin(), fingers.end(), [&](const FingerSettings& f) { return growth(law, lever, &f) <= kOne; });
}

// Down from the requested stiffness in twentieths, with as much damping as it needs.
StablePoint nearest_borne(const ForceLaw& law, const ArmSettings& arm, std::span<const FingerSettings> fingers) {
    constexpr double kMore = 0.5;  // N s/m
    const LeverSettings lever = as_lever(arm);
    for (double stiffness = std::min(law.stiffness, arm.most_stiffness); stiffness > 0.01; stiffness *= 0.95)
        for (double damping = law.damping_ns_per_m; damping <= std::max(law.damping_ns_per_m, kMostDamping);
             damping = kMore * (std::floor(damping / kMore) + 1))
            if (is_borne({stiffness / kSpare, damping}, lever, fingers))
                return {damping, stiffness == law.stiffness ? stiffness : std::floor(stiffness * 100) / 100};
    return {0, 0};
}

}  // namespace

StableCheck check_arm(const ForceLaw& law, const ArmSettings& arm, std::span<const FingerSettings> fingers) {
    if (!(law.stiffness > 0) || !std::isfinite(law.stiffness) || !(law.damping_ns_per_m >= 0) ||
        !std::isfinite(law.damping_ns_per_m))
        return {false, phrase("stiffness must be above 0 N/mm and damping not below 0 N s/m"), arm.most_stiffness / 2, 1};
    const bool grows = !is_borne(law, as_lever(arm), fingers);
    if (!grows && law.stiffness <= arm.most_stiffness) return {true, "", law.stiffness, law.damping_ns_per_m};
    const StablePoint nearest = nearest_borne(law, arm, fingers);
    const Phrase reason = grows ? phrase("at {0} N/mm and {1} N s/m the arm swings up at {2}", say(law.stiffness),
                                         say(law.damping_ns_per_m), loop_words(arm.rate_hz, arm.delay))
                                : phrase("at {0} N/mm and {1} N s/m it is stiffer than the {2} N/mm that the arm can be",
                                         say(law.stiffness), say(law.damping_ns_per_m), say(arm.most_stiffness));
    return {false, nearest.stiffness > 0 ? reason : phrase("{0}; no setting comes to rest: a shorter delay would help", reason),
            nearest.stiffness, nearest.damping_ns_per_m};
}

StableCheck check_stable(const ForceLaw& law, const LeverSettings& lever, std::span<const FingerSettings> fingers) {
    if (!(law.stiffness > 0) || !std::isfinite(law.stiffness) || !(law.damping_ns_per_m >= 0) ||
        !std::isfinite(law.damping_ns_per_m))
        return {false, phrase("stiffness must be above 0 N/mm and damping not below 0 N s/m"), 1, 0.5};
    // Above a stiffness that does not come to rest others may: by chance, for these starts.
    const LeverSettings loose = without_friction(lever);
    if (comes_to_rest(law, loose, {}) && comes_to_rest(law, loose, fingers) &&
        law.stiffness <= kFactor * borne_up_to(law.stiffness, law.damping_ns_per_m, law.sign, lever, fingers))
        return {true, "", law.stiffness, law.damping_ns_per_m};
    double left = 0, grows = 0;
    const auto look = [&](const FingerSettings* finger) {
        left = std::max(left, swing_left(law, loose, finger));
        grows = std::max(grows, growth(law, loose, finger));
    };
    for (const FingerSettings& finger : fingers) look(&finger);
    const bool held = left > 0;
    if (!held) look(nullptr);
    Phrase reason = phrase("at {0} N/mm and {1} N s/m the lever {2} at {3}", say(law.stiffness), say(law.damping_ns_per_m),
                           motion_words(left, held), loop_words(lever.rate_hz, lever.delay));
    if (grows > 1.001)
        reason = phrase("{0}, growing by {1} % a tick while it is small", std::move(reason), say((grows - 1) * 100));
    if (law.sign == DampingSign::as_printed) reason = phrase("{0}; the sign as printed takes damping away", std::move(reason));
    const StablePoint nearest = nearest_borne(law, lever, fingers);
    if (nearest.stiffness == 0)
        return {false, phrase("{0}; no setting comes to rest: a shorter delay or a quicker loop would help", reason), 0, 0};
    return {false, reason, nearest.stiffness, nearest.damping_ns_per_m};
}

}  // namespace tactics

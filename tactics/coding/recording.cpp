// SPDX-License-Identifier: Apache-2.0
#include "tactics/coding/recording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "tactics/coding/binary_coder.h"
#include "tactics/coding/bytes.h"
#include "tactics/error.h"
#include "tactics/point3.h"

namespace tactics {

namespace {

constexpr std::int64_t kMostSteps = std::int64_t{1} << 44;
constexpr std::int64_t kMostForceSteps = std::int64_t{1} << 34;  // a slope of 256ths has then less than kMostSteps
constexpr std::size_t kSinceKinds = 16;

bool in_bounds(std::int64_t steps) { return steps > -kMostSteps && steps < kMostSteps; }

std::array<std::int64_t, 3> axes_of(const Steps3& steps) { return {steps.x, steps.y, steps.z}; }
Steps3 steps_of(const std::array<std::int64_t, 3>& axes) { return {axes[0], axes[1], axes[2]}; }

// Numbers that go on as they went in the two ticks before.
struct Course {
    NumberChances chances;
    std::int64_t last = 0, step = 0;
    std::int64_t guess() const noexcept { return last + step; }
    void go(std::int64_t now) noexcept {
        step = now - last;
        last = now;
    }
};

// What both sides keep of a part.
struct PartState {
    Course time;
    std::array<Course, 3> place;
    std::array<Chance, kSinceKinds> is_told;
    std::array<NumberChances, 3> miss, slope;
    GuessedForce guessed;
    std::size_t since = 0;  // ticks since a force was told
    Chance& told_chance() noexcept { return is_told[std::min(since, kSinceKinds - 1)]; }
};

struct PartTicks {
    std::size_t first = 0, count = 0;
};

PartTicks ticks_of(std::size_t part, std::size_t ticks) {
    const std::size_t first = part * kTicksOfPart;
    return {first, std::min(kTicksOfPart, ticks - first)};
}

std::size_t parts_of(std::size_t ticks) { return (ticks + kTicksOfPart - 1) / kTicksOfPart; }

void put_force(BinaryEncoder& encoder, PartState& state, const ForceTold& told, bool linear, std::size_t first_axis) {
    const auto guess = axes_of(state.guessed.now()), force = axes_of(told.force), slope = axes_of(told.slope);
    for (std::size_t axis = first_axis; axis < 3; ++axis) {
        state.miss[axis].put(encoder, folded(force[axis] - guess[axis]));
        if (linear) state.slope[axis].put(encoder, folded(slope[axis]));
    }
}

std::string part_bytes(const Recording& recording, const PartTicks& ticks, const std::vector<ToldAt>& told, bool linear) {
    std::string bytes;
    append_number(bytes, static_cast<std::uint64_t>(recording.times[ticks.first]), 8);
    BinaryEncoder encoder(bytes);
    PartState state;
    state.time.last = recording.times[ticks.first];
    auto next = told.begin();
    for (std::size_t i = 0; i < ticks.count; ++i) {
        const std::size_t tick = ticks.first + i;
        const std::int64_t time = recording.times[tick];
        state.time.chances.put(encoder, folded(time - state.time.guess()));
        state.time.go(time);
        const auto place = axes_of(recording.places[tick]);
        for (std::size_t axis = 0; axis < (recording.has_height ? 3 : 2); ++axis) {
            state.place[axis].chances.put(encoder, folded(place[axis] - state.place[axis].guess()));
            state.place[axis].go(place[axis]);
        }
        const bool is_told = next != told.end() && next->tick == i;
        encoder.put(state.told_chance(), is_told);
        ++state.since;
        if (is_told) {
            put_force(encoder, state, next->told, linear, recording.spatial ? 0 : 2);
            state.guessed.tell(next->told);
            state.since = 0;
            ++next;
        }
        state.guessed.tick();
    }
    encoder.finish();
    return bytes;
}

// False: there can be none such.
bool get_force(BinaryDecoder& decoder, PartState& state, bool linear, std::size_t first_axis) {
    auto force = axes_of(state.guessed.now());
    std::array<std::int64_t, 3> slope{};
    bool fits = true;
    for (std::size_t axis = first_axis; axis < 3; ++axis) {
        const std::int64_t miss = unfolded(state.miss[axis].get(decoder));
        if (linear) slope[axis] = unfolded(state.slope[axis].get(decoder));
        fits = fits && in_bounds(force[axis]) && in_bounds(force[axis] + miss) && in_bounds(slope[axis]);
        force[axis] += miss;
    }
    if (fits) state.guessed.tell({steps_of(force), steps_of(slope)});
    return fits;
}

// Adds its ticks to `recording`. False: the part is none.
bool read_part(std::string_view bytes, std::size_t count, bool linear, Recording& recording) {
    ByteReader reader(bytes);
    PartState state;
    state.time.last = static_cast<std::int64_t>(reader.number(8));
    BinaryDecoder decoder(reader.take(reader.left()));
    if (!reader.whole() || !in_bounds(state.time.last)) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int64_t time = state.time.guess() + unfolded(state.time.chances.get(decoder));
        if (!in_bounds(time) || (!recording.times.empty() && time < recording.times.back())) return false;
        state.time.go(time);
        std::array<std::int64_t, 3> place{};
        for (std::size_t axis = 0; axis < (recording.has_height ? 3 : 2); ++axis) {
            place[axis] = state.place[axis].guess() + unfolded(state.place[axis].chances.get(decoder));
            if (!in_bounds(place[axis])) return false;
            state.place[axis].go(place[axis]);
        }
        const bool is_told = decoder.get(state.told_chance());
        ++state.since;
        if (is_told) {
            if (!get_force(decoder, state, linear, recording.spatial ? 0 : 2)) return false;
            state.since = 0;
        }
        if (decoder.overrun()) return false;
        recording.times.push_back(time);
        recording.places.push_back(steps_of(place));
        recording.forces.push_back(state.guessed.now());
        state.guessed.tick();
    }
    return decoder.whole();
}

Recording empty_of(const RecordingFacts& facts) {
    return {facts.place_step, facts.force_step, facts.has_height, facts.spatial, {}, {}, {}};
}

void add_part(const Container& container, const RecordingFacts& facts, std::size_t part, Recording& recording) {
    if (!read_part(container.part(part), ticks_of(part, facts.ticks).count, facts.band.guess == ForceGuess::linear, recording))
        container.fail(phrase("part {0} of the recording is none", std::to_string(part + 1)));
}

std::int64_t begin_of(const Container& container, std::size_t part) {
    ByteReader reader(container.part(part));
    return static_cast<std::int64_t>(reader.number(8));
}

void check_bounds(const Recording& recording) {
    const auto within = [](const Steps3& steps, std::int64_t most) {
        return std::max({std::abs(steps.x), std::abs(steps.y), std::abs(steps.z)}) < most;
    };
    for (std::size_t i = 0; i < recording.times.size(); ++i)
        if (!in_bounds(recording.times[i]) || !within(recording.places[i], kMostSteps) ||
            !within(recording.forces[i], kMostForceSteps) || (i > 0 && recording.times[i] < recording.times[i - 1]))
            throw std::logic_error("a recording beyond its bounds");
}

}  // namespace

EncodedRecording encode_recording(const Recording& recording, const ForceBand& band) {
    const std::size_t ticks = recording.times.size();
    if (ticks == 0 || ticks > kMostTicks || recording.places.size() != ticks || recording.forces.size() != ticks)
        throw std::logic_error("no recording");
    check_bounds(recording);
    std::string facts;
    append_number(facts, ticks, 4);
    append_number(facts, static_cast<std::uint64_t>(band.guess), 1);
    append_number(facts, (recording.has_height ? 1u : 0u) | (recording.spatial ? 2u : 0u), 1);
    append_number(facts, 0, 2);
    for (const double number : {recording.place_step, recording.force_step, band.share, band.floor, band.allowance})
        append_double(facts, number);
    append_number(facts, static_cast<std::uint64_t>(recording.times.front()), 8);
    const Deadband deadband{band.share, band.floor / recording.force_step,
                            band.allowance / (recording.force_step * recording.place_step), band.guess};
    EncodedRecording encoded;
    std::vector<std::string> parts;
    double added = 0;
    for (std::size_t part = 0; part < parts_of(ticks); ++part) {
        const PartTicks own = ticks_of(part, ticks);
        const std::size_t places = std::min(own.count + 1, ticks - own.first);
        const auto told = forces_told(std::span(recording.forces).subspan(own.first, own.count),
                                      std::span(recording.places).subspan(own.first, places), deadband, added);
        encoded.told += told.size();
        parts.push_back(part_bytes(recording, own, told, band.guess == ForceGuess::linear));
    }
    encoded.bytes = container_bytes(ContainerKind::recording, facts, parts);
    return encoded;
}

ForceLoss loss_of(const Recording& truth, const Recording& decoded, const ForceBand& band) {
    ForceLoss loss;
    double squares = 0, added = 0;
    const auto real = [](const Steps3& steps, double step) {
        return Point3{static_cast<double>(steps.x) * step, static_cast<double>(steps.y) * step,
                      static_cast<double>(steps.z) * step};
    };
    for (std::size_t i = 0; i < truth.forces.size(); ++i) {
        const Point3 force = real(truth.forces[i], truth.force_step);
        const Point3 missed = real(decoded.forces[i], decoded.force_step) - force;
        const double error = length_of(missed), threshold = std::max(band.share * length_of(force), band.floor);
        squares += error * error;
        loss.most = std::max(loss.most, error);
        if (error > 0) loss.of_threshold = std::max(loss.of_threshold, threshold > 0 ? error / threshold : INFINITY);
        loss.touched += truth.forces[i] != Steps3{} ? 1 : 0;
        if (i + 1 == truth.forces.size()) break;
        const Point3 way = real(truth.places[i + 1], truth.place_step) - real(truth.places[i], truth.place_step);
        added = std::max(added, 0.0) + dot(missed, way);
        loss.work = std::max(loss.work, added);
    }
    loss.rms = std::sqrt(squares / static_cast<double>(truth.forces.size()));
    return loss;
}

RecordingFacts recording_facts(const Container& container) {
    if (container.kind() != ContainerKind::recording)
        throw Error(Fault::failed, container.name(),
                    phrase("holds heights and no recording; play it, or make another file of heights of it with tactics relief"));
    ByteReader reader(container.facts());
    RecordingFacts facts;
    facts.ticks = reader.number(4);
    const std::uint64_t guess = reader.number(1), flags = reader.number(1), rest = reader.number(2);
    facts.has_height = (flags & 1u) != 0;
    facts.spatial = (flags & 2u) != 0;
    facts.place_step = reader.real();
    facts.force_step = reader.real();
    facts.band = {reader.real(), reader.real(), reader.real(), guess == 1 ? ForceGuess::linear : ForceGuess::hold};
    reader.number(8);
    if (!reader.whole() || reader.left() > 0 || guess > 1 || flags > 3 || rest != 0)
        container.fail(phrase("its facts are none of a recording"));
    const auto is_step = [](double step) { return step >= 1e-9 && step <= 1e3; };
    const auto is_bound = [](double bound) { return bound >= 0 && bound <= 1e9; };
    if (!is_step(facts.place_step) || !is_step(facts.force_step) || !is_bound(facts.band.share) || !is_bound(facts.band.floor) ||
        !is_bound(facts.band.allowance))
        container.fail(phrase("a step or a bound of it is none"));
    if (facts.ticks < 1 || facts.ticks > kMostTicks || container.parts() != parts_of(facts.ticks))
        container.fail(phrase("it has not as many parts as its ticks need"));
    return facts;
}

Recording decode_recording(const Container& container) {
    const RecordingFacts facts = recording_facts(container);
    Recording recording = empty_of(facts);
    for (std::size_t part = 0; part < container.parts(); ++part) add_part(container, facts, part, recording);
    return recording;
}

Recording decode_recording(const Container& container, std::int64_t from, std::int64_t to) {
    const RecordingFacts facts = recording_facts(container);
    // The last part that begins at `from` or before; times never go back.
    std::size_t low = 0, high = container.parts();
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (begin_of(container, middle) <= from ? low : high) = middle;
    }
    // Several ticks may have one time.
    while (low > 0 && begin_of(container, low) >= from) --low;
    Recording recording = empty_of(facts);
    for (std::size_t part = low; part < container.parts() && begin_of(container, part) <= to; ++part)
        add_part(container, facts, part, recording);
    const auto first = std::lower_bound(recording.times.begin(), recording.times.end(), from) - recording.times.begin();
    const auto last = std::upper_bound(recording.times.begin(), recording.times.end(), to) - recording.times.begin();
    const auto cut = [&](auto& values) {
        values.erase(values.begin() + last, values.end());
        values.erase(values.begin(), values.begin() + std::min(first, last));
    };
    cut(recording.times);
    cut(recording.places);
    cut(recording.forces);
    return recording;
}

}  // namespace tactics

// SPDX-License-Identifier: Apache-2.0
// How strongly a line attracts a finger beside it: the weighting function of a virtual fixture ("Design of a Haptic Graphing
// System", J. P. Fritz and K. E. Barner, section Development, figure 2).
//
// The paper's formula is missing from every copy that could be found. Two RECONSTRUCTIONS follow its text: a constant C,
// steepnesses k1 and k2, lengths l1 and l2, a left half that "prevents an instantaneous change" at the line and so leaves a core
// without force, and a cylinder that limits the whole.
#pragma once

#include <span>
#include <string_view>

namespace tactics {

enum class FixtureForm {
    r1,      ///< two logistic halves, each minus its value at its end
    r2,      ///< two stretched exponentials, minus their values at the radius
    linear,  ///< zero up to l1, linear from there to C at l2, and linear back to zero at the radius
    rod,     ///< no fixture: a solid cylinder that pushes a finger out, the paper's first attempt
};

struct FixtureSettings {
    FixtureForm form = FixtureForm::r2;
    double strength = 1.5;    ///< C, N. For a rod: force in its middle
    double radius = 10;       ///< mm; nothing is felt beyond it
    double k1 = 2, l1 = 1.2;  ///< of the half at the line; l1 in mm; k1 per mm for r1, an exponent for r2
    double k2 = 4, l2 = 6;    ///< of the half at the radius
};

struct NamedFixture {
    std::string_view name, what;
    FixtureSettings settings;
};
/// Settings with the numbers of the reconstructions; the first is the default.
std::span<const NamedFixture> fixtures();

/// Force at a `distance` (mm, not negative) from the line, N; positive towards the line, negative away from it. Continuous; zero
/// at the line (except at a rod's middle) and beyond the radius.
double pull(const FixtureSettings& fixture, double distance) noexcept;

/// The steepest rise of the pull with distance, N/mm, which a device must sustain as a stiffness; and the steepest fall, which a
/// hand must sustain, or the finger snaps off the line. Both positive, by sampling.
struct FixtureSlopes {
    double rise = 0, fall = 0;
};
FixtureSlopes slopes_of(const FixtureSettings& fixture);

}  // namespace tactics

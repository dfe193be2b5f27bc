// SPDX-License-Identifier: Apache-2.0
// How strongly a line pulls a finger that is beside it: the weighting function of a virtual fixture ("Design of a Haptic Graphing
// System", J. P. Fritz and K. E. Barner, section Development, figure 2).
//
// The paper's formula is lost from every copy that could be found. What its text tells is kept by two RECONSTRUCTIONS: a constant
// C, steepnesses k1 and k2, lengths l1 and l2, a left half that "prevents an instantaneous change" at the line and so leaves a
// core without force, and a cylinder that ends the whole.
#pragma once

#include <span>
#include <string_view>

namespace tactics {

enum class FixtureForm {
    r1,      ///< two logistic halves, each less what it would leave at its end
    r2,      ///< two stretched exponentials, less what they would leave at the radius
    linear,  ///< none up to l1, from there in a straight line to C at l2, and back to none at the radius
    rod,     ///< no fixture: a solid cylinder that pushes a finger out, the paper's first attempt
};

struct FixtureSettings {
    FixtureForm form = FixtureForm::r2;
    double strength = 1.5;    ///< N; C. A rod: in its middle
    double radius = 10;       ///< mm; from there on nothing is felt
    double k1 = 2, l1 = 1.2;  ///< of the half at the line; l1 in mm; k1 per mm for r1, an exponent for r2
    double k2 = 4, l2 = 6;    ///< of the half at the radius
};

struct NamedFixture {
    std::string_view name, what;
    FixtureSettings settings;
};
/// With the numbers of the reconstructions; the first is the default.
std::span<const NamedFixture> fixtures();

/// N towards the line, `distance` mm (not negative) from it; away from it where negative. Continuous; none at the line (but
/// beside a rod's middle) and from the radius on.
double pull(const FixtureSettings& fixture, double distance) noexcept;

/// N/mm: the steepest rise of the pull with distance, which a device must bear as a stiffness; and the steepest fall, which a
/// hand must, or the finger snaps off the line. Both positive, by sampling.
struct FixtureSlopes {
    double rise = 0, fall = 0;
};
FixtureSlopes slopes_of(const FixtureSettings& fixture);

}  // namespace tactics

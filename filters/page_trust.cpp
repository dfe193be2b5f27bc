// SPDX-License-Identifier: Apache-2.0
#include "filters/page_trust.h"

#include <cmath>

namespace tactics {

namespace {

// Logistic, each with its constant last.
struct TrustWeights {
    float line[kTrustFeatures + 1];
    float found[kTrustFeatures + 1];
};

#include "filters/trust_weights.inc"

double logistic(const float (&weights)[kTrustFeatures + 1], const TrustFeatures& features) {
    float sum = weights[kTrustFeatures];
    for (std::size_t i = 0; i < kTrustFeatures; ++i) sum += weights[i] * features[i];
    return 1 / (1 + std::exp(-static_cast<double>(sum)));
}

}  // namespace

// More was tried: how unsure the arcs are, the best of what is not drawn, the surest thing that is enclosed, how busy the picture
// is, twenty-one numbers in all. On photographs that nothing was fitted to these two tell poor pages as well as all of them
// together (area under the curve 0.82 either way, every second of BSDS500's 100 for validation).
std::optional<TrustFeatures> trust_features_of(const RegionTree& tree, const Parts& parts, std::span<const float> chances) {
    double drawn = 0, drawn_rightly = 0, all = 0;
    for (std::size_t i = 0; i < tree.arcs.size(); ++i) {
        const double length = steps_of(tree.arcs[i]), wanted = length * static_cast<double>(chances[i]);
        all += wanted;
        if (!parts.divides(tree.arcs[i])) continue;
        drawn += length;
        drawn_rightly += wanted;
    }
    if (drawn <= 0 || all <= 0) return std::nullopt;
    return TrustFeatures{static_cast<float>(drawn_rightly / drawn), static_cast<float>(drawn_rightly / all)};
}

std::optional<Trust> trust_of(const RegionTree& tree, const Parts& parts, std::span<const float> chances) {
    const auto features = trust_features_of(tree, parts, chances);
    if (!features) return std::nullopt;
    const TrustWeights& weights = tree.learned ? kLearnedTrust : kPlainTrust;
    return Trust{logistic(weights.line, *features), logistic(weights.found, *features)};
}

}  // namespace tactics

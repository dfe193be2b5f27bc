// SPDX-License-Identifier: Apache-2.0
// Hostile NRRD files: what is read has as many finite numbers as it says, and is measured within its bounds.
#include <cmath>
#include <cstdlib>
#include <span>

#include "cli/verbs/voxel_report.h"
#include "tactics/error.h"
#include "tactics/readers/nrrd.h"

using namespace tactics;

namespace {

void expect(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
    try {
        Source source = memory_source({data, size}, "fuzz.nrrd");
        if (!is_nrrd(source)) return 0;
        Voxels voxels = read_nrrd(source);
        const auto count = static_cast<std::size_t>(voxels.columns) * static_cast<std::size_t>(voxels.rows) *
                           static_cast<std::size_t>(voxels.slices) * static_cast<std::size_t>(voxels.components);
        expect(voxels.values.size() == count && count > 0);
        for (const double value : voxels.values) expect(std::isfinite(value));
        if (count > 4096) return 0;
        const MeasuredVoxels measured = voxel_report("fuzz.nrrd", std::move(voxels), true).measured;
        expect(measured.low >= 0 && measured.low <= measured.high && measured.high <= measured.raw * (1 + 1e-9));
        for (const VoxelDetail& detail : measured.details) expect(detail.bits <= measured.high && std::isfinite(detail.error));
    } catch (const Error&) {
    }
    return 0;
}

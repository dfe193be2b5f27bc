// SPDX-License-Identifier: Apache-2.0
// Shapes as GEOS has them (Debian: libgeos-dev; LGPL, a shared library, no part of the program), a witness that shares no code
// with ours.
#pragma once

#include <geos_c.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tactics/drawing.h"

namespace tactics::tests {

struct Geos {
    GEOSContextHandle_t handle = GEOS_init_r();
    Geos() = default;
    ~Geos() { GEOS_finish_r(handle); }
    Geos(const Geos&) = delete;
    Geos& operator=(const Geos&) = delete;
};

class GeosShape {
public:
    /// An open line.
    static GeosShape line(const Geos& geos, const std::vector<Point>& points) {
        return {geos, GEOSGeom_createLineString_r(geos.handle, sequence_of(geos, points, points.size()))};
    }
    /// Rings by the even-odd rule.
    static GeosShape area(const Geos& geos, const std::vector<std::vector<Point>>& rings) {
        GeosShape whole(geos, GEOSGeom_createEmptyPolygon_r(geos.handle));
        for (const std::vector<Point>& ring : rings) {
            if (ring.size() < 3) continue;
            const GeosShape raw(
                geos,
                GEOSGeom_createPolygon_r(
                    geos.handle, GEOSGeom_createLinearRing_r(geos.handle, sequence_of(geos, ring, ring.size() + 1)), nullptr, 0));
            const GeosShape valid(geos, GEOSMakeValid_r(geos.handle, raw.shape_));
            whole = GeosShape(geos, GEOSSymDifference_r(geos.handle, whole.shape_, valid.shape_));
        }
        return whole;
    }

    GeosShape(GeosShape&& other) noexcept : geos_(other.geos_), shape_(std::exchange(other.shape_, nullptr)) {}
    GeosShape& operator=(GeosShape&& other) noexcept {
        std::swap(geos_, other.geos_);
        std::swap(shape_, other.shape_);
        return *this;
    }
    GeosShape(const GeosShape&) = delete;
    GeosShape& operator=(const GeosShape&) = delete;
    ~GeosShape() {
        if (shape_ != nullptr) GEOSGeom_destroy_r(geos_->handle, shape_);
    }

    double distance_to(const GeosShape& other) const {
        double apart = -1;
        GEOSDistance_r(geos_->handle, shape_, other.shape_, &apart);
        return apart;
    }
    double area() const {
        double size = -1;
        GEOSArea_r(geos_->handle, shape_, &size);
        return size;
    }
    double length() const {  ///< of the border
        double size = -1;
        GEOSLength_r(geos_->handle, shape_, &size);
        return size;
    }
    /// Area that both cover, of corners rounded to a millionth: GEOS 3.11 may be wrong about sides that are equal but for the
    /// last bits.
    double shared_with(const GeosShape& other) const {
        const GeosShape both(*geos_, GEOSIntersectionPrec_r(geos_->handle, shape_, other.shape_, 1e-6));
        return both.shape_ == nullptr ? -1 : both.area();
    }
    /// How many pieces shapes are together, where those that are no farther apart than `joint` are one.
    static int pieces_of(const Geos& geos, const std::vector<const GeosShape*>& shapes, double joint) {
        std::vector<GEOSGeometry*> broad;
        constexpr int kQuarterCircle = 2;  // segments
        for (const GeosShape* shape : shapes)
            broad.push_back(GEOSBuffer_r(geos.handle, shape->shape_, joint / 2, kQuarterCircle));
        const GeosShape all(geos, GEOSGeom_createCollection_r(geos.handle, GEOS_GEOMETRYCOLLECTION, broad.data(),
                                                              static_cast<unsigned>(broad.size())));
        const GeosShape joined(geos, GEOSUnaryUnion_r(geos.handle, all.shape_));
        return GEOSGetNumGeometries_r(geos.handle, joined.shape_);
    }

private:
    GeosShape(const Geos& geos, GEOSGeometry* shape) : geos_(&geos), shape_(shape) {}
    static GEOSCoordSequence* sequence_of(const Geos& geos, const std::vector<Point>& points, std::size_t count) {
        GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos.handle, static_cast<unsigned>(count), 2);
        for (unsigned i = 0; i < count; ++i)
            GEOSCoordSeq_setXY_r(geos.handle, sequence, i, points[i % points.size()].x, points[i % points.size()].y);
        return sequence;
    }

    const Geos* geos_;
    GEOSGeometry* shape_ = nullptr;
};

}  // namespace tactics::tests

// Affine maps of the plane: how a selection is moved, turned and scaled.
#pragma once

namespace splineloft {

/// A place of the plane of two coordinates.
struct PlanePlace {
    double x = 0, y = 0;
    bool operator==(const PlanePlace&) const = default;
};

/// x' = xx x + xy y + dx, y' = yx x + yy y + dy. As it stands, it leaves every place where it is.
struct PlaneMap {
    double xx = 1, xy = 0, yx = 0, yy = 1;
    double dx = 0, dy = 0;

    static PlaneMap moved(double dx, double dy);
    /// Away from `center`, by a factor for each axis; -1 mirrors.
    static PlaneMap scaledAbout(PlanePlace center, double byX, double byY);
    /// To the left (from x toward y), in radians.
    static PlaneMap rotatedAbout(PlanePlace center, double angle);

    PlanePlace apply(PlanePlace place) const;
    /// The same without the displacement: for differences of places, such as tangents.
    PlanePlace applyLinear(PlanePlace difference) const;

    bool operator==(const PlaneMap&) const = default;
};

/// Both, `second` after `first`.
PlaneMap composed(const PlaneMap& second, const PlaneMap& first);

} // namespace splineloft

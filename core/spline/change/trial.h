// Propose, then measure: curves of the wanted family are drawn and compared with the one to be
// converted, so that no proposal needs to be right, only one of them.
#pragma once

#include "core/spline/change/convert.h"
#include "core/spline/change/shape.h"

#include <string_view>

namespace splineloft::conversion {

/// Looks for a curve among those that are offered.
class Trial {
  public:
    Trial(const Shape& shape, const Curve& source, std::string_view family);

    /// A curve of the wanted family with the name and coordinates of the source, without points.
    /// A closed one has the family's usual ends, which it will have when it is opened.
    Curve blank() const;

    /// Draws and compares a curve. Whether it settles the matter: it agrees, and no other could
    /// keep more of the parameter.
    bool offer(const Curve& candidate);

    /// The curve that was found: one that keeps the parameter t, or else one that keeps u.
    const std::optional<Curve>& found() const { return found_; }
    /// In words, how far and where the best of those drawn is off, or why none could be drawn.
    std::string whyNot() const;

  private:
    const Shape& shape_;
    const Curve& source_;
    std::string family_;
    std::optional<Curve> found_;
    std::optional<Difference> least_;
    std::optional<Pieces> nearest_;
    std::optional<Problem> problem_;
};

} // namespace splineloft::conversion

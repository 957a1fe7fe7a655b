#include "chance.h"

#include "hand.h"

#include "core/spline/catalog.h"

#include <cstdlib>

namespace splineloft::ui {

namespace {

void addLists(Curve& curve, Chance& chance) {
    const auto& family = familyOf(curve);
    const auto n = curve.points.size();
    for (std::size_t i = 0; family.usesWeights && chance.oneIn(2) && i < n; ++i) {
        curve.weights.resize(n, 1);
        curve.weights[i] = chance.real(0.1, 5);
    }
    for (const auto& parameter : family.parameters) {
        if (parameter.local && chance.oneIn(2)) {
            curve.local[std::string(parameter.key)].assign(
                n, chance.real(parameter.sliderLeast, parameter.sliderMost));
        }
    }
    if (family.usesKnots && chance.oneIn(2)) {
        const auto degree = static_cast<std::size_t>(parameterOf(curve, "degree"));
        for (std::size_t i = 0; i < n + (curve.closed ? 1 : degree + 1); ++i) {
            curve.knots.push_back(static_cast<double>(i));
        }
        curve.ends = Ends::none;
    }
}

} // namespace

unsigned long numberFrom(const char* variable, unsigned long otherwise) {
    const char* text = std::getenv(variable);
    return text != nullptr ? std::strtoul(text, nullptr, 10) : otherwise;
}

std::size_t Chance::below(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
}

double Chance::real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
}

Document Chance::document() {
    Document document;
    for (auto count = below(4); count > 0; --count) {
        const auto& family = among(catalog());
        const bool closed = oneIn(2) && family.closable;
        auto curve = oneIn(3) ? curveOf(family.id, static_cast<int>(1 + below(6)))
                              : curveOf(family.id, closed);
        addLists(curve, *this);
        document.curves.push_back(std::make_shared<Curve>(curve));
    }
    return document;
}

} // namespace splineloft::ui

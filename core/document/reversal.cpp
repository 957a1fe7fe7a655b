#include "core/document/reversal.h"

#include "core/document/handles.h"
#include "core/spline/catalog.h"

#include <algorithm>
#include <map>

namespace splineloft {
namespace {

using Values = std::map<std::string, double>;

/// Turns the values of a family's parameters into those with which it draws the same shape
/// backwards. Most are the same either way.
void mirror(std::string_view family, Values& values) {
    if (family == "kochanek-bartels") {
        values["bias"] = 0 - values["bias"];
    } else if (family == "parametric-parabola") {
        values["mu"] = 1 - values["mu"];
    } else if (family == "beta") {
        // At a joint P'+ = b1 P'-, P"+ = b1^2 P"- + b2 P'-, solved for what is before it.
        const double bias = values["bias"];
        const auto& tension = findFamily(family)->parameters[1];
        values["tension"] = std::min(values["tension"] / (bias * bias * bias), tension.most);
        values["bias"] = 1 / bias;
    }
}

void mirrorParameters(Curve& curve) {
    completeParameters(curve);
    if (curve.family == "beta" && curve.local.contains("bias")) { // which the tension goes by
        curve.local.try_emplace("tension", curve.points.size(), curve.parameters.at("tension"));
    }
    for (std::size_t i = 0; !curve.local.empty() && i < curve.points.size(); ++i) {
        Values here = curve.parameters;
        for (const auto& [key, values] : curve.local) {
            here[key] = values[i];
        }
        mirror(curve.family, here);
        for (auto& [key, values] : curve.local) {
            values[i] = here.at(key);
        }
    }
    mirror(curve.family, curve.parameters);
}

/// Which control points change places: those that the pieces read, backwards. Number i gets what
/// was number `of(i)`, and the other way round.
class Order {
  public:
    explicit Order(const Curve& curve) : closed_(curve.closed) {
        const auto layout = layoutOf(curve);
        const auto stride = static_cast<std::size_t>(layout.stride);
        const auto window = static_cast<std::size_t>(layout.window);
        const auto n = curve.points.size();
        const bool extended = curve.ends == Ends::doubled || curve.ends == Ends::reflected;
        if (closed_) { // the window of the last piece, backwards, is that of the first
            used_ = n / stride * stride;
            last_ = 2 * used_ - stride + window - 1 - 2 * static_cast<std::size_t>(layout.lead);
        } else { // what waits for partners at the end goes on waiting there
            used_ = stride > 1 && !extended && n >= window ? n - (n - window) % stride : n;
            last_ = used_ - 1;
        }
    }

    std::size_t of(std::size_t index) const {
        if (index >= used_) {
            return index;
        }
        return closed_ ? (last_ - index) % used_ : last_ - index;
    }

  private:
    bool closed_;
    std::size_t used_ = 0, last_ = 0;
};

Points reordered(const Points& table, const Order& order, double factor) {
    Points result(table.dimension());
    result.reserve(table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        const Point own = table.at(order.of(i));
        result.append(factor == 1 ? own : factor * own);
    }
    return result;
}

std::vector<double> reordered(const std::vector<double>& values, const Order& order) {
    std::vector<double> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        result.push_back(values[order.of(i)]);
    }
    return result;
}

} // namespace

CurveEntry reversed(const CurveEntry& entry) {
    auto curve = std::make_shared<Curve>(*entry);
    const Order order(*entry);
    mirrorParameters(*curve);
    curve->points = reordered(entry->points, order, 1);
    curve->tangents = reordered(entry->tangents, order, -1);
    curve->weights = reordered(entry->weights, order);
    for (auto& [key, values] : curve->local) {
        values = reordered(values, order);
    }
    const auto& knots = entry->knots;
    for (std::size_t i = 0; i < knots.size(); ++i) {
        curve->knots[i] = knots.front() + (knots.back() - knots[knots.size() - 1 - i]);
    }
    CurveEntry result = entry;
    result.handleModes = renumbered(
        entry.handleModes, [&](std::size_t anchor) { return std::optional(order.of(anchor)); });
    settleModes(*curve, result.handleModes);
    result = std::move(curve);
    return result;
}

} // namespace splineloft

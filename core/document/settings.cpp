// Edits of how a curve is drawn: its family, parameters, weights, ends.
#include "core/document/change.h"
#include "core/document/edits.h"
#include "core/document/lists.h"
#include "core/document/tangents.h"
#include "core/spline/catalog.h"

#include <algorithm>

namespace splineloft {
namespace {

/// Whether the curve's family lets a parameter have a value at each control point.
bool mayBeLocal(const Curve& curve, std::string_view key) {
    const auto& parameters = familyOf(curve).parameters;
    const auto found = std::ranges::find(parameters, key, &Parameter::key);
    return found != parameters.end() && found->local;
}

} // namespace

Document setFamily(const Document& document, std::size_t curve, std::string_view family) {
    const Family* wanted = findFamily(family);
    if (wanted == nullptr || document.curves[curve]->family == family) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        const Family& before = familyOf(changing);
        const bool usual = changing.ends == before.ends.front();
        changing.family = family;
        changing.closed = changing.closed && wanted->closable;
        dropUnusedLists(changing);
        if (!(before.usesKnots && wanted->usesKnots)) { // of two B-splines all means the same
            changing.parameters.clear(); // elsewhere the same word means something else
            changing.local.clear();
            dropKnots(changing);
            changing.ends = usual ? wanted->ends.front() : changing.ends;
        }
        completeParameters(changing);
        changing.tangents = wanted->usesTangents
                                ? catmullRomTangents(changing.points, changing.closed)
                                : Points(changing.points.dimension());
    });
}

Document setParameter(const Document& document, std::size_t curve, std::string_view key,
                      double value) {
    return changed(document, curve, [&](Curve& changing) {
        const auto before = parameterOf(changing, key);
        changing.parameters[std::string(key)] = value;
        if (familyOf(changing).usesKnots && value != before) {
            dropKnots(changing); // they belong to the degree, and stand in place of a spacing
        }
    });
}

Document makeLocal(const Document& document, std::size_t curve, std::string_view key) {
    const Curve& old = *document.curves[curve];
    if (!mayBeLocal(old, key) || old.local.contains(std::string(key)) || old.points.empty()) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        changing.local[std::string(key)].assign(old.points.size(), parameterOf(old, key));
    });
}

Document makeGlobal(const Document& document, std::size_t curve, std::string_view key) {
    const auto& local = document.curves[curve]->local;
    const auto found = local.find(std::string(key));
    if (found == local.end()) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        const auto& values = found->second;
        if (std::ranges::all_of(values, [&](double v) { return v == values.front(); })) {
            changing.parameters[std::string(key)] = values.front();
        }
        changing.local.erase(std::string(key));
    });
}

Document setLocal(const Document& document, std::size_t curve, std::string_view key,
                  std::span<const std::size_t> points, double value) {
    const Document local = makeLocal(document, curve, key);
    if (!local.curves[curve]->local.contains(std::string(key))) {
        return document;
    }
    return changed(local, curve, [&](Curve& changing) {
        auto& values = changing.local.at(std::string(key));
        for (const auto index : points) {
            if (index < values.size()) {
                values[index] = value;
            }
        }
        if (points.empty()) {
            std::ranges::fill(values, value);
        }
    });
}

Document setWeight(const Document& document, std::size_t curve, std::size_t point, double weight) {
    const Curve& old = *document.curves[curve];
    if (!familyOf(old).usesWeights || point >= old.points.size()) {
        return document;
    }
    return changed(document, curve, [&](Curve& changing) {
        auto& weights = changing.weights;
        weights.resize(changing.points.size(), 1);
        weights[point] = weight;
        if (std::ranges::all_of(weights, [](double w) { return w == 1; })) {
            weights.clear();
        }
    });
}

Document setEnds(const Document& document, std::size_t curve, Ends ends) {
    return changed(document, curve, [&](Curve& changing) {
        changing.ends = ends;
        dropKnots(changing);
    });
}

Document setClosed(const Document& document, std::size_t curve, bool closed) {
    return changed(document, curve, [&](Curve& changing) {
        if (hasHandles(changing)) {
            fitHandlesToClosing(changing, closed);
        }
        if (changing.closed != closed) {
            changing.closed = closed;
            dropKnots(changing); // an open curve has others than a closed one
        }
    });
}

} // namespace splineloft

// The library in one include: spline curves, what can be asked of them, and their files.
//
//     const splineloft::Spline spline{.family = "cardinal", .parameters = {{"tension", 0.5}}};
//     const auto pieces = splineloft::piecesOf(spline, points); // any array of points
//     const auto place = pieces.position({0, 0.25});            // piece 0, a quarter of the way
#pragma once

#include "core/document/document.h"
#include "core/document/edits.h"
#include "core/document/history.h"
#include "core/formats/document_json.h"
#include "core/formats/file.h"
#include "core/formats/samples.h"
#include "core/spline/algebra/bernstein.h"
#include "core/spline/algebra/roots.h"
#include "core/spline/catalog.h"
#include "core/spline/change/basis_change.h"
#include "core/spline/change/constructions.h"
#include "core/spline/change/convert.h"
#include "core/spline/change/knots.h"
#include "core/spline/continuity.h"
#include "core/spline/curve.h"
#include "core/spline/fast/dense.h"
#include "core/spline/fast/natural_function.h"
#include "core/spline/fast/power_form.h"
#include "core/spline/measure/bounds.h"
#include "core/spline/measure/length.h"
#include "core/spline/measure/nearest.h"
#include "core/spline/measure/sample.h"
#include "core/spline/points_view.h"
#include "core/spline/problem.h"
#include "core/spline/shape/flatten.h"
#include "core/spline/shape/hodograph.h"
#include "core/spline/shape/intersect.h"
#include "core/spline/shape/osculating.h"
#include "core/spline/shape/self_intersect.h"
#include "core/spline/shape/subdivide.h"
#include "core/spline/shape/turning.h"
#include "core/spline/traits.h"

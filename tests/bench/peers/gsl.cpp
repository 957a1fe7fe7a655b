// GSL: natural cubic splines of gsl_spline, with an accelerator, and adaptive integration.
#include "tests/bench/peers/peers.h"
#include "tests/bench/works.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_spline.h>

namespace splineloft::bench {
namespace {

struct Free {
    void operator()(gsl_spline* spline) const { gsl_spline_free(spline); }
    void operator()(gsl_interp_accel* accelerator) const { gsl_interp_accel_free(accelerator); }
    void operator()(gsl_integration_workspace* space) const {
        gsl_integration_workspace_free(space);
    }
};
using Spline = std::shared_ptr<gsl_spline>;

Spline splineOf(const Graph& work) {
    Spline spline(gsl_spline_alloc(gsl_interp_cspline, work.x.size()), Free{});
    gsl_spline_init(spline.get(), work.x.data(), work.y.data(), work.x.size());
    return spline;
}

void evaluate(const gsl_spline* spline, gsl_interp_accel* accelerator, std::span<const double> x,
              std::span<double> out) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        out[i] = gsl_spline_eval(spline, x[i], accelerator);
    }
}

std::shared_ptr<gsl_interp_accel> accelerator() {
    return {gsl_interp_accel_alloc(), Free{}};
}

Trial build(const Graph& work) {
    const auto built = std::make_shared<Spline>(splineOf(work));
    return {.pass =
                [built, &work] { // anew, in the memory it has
                    gsl_spline_init(built->get(), work.x.data(), work.y.data(), work.x.size());
                    benchmark::ClobberMemory();
                },
            .error =
                [built, &work] {
                    std::vector<double> found(askedOfBuilt);
                    evaluate(built->get(), accelerator().get(),
                             std::span(work.asked).first(askedOfBuilt), found);
                    return deviation<double>(found, std::span(work.answers).first(askedOfBuilt));
                }};
}

Trial evaluation(const Graph& work) {
    return filling<double>(work.answers, [spline = splineOf(work), memory = accelerator(),
                                          &work](std::span<double> out) {
        evaluate(spline.get(), memory.get(), work.asked, out);
    });
}

/// Speed of the cubic whose hodograph's power coefficients are x0, x1, x2, y0, y1, y2.
double speed(double u, void* hodograph) {
    const auto* h = static_cast<const double*>(hodograph);
    const double x = h[0] + u * (h[1] + u * h[2]);
    const double y = h[3] + u * (h[4] + u * h[5]);
    return std::sqrt(x * x + y * y);
}

double cubicLengthByQags(const double* p, gsl_integration_workspace* space, std::size_t limit) {
    double hodograph[6];
    for (std::size_t c = 0; c < 2; ++c) {
        hodograph[3 * c] = 3 * (p[2 + c] - p[c]);
        hodograph[3 * c + 1] = 6 * (p[c] - 2 * p[2 + c] + p[4 + c]);
        hodograph[3 * c + 2] = 3 * (p[6 + c] - 3 * p[4 + c] + 3 * p[2 + c] - p[c]);
    }
    gsl_function integrand{speed, hodograph};
    double length = 0, error = 0;
    gsl_integration_qags(&integrand, 0, 1, 0, 1e-9, limit, space, &length, &error);
    return length;
}

Trial length() {
    constexpr std::size_t limit = 1000;
    const auto& work = randomCubics();
    const std::shared_ptr<gsl_integration_workspace> space(gsl_integration_workspace_alloc(limit),
                                                           Free{});
    const auto lengths = std::make_shared<std::vector<double>>(work.count);
    return {.pass =
                [space, lengths, &work] {
                    for (std::size_t i = 0; i < work.count; ++i) {
                        (*lengths)[i] = cubicLengthByQags(&work.bezier[8 * i], space.get(), limit);
                    }
                    benchmark::ClobberMemory();
                },
            .error = [lengths] { return deviationOfLengths(*lengths); }};
}

} // namespace

void addGsl(Contest& contest) {
    // A cubic that is hard to integrate must not end the program, as is GSL's usual way.
    gsl_set_error_handler_off();
    contest.entries.insert(contest.entries.end(),
                           {{"natural-build-1e4", "GSL", [] { return build(smallGraph()); }},
                            {"natural-build-1e6", "GSL", [] { return build(largeGraph()); }},
                            {"natural-build-even", "GSL", [] { return build(smallEvenGraph()); }},
                            {"natural-at", "GSL", [] { return evaluation(smallGraph()); }},
                            {"natural-at-even", "GSL", [] { return evaluation(smallEvenGraph()); }},
                            {"length", "GSL", length}});
}

} // namespace splineloft::bench

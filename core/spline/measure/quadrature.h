// Gauss quadrature on one panel, and what its samples tell of their own error.
//
// Sixteen samples give not only the integral but the first sixteen coefficients of the integrand's
// Legendre series. For a smooth integrand these fall geometrically, as fast as its nearest complex
// singularity lies far away, and the error of the integral is about the coefficient twice as far
// along (Trefethen 2008, "Is Gauss Quadrature Better than Clenshaw-Curtis?"). So a panel says by
// itself whether it is good, without a second look at halves of it.
#pragma once

#include "core/spline/fast/lanes/speed_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

namespace splineloft::gauss {

/// Samples lie in pairs, at +x and -x.
inline constexpr std::size_t pairs = 8;
inline constexpr std::size_t count = 2 * pairs;

/// One number a pair.
using Pairs = std::array<double, pairs>;
static_assert(std::same_as<Pairs, lanes::Eight>);

// 16-point Gauss-Legendre rule on [-1, 1]: the positive nodes and their weights
// (Abramowitz and Stegun 1964, table 25.4).
inline constexpr Pairs nodes = {
    0.0950125098376374401853193354249581, 0.2816035507792589132304605014604961,
    0.4580167776572273863424194429835776, 0.6178762444026437484466717640487911,
    0.7554044083550030338951011948474422, 0.8656312023878317438804678977123931,
    0.9445750230732325760779884155346083, 0.9894009349916499325961541734503326};
inline constexpr Pairs weights = {
    0.1894506104550684962853967232082831, 0.1826034150449235888667636679692199,
    0.1691565193950025381893120790303600, 0.1495959888165767320815017305474786,
    0.1246289712555338720524762821920164, 0.0951585116824927848099251076022462,
    0.0622535239386478928628438369943776, 0.0271524594117540948517805724560181};

/// The rule of 32 points (the same table), for those who want the integral alone.
inline constexpr lanes::WideRule wide = {
    {0.0483076656877383162348125704405022, 0.144471961582796493485186373598811,
     0.239287362252137074544603209165502, 0.331868602282127649779916805730188,
     0.421351276130635345364119436172426, 0.506899908932229390023747474377821,
     0.587715757240762329040745476401827, 0.663044266930215200975115168663238,
     0.732182118740289680387426665091267, 0.794483795967942406963097298970429,
     0.849367613732569970133693004967743, 0.896321155766052123965307243719212,
     0.934906075937739689170919134835409, 0.964762255587506430773811928118275,
     0.985611511545268335400175044630902, 0.997263861849481563544981128665041},
    {0.0965400885147278005667648300635758, 0.0956387200792748594190820022041311,
     0.0938443990808045656391802376681173, 0.0911738786957638847128685771116371,
     0.0876520930044038111427714627518023, 0.0833119242269467552221990746043486,
     0.0781938957870703064717409188283067, 0.0723457941088485062253993564784878,
     0.0658222227763618468376500637069388, 0.0586840934785355471452836373001709,
     0.0509980592623761761961632446895217, 0.0428358980222266806568786466061255,
     0.0342738629130214331026877322523727, 0.0253920653092620594557525897892240,
     0.0162743947309056706051705622063866, 0.00701861000947009660040706373885318}};

/// What a function is at the nodes of [-1, 1].
using Samples = lanes::EightPairs;

/// The integral over [-1, 1] of what was sampled.
inline double integralOf(const Samples& samples) {
    double even = 0, odd = 0;
    for (std::size_t i = 0; i < pairs; i += 2) {
        even += weights[i] * (samples.after[i] + samples.before[i]);
        odd += weights[i + 1] * (samples.after[i + 1] + samples.before[i + 1]);
    }
    return even + odd;
}

/// The Legendre series of what was sampled: coefficients 0 to 15.
class Spectrum {
  public:
    explicit Spectrum(const Samples& samples);

    /// The coefficients of orders 0, 2, 4 to 14, and of orders 1, 3, 5 to 15.
    const Pairs& even() const { return even_; }
    const Pairs& odd() const { return odd_; }

    /// Size of the last coefficients: the error of the series between the nodes.
    double tail() const { return largest(odd_[6], even_[7], odd_[7]); }

    /// Estimate of the integral's error, on the safe side: the fall from coefficients 5, 6, 7 to
    /// 13, 14, 15 goes on for twice as long, of which it takes half. (Three of each, because single
    /// ones may vanish by chance or symmetry.)
    double error() const {
        const double late = tail();
        const double early = largest(odd_[2], even_[3], odd_[3]);
        return early > late ? late * (late / early) : late;
    }

  private:
    static double largest(double a, double b, double c) {
        return std::max({std::abs(a), std::abs(b), std::abs(c)});
    }

    Pairs even_, odd_;
};

} // namespace splineloft::gauss

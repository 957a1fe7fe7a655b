#include "tests/bench/contest.h"

#include "tests/bench/peers/peers.h"
#include "tests/bench/rows.h"

namespace splineloft::bench {

Contest wholeContest() {
    Contest contest;
    addDense(contest);
    addLarge(contest);
    addRandom(contest);
    addHighDegree(contest);
    addNatural(contest);
    addLength(contest);
    addEven(contest);
    addNearest(contest);
    addBSpline(contest);
    addJets(contest);
#ifdef BENCH_HAS_GLM
    addGlm(contest);
#endif
#ifdef BENCH_HAS_EIGEN
    addEigen(contest);
#endif
#ifdef BENCH_HAS_GSL
    addGsl(contest);
#endif
#ifdef BENCH_HAS_BOOST
    addBoost(contest);
#endif
#ifdef BENCH_HAS_SISL
    addSisl(contest);
#endif
#ifdef BENCH_HAS_LIB2GEOM
    addLib2geom(contest);
#endif
    return contest;
}

} // namespace splineloft::bench

// How samples lie in the lanes of vectors, so that their coordinates go to memory point after point
// in few steps. Included once for every set of instructions, by files that are.
#if defined(SPLINELOFT_LANES_WEAVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef SPLINELOFT_LANES_WEAVE_INL_H
#undef SPLINELOFT_LANES_WEAVE_INL_H
#else
#define SPLINELOFT_LANES_WEAVE_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace splineloft::lanes::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
template <class Lane> using Tag = hn::ScalableTag<Lane>;
template <class Lane> using Vector = hn::Vec<Tag<Lane>>;

/// Coordinates of a vector of samples on their way to rows of points. The samples lie in the lanes
/// in such an order that few shuffles are left: it is the arguments that are brought into it.
template <int dimension, class Lane, class Number> class Weave {
  public:
    static constexpr std::size_t lanes = hn::MaxLanes(Tag<Lane>());

    Weave() {
        static constexpr Tables tables = makeTables();
        back_ = hn::SetTableIndices(Tag<Lane>(), tables.back);
        for (std::size_t c = 0; c < dimension; ++c) {
            orders_[c] = hn::SetTableIndices(Tag<Lane>(), tables.samples[c]);
            every_[c] = hn::Eq(hn::Load(Tag<Lane>(), tables.coordinates),
                               hn::Set(Tag<Lane>(), static_cast<Lane>(c)));
        }
    }

    /// A vector of a table, in the order for one coordinate.
    HWY_INLINE Vector<Lane> load(const Lane* table, std::size_t coordinate) const {
        const auto samples = hn::LoadU(Tag<Lane>(), table);
        if constexpr (dimension == 1 || (dimension == 2 && lanes * sizeof(Number) <= 16)) {
            return samples;
        } else {
            return hn::TableLookupLanes(samples, orders_[dimension == 2 ? 0 : coordinate]);
        }
    }

    /// A number of each sample, loaded in the order for the first coordinate.
    HWY_INLINE void storeOne(Vector<Lane> v, Number* HWY_RESTRICT out) const {
        storeVector(hn::TableLookupLanes(v, back_), out);
    }

    HWY_INLINE void store(const Vector<Lane> (&p)[dimension], Number* HWY_RESTRICT out) const {
        if constexpr (dimension == 1) {
            storeVector(p[0], out);
        } else if constexpr (dimension == 2) {
            storePairs(p[0], p[1], out);
        } else {
            // Each lane of each vector of memory has its coordinate there already.
            for (std::size_t v = 0; v < 3; ++v) {
                const auto rest = hn::IfThenElse(every_[(1 + 2 * v * lanes) % 3], p[1], p[2]);
                const auto whole = hn::IfThenElse(every_[2 * v * lanes % 3], p[0], rest);
                storeVector(whole, out + v * lanes);
            }
        }
    }

  private:
    using Index = hwy::MakeSigned<Lane>;
    using Order = decltype(hn::SetTableIndices(Tag<Lane>(), static_cast<const Index*>(nullptr)));
    /// As many numbers as there are lanes.
    using Numbers = hn::Rebind<Number, Tag<Lane>>;

    struct Tables {
        HWY_ALIGN Index samples[dimension][lanes]; ///< which sample is in a lane
        HWY_ALIGN Index back[lanes];               ///< in which lane a sample is, for the first
        HWY_ALIGN Lane coordinates[lanes];         ///< lane % dimension
    };

    static constexpr Tables makeTables() {
        Tables tables{};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            tables.coordinates[lane] = static_cast<Lane>(lane % dimension);
            tables.back[sampleOfLane(lane, 0)] = static_cast<Index>(lane);
            for (std::size_t c = 0; c < dimension; ++c) {
                tables.samples[c][lane] = static_cast<Index>(sampleOfLane(lane, c));
            }
        }
        return tables;
    }

    /// Machines interleave two vectors within blocks of 16 bytes, so pairs of samples lie in every
    /// other half of a block. Of three coordinates each number has the lane where it goes to.
    static constexpr std::size_t sampleOfLane(std::size_t lane, std::size_t coordinate) {
        if constexpr (dimension == 2) {
            constexpr auto block = HWY_MIN(16 / sizeof(Number), lanes);
            constexpr auto half = HWY_MAX(block / 2, 1);
            const auto lower = lane / block * half;
            const auto within = lane % block;
            return within < half ? lower + within : lanes / 2 + lower + within - half;
        } else {
            std::size_t sample = 0;
            while ((sample * dimension + coordinate) % lanes != lane) {
                ++sample;
            }
            return sample;
        }
    }

    static HWY_INLINE auto rounded(Vector<Lane> v) {
        if constexpr (sizeof(Lane) == sizeof(Number)) {
            return v;
        } else {
            return hn::DemoteTo(Numbers(), v);
        }
    }

    static HWY_INLINE void storeVector(Vector<Lane> v, Number* HWY_RESTRICT out) {
        hn::StoreU(rounded(v), Numbers(), out);
    }

    static HWY_INLINE void storePairs(Vector<Lane> x, Vector<Lane> y, Number* HWY_RESTRICT out) {
#if HWY_TARGET == HWY_SCALAR
        hn::StoreInterleaved2(rounded(x), rounded(y), Numbers(), out);
#else
        const auto p = rounded(x), q = rounded(y);
        hn::StoreU(hn::InterleaveLower(Numbers(), p, q), Numbers(), out);
        hn::StoreU(hn::InterleaveUpper(Numbers(), p, q), Numbers(), out + lanes);
#endif
    }

    Order orders_[dimension];
    Order back_;
    hn::Mask<Tag<Lane>> every_[dimension]; ///< lanes 0, d, 2d, ..., then 1, d + 1, ... and so on
};

/// The first sample, less than a vector on, from which on points fill whole vectors of memory; 0
/// where there is none. Stores that straddle lines of the cache take twice the time.
template <int dimension, class Lane, class Number>
HWY_INLINE std::size_t samplesToLine(const Number* out) {
    constexpr auto lanes = hn::MaxLanes(Tag<Lane>());
    const auto address = reinterpret_cast<std::uintptr_t>(out);
    for (std::size_t i = 0; i < lanes; ++i) {
        if ((address + i * dimension * sizeof(Number)) % (lanes * sizeof(Number)) == 0) {
            return i;
        }
    }
    return 0;
}

} // namespace
} // namespace splineloft::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif

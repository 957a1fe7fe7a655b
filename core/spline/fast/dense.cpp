#include "core/spline/fast/dense.h"

#include "core/spline/fast/lanes/column_sampler.h"
#include "core/spline/fast/lanes/direct_sampler.h"
#include "core/spline/fast/lanes/plane_jet_lanes.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace splineloft {
namespace {

using lanes::ColumnSampler;

double along(std::size_t k, std::size_t perPiece) {
    return static_cast<double>(k) / static_cast<double>(perPiece);
}

template <class Number> void write(const Point& place, Number* out) {
    for (int c = 0; c < place.dimension(); ++c) {
        out[c] = static_cast<Number>(place[c]);
    }
}

template <class Number>
void sampleByColumns(const Pieces& pieces, std::size_t perPiece, std::span<Number> out) {
    ColumnSampler sampler(pieces, 0, perPiece);
    auto* next = out.data();
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        sampler.choosePiece(piece);
        for (std::size_t begin = 0; begin < perPiece; begin += ColumnSampler::mostSamples) {
            const auto end = std::min(begin + ColumnSampler::mostSamples, perPiece);
            const auto& columns = sampler.sample(begin, end);
            if (pieces.form() == Form::rational) {
                lanes::projectPositions(columns);
            }
            lanes::weave(columns, next);
            next += (end - begin) * static_cast<std::size_t>(pieces.dimension());
        }
    }
}

/// By de Casteljau's construction, for degrees at which scaled coefficients would overflow.
template <class Number>
void sampleSlowly(const Pieces& pieces, std::size_t perPiece, std::span<Number> out) {
    auto* next = out.data();
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        for (std::size_t k = 0; k < perPiece; ++k) {
            write(pieces.position({piece, along(k, perPiece)}), next);
            next += pieces.dimension();
        }
    }
}

template <class Number> void writeEnd(const Pieces& pieces, std::span<Number> out) {
    if (pieces.form() == Form::polynomial) {
        std::ranges::transform(pieces.bezier().last(out.size()), out.begin(),
                               [](double number) { return static_cast<Number>(number); });
    } else {
        write(pieces[pieces.size() - 1].bezierPoint(pieces.degree()), out.data());
    }
}

template <class Number>
void writePositions(const Pieces& pieces, std::size_t perPiece, std::span<Number> out) {
    const auto places = placesPerPiece(pieces, perPiece);
    const auto dimension = static_cast<std::size_t>(pieces.dimension());
    if (out.size() != places * dimension) {
        throw std::invalid_argument("positionsPerPiece: " + std::to_string(places) +
                                    " places of dimension " + std::to_string(dimension) +
                                    " need room for " + std::to_string(places * dimension) +
                                    " numbers, not " + std::to_string(out.size()));
    }
    if (places == 0) {
        return;
    }
    const auto before = out.first(out.size() - dimension);
    if (pieces.degree() > lanes::mostScaledDegree) {
        sampleSlowly(pieces, perPiece, before);
    } else if (pieces.form() == Form::polynomial &&
               pieces.dimension() <= lanes::mostDirectDimension) {
        lanes::sampleDirectly(pieces, perPiece, lanes::storeFor(before.size_bytes()), before);
    } else {
        sampleByColumns(pieces, perPiece, before);
    }
    writeEnd(pieces, out.last(dimension));
}

/// Where the next row of each table goes.
struct JetRows {
    double* position;
    double* first;
    double* curvature;
};

void writeJet(const Jet& jet, JetRows& rows) {
    write(jet.position, rows.position);
    write(jet.first, rows.first);
    *rows.curvature = jet.curvature.value_or(0);
    rows.position += jet.position.dimension();
    rows.first += jet.position.dimension();
    ++rows.curvature;
}

/// Plane polynomials have all in one pass.
bool haveDirectJets(const Pieces& pieces) {
    return pieces.form() == Form::polynomial && pieces.dimension() == 2 && pieces.degree() >= 2 &&
           !lanes::isScaled(pieces.degree());
}

void writeDirectJets(const Pieces& pieces, std::size_t perPiece, JetRows& rows) {
    const lanes::CoefficientMaker maker(pieces.degree());
    const auto run = lanes::runsOf(pieces.degree(), perPiece).front();
    const auto numbers = 2 * static_cast<std::size_t>(pieces.degree() + 1);
    std::vector<double> coefficients(numbers);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        maker.make(pieces.bezier().data() + piece * numbers, 2, coefficients.data());
        lanes::planeJets({coefficients.data(), pieces.degree(), run.x.data(), perPiece},
                         rows.position, rows.first, rows.curvature);
        rows.position += 2 * perPiece;
        rows.first += 2 * perPiece;
        rows.curvature += perPiece;
    }
}

void writeJets(const Pieces& pieces, std::size_t perPiece, JetRows& rows) {
    ColumnSampler positions(pieces, 0, perPiece);
    ColumnSampler firsts(pieces, 1, perPiece);
    ColumnSampler seconds(pieces, 2, perPiece);
    std::vector<double> curvatures(ColumnSampler::mostSamples + lanes::runPadding);
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        positions.choosePiece(piece);
        firsts.choosePiece(piece);
        seconds.choosePiece(piece);
        for (std::size_t begin = 0; begin < perPiece; begin += ColumnSampler::mostSamples) {
            const auto end = std::min(begin + ColumnSampler::mostSamples, perPiece);
            const auto& p = positions.sample(begin, end);
            const auto& f = firsts.sample(begin, end);
            const auto& s = seconds.sample(begin, end);
            if (pieces.form() == Form::rational) {
                lanes::projectJets(p, f, s);
            }
            lanes::curvaturesOf(f, s, curvatures.data());
            lanes::weave(p, rows.position);
            lanes::weave(f, rows.first);
            std::copy_n(curvatures.begin(), end - begin, rows.curvature);
            rows.position += (end - begin) * static_cast<std::size_t>(pieces.dimension());
            rows.first += (end - begin) * static_cast<std::size_t>(pieces.dimension());
            rows.curvature += end - begin;
        }
    }
}

} // namespace

std::size_t placesPerPiece(const Pieces& pieces, std::size_t perPiece) {
    return pieces.empty() || perPiece == 0 ? 0 : pieces.size() * perPiece + 1;
}

void positionsPerPiece(const Pieces& pieces, std::size_t perPiece, std::span<double> out) {
    writePositions(pieces, perPiece, out);
}

void positionsPerPiece(const Pieces& pieces, std::size_t perPiece, std::span<float> out) {
    writePositions(pieces, perPiece, out);
}

DenseJets jetsPerPiece(const Pieces& pieces, std::size_t perPiece) {
    DenseJets jets;
    jetsPerPiece(pieces, perPiece, jets);
    return jets;
}

void jetsPerPiece(const Pieces& pieces, std::size_t perPiece, DenseJets& jets) {
    const auto places = placesPerPiece(pieces, perPiece);
    jets.positions.resize(places * static_cast<std::size_t>(pieces.dimension()));
    jets.firsts.resize(jets.positions.size());
    jets.curvatures.resize(places);
    if (places == 0) {
        return;
    }
    JetRows rows{jets.positions.data(), jets.firsts.data(), jets.curvatures.data()};
    if (pieces.degree() > lanes::mostScaledDegree) {
        for (std::size_t k = 0; k + 1 < places; ++k) {
            writeJet(pieces.jet({k / perPiece, along(k % perPiece, perPiece)}), rows);
        }
    } else if (haveDirectJets(pieces)) {
        writeDirectJets(pieces, perPiece, rows);
    } else {
        writeJets(pieces, perPiece, rows);
    }
    writeJet(pieces.jet({pieces.size() - 1, 1}), rows);
}

} // namespace splineloft

// Chance, for tests that do at random what a hand could do: choices, numbers and documents, all
// from a seed.
#pragma once

#include "core/document/document.h"

#include <random>

namespace splineloft::ui {

/// The number in an environment variable, or another one where it is not set.
unsigned long numberFrom(const char* variable, unsigned long otherwise);

class Chance {
  public:
    explicit Chance(unsigned long seed) : random_(static_cast<std::mt19937::result_type>(seed)) {}

    /// A whole number from 0 to count - 1; `count` must be above 0.
    std::size_t below(std::size_t count);
    bool oneIn(std::size_t count) { return below(count) == 0; }
    double real(double low, double high);
    template <class List> auto& among(const List& list) { return list[below(list.size())]; }

    /// Up to three curves of any families; now and then with weights, local parameters, knots.
    Document document();

  private:
    std::mt19937 random_;
};

} // namespace splineloft::ui

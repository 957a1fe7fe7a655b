// Which instructions the fast evaluation runs on: the program holds it once for each set of
// instructions and takes, when it runs, the best that the machine has.
#pragma once

#include <string>
#include <vector>

namespace splineloft::lanes {

/// Names of the sets that this program holds and this machine has, best first, e.g. "AVX2".
std::vector<std::string> instructionSets();

/// From now on only the named set is used; with an empty name, again the best. For tests, when
/// nothing else runs. Throws std::invalid_argument if the name is not among `instructionSets()`.
void useInstructionSet(const std::string& name);

} // namespace splineloft::lanes

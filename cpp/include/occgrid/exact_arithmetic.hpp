// Whether this library was compiled to arithmetic that keeps the map's bits.
#pragma once

namespace occgrid {

/// Throws std::runtime_error, with one line that says what to do, unless the
/// library computes as SPEC.md section 1 has it: IEEE-754 binary64, to
/// nearest, each operation rounded once and in order, subnormals, signed zeros
/// and NaN kept.
///
/// Compilers have many flags that change this, and not all can be seen while
/// compiling. So a few dozen operations are made, once in a process, and their
/// bits compared: some microseconds. Every OccupancyGrid asks for it.
void require_exact_arithmetic();

}  // namespace occgrid

// Numbers as a scenario and the command line have them (SPEC.md section 5.1).
// Nothing here depends on a locale.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace occgrid {

/// Characters are compared as such: the functions of <cctype> depend on the
/// locale.
inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// A number, NaN and infinity included, or none.
std::optional<double> parse_number(std::string_view token);

/// A whole number, digits only; 2^62 for any that is greater. Or none.
std::optional<std::int64_t> parse_whole(std::string_view token);

}  // namespace occgrid

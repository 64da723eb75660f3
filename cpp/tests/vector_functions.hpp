// The functions of scenarios/vectors/, answered in text: for the probe, and
// for the test of the vectors themselves.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

using Columns = std::vector<std::string>;

/// Input columns to output columns. Throws where the input is no input.
using VectorFunction = std::function<Columns(const Columns& input)>;

/// By name. Doubles are 16 hexadecimal digits, words of Philox 8.
const std::map<std::string, VectorFunction>& vector_functions();

#pragma once

#include <cstddef>
#include <string>

namespace pbffd {

// How figures are written wherever they are read by people: "2,903", "\u22120.35".

/// Thousands apart by commas.
std::string counted(std::size_t count);

/// Three digits that count, thousands apart by commas, with a minus sign that is no hyphen; powers of ten only
/// where the zeros would not be read any more.
std::string figures(double value);

}  // namespace pbffd

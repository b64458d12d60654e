#pragma once
#include <vector>

namespace ringfilm::models {

/// x of A x = b by elimination with row pivots; A row after row. An unknown that no equation holds is zero.
std::vector<double> linear_solution(std::vector<std::vector<double>> A, std::vector<double> b);

}  // namespace ringfilm::models

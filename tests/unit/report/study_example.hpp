#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/study/design/plan.hpp"

/// Pages of studies with made-up values.
namespace example {

/// A cycle value of a scenario, by its name and the numbers of the scenario's factors.
using MadeUp = std::function<double(const std::string& value, const ringfilm::study::Point& point)>;

/// The page of a study whose file holds these lines, with bases "new" and "worn" that have their cases; scenarios of
/// which `made_up` gives no finite film are not solved. @param files that are next to it: names and contents
std::string study_page(const std::string& lines, const MadeUp& made_up,
                       const std::vector<std::pair<std::string, std::string>>& files = {});

/// Two bases, three factors of which two are correlated, Sobol points with indices, curves.
std::string uncertainty_page(const std::string& title = "made-up uncertainty");
/// Speed, temperature and a law: a grid with unsolved corners.
std::string map_page();
std::string screening_page();
/// A law, as it is in each base.
std::string comparison_page();
/// Three operating points of both bases, whose weighted mean is not their median.
std::string points_page();
/// Speeds of one base with all curves, more than are drawn; every value but the film is the same to a millionth.
std::string sweep_page();

}  // namespace example

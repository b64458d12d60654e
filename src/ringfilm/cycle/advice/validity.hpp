#pragma once
#include <vector>

#include "ringfilm/cycle/integration/time_integration.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"

namespace ringfilm::cycle {

/// Asperity load from separations at which the contact law is not trusted: beyond the turning point of the printed F5/2
/// polynomial, beyond the last separation of a table at which several spots carry.
struct UntrustedContact {
  long steps = 0;             ///< crank steps with asperity load from there, of the polynomial
  double largest_share = 0;   ///< largest share of the asperity load that is from there, at one of these steps [-]
  double share_of_cycle = 0;  ///< share of the asperity load over the cycle that is from there, for a table [-]
};

/// Notes on models used outside the range in which they were made, and on results that no ring can have.
/// @param grid the cells of the film  @param values of the cycle; zeros where it was not finished
void append_validity_notes(const Setup& setup, const film::FilmGrid& grid, const std::vector<Sample>& base,
                           const CycleValues& values, const UntrustedContact& untrusted, std::vector<Note>& notes);

/// The note on steps of the cycle that could not be cut as far as their error requires: a limit of the result, or for
/// information where it changes the values by less than the accuracy of the case.
/// @param base samples at the base angles of the cycle
void append_step_note(const Setup& setup, const std::vector<Sample>& base, const std::vector<UncontrolledStep>& steps,
                      std::vector<Note>& notes);

/// The note on oil on the liner that has not come to rest in a cycle that was finished.
Note settling_note(double cycles, double oil_ahead);

/// Notes on remedies that the solver had to use.
void append_effort_notes(const Effort& effort, const TimeIntegration::Totals& totals, std::vector<Note>& notes);

}  // namespace ringfilm::cycle

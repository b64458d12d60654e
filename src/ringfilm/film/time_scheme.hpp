#pragma once

namespace ringfilm::film {

/// BDF2, eq-bdf2. The rate of growth of the film is its difference from `of_state` times the last film less `of_before`
/// times the film before it, divided by `time_step`.
struct Bdf2 {
  double of_state, of_before;  ///< [-]
  double time_step;            ///< [s]

  /// @param step that is taken @param last the one before it [s]
  Bdf2(double step, double last) {
    const double ratio = step / last, of_new = (1 + 2 * ratio) / (1 + ratio);
    of_state = (1 + ratio) / of_new;
    of_before = ratio * ratio / (1 + ratio) / of_new;
    time_step = step / of_new;
  }
};

/// What the films before a step lead to expect of it, and how its difference from that measures its error,
/// eq-time-error and eq-bdf2-error.
struct Prediction {
  double of_state, of_before, of_older;  ///< weights of the last three films [-]
  double error_share;                    ///< share of the difference from the prediction that is the error [-]

  double expected(double state, double before, double older) const {
    return of_state * state + of_before * before + of_older * older;
  }

  /// Backward Euler against the line through the last two. @param step that is taken @param last the one before it [s]
  static Prediction line(double step, double last) {
    const double ratio = step / last;
    return {1 + ratio, -ratio, 0, step / (step + last)};
  }

  /// BDF2 against the parabola through the last three. @param older the step before `last` [s]
  static Prediction parabola(double step, double last, double older) {
    const double two = step + last, three = two + older;
    return {two * three / (last * (last + older)), -step * three / (last * older),
            step * two / (older * (last + older)), step * two / ((last + 2 * step) * three)};
  }
};

}  // namespace ringfilm::film

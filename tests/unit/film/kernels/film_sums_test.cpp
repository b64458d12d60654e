#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/models/contact/contact_fit.hpp"

namespace ringfilm::film {
namespace {

using Numbers = std::vector<double>;

/// Lengths that fill registers of all widths, and leave some nodes over.
constexpr int kNodes[] = {3, 4, 9, 15, 16, 17, 98, 300};

class FilmSumsOf : public ::testing::TestWithParam<std::string> {
 protected:
  const FilmKernels& kernels_ = kernels(GetParam());

  Numbers drawn(int n, double low, double high) {
    std::uniform_real_distribution<double> between(low, high);
    Numbers numbers(n);
    for (double& x : numbers) x = between(random_);
    return numbers;
  }

 private:
  std::mt19937 random_{7};
};

std::vector<std::string> names() {
  const auto all = kernel_names();
  return {all.begin(), all.end()};
}
INSTANTIATE_TEST_SUITE_P(Everywhere, FilmSumsOf, ::testing::ValuesIn(names()), [](const auto& of) { return of.param; });

TEST_P(FilmSumsOf, MassIsRememberedAndExpectedNodeByNode) {
  for (const int n : kNodes) {
    const Numbers state = drawn(n, 1, 2), before = drawn(n, 1, 2), older = drawn(n, 1, 2), is = drawn(n, 1, 2);
    Numbers remembered(n);
    const double least =
        kernels_.remembered_mass({1.6, -0.9, 0, state.data(), before.data(), nullptr}, n, remembered.data());
    double lowest = 0, off = 0, all = 0;
    for (int i = 0; i < n; ++i) {
      EXPECT_NEAR(remembered[i], 1.6 * state[i] - 0.9 * before[i], 1e-15);  // of numbers about 1
      lowest = std::min(lowest, remembered[i]);
      off += std::abs(is[i] - (2.5 * state[i] - 2 * before[i] + 0.5 * older[i]));
      all += is[i];
    }
    EXPECT_NEAR(least, lowest, 1e-15);
    const MassSums sums = kernels_.mass_off(is.data(), {2.5, -2, 0.5, state.data(), before.data(), older.data()}, n);
    EXPECT_NEAR(sums.off, off, 1e-13 * n);
    EXPECT_NEAR(sums.all, all, 1e-13 * n);
  }
}

TEST_P(FilmSumsOf, NodesGoOnAsTheyDidOrCrossOver) {
  const double p_c = 1e5;
  struct Node {
    double p_before, p, deficit_before, deficit, p_next, deficit_next;
  };
  const Node nodes[] = {
      {3e5, 4e5, 0, 0, 5e5, 0},        // a film that rises
      {3e5, 1.5e5, 0, 0, p_c, 1e-6},   // and one that would fall below p_c
      {8e5, 5e5, 0, 0, 5e5, 0},        // or lose more than half: it stays
      {p_c, p_c, 0.2, 0.3, p_c, 0.4},  // a cavity that empties
      {p_c, p_c, 0.3, 0.1, p_c, 0},    // and one that would be more than full
      {p_c, p_c, 0.3, 0.7, p_c, 0.7},  // or less than empty: it stays
      {p_c, 2e5, 0.3, 0, 2e5, 0},      // what was another thing stays
      {2e5, p_c, 0, 0.3, p_c, 0.3},
  };
  for (const int n : kNodes) {
    Numbers p_before, p, deficit_before, deficit;
    for (int i = 0; i < n; ++i) {
      const Node& node = nodes[i % std::size(nodes)];
      p_before.push_back(node.p_before);
      p.push_back(node.p);
      deficit_before.push_back(node.deficit_before);
      deficit.push_back(node.deficit);
    }
    Numbers p_next = p, deficit_next = deficit;
    kernels_.continued({p.data(), p_before.data(), deficit.data(), deficit_before.data(), 1, p_c}, n,
                       {p_next.data(), deficit_next.data()});
    for (int i = 0; i < n; ++i) {
      const Node& node = nodes[i % std::size(nodes)];
      EXPECT_DOUBLE_EQ(p_next[i], node.p_next) << i;
      EXPECT_NEAR(deficit_next[i], node.deficit_next, 1e-15) << i;
    }
  }
}

TEST_P(FilmSumsOf, EveryNodeIsCountedOnce) {
  const double h_m = 1e-6, U = 8;
  for (const int n_nodes : kNodes) {
    const int n = n_nodes - 1;
    const Numbers node_height = drawn(n_nodes, 0, 4e-6), face_height = drawn(n, 0, 4e-6), share(n_nodes, 1e-6);
    const Numbers spacing = drawn(n, 1e-6, 2e-6), p = drawn(n_nodes, 1e5, 1e6), full(n_nodes, 0.0);
    const Numbers mass = drawn(n_nodes, 1e-3, 2e-3), rho = drawn(n_nodes, 850, 900), K = drawn(n_nodes, 8e4, 2e5);
    FilmView film{};
    film.n_cells = n;
    film.node_height = node_height.data();
    film.face_height = face_height.data();
    film.share = share.data();
    film.spacing = spacing.data();
    film.p = p.data();
    film.deficit = film.shear_deficit = full.data();
    film.mass_per_area = mass.data();
    film.h_m = h_m;
    film.deficit_share = 1;
    const StepView step{U, 1e3, full.data()};
    const NodalOilView oil{rho.data(), K.data()};
    const FilmSums sums = kernels_.sums_of_given_oil(film, oil, step, {nullptr, nullptr, 0});
    double load = 0, rate_squared = 0;
    for (int i = 0; i <= n; ++i) load += share[i] * p[i];
    for (int i = 1; i < n; ++i) {
      const double h = h_m + node_height[i], slope = (p[i + 1] - p[i - 1]) / (spacing[i - 1] + spacing[i]);
      const double by_pressure = kPressureShear * h * slope * K[i] / rho[i];  // eq-shear-rate
      rate_squared = std::max(rate_squared, U / h * (U / h) + by_pressure * by_pressure);
    }
    EXPECT_NEAR(sums.hydrodynamic_load, load, 1e-13 * load);
    EXPECT_NEAR(sums.peak_shear_squared, rate_squared, 1e-13 * rate_squared);
    const HeatingSums heating = kernels_.heating_of_given_oil(film, oil, U);
    EXPECT_DOUBLE_EQ(sums.heating.dissipation, heating.dissipation);
    EXPECT_DOUBLE_EQ(sums.heating.flow, heating.flow);
    EXPECT_DOUBLE_EQ(sums.heating.length, heating.length);

    const Numbers thinning = drawn(n_nodes, 0.5, 1), mobility = drawn(n_nodes, 0.5, 2);
    const Numbers carried = drawn(n, -1e-7, 1e-7), sliding_stress = drawn(n, 1, 2);
    FilmView with_factors = film;
    with_factors.thinning = thinning.data();
    with_factors.mobility = mobility.data();
    with_factors.carried = carried.data();
    with_factors.sliding_stress = sliding_stress.data();
    double dissipation = 0, conductance = 0, flow = 0;
    for (int i = 0; i < n; ++i) {  // eq-viscous-heating
      const double h = h_m + face_height[i], slope = (p[i + 1] - p[i]) / spacing[i];
      const double eta = 0.5 * (thinning[i] * rho[i] / K[i] + thinning[i + 1] * rho[i + 1] / K[i + 1]);
      const double resistance = 0.5 * (rho[i] / (K[i] * mobility[i]) + rho[i + 1] / (K[i + 1] * mobility[i + 1]));
      const double by_pressure = h * h * h * slope / (12 * resistance);
      dissipation += spacing[i] * (sliding_stress[i] * eta * U * U / h + by_pressure * slope);
      conductance += spacing[i] * sliding_stress[i] / h;
      flow += spacing[i] * 0.5 * (rho[i] + rho[i + 1]) * (0.5 * U * (h + carried[i]) - by_pressure);
    }
    const HeatingSums heating_with_factors = kernels_.heating_of_given_oil(with_factors, oil, U);
    EXPECT_NEAR(heating_with_factors.dissipation, dissipation, 1e-13 * dissipation);
    EXPECT_NEAR(heating_with_factors.conductance, conductance, 1e-13 * conductance);
    EXPECT_NEAR(heating_with_factors.flow, flow, 1e-12 * std::abs(flow));

    const models::ContactFit& fit = models::contact_fit();
    const double reach = 3e-6;
    const ContactSums contact =
        kernels_.contact(film, {fit.P52.data(), fit.P2.data(), reach, 2 / reach, 1, 1, 1, 2e-6});
    double sum = 0, beyond = 0;
    for (int i = 0; i <= n; ++i) {
      FilmView node = film;  // of one node alone
      node.n_cells = 0;
      node.node_height += i;
      node.share += i;
      const ContactSums of = kernels_.contact(node, {fit.P52.data(), fit.P2.data(), reach, 2 / reach, 1, 1, 1, 2e-6});
      sum += of.load;
      beyond += of.load_beyond;
    }
    EXPECT_NEAR(contact.load, sum, 1e-12 * sum);
    EXPECT_NEAR(contact.load_beyond, beyond, 1e-12 * sum);
  }
}

}  // namespace
}  // namespace ringfilm::film

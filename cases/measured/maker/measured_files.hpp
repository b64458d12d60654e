#pragma once
#include <string>
#include <vector>

/// Synthetic files of instruments, made such that the chain of docs/manual/measured-chain.md gives Tables 1, 2 and 4 of
/// styles2014 back. What it should give back is read from cases/styles2014/.
namespace ringfilm::measured_files {

struct GeneratedFile {
  std::string name;
  std::string bytes;
};

/// What one ring should come out as.
struct TargetRing {
  std::string name;                ///< as the files are named
  double density_per_m2;           ///< N
  double beta_m;                   ///< beta
  double sigma_m;                  ///< sigma
  double shear_strength;           ///< zeta
  std::vector<double> face_mm_um;  ///< coefficients, highest power first
};

/// The rings of cases/styles2014/. @param cases the folder that holds it
std::vector<TargetRing> target_rings(const std::string& cases);

/// liner.sur and ring_<name>.x3p: Gaussian surfaces, tilted, some points of the rings missing.
std::vector<GeneratedFile> surface_files(const std::vector<TargetRing>& rings);

/// face_<name>.csv: traces longer than the face, tilted, with noise.
std::vector<GeneratedFile> face_files(const std::vector<TargetRing>& rings);

/// loops_silicon.csv and loops_<name>.csv: friction loops at several loads, with noise.
std::vector<GeneratedFile> loop_files(const std::vector<TargetRing>& rings);

/// All of them.
std::vector<GeneratedFile> all_files(const std::string& cases);

}  // namespace ringfilm::measured_files

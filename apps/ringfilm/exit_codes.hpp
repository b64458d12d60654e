#pragma once

/// docs/manual/command-line.md
namespace ringfilm::app {

inline constexpr int kFine = 0;
inline constexpr int kBug = 1;
inline constexpr int kBadInput = 2;
inline constexpr int kNoConvergence = 3;
inline constexpr int kSomethingFailed = 4;
inline constexpr int kCouldNotWrite = 5;
inline constexpr int kStopped = 128;  ///< plus the number of the signal, as shells count: 130 after Ctrl-C

}  // namespace ringfilm::app

#pragma once
#include <functional>

/// The only place where threads begin.
namespace ringfilm::study {

/// As many as requested; 0: as many as the machine runs at once. At least 1.
int n_threads(int requested);

/// Does `work(0)` to `work(n - 1)`, each on a thread of its own, the first on that of the caller, and returns when all
/// have ended. Where the system gives no more threads, the caller does what is left over. Rethrows the first exception.
void on_threads(int n, const std::function<void(int)>& work);

/// Does `work` on a thread of its own and calls `look` on that of the caller, every 50 ms until the work has ended. If
/// `look` throws, it is not called again, and its exception is rethrown when the work has ended, which is the caller's
/// to bring about; otherwise that of the work is.
void run_while_polling(const std::function<void()>& work, const std::function<void()>& look);

}  // namespace ringfilm::study

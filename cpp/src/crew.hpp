// Threads that wait for work, for the mapper on several threads.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace occgrid {

/// A fixed number of threads that take one piece of work each, again and
/// again. Starting a thread for each piece would take as long as some pieces,
/// and a new thread can share its parent's core for a while.
class Crew {
 public:
  explicit Crew(int size);
  /// Waits for the work at hand.
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// Begins work(0) .. work(size - 1), each on a thread of its own, and
  /// returns. wait() must come before the next start().
  void start(std::function<void(int)> work);

  /// Waits for the work to end; throws what one of its pieces threw.
  void wait();

 private:
  void serve(int number);

  std::mutex mutex_;
  std::condition_variable started_, ended_;
  std::function<void(int)> work_;  ///< none: the threads are to end
  std::uint64_t round_ = 0;        ///< how many times work was begun
  std::size_t busy_ = 0;           ///< threads that are at it
  std::exception_ptr error_;
  std::vector<std::thread> threads_;
};

}  // namespace occgrid

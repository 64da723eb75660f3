#include "crew.hpp"

#include <utility>

namespace occgrid {

Crew::Crew(int size) {
  for (int i = 0; i < size; ++i) {
    threads_.emplace_back([this, i] { serve(i); });
  }
}

Crew::~Crew() {
  {
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [this] { return busy_ == 0; });
  }
  start({});
  for (std::thread& thread : threads_) thread.join();
}

void Crew::start(std::function<void(int)> work) {
  const std::lock_guard lock(mutex_);
  work_ = std::move(work);
  busy_ = threads_.size();
  ++round_;
  started_.notify_all();
}

void Crew::wait() {
  std::unique_lock lock(mutex_);
  ended_.wait(lock, [this] { return busy_ == 0; });
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Crew::serve(int number) {
  for (std::uint64_t round = 1;; ++round) {
    std::unique_lock lock(mutex_);
    started_.wait(lock, [&] { return round_ == round; });
    if (!work_) return;
    lock.unlock();
    std::exception_ptr error;
    try {
      work_(number);
    } catch (...) {
      error = std::current_exception();
    }
    lock.lock();
    if (error) error_ = error;
    if (--busy_ == 0) ended_.notify_one();
  }
}

}  // namespace occgrid

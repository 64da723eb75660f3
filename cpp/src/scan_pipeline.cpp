#include "scan_pipeline.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <variant>

#include "occgrid/mapper.hpp"

namespace occgrid {
namespace {

/// Enough for the work between two looks at what is next, and not so many that
/// their beams leave the processor's cache.
constexpr Eigen::Index batch_beams = 1 << 14;
/// Batches between reading and the grid, for each thread.
constexpr std::size_t batches_ahead = 2;

/// Scans on their way into the grid.
struct Batch {
  std::uint32_t first_number = 0;        ///< of its first scan in the scenario
  std::vector<ScenarioScan> scans;       ///< as they were read
  std::vector<std::vector<Beam>> beams;  ///< of each part of the scans
  std::vector<Rows> bands;               ///< once all beams are found
  std::size_t parts_begun = 0, parts_done = 0;
  std::size_t bands_begun = 0, bands_done = 0;
};

class Pipeline {
 public:
  Pipeline(OccupancyGrid& grid, const Scenario& scenario,
           std::optional<std::uint32_t> seed, std::size_t threads)
      : grid_(grid),
        scenario_(scenario),
        seed_(seed),
        next_scan_(scenario.scans()),
        shares_(threads) {}

  /// Takes tasks until all is done; what each thread does.
  void work() {
    std::unique_lock lock(mutex_);
    try {
      while (!is_done()) {
        const Task task = next_task();
        if (task.kind == Task::none) {
          changed_.wait(lock);
          continue;
        }
        lock.unlock();
        carry_out(task);
        lock.lock();
        conclude(task);
        changed_.notify_all();
      }
    } catch (...) {
      if (!lock.owns_lock()) lock.lock();
      if (!error_) error_ = std::current_exception();
      changed_.notify_all();
    }
  }

  /// Throws what a task threw.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
    // that of the reading comes after all scans before it
    if (read_error_) std::rethrow_exception(read_error_);
  }

 private:
  struct Task {
    enum Kind { none, read, find_beams, update } kind = none;
    Batch* batch = nullptr;
    std::size_t share = 0;  ///< number of the part or of the band
  };

  // --- under the lock ---

  bool is_done() const {
    return error_ || (all_read_ && !reading_ && batches_.empty());
  }

  /// Chooses a task and marks it as begun. Reading comes first, as it cannot
  /// be shared; then what is nearest to its end.
  Task next_task() {
    if (!reading_ && !all_read_ && batches_.size() < batches_ahead * shares_) {
      reading_ = std::make_unique<Batch>();
      if (!spare_.empty()) {
        reading_ = std::move(spare_.back());
        spare_.pop_back();
      }
      return {Task::read, reading_.get(), 0};
    }
    if (!batches_.empty()) {
      Batch& oldest = *batches_.front();
      if (oldest.bands_begun < oldest.bands.size()) {
        return {Task::update, &oldest, oldest.bands_begun++};
      }
    }
    for (const auto& batch : batches_) {
      if (batch->parts_begun < shares_) {
        return {Task::find_beams, batch.get(), batch->parts_begun++};
      }
    }
    return {};
  }

  /// Notes that a task has ended.
  void conclude(const Task& task) {
    Batch& batch = *task.batch;
    if (task.kind == Task::read) {
      if (batch.scans.empty()) {
        reading_.reset();
      } else {
        batches_.push_back(std::move(reading_));
      }
    } else if (task.kind == Task::find_beams) {
      if (++batch.parts_done == shares_) {
        batch.bands = cut_bands(batch.beams, grid_.spec().height, shares_);
      }
    } else if (++batch.bands_done == shares_) {
      spare_.push_back(std::move(batches_.front()));
      batches_.pop_front();
    }
  }

  // --- beside the others ---

  void carry_out(const Task& task) {
    if (task.kind == Task::read) {
      read(*task.batch);
    } else if (task.kind == Task::find_beams) {
      find_beams(*task.batch, task.share);
    } else {
      const Rows rows = task.batch->bands[task.share];
      for (const std::vector<Beam>& beams : task.batch->beams) {
        update_rows_from_beams(grid_, beams, rows);
      }
    }
  }

  void read(Batch& batch) {
    // its lists keep their memory, as new memory is slow at first
    batch.first_number = scans_read_;
    batch.scans.clear();
    batch.beams.resize(shares_);
    batch.bands.clear();
    batch.parts_begun = batch.parts_done = 0;
    batch.bands_begun = batch.bands_done = 0;
    try {
      for (Eigen::Index beams = 0; beams < batch_beams;) {
        std::optional<ScenarioScan> scan = next_scan_();
        if (!scan) {
          all_read_ = true;
          break;
        }
        const Scan* recorded = std::get_if<Scan>(&*scan);
        beams += recorded
                     ? recorded->ranges.size()
                     : static_cast<Eigen::Index>(scenario_.settings.beams);
        batch.scans.push_back(std::move(*scan));
        ++scans_read_;
      }
    } catch (...) {
      read_error_ = std::current_exception();
      all_read_ = true;
    }
  }

  /// The beams of part `part` of the scans, those of bare poses simulated.
  void find_beams(Batch& batch, std::size_t part) {
    const Settings& settings = scenario_.settings;
    std::vector<Beam>& beams = batch.beams[part];
    beams.clear();
    const std::size_t end = batch.scans.size() * (part + 1) / shares_;
    for (std::size_t s = batch.scans.size() * part / shares_; s < end; ++s) {
      const auto append = [&](const Scan& scan) {
        append_beams(beams, grid_, scan, settings.max_range,
                     settings.no_return);
      };
      if (const Pose* pose = std::get_if<Pose>(&batch.scans[s])) {
        const auto number = batch.first_number + static_cast<std::uint32_t>(s);
        append(simulated_scan(scenario_, *pose, number, seed_));
      } else {
        append(std::get<Scan>(batch.scans[s]));
      }
    }
  }

  OccupancyGrid& grid_;
  const Scenario& scenario_;
  const std::optional<std::uint32_t> seed_;
  const ScanSource next_scan_;
  const std::size_t shares_;  ///< parts, and bands, of a batch

  std::mutex mutex_;
  std::condition_variable changed_;
  std::unique_ptr<Batch> reading_;
  std::deque<std::unique_ptr<Batch>> batches_;  ///< read, the oldest first
  std::vector<std::unique_ptr<Batch>> spare_;
  std::uint32_t scans_read_ = 0;
  std::atomic<bool> all_read_ = false;
  std::exception_ptr read_error_, error_;
};

}  // namespace

void map_on_threads(OccupancyGrid& grid, const Scenario& scenario,
                    std::optional<std::uint32_t> seed, int threads) {
  Pipeline pipeline(grid, scenario, seed, static_cast<std::size_t>(threads));
  struct Team {
    std::vector<std::thread> threads;
    ~Team() {
      for (std::thread& thread : threads) thread.join();
    }
  };
  {
    Team team;
    for (int i = 1; i < threads; ++i) {
      team.threads.emplace_back([&] { pipeline.work(); });
    }
    pipeline.work();
  }
  pipeline.rethrow();
}

std::vector<Rows> cut_bands(const std::vector<std::vector<Beam>>& beams,
                            std::int64_t height, std::size_t bands) {
  // of a beam: its rows in the grid, and its cells in each of them
  struct Weight {
    std::int64_t first, last;
    double in_a_row;
  };
  std::vector<Weight> weights;
  std::int64_t low_row = height, high_row = -1;
  double all = 0.0;
  for (const std::vector<Beam>& some : beams) {
    // a thousand of them say enough
    const std::size_t step = 1 + some.size() / 1024;
    for (std::size_t i = 0; i < some.size(); i += step) {
      const Beam& beam = some[i];
      const auto [low, high] = std::minmax(beam.robot.gy, beam.end.gy);
      const std::int64_t first = std::max<std::int64_t>(low, 0);
      const std::int64_t last = std::min(high, height - 1);
      if (last < first) continue;
      const std::int64_t columns = std::abs(beam.end.gx - beam.robot.gx);
      const double in_a_row =
          std::max(1.0, static_cast<double>(columns) /
                            static_cast<double>(high - low + 1));
      weights.push_back({first, last, in_a_row});
      all += in_a_row * static_cast<double>(last - first + 1);
      low_row = std::min(low_row, first);
      high_row = std::max(high_row, last);
    }
  }
  if (high_row < low_row) low_row = high_row = 0;
  // how many more cells a row has of the beams than the row before
  std::vector<double> rise(static_cast<std::size_t>(high_row - low_row) + 2);
  for (const Weight& weight : weights) {
    rise[static_cast<std::size_t>(weight.first - low_row)] += weight.in_a_row;
    rise[static_cast<std::size_t>(weight.last - low_row) + 1] -=
        weight.in_a_row;
  }
  std::vector<Rows> cut;
  std::int64_t first = 0, row = low_row;
  double cells = 0.0, before = 0.0;
  for (std::size_t band = 1; band < bands; ++band) {
    const double share =
        all * static_cast<double>(band) / static_cast<double>(bands);
    for (; row <= high_row && before < share; ++row) {
      cells += rise[static_cast<std::size_t>(row - low_row)];
      before += cells;
    }
    cut.push_back({first, row - 1});
    first = row;
  }
  cut.push_back({first, height - 1});
  return cut;
}

}  // namespace occgrid

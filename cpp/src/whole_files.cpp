#include "whole_files.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <locale>
#include <random>
#include <string_view>
#include <system_error>

#include "occgrid/map_writer.hpp"

namespace occgrid {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view before_middle = ".occgrid-";
constexpr std::string_view behind_middle = ".part";
constexpr std::string_view characters = "abcdefghijklmnopqrstuvwxyz0123456789";
constexpr std::size_t max_files = 8;

/// Paths of temporary files, for remove_temporary_files.
std::array<std::atomic<const char*>, max_files> temporary_files{};

void note(const std::string& path) {
  for (auto& slot : temporary_files) {
    const char* empty = nullptr;
    if (slot.compare_exchange_strong(empty, path.c_str())) return;
  }
}

void forget(const std::string& path) {
  for (auto& slot : temporary_files) {
    const char* noted = path.c_str();
    if (slot.compare_exchange_strong(noted, nullptr)) return;
  }
}

/// No part of the file's own name: that may be as long as the system allows.
std::string temporary_name() {
  std::random_device random;
  std::string name(before_middle);
  for (int i = 0; i < 20; ++i)
    name += characters[random() % characters.size()];
  return name += behind_middle;
}

bool is_temporary(std::string_view name) {
  if (name.size() <= before_middle.size() + behind_middle.size() ||
      name.size() > before_middle.size() + 40 + behind_middle.size() ||
      name.substr(0, before_middle.size()) != before_middle ||
      name.substr(name.size() - behind_middle.size()) != behind_middle) {
    return false;
  }
  name.remove_prefix(before_middle.size());
  name.remove_suffix(behind_middle.size());
  return name.find_first_not_of(
             "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
             "abcdefghijklmnopqrstuvwxyz0123456789-") ==
         std::string_view::npos;
}

/// Runs that were killed leave their files. Those of a day ago are of no run
/// that still goes on.
void remove_leftovers(const std::string& folder) {
  std::error_code error;
  const auto day_ago =
      fs::file_time_type::clock::now() - std::chrono::hours(24);
  fs::directory_iterator entry(folder + "/", error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    if (!is_temporary(entry->path().filename().native()) ||
        entry->symlink_status(ignored).type() != fs::file_type::regular) {
      continue;
    }
    const auto written = entry->last_write_time(ignored);
    if (!ignored && written < day_ago) fs::remove(entry->path(), ignored);
  }
}

/// Keeps SIGINT and SIGTERM waiting.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t both;
    sigemptyset(&both);
    sigaddset(&both, SIGINT);
    sigaddset(&both, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &both, &before_);
  }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;
  ~SignalsWait() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_;
};

}  // namespace

WholeFiles::WholeFiles(const std::string& folder)
    : folder_(folder.substr(0, folder.find_last_not_of('/') + 1)) {
  files_.reserve(max_files);
  const std::string named = folder_.empty() ? "/" : folder_;
  std::error_code error;
  fs::create_directories(named, error);
  if (!fs::is_directory(named, error)) throw WriteError(named);
  remove_leftovers(folder_);
}

WholeFiles::~WholeFiles() {
  for (const File& file : files_) {
    unlink(file.temporary.c_str());
    forget(file.temporary);
  }
}

void WholeFiles::write(const std::string& name,
                       const std::function<void(std::ostream&)>& contents) {
  files_.push_back({folder_ + "/" + name, folder_ + "/" + temporary_name()});
  const File& file = files_.back();
  std::error_code ignored;
  if (fs::is_directory(file.path, ignored)) throw WriteError(file.path);
  note(file.temporary);
  std::ofstream out;
  out.imbue(std::locale::classic());
  out.open(file.temporary, std::ios::binary);
  if (out.is_open()) contents(out);
  out.close();
  if (!out) throw WriteError(file.path);
}

void WholeFiles::publish() {
  const SignalsWait until_done;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    std::error_code error;
    fs::rename(files_[i].temporary, files_[i].path, error);
    if (!error) continue;
    for (std::size_t k = 0; k < i; ++k) unlink(files_[k].path.c_str());
    throw WriteError(files_[i].path);
  }
}

void remove_temporary_files() noexcept {
  for (const auto& slot : temporary_files) {
    if (const char* path = slot.load()) unlink(path);
  }
}

}  // namespace occgrid

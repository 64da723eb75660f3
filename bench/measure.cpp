// Runs a command and writes its wall time (s), peak resident memory (KiB) and
// exit status to a file.
//
// usage: measure FILE COMMAND [ARGUMENT...]
//
// A process starts with its parent's peak on its account, so a small program
// has to be the parent where peaks are to be told apart.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child < 0) return 1;
  if (child == 0) {
    execvp(argv[2], argv + 2);
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child) return 1;
  const std::chrono::duration<double> wall =
      std::chrono::steady_clock::now() - start;
  std::FILE* file = std::fopen(argv[1], "w");
  if (!file) return 1;
  std::fprintf(file, "%.9f %ld %d\n", wall.count(), usage.ru_maxrss,
               WIFEXITED(status) ? WEXITSTATUS(status) : -1);
  return std::fclose(file) == 0 ? 0 : 1;
}

// Reading a file line by line, in large blocks.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace occgrid {

/// The lines of a file, without their LF.
class LineReader {
 public:
  explicit LineReader(const std::string& path);

  /// The next line, good until the next call; false at the end of the file,
  /// and where it cannot be read.
  bool next(std::string_view& line);

  /// Whether reading has failed: no such file, a folder, a fault of the disk.
  bool failed() const;

  /// Whether another reader of the same path begins at the start again. A
  /// pipe's bytes come only once.
  bool can_be_read_again() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::unique_ptr<std::FILE, Close> file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  ///< of what is in the buffer and not yet given
  std::size_t end_ = 0;
};

}  // namespace occgrid

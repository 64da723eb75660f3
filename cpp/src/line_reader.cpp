#include "line_reader.hpp"

#include <cstring>

namespace occgrid {

LineReader::LineReader(const std::string& path)
    : file_(std::fopen(path.c_str(), "rb")), buffer_(std::size_t{1} << 16) {
  // the buffer here is enough
  if (file_) std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

bool LineReader::next(std::string_view& line) {
  if (failed()) return false;
  for (std::size_t searched = begin_;;) {
    const char* const start = buffer_.data() + begin_;
    const void* const found =
        std::memchr(buffer_.data() + searched, '\n', end_ - searched);
    if (found) {
      const auto length =
          static_cast<std::size_t>(static_cast<const char*>(found) - start);
      line = {start, length};
      begin_ += length + 1;
      return true;
    }
    // move the line's beginning to the front, and read on behind it
    const std::size_t kept = end_ - begin_;
    std::memmove(buffer_.data(), start, kept);
    begin_ = 0;
    if (kept == buffer_.size()) buffer_.resize(2 * buffer_.size());
    const std::size_t got = std::fread(buffer_.data() + kept, 1,
                                       buffer_.size() - kept, file_.get());
    end_ = kept + got;
    searched = kept;
    if (std::ferror(file_.get())) return false;
    if (got == 0) {  // the last line may lack its LF
      line = {buffer_.data(), kept};
      begin_ = end_;
      return kept > 0;
    }
  }
}

bool LineReader::failed() const {
  return !file_ || std::ferror(file_.get());
}

bool LineReader::can_be_read_again() const {
  return file_ && std::fseek(file_.get(), 0, SEEK_CUR) == 0;
}

}  // namespace occgrid

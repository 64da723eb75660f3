// Files that are written whole or not at all (SPEC.md section 7).
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace occgrid {

/// Files of one folder that are written under temporary names, and take their
/// own names when all of them are whole. What was not published is removed.
/// Throws WriteError.
class WholeFiles {
 public:
  /// `folder` as it is given: messages show it so. It is made where it is
  /// missing, and cleared of what runs of long ago have left.
  explicit WholeFiles(const std::string& folder);
  WholeFiles(const WholeFiles&) = delete;
  WholeFiles& operator=(const WholeFiles&) = delete;
  ~WholeFiles();

  /// Writes a file; it must not bear the name of a folder.
  void write(const std::string& name,
             const std::function<void(std::ostream&)>& contents);

  /// Renames all of them. Where one cannot be renamed, those before it are
  /// removed. A signal waits until this is done.
  void publish();

 private:
  struct File {
    std::string path;       ///< its own, for messages too
    std::string temporary;  ///< no longer there once it is renamed
  };

  std::string folder_;       ///< without slashes at its end
  std::vector<File> files_;  ///< their memory stays where it is
};

/// Removes the temporary files of this process. It may be called by a handler
/// of a signal, of which the process then ends.
void remove_temporary_files() noexcept;

}  // namespace occgrid

#include "film/scratch_folder.h"

#include "core/files.h"
#include "core/temporary_name.h"

namespace wold::film {
namespace fs = std::filesystem;

ScratchFolder::ScratchFolder(const fs::path& parent) : path_(temporary_name(parent / "scratch")) {}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  remove_empty_folder(path_.parent_path());
}

}  // namespace wold::film

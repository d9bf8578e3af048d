#include "work/build_hash.h"

#include "core/file_list.h"
#include "core/files.h"

namespace wold::work {

std::string hash_of_build() {
  return content_hash(content_hash(read_file("/proc/self/exe")) +
                      hash_of_programs_below(shipped_file("models")) +
                      hash_of_programs_below(shipped_file("templates")));
}

}  // namespace wold::work

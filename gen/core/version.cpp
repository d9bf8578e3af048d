#include "core/version.h"

namespace wold {

const char* const version = WOLD_VERSION;

}  // namespace wold

#include "landscape/landscape.h"

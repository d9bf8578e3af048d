#include "core/vdb.h"

template class openvdb::Grid<openvdb::Vec3STree>;
template class openvdb::tree::Tree<openvdb::Vec3STree::RootNodeType>;

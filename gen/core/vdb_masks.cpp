#include "core/vdb.h"

template class openvdb::Grid<openvdb::BoolTree>;
template class openvdb::tree::Tree<openvdb::BoolTree::RootNodeType>;
template class openvdb::tree::Tree<openvdb::MaskTree::RootNodeType>;

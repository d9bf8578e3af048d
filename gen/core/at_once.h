#pragma once

#include <cstddef>
#include <functional>

namespace wold {

/// Runs body(i) for every i in [0, count), started in order, `at_once` at a time: for work that
/// waits for other programs; loops that compute are parallel_for's. After an exception no more are
/// started; it reaches the caller when those under way have ended. The caller's StopScope
/// (parallel.h) is asked before every body and counts in them.
void run_at_once(std::size_t count, std::size_t at_once,
                 const std::function<void(std::size_t)>& body);

}  // namespace wold

#include <cstdint>
#include <string>
#include <vector>

#include "cli/program.h"
#include "core/error.h"

namespace {

/// A line for each argument, after the program's name. An argument has no byte 0.
std::vector<std::string> arguments_of(const std::uint8_t* bytes, std::size_t count) {
  std::vector<std::string> arguments = {"wold", ""};
  for (std::size_t i = 0; i < count; ++i)
    if (bytes[i] == '\n')
      arguments.emplace_back();
    else if (bytes[i] != 0)
      arguments.back() += static_cast<char>(bytes[i]);
  return arguments;
}

}  // namespace

/// Any command line asks for something or is an error. Nothing is done.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  std::vector<std::string> arguments = arguments_of(bytes, count);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  const int number = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  try {
    wold::cli::asked_for(number, pointers.data());
  } catch (const wold::InputError&) {
  }
  return 0;
}

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace wold {

/// What the program tells its caller; the numbers are part of the contract.
enum class ExitCode {
  done = 0,
  different = 1,      ///< compared and different
  wrong_input = 2,    ///< command line or scene wrong; nothing was written
  renderer = 3,       ///< a renderer is missing, failed, timed out or made no valid picture
  file = 4,           ///< reading or writing failed
  interrupted = 130,  ///< stopped by the user; the same command resumes
};

/// A place in a text file; line and column count from 1, 0 means unknown.
struct SourcePosition {
  std::string file;
  int line = 0;
  int column = 0;
};

/// One thing that is wrong with the user's input: where, and a sentence that says what was
/// found, what was expected and what to do.
struct Problem {
  SourcePosition where;
  std::string message;
};

/// "file:line:column: message", leaving out what is unknown.
std::string to_string(const Problem& problem);

/// Base of every error that reaches the user; libraries throw it, only the program prints it.
class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The scene or the command line is wrong. Carries every problem found, not just the first.
class InputError : public Error {
 public:
  explicit InputError(std::vector<Problem> problems);
  explicit InputError(const std::string& message);
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// A renderer is missing, failed, timed out or produced no valid picture.
class RendererError : public Error {
 public:
  explicit RendererError(const std::string& message) : Error(ExitCode::renderer, message) {}
};

/// A file is missing, damaged, unreadable or could not be written.
class FileError : public Error {
 public:
  explicit FileError(const std::string& message) : Error(ExitCode::file, message) {}
};

/// The user asked to stop.
class InterruptedError : public Error {
 public:
  InterruptedError() : Error(ExitCode::interrupted, "interrupted") {}
};

}  // namespace wold

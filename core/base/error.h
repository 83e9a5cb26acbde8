#pragma once

#include <stdexcept>
#include <string>

namespace pbffd {

/// The base of everything that pbffd throws on purpose. The message says what was tried, on what,
/// why it failed and what to try; it is fit to be shown to a user as it is.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller's data cannot be used: a malformed file, an edit that cannot be done.
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// The system refused to read or write.
class IoError : public Error {
 public:
  using Error::Error;
};

/// A numeric method found no answer.
class SolverError : public Error {
 public:
  using Error::Error;
};

/// The user asked to stop; nothing was changed.
class Cancelled : public Error {
 public:
  Cancelled() : Error("Cancelled.") {}
};

}  // namespace pbffd

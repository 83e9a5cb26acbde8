#pragma once

#include "core/base/progress.h"

#include <vtkAlgorithm.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// Listens to a VTK reader or writer on the thread that runs it: reports its progress, stops it when that is
/// cancelled, and keeps what it says went wrong, which VTK would print.
class VtkWatch {
 public:
  /// stage: what the user reads meanwhile. Forgets the algorithm when it dies.
  VtkWatch(vtkAlgorithm& algorithm, std::string stage, const Progress& progress);
  ~VtkWatch();
  VtkWatch(const VtkWatch&) = delete;
  VtkWatch& operator=(const VtkWatch&) = delete;

  /// Throws Cancelled, or nothing.
  void throwIfCancelled() const { progress_.throwIfCancelled(); }

  /// What went wrong, in VTK's words without the places in its source; empty for nothing.
  std::string errors() const;

  /// What it warned of.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  class Observer;
  class LogListener;
  void hear(bool isError, std::string_view text);
  void stop();

  vtkAlgorithm& algorithm_;
  std::string stage_;
  Progress progress_;
  std::vector<std::string> errors_;
  std::vector<std::string> warnings_;
  Observer* observer_;
  std::unique_ptr<LogListener> log_;
};

}  // namespace pbffd

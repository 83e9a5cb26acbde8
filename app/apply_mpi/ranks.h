#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pbffd::mpi {

/// The processes that mpirun started, seen from one of them: a thin cover of VTK's MPI controller. Each call
/// below must be made by all ranks.
class Ranks {
 public:
  /// Joins the other processes. Takes MPI's own arguments away.
  Ranks(int& argc, char**& argv);
  /// Waits for the others.
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const;
  int count() const;
  bool isFirst() const { return rank() == 0; }

  /// What one rank says, on every rank.
  std::string from(int rank, std::string text) const;
  std::string fromFirst(std::string text) const { return from(0, std::move(text)); }
  std::vector<double> fromFirst(std::vector<double> numbers) const;

  bool any(bool mine) const;
  /// The lowest rank that says yes; -1 for none.
  int lowest(bool mine) const;
  long long sum(long long mine) const;
  /// What each rank says, by rank.
  std::vector<long long> gathered(long long mine) const;

 private:
  class Controller;
  std::unique_ptr<Controller> controller_;
};

}  // namespace pbffd::mpi

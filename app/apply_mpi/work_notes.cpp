#include "app/apply_mpi/work_notes.h"

#include "core/base/text.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace pbffd::mpi {
namespace {

long long thisMachine() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return static_cast<long long>(std::hash<std::string_view>()(name.data()));
}

}  // namespace

WorkNotes::WorkNotes(const Ranks& ranks, std::filesystem::path folder)
    : folder_(std::move(folder)), rank_(ranks.rank()), processes_(ranks.gathered(::getpid())) {
  const std::vector<long long> machines = ranks.gathered(thisMachine());
  for (std::size_t r = 0; r < processes_.size(); ++r) {
    processes_[r] = machines[r] == thisMachine() ? processes_[r] : 0;
  }
}

void WorkNotes::workingOn(std::size_t piece) const {
  std::ofstream(noteOf(rank_)) << piece << '\n';
}

std::optional<WorkNotes::Lost> WorkNotes::lost() const {
  std::error_code gone;
  if (!std::filesystem::is_directory(folder_, gone)) {
    return std::nullopt;
  }
  for (std::size_t r = 0; r < processes_.size(); ++r) {
    if (processes_[r] != 0 && ::kill(static_cast<pid_t>(processes_[r]), 0) != 0 && errno == ESRCH) {
      Lost lost{static_cast<int>(r), std::nullopt};
      if (std::size_t piece = 0; std::ifstream(noteOf(lost.rank)) >> piece) {
        lost.piece = piece;
      }
      return lost;
    }
  }
  return std::nullopt;
}

std::filesystem::path WorkNotes::noteOf(int rank) const {
  return folder_ / format("r{}.piece", rank);
}

}  // namespace pbffd::mpi

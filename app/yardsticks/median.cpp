#include "app/yardsticks/median.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace pbffd {
namespace {

constexpr int leastRuns = 3;
constexpr int mostRuns = 101;
constexpr double enoughSeconds = 0.5;
constexpr double tooManySeconds = 20.0;

}  // namespace

double medianSeconds(const std::function<void()>& prepare, const std::function<void()>& work,
                     const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> seconds;
  double sum = 0.0;
  const auto isEnough = [&] {
    const auto runs = static_cast<int>(seconds.size());
    return runs >= mostRuns || (runs >= leastRuns && sum >= enoughSeconds) ||
           (runs > 0 && sum >= tooManySeconds);
  };
  while (!isEnough()) {
    progress.throwIfCancelled();
    prepare();
    const Clock::time_point start = Clock::now();
    work();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    sum += seconds.back();
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), middle, seconds.end());
  return *middle;
}

double medianSeconds(const std::function<void()>& work, const Progress& progress) {
  return medianSeconds([] {}, work, progress);
}

}  // namespace pbffd

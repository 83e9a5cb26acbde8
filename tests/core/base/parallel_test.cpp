#include "core/base/parallel.h"
#include "core/base/lazy.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace pbffd {
namespace {

std::vector<std::uint64_t> scatteredNumbers(std::size_t count) {
  std::vector<std::uint64_t> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    numbers[i] = (i * 0x9e3779b97f4a7c15) >> 40U;
  }
  return numbers;
}

}  // namespace

class ParallelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyNumberIsVisitedOnce() {
    std::vector<int> visits(10007, 0);
    parallelFor(visits.size(), 16, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        ++visits[i];
      }
    });
    QCOMPARE(std::count(visits.begin(), visits.end(), 1), 10007);
  }

  void sortsAnyLength() {
    for (const std::size_t count : {0, 1, 2, 100, 8191, 8192, 8193, 100003}) {
      std::vector<std::uint64_t> numbers = scatteredNumbers(count);
      std::vector<std::uint64_t> expected = numbers;
      std::sort(expected.begin(), expected.end());
      parallelSort(numbers);
      QVERIFY(numbers == expected);
    }
  }

  void workOnThisThreadAloneStaysThere() {
    std::atomic<int> elsewhere = 0;
    const std::thread::id own = std::this_thread::get_id();
    onThisThreadAlone([&] {
      parallelFor(1000, 1, [&](std::size_t, std::size_t) { elsewhere += std::this_thread::get_id() != own; });
    });
    QCOMPARE(elsewhere.load(), 0);
  }

  void lazyValueIsMadeOnceByWhoeverAsksFirst() {
    Lazy<int> lazy;
    std::atomic<int> made = 0;
    std::atomic<int> wrong = 0;
    // The value is itself made by a parallel loop, as a thread that waits for it in one must not take part in.
    const auto make = [&] {
      std::atomic<int> sum = 0;
      parallelFor(1000, 1, [&](std::size_t begin, std::size_t end) { sum += static_cast<int>(end - begin); });
      ++made;
      return sum.load();
    };
    parallelFor(1000, 1, [&](std::size_t, std::size_t) { wrong += lazy.get(make) != 1000; });
    QCOMPARE(made.load(), 1);
    QCOMPARE(wrong.load(), 0);
  }
};

const test::Registration<ParallelTest> registration;

}  // namespace pbffd

#include "parallel_test.moc"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <string>
#include <vector>

namespace pbffd {

class ProgressTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void copiesShareTheCancel() {
    const Progress original([](std::string_view, double) {});
    const Progress copy = original;
    original.throwIfCancelled();
    copy.cancel();
    QVERIFY(original.isCancelled());
    QVERIFY_EXCEPTION_THROWN(original.throwIfCancelled(), Cancelled);
  }

  void defaultHandleIsNeverCancelled() {
    const Progress progress;
    progress.cancel();
    progress.report("nothing");
    QVERIFY(!progress.isCancelled());
  }

  void listenerHearsStageAndShare() {
    std::string stage;
    double share = 0.0;
    const Progress progress([&](std::string_view s, double x) {
      stage = s;
      share = x;
    });
    progress.report("cells", 0.25);
    QCOMPARE(stage, std::string("cells"));
    QCOMPARE(share, 0.25);
  }

  void parallelRangesCoverEverySlotOnce() {
    std::vector<int> hits(10'000, 0);
    parallelFor(hits.size(), 64, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        ++hits[i];
      }
    });
    QCOMPARE(hits, std::vector<int>(10'000, 1));
  }

  void exceptionOfABodyReachesTheCaller() {
    QVERIFY_EXCEPTION_THROWN(
        parallelFor(1000, 1, [](std::size_t, std::size_t) { throw InvalidInput("no"); }), InvalidInput);
  }
};

const test::Registration<ProgressTest> registration;

}  // namespace pbffd

#include "progress_test.moc"

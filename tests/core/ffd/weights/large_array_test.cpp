#include "core/ffd/weights/large_array.h"
#include "tests/support/test_main.h"

#include <QtTest>

#include <cstdint>

namespace pbffd {

class LargeArrayTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void memoryIsAligned() {
    for (const std::size_t count : {1U, 1000U, 5000000U}) {
      const LargeArray<float> array(count);
      QCOMPARE(reinterpret_cast<std::uintptr_t>(array.data()) % 64, std::uintptr_t(0));
    }
  }

  void whatWasFreedIsUsedAgain() {
    const float* before = nullptr;
    {
      LargeArray<float> array;
      array.resize(3000000);
      before = array.data();
    }
    LargeArray<float> next;
    next.resize(2900000);
    QVERIFY(next.data() == before);
    // Not by two at a time.
    LargeArray<float> other;
    other.resize(2900000);
    QVERIFY(other.data() != before);
  }

  void copiesAreTheirOwn() {
    LargeArray<float> array(2000000, 1.0F);
    LargeArray<float> copy = array;
    copy[7] = 2.0F;
    QCOMPARE(array[7], 1.0F);
    QCOMPARE(copy[1999999], 1.0F);
  }
};

const test::Registration<LargeArrayTest> registration;

}  // namespace pbffd

#include "large_array_test.moc"

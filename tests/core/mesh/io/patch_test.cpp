#include "core/mesh/io/patch.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::io {

class PatchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void onlyThePiecesChange() {
    const std::string_view source = "v 1.0 2.0 3.0\n";
    Patch patch(source);
    patch.replace(source.substr(2, 3), 0.25);
    patch.replace(source.substr(10, 3), "x");
    QCOMPARE(patch.finish(), std::string("v 0.25 2.0 x\n"));
  }

  void nothingReplacedIsTheSource() {
    QCOMPARE(Patch("abc").finish(), std::string("abc"));
    QCOMPARE(Patch("").finish(), std::string());
  }
};

const test::Registration<PatchTest> registration;

}  // namespace pbffd::io

#include "patch_test.moc"

#include "core/mesh/io/text_scanner.h"
#include "core/base/error.h"
#include "tests/support/test_main.h"

#include <QtTest>

namespace pbffd::io {

class TextScannerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void wordsStopAtTheEndOfTheirLine() {
    const Input input{" a\tbb \n\n c", "a", {}};
    TextScanner text(input, {});
    QVERIFY(text.word() == "a");
    QVERIFY(text.word() == "bb");
    QVERIFY(text.word().empty());
    QVERIFY(text.word().empty());
    QCOMPARE(text.line(), std::size_t{1});
    QVERIFY(text.firstWordOfNextLine() == "c");
    QCOMPARE(text.line(), std::size_t{3});
    QVERIFY(text.firstWordOfNextLine().empty());
  }

  void wordsAnywhereCrossLines() {
    const Input input{"a\r\rb\r\nc", "a", {}};
    TextScanner text(input, {});
    QVERIFY(text.wordAnywhere() == "a");
    QVERIFY(text.wordAnywhere() == "b");
    QCOMPARE(text.line(), std::size_t{3});
    QVERIFY(text.wordAnywhere() == "c");
    QCOMPARE(text.line(), std::size_t{4});
    QVERIFY(text.wordAnywhere().empty());
  }

  void wordsKnowTheirPlace() {
    const Input input{"ab cd", "a", {}};
    TextScanner text(input, {});
    text.word();
    QCOMPARE(text.word().data() - input.bytes.data(), std::ptrdiff_t{3});
    QCOMPARE(text.byte(), std::size_t{5});
  }

  void commentsAndContinuationsOnlyWhereTheyAreKnown() {
    const Input input{"a #b\\\nc\\\nd \\\n e\\ f#g", "a", {}};
    TextScanner with(input, {.hasComments = true, .hasContinuations = true});
    QVERIFY(with.word() == "a");
    QVERIFY(with.word().empty());
    QVERIFY(with.firstWordOfNextLine() == "c");
    QVERIFY(with.word() == "d");
    QVERIFY(with.word() == "e\\");
    QVERIFY(with.word() == "f#g");
    QCOMPARE(with.line(), std::size_t{4});
    TextScanner without(input, {});
    without.word();
    QVERIFY(without.word() == "#b\\");
  }

  void messagesShowUnreadableBytesAsQuestionMarks() {
    const Input input{"a\x01\xC3\xA9 ", "a.obj", {}};
    TextScanner text(input, {});
    const std::string_view word = text.word();
    try {
      text.integer(word, "a number");
      QFAIL("no error");
    } catch (const InvalidInput& error) {
      QCOMPARE(
          std::string(error.what()),
          std::string(
              "Could not read a.obj. Line 1: \"a???\" stands where a number belongs, and is no whole number. "
              "Correct it there, or export the file again."));
    }
    QCOMPARE(inQuotes(std::string(100, 'x')).size(), std::size_t{45});
  }
};

const test::Registration<TextScannerTest> registration;

}  // namespace pbffd::io

#include "text_scanner_test.moc"

#include "core/base/file.h"
#include "core/base/error.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

#include <filesystem>

namespace pbffd {

class FileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void writtenBytesComeBack() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.bin").toStdString();
    const std::string bytes("a\0b\n\xff", 5);
    writeFileAtomically(path, bytes);
    QCOMPARE(readFile(path), bytes);
  }

  void failedWriteNamesTheFileAndLeavesNothing() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("none/a.bin").toStdString();
    try {
      writeFileAtomically(path, "x");
      QFAIL("no error");
    } catch (const IoError& error) {
      const std::string what = error.what();
      QVERIFY(what.find(path.string()) != std::string::npos);
      QVERIFY2(what.ends_with("No such file or directory. Check the name and its folder."), what.c_str());
    }
    QVERIFY(!std::filesystem::exists(path));
  }

  void aReplacementThatFailsLeavesWhatWasThere() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.txt").toStdString();
    writeFileAtomically(path, "old");
    const auto fails = [](const std::filesystem::path& temporary) {
      writeFileAtomically(temporary, "new");
      throw Cancelled();
    };
    QVERIFY_EXCEPTION_THROWN(replaceFile(path, fails), Cancelled);
    QCOMPARE(readFile(path), std::string("old"));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 1);
    replaceFile(path, [](const auto& temporary) { writeFileAtomically(temporary, "new"); });
    QCOMPARE(readFile(path), std::string("new"));
  }

  void writingThroughALinkLeavesTheLink() {
    const QTemporaryDir folder;
    const std::filesystem::path root = folder.path().toStdString();
    std::filesystem::create_symlink("second", root / "first");
    std::filesystem::create_symlink(root / "target", root / "second");
    for (const char* bytes : {"to a file that is not there yet", "to one that is"}) {
      writeFileAtomically(root / "first", bytes);
      QVERIFY(std::filesystem::is_symlink(root / "first") && std::filesystem::is_symlink(root / "second"));
      QCOMPARE(readFile(root / "target"), std::string(bytes));
    }
    std::filesystem::create_symlink("circle", root / "circle");
    QVERIFY_EXCEPTION_THROWN(writeFileAtomically(root / "circle", "x"), IoError);
    QVERIFY(std::filesystem::is_symlink(root / "circle"));
  }

  void missingFileAndFolderAreErrors() {
    const QTemporaryDir folder;
    QVERIFY_EXCEPTION_THROWN(readFile(folder.filePath("none").toStdString()), IoError);
    QVERIFY_EXCEPTION_THROWN(readFile(folder.path().toStdString()), IoError);
  }

  void permissionsOfAReplacedFileStay() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a").toStdString();
    writeFileAtomically(path, "1");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    writeFileAtomically(path, "2");
    QVERIFY(std::filesystem::status(path).permissions() == std::filesystem::perms::owner_all);
  }

  void digestIsTheStandardOne() {
    QCOMPARE(sha256("abc"), std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"));
  }
};

const test::Registration<FileTest> registration;

}  // namespace pbffd

#include "file_test.moc"

#include "core/base/error.h"
#include "core/base/file.h"
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
      QVERIFY(std::string(error.what()).find(path.string()) != std::string::npos);
    }
    QVERIFY(!std::filesystem::exists(path));
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

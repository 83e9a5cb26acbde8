#include "app/dataset/staged_files.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/app/dataset/fixture.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QtTest>

#include <cstdlib>

namespace pbffd {

class StagedFilesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
  }

  void filesAppearTogetherWhenCommitted() {
    {
      StagedFiles staged(folder_ / "index");
      writeFileAtomically(staged.add(folder_ / "pieces/a"), "1");
      writeFileAtomically(staged.add(folder_ / "index"), "2");
      QVERIFY(!std::filesystem::exists(folder_ / "index"));
      staged.commit();
    }
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"index", "pieces"}));
    QCOMPARE(readFile(folder_ / "pieces/a"), std::string("1"));
    QCOMPARE(readFile(folder_ / "index"), std::string("2"));
  }

  void whatIsNotCommittedLeavesNothing() {
    writeFileAtomically(folder_ / "a", "old");
    {
      StagedFiles staged(folder_ / "a");
      writeFileAtomically(staged.add(folder_ / "a"), "new");
    }
    QCOMPARE(readFile(folder_ / "a"), std::string("old"));
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"a"}));
  }

  void linkIsFollowedAndPermissionsStay() {
    writeFileAtomically(folder_ / "real", "old");
    std::filesystem::permissions(folder_ / "real", std::filesystem::perms::owner_all);
    std::filesystem::create_symlink("real", folder_ / "link");
    StagedFiles staged(folder_ / "link");
    writeFileAtomically(staged.add(folder_ / "link"), "new");
    staged.commit();
    QCOMPARE(readFile(folder_ / "real"), std::string("new"));
    QVERIFY(std::filesystem::is_symlink(folder_ / "link"));
    QVERIFY(std::filesystem::status(folder_ / "real").permissions() == std::filesystem::perms::owner_all);
  }

  void foldersAndMissingPlacesAreErrors() {
    std::filesystem::create_directory(folder_ / "folder");
    for (const char* name : {"folder", "none/a"}) {
      const std::string message = test::messageOf([&] { StagedFiles(folder_ / name); });
      QVERIFY2(message.find(name) != std::string::npos, message.c_str());
    }
  }

  void placeOnAnotherDiskIsRefusedBeforeAnyWork() {
    std::string elsewhere = "/dev/shm/pbffd-staged-XXXXXX";
    if (::mkdtemp(elsewhere.data()) == nullptr) {
      QSKIP("There is no second file system to try it on.");
    }
    std::filesystem::create_directory_symlink(elsewhere, folder_ / "pieces");
    std::string message;
    {
      StagedFiles staged(folder_ / "index");
      staged.add(folder_ / "index");
      message = test::messageOf([&] { staged.add(folder_ / "pieces/a"); });
    }
    const bool isEmpty = std::filesystem::is_empty(elsewhere);
    std::filesystem::remove_all(elsewhere);
    QVERIFY2(message.find("pieces/a: it lies on another file system than") != std::string::npos,
             message.c_str());
    QVERIFY(isEmpty);
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"pieces"}));
  }

  void preparedFilesHaveNoNameYet() {
    StagedFiles staged(folder_ / "index");
    writeFileAtomically(staged.add(folder_ / "new/a"), "a");
    writeFileAtomically(staged.add(folder_ / "index"), "i");
    staged.prepare();
    QVERIFY(std::filesystem::is_empty(folder_ / "new") && !std::filesystem::exists(folder_ / "index"));
    staged.commit();
    QVERIFY(std::filesystem::exists(folder_ / "new/a") && std::filesystem::exists(folder_ / "index"));
  }

  void fileThatIsGoneIsToldBeforeAnyNameIsGiven() {
    StagedFiles staged(folder_ / "a");
    writeFileAtomically(staged.add(folder_ / "a"), "a");
    staged.add(folder_ / "b");
    const std::string message = test::messageOf([&] { staged.commit(); });
    QVERIFY2(message.find("/b: ") != std::string::npos, message.c_str());
    QVERIFY(!std::filesystem::exists(folder_ / "a"));
  }

  void partsOfOthersStayTheirs() {
    StagedFiles first(folder_ / "index");
    {
      StagedFiles second(StagedFiles::Shared{first.folder(), "r1-"});
      writeFileAtomically(second.add(folder_ / "b"), "b");
    }
    writeFileAtomically(first.add(folder_ / "index"), "i");
    first.commit();
    QVERIFY(std::filesystem::exists(folder_ / "index") && !std::filesystem::exists(folder_ / "b"));
  }

 private:
  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<StagedFilesTest> registration;

}  // namespace pbffd

#include "staged_files_test.moc"

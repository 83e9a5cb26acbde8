#include "app/dataset/apply.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "tests/app/dataset/fixture.h"
#include "tests/support/test_main.h"

#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <QTemporaryDir>
#include <QtTest>

#include <sys/mount.h>

#include <atomic>
#include <cerrno>
#include <cstring>

Q_DECLARE_METATYPE(pbffd::test::XmlMode)

namespace pbffd {
namespace {

/// A small disk of its own while it lives, where the machine lets one be made.
class SmallDisk {
 public:
  SmallDisk(std::filesystem::path folder, const char* options) : folder_(std::move(folder)) {
    std::filesystem::create_directory(folder_);
    error_ = ::mount("tmpfs", folder_.c_str(), "tmpfs", 0, options) == 0 ? 0 : errno;
  }
  ~SmallDisk() {
    if (error_ == 0) {
      ::umount(folder_.c_str());
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  /// Why there is none; empty where there is one.
  std::string reason() const { return error_ == 0 ? std::string() : std::strerror(error_); }

 private:
  std::filesystem::path folder_;
  int error_;
};

}  // namespace

/// What happens in the middle of a file.
class MidstTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    dir_ = std::make_unique<QTemporaryDir>();
    folder_ = dir_->path().toStdString();
  }

  void cancelInTheMidstLeavesWhatWasThere_data() {
    using test::XmlMode;
    QTest::addColumn<XmlMode>("mode");
    QTest::addColumn<QByteArray>("stage");
    QTest::newRow("streamed") << XmlMode::raw << QByteArray("Deforming");
    QTest::newRow("by VTK, deforming") << XmlMode::binary << QByteArray("Deforming");
    QTest::newRow("by VTK, writing") << XmlMode::binary << QByteArray("Writing");
    QTest::newRow("by VTK, writing compressed") << XmlMode::rawCompressed << QByteArray("Writing");
  }
  void cancelInTheMidstLeavesWhatWasThere() {
    QFETCH(test::XmlMode, mode);
    QFETCH(QByteArray, stage);
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(64, true), mode);
    writeFileAtomically(folder_ / "b.vtu", "old");
    std::atomic<int> reports = 0;
    std::atomic<bool> wasWriting = false;
    Progress progress;
    progress = Progress([&](std::string_view said, double share) {
      if (said.starts_with(stage.toStdString()) && share >= (stage == "Writing" ? 1e-9 : 0.0) &&
          ++reports == 1) {
        wasWriting = hasStagedFile();
        progress.cancel();
      }
    });
    QVERIFY_EXCEPTION_THROWN(
        applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "b.vtu", {}, progress), Cancelled);
    QVERIFY(reports > 0);
    QVERIFY(wasWriting || stage == "Deforming");
    QCOMPARE(readFile(folder_ / "b.vtu"), std::string("old"));
    QCOMPARE(test::namesIn(folder_), (std::vector<std::string>{"a.vtu", "b.vtu"}));
  }

  void fullDiskIsToldAndLeavesNothing_data() {
    using test::XmlMode;
    QTest::addColumn<XmlMode>("mode");
    QTest::newRow("streamed") << XmlMode::raw;
    QTest::newRow("by VTK") << XmlMode::binary;
    QTest::newRow("by VTK, appended") << XmlMode::base64;
  }
  void fullDiskIsToldAndLeavesNothing() {
    QFETCH(test::XmlMode, mode);
    const SmallDisk disk(folder_ / "disk", "size=256k");
    if (!disk.reason().empty()) {
      QSKIP(qPrintable("No small disk can be made here: " + QString::fromStdString(disk.reason())));
    }
    test::writeXml(folder_ / "a.vtu", *test::hexahedra(24, true), mode);
    const QString message = QString::fromStdString(
        test::messageOf([&] { applyToFile(test::bentProject(), folder_ / "a.vtu", folder_ / "disk/b.vtu"); }));
    QVERIFY2(message.contains("disk/b.vtu") && message.contains("space left", Qt::CaseInsensitive),
             qPrintable(message));
    QVERIFY(test::namesIn(folder_ / "disk").empty());
  }

 private:
  /// Whether a file is being made beside the others.
  bool hasStagedFile() const {
    for (const std::string& name : test::namesIn(folder_)) {
      if (name.starts_with(".b.vtu.") && !test::namesIn(folder_ / name).empty()) {
        return true;
      }
    }
    return false;
  }

  std::unique_ptr<QTemporaryDir> dir_;
  std::filesystem::path folder_;
};

const test::Registration<MidstTest> registration;

}  // namespace pbffd

#include "midst_test.moc"

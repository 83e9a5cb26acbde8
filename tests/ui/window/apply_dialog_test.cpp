#include "ui/window/apply_dialog.h"

#include "core/base/error.h"
#include "tests/support/test_main.h"
#include "tests/ui/window/open_window.h"
#include "ui/document/job_runner.h"
#include "ui/window/error_bar.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QThread>

#include <atomic>

namespace pbffd::test {

using ui::ActionId;
using ui::ApplyService;

/// Fills the dialog that the next action opens, and presses its button.
void answerApplyDialog(const QString& source, const QString& target, bool isAligned = false) {
  QTimer::singleShot(0, qApp, [=] {
    auto* dialog = qobject_cast<ui::ApplyDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr) {
      return answerApplyDialog(source, target, isAligned);
    }
    dialog->findChild<QLineEdit*>("source")->setText(source);
    dialog->findChild<QLineEdit*>("target")->setText(target);
    dialog->findChild<QCheckBox*>("align")->setChecked(isAligned);
    dialog->accept();
  });
}

/// A service that remembers what it was asked, and on which thread.
struct FakeService {
  ApplyService service() {
    return {[this](const Project& project, const ApplyService::Request& asked, const Progress& progress) {
              request = asked;
              points = project.controls.finest().size();
              isOnUiThread = QThread::currentThread() == qApp->thread();
              ++calls;
              while (isSlow) {
                progress.throwIfCancelled();
                QThread::msleep(1);
              }
              if (fails) {
                throw InvalidInput("Could not read other.vtu: it has no points.");
              }
              return ApplyService::Report{1234567, 3, {"It has volume cells.", "Its normals stayed."}};
            },
            [](const std::filesystem::path& path) { return path.extension() == ".vtu"; },
            [](const std::filesystem::path& source, const std::filesystem::path& target) {
              return source.extension() == target.extension();
            },
            [](const std::filesystem::path& path) { return path.extension() == ".vtu"; }, ".obj and .vtu"};
  }

  ApplyService::Request request;
  Index points = 0;
  bool isOnUiThread = false;
  std::atomic<int> calls = 0;
  std::atomic<bool> isSlow = false;
  bool fails = false;
};

class ApplyDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void applyIsGreyUntilBothFilesAreNamed() {
    FakeService fake;
    const ApplyService service = fake.service();
    const QTemporaryDir folder;
    ui::ApplyDialog dialog(service, folder.path(), nullptr);
    const auto* apply = buttonOf(dialog);
    auto* source = dialog.findChild<QLineEdit*>("source");
    auto* target = dialog.findChild<QLineEdit*>("target");
    QVERIFY(!apply->isEnabled());
    source->setText(folder.filePath("a.vtu"));
    QVERIFY(!apply->isEnabled());
    touch(folder.filePath("a.vtu"));
    touch(folder.filePath("a.png"));
    source->setText(folder.filePath("a.png"));
    QVERIFY(!apply->isEnabled());
    QVERIFY(!dialog.findChild<QLineEdit*>("arrays")->isEnabled());
    source->setText(folder.filePath("a.vtu"));
    QVERIFY(apply->isEnabled());
    QCOMPARE(target->text(), folder.filePath("a-deformed.vtu"));
    QVERIFY(dialog.findChild<QLineEdit*>("arrays")->isEnabled());
    target->clear();
    QVERIFY(!apply->isEnabled());
  }

  void anotherFormatIsRefusedWithTheReason() {
    FakeService fake;
    const ApplyService service = fake.service();
    const QTemporaryDir folder;
    touch(folder.filePath("a.vtu"));
    ui::ApplyDialog dialog(service, folder.path(), nullptr);
    dialog.findChild<QLineEdit*>("source")->setText(folder.filePath("a.vtu"));
    dialog.findChild<QLineEdit*>("target")->setText("b.obj");
    QVERIFY(!buttonOf(dialog)->isEnabled());
    QCOMPARE(dialog.findChild<QLabel*>("reason")->text(),
             QString("a.vtu keeps its format: let the file to write end in .vtu."));
  }

  void whatIsThereIsReplacedOnlyBySayingSo() {
    FakeService fake;
    const ApplyService service = fake.service();
    const QTemporaryDir folder;
    for (const char* name : {"a.vtu", "a-deformed.vtu", "a-deformed-2.vtu", "old.vtu"}) {
      touch(folder.filePath(name));
    }
    ui::ApplyDialog dialog(service, folder.path(), nullptr);
    const auto* apply = buttonOf(dialog);
    auto* target = dialog.findChild<QLineEdit*>("target");
    dialog.findChild<QLineEdit*>("source")->setText(folder.filePath("a.vtu"));
    QCOMPARE(target->text(), folder.filePath("a-deformed-3.vtu"));
    QCOMPARE(apply->text(), QString("Apply"));
    target->setText("old.vtu");
    QCOMPARE(dialog.request().target, std::filesystem::path(folder.filePath("old.vtu").toStdString()));
    QCOMPARE(apply->text(), QString("Replace"));
    QVERIFY(apply->isEnabled());
  }

  void ownTargetIsKept() {
    FakeService fake;
    const ApplyService service = fake.service();
    ui::ApplyDialog dialog(service, {}, nullptr);
    auto* target = dialog.findChild<QLineEdit*>("target");
    QTest::keyClicks(target, "mine.vtu");
    dialog.findChild<QLineEdit*>("source")->setText("/somewhere/a.vtu");
    QCOMPARE(target->text(), QString("mine.vtu"));
    dialog.findChild<QLineEdit*>("arrays")->setText(" velocity, ,Normals:normal");
    QCOMPARE(dialog.request().transports, (std::vector<std::string>{"velocity", "Normals:normal"}));
  }

  void windowAppliesOffTheUiThreadAndTells() {
    FakeService fake;
    OpenWindow open({ui::Theme::Choice::dark, false, fake.service()});
    QVERIFY(open.isReady);
    QVERIFY(open.open(writeShape(open.folder, cube(), "cube.obj")));
    touch(open.folder.filePath("other.vtu"));
    QStringList informed;
    connect(&open.window.document(), &ui::Document::informed, this,
            [&informed](const QString& text) { informed += text; });
    trigger(open, "out.vtu", true);
    QVERIFY(finishJobs(open.window.document()));
    QCOMPARE(fake.calls.load(), 1);
    QVERIFY(!fake.isOnUiThread);
    QCOMPARE(fake.points, open.window.document().committed().controls.finest().size());
    QVERIFY(fake.request.align);
    QCOMPARE(QString::fromStdString(fake.request.target.string()), open.folder.filePath("out.vtu"));
    QCOMPARE(informed.last(), QString("Wrote out.vtu: 1,234,567 points in 3 pieces."));
    QCOMPARE(open.window.errorBar().text(), QString("It has volume cells. Its normals stayed."));
  }

  void failureIsToldAndCancelLeavesAllAsBefore() {
    FakeService fake;
    fake.fails = true;
    OpenWindow open({ui::Theme::Choice::dark, false, fake.service()});
    QVERIFY(open.open(writeShape(open.folder, cube(), "cube.obj")));
    touch(open.folder.filePath("other.vtu"));
    trigger(open, "out.vtu", false);
    QVERIFY(finishJobs(open.window.document()));
    QVERIFY(open.window.errorBar().text().contains("it has no points"));
    fake.isSlow = true;
    trigger(open, "out.vtu", false);
    QTRY_COMPARE(fake.calls.load(), 2);
    const int entries = open.window.document().history().count();
    open.window.document().jobs().cancel();
    QVERIFY(finishJobs(open.window.document()));
    QCOMPARE(open.window.document().history().count(), entries);
  }

  void secondFileWaitsForTheFirst() {
    FakeService fake;
    fake.isSlow = true;
    OpenWindow open({ui::Theme::Choice::dark, false, fake.service()});
    QVERIFY(open.open(writeShape(open.folder, cube(), "cube.obj")));
    touch(open.folder.filePath("other.vtu"));
    QStringList informed;
    connect(&open.window.document(), &ui::Document::informed, this,
            [&informed](const QString& text) { informed += text; });
    trigger(open, "one.vtu", false);
    QTRY_COMPARE(fake.calls.load(), 1);
    trigger(open, "two.vtu", false);
    fake.isSlow = false;
    QVERIFY(finishJobs(open.window.document()));
    QCOMPARE(fake.calls.load(), 2);
    QCOMPARE(informed.mid(informed.size() - 2), (QStringList{"Wrote one.vtu: 1,234,567 points in 3 pieces.",
                                                             "Wrote two.vtu: 1,234,567 points in 3 pieces."}));
  }

  void withoutAServiceTheActionIsNotThere() {
    OpenWindow open;
    QVERIFY(!open.window.actions()[ActionId::applyToOther]->isVisible());
    FakeService fake;
    OpenWindow other({ui::Theme::Choice::dark, false, fake.service()});
    QVERIFY(other.window.actions()[ActionId::applyToOther]->isVisible());
    QVERIFY(!other.window.actions()[ActionId::applyToOther]->isEnabled());
  }

 private:
  static const QPushButton* buttonOf(const ui::ApplyDialog& dialog) {
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) {
      if (button->text() == "Apply") {
        return button;
      }
    }
    return nullptr;
  }

  static void touch(const QString& path) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
  }

  static void trigger(OpenWindow& open, const QString& target, bool isAligned) {
    answerApplyDialog(open.folder.filePath("other.vtu"), open.folder.filePath(target), isAligned);
    open.window.actions()[ActionId::applyToOther]->trigger();
  }
};

const Registration<ApplyDialogTest> registration;

}  // namespace pbffd::test

#include "apply_dialog_test.moc"

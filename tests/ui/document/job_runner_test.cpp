#include "ui/document/job_runner.h"

#include "core/base/error.h"
#include "tests/support/test_main.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QThread>
#include <QtTest>

#include <atomic>

namespace pbffd::test {

using ui::JobRunner;

constexpr int patience = 30000;

class JobRunnerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void workRunsElsewhereAndIsDeliveredHere();
  void oneJobRunsAtATimeInOrder();
  void aNewerJobOfTheSameKeyReplaces();
  void cancelledWorkIsNotDelivered();
  void cancelDropsWaitingJobs();
  void exceptionsBecomeMessages();
  void progressIsReportedAtMostThirtyTimesASecond();
  void destructionWaitsForTheWorker();
};

/// Work that runs until it is told to stop.
JobRunner::Deliver untilCancelled(const Progress& progress, QSemaphore& started) {
  started.release();
  while (true) {
    progress.throwIfCancelled();
    QThread::msleep(1);
  }
}

void JobRunnerTest::workRunsElsewhereAndIsDeliveredHere() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  QThread* workThread = nullptr;
  QThread* deliveryThread = nullptr;
  jobs.start({"a", "A", [&](const Progress&) -> JobRunner::Deliver {
                workThread = QThread::currentThread();
                return [&] { deliveryThread = QThread::currentThread(); };
              }});
  QVERIFY(jobs.isRunning("a"));
  QVERIFY(finished.wait(patience));
  QVERIFY(workThread != nullptr && workThread != QThread::currentThread());
  QCOMPARE(deliveryThread, QThread::currentThread());
  QVERIFY(!jobs.isRunning());
}

void JobRunnerTest::oneJobRunsAtATimeInOrder() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  std::atomic<int> running{0};
  std::atomic<int> most{0};
  QStringList order;
  for (const QString key : {"a", "b", "c"}) {
    jobs.start({key, key, [&, key](const Progress&) -> JobRunner::Deliver {
                  most = std::max(most.load(), ++running);
                  QThread::msleep(5);
                  --running;
                  return [&, key] { order += key; };
                }});
  }
  QVERIFY(finished.wait(patience));
  QCOMPARE(order, QStringList({"a", "b", "c"}));
  QCOMPARE(most.load(), 1);
  QCOMPARE(finished.count(), 1);
}

void JobRunnerTest::aNewerJobOfTheSameKeyReplaces() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  QSignalSpy cancelled(&jobs, &JobRunner::cancelled);
  QSemaphore started;
  int delivered = 0;
  jobs.start({"place", "1", [&](const Progress& progress) { return untilCancelled(progress, started); }});
  started.acquire();
  for (int number = 2; number <= 4; ++number) {
    jobs.start({"place", "n", [&, number](const Progress&) -> JobRunner::Deliver {
                  return [&, number] { delivered = number; };
                }});
  }
  QVERIFY(finished.wait(patience));
  QCOMPARE(delivered, 4);
  QCOMPARE(cancelled.count(), 0);
}

void JobRunnerTest::cancelledWorkIsNotDelivered() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  QSignalSpy cancelled(&jobs, &JobRunner::cancelled);
  QSignalSpy failed(&jobs, &JobRunner::failed);
  QSemaphore started;
  QSemaphore go;
  bool isDelivered = false;
  // The work ends as if it had not noticed.
  jobs.start({"a", "A", [&](const Progress&) -> JobRunner::Deliver {
                started.release();
                go.acquire();
                return [&] { isDelivered = true; };
              }});
  started.acquire();
  jobs.cancel();
  go.release();
  QVERIFY(finished.wait(patience));
  QVERIFY(!isDelivered);
  QCOMPARE(cancelled.count(), 1);
  QCOMPARE(failed.count(), 0);
}

void JobRunnerTest::cancelDropsWaitingJobs() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  QSemaphore started;
  std::atomic<bool> ran{false};
  jobs.start({"a", "A", [&](const Progress& progress) { return untilCancelled(progress, started); }});
  jobs.start({"b", "B", [&](const Progress&) -> JobRunner::Deliver {
                ran = true;
                return {};
              }});
  started.acquire();
  jobs.cancel();
  QVERIFY(finished.wait(patience));
  QVERIFY(!ran);
}

void JobRunnerTest::exceptionsBecomeMessages() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  QSignalSpy failed(&jobs, &JobRunner::failed);
  jobs.start({"a", "A", [](const Progress&) -> JobRunner::Deliver { throw InvalidInput("It is broken."); }});
  jobs.start({"b", "B", [](const Progress&) -> JobRunner::Deliver { throw std::bad_alloc(); }});
  QVERIFY(finished.wait(patience));
  QCOMPARE(failed.count(), 2);
  QCOMPARE(failed[0][0].toString(), QString("It is broken."));
  QVERIFY(failed[1][0].toString().contains("memory"));
}

void JobRunnerTest::progressIsReportedAtMostThirtyTimesASecond() {
  JobRunner jobs;
  QSignalSpy finished(&jobs, &JobRunner::finished);
  QSignalSpy progressed(&jobs, &JobRunner::progressed);
  QElapsedTimer timer;
  timer.start();
  jobs.start({"a", "A", [](const Progress& progress) -> JobRunner::Deliver {
                for (int i = 0; i < 400; ++i) {
                  progress.report("Counting", i / 400.0);
                  QThread::msleep(1);
                }
                return {};
              }});
  QVERIFY(finished.wait(patience));
  QVERIFY(progressed.count() > 0);
  QVERIFY(progressed.count() <= 1 + timer.elapsed() * 30 / 1000);
  QCOMPARE(progressed.last()[0].toString(), QString("Counting"));
}

void JobRunnerTest::destructionWaitsForTheWorker() {
  std::atomic<bool> ended{false};
  QSemaphore started;
  {
    JobRunner jobs;
    jobs.start({"a", "A", [&](const Progress& progress) -> JobRunner::Deliver {
                  started.release();
                  while (!progress.isCancelled()) {
                    QThread::msleep(1);
                  }
                  ended = true;
                  return {};
                }});
    started.acquire();
  }
  QVERIFY(ended);
}

const Registration<JobRunnerTest> registration;

}  // namespace pbffd::test

#include "job_runner_test.moc"

#pragma once

#include "core/base/progress.h"

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>

#include <deque>
#include <functional>
#include <memory>

namespace pbffd::ui {

/// Runs long work off the UI thread, one job at a time in the order asked for; a newer job of the same key
/// replaces a running or waiting one. All members and signals belong to the UI thread.
class JobRunner : public QObject {
  Q_OBJECT

 public:
  /// What to do on the UI thread with a result; not called for a job that was cancelled or replaced.
  using Deliver = std::function<void()>;
  /// Runs on a worker thread; an exception becomes `failed` (Cancelled: nothing).
  using Work = std::function<Deliver(const Progress&)>;

  struct Job {
    QString key;    ///< what it is a kind of: "open", "place", "export"
    QString title;  ///< said until the work names a stage
    Work work;
  };

  explicit JobRunner(QObject* parent = nullptr);
  /// Cancels everything and waits for the worker to notice.
  ~JobRunner() override;

  void start(Job job);
  /// Asks the running job to stop and drops those that wait.
  void cancel();
  void cancel(const QString& key);
  /// Cancels everything and waits until the worker is at rest.
  void stop();

  bool isRunning() const { return running_ != nullptr; }
  bool isRunning(const QString& key) const;
  double runningSeconds() const { return 0.001 * static_cast<double>(clock_.elapsed()); }

 Q_SIGNALS:
  void started(const QString& title);
  /// At most 30 a second. share: 0 to 1 of the stage, negative where it is not known.
  void progressed(const QString& stage, double share);
  /// Nothing runs and nothing waits any more.
  void finished();
  void failed(const QString& message);
  void cancelled(const QString& title);

 private:
  struct Running;
  struct Outcome;

  void startNext();
  void finish(const std::shared_ptr<Running>& job, const Outcome& outcome);
  void pollProgress();

  std::deque<Job> waiting_;
  std::shared_ptr<Running> running_;
  QElapsedTimer clock_;
  QTimer poll_;
  QThreadPool pool_;
};

}  // namespace pbffd::ui

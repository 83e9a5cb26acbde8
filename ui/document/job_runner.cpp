#include "ui/document/job_runner.h"

#include "core/base/error.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <utility>

namespace pbffd::ui {
namespace {

constexpr int pollMilliseconds = 34;

/// The latest report of the work, written by any thread and read by the UI thread.
struct Report {
  std::mutex mutex;
  std::string stage;
  double share = -1.0;
  bool isNew = false;
};

}  // namespace

struct JobRunner::Running {
  Job job;
  std::shared_ptr<Report> report = std::make_shared<Report>();
  Progress progress;
  bool isReplaced = false;
};

struct JobRunner::Outcome {
  Deliver deliver;
  QString error;
};

namespace {

template <class Outcome>
Outcome outcomeOf(const JobRunner::Work& work, const Progress& progress) {
  try {
    return {work(progress), {}};
  } catch (const Cancelled&) {
    return {};
  } catch (const std::bad_alloc&) {
    return {{},
            JobRunner::tr("There is not enough memory for this. Close other programs or use a smaller mesh.")};
  } catch (const std::exception& error) {
    return {{}, QString::fromUtf8(error.what())};
  }
}

}  // namespace

JobRunner::JobRunner(QObject* parent) : QObject(parent) {
  pool_.setMaxThreadCount(1);
  poll_.setInterval(pollMilliseconds);
  connect(&poll_, &QTimer::timeout, this, &JobRunner::pollProgress);
}

JobRunner::~JobRunner() {
  waiting_.clear();
  if (running_) {
    running_->progress.cancel();
  }
  pool_.waitForDone();
}

bool JobRunner::isRunning(const QString& key) const {
  return running_ && running_->job.key == key;
}

void JobRunner::start(Job job) {
  std::erase_if(waiting_, [&](const Job& other) { return other.key == job.key; });
  if (isRunning(job.key)) {
    running_->isReplaced = true;
    running_->progress.cancel();
  }
  waiting_.push_back(std::move(job));
  if (!running_) {
    startNext();
  }
}

void JobRunner::cancel() {
  waiting_.clear();
  if (running_) {
    running_->progress.cancel();
  }
}

void JobRunner::cancel(const QString& key) {
  std::erase_if(waiting_, [&](const Job& other) { return other.key == key; });
  if (isRunning(key)) {
    running_->progress.cancel();
  }
}

void JobRunner::stop() {
  cancel();
  pool_.waitForDone();
}

void JobRunner::startNext() {
  running_ = std::make_shared<Running>();
  running_->job = std::move(waiting_.front());
  waiting_.pop_front();
  running_->progress = Progress([report = running_->report](std::string_view stage, double share) {
    const std::lock_guard lock(report->mutex);
    report->stage = stage;
    report->share = share;
    report->isNew = true;
  });
  clock_.start();
  poll_.start();
  Q_EMIT started(running_->job.title);
  pool_.start([this, job = running_] {
    const Outcome outcome = outcomeOf<Outcome>(job->job.work, job->progress);
    QMetaObject::invokeMethod(
        this, [this, job, outcome] { finish(job, outcome); }, Qt::QueuedConnection);
  });
}

void JobRunner::finish(const std::shared_ptr<Running>& job, const Outcome& outcome) {
  running_.reset();
  if (job->progress.isCancelled()) {
    if (!job->isReplaced) {
      Q_EMIT cancelled(job->job.title);
    }
  } else if (!outcome.error.isEmpty()) {
    Q_EMIT failed(outcome.error);
  } else if (outcome.deliver) {
    outcome.deliver();
  }
  if (!running_ && !waiting_.empty()) {
    startNext();
  }
  if (!running_) {
    poll_.stop();
    Q_EMIT finished();
  }
}

void JobRunner::pollProgress() {
  if (!running_) {
    return;
  }
  QString stage;
  double share = -1.0;
  {
    const std::lock_guard lock(running_->report->mutex);
    if (!running_->report->isNew) {
      return;
    }
    running_->report->isNew = false;
    stage = QString::fromStdString(running_->report->stage);
    share = running_->report->share;
  }
  Q_EMIT progressed(stage, share);
}

}  // namespace pbffd::ui

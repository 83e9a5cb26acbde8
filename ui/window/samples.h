#pragma once

#include <QImage>
#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <vector>

namespace pbffd::ui {

/// The sample models that come with the program.
struct Sample {
  QString path;
  QString name;  ///< "creature.obj"
};
/// Those found beside the program: ../samples where it was built, ../share/pbffd-workbench/samples where it
/// is installed. At most six, the most telling first.
std::vector<Sample> findSamples();

/// Makes pictures of samples off the UI thread, and keeps them in the cache folder where one may.
class SamplePictures : public QObject {
  Q_OBJECT

 public:
  SamplePictures(bool isKept, QObject* parent = nullptr);
  ~SamplePictures() override;

  void ask(const std::vector<Sample>& samples);

 Q_SIGNALS:
  /// The picture may be null where a sample could not be read.
  void ready(const QString& path, const QImage& picture, int triangles);

 private:
  bool isKept_;
  std::atomic<bool> isStopped_{false};
  QThreadPool pool_;
};

}  // namespace pbffd::ui

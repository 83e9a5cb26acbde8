#include "ui/window/samples.h"

#include "core/base/error.h"
#include "core/mesh/io/mesh_io.h"
#include "ui/window/recent_files.h"
#include "ui/window/thumbnail.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace pbffd::ui {
namespace {

constexpr std::size_t mostSamples = 6;
const QSize pictureSize(560, 320);
/// Raised when pictures look different, so that old ones are not shown.
constexpr int pictureVersion = 1;

struct Made {
  QImage picture;
  int triangles = 0;
};

Made make(const QString& path) {
  try {
    const Mesh mesh = readMesh(std::filesystem::path(path.toStdU16String()));
    const Triangles triangles = triangulate(mesh.positions, mesh.faces);
    return {renderThumbnail(mesh.positions, triangles, pictureSize), triangles.size()};
  } catch (const Error&) {
    // A sample that cannot be read gets an empty card; opening it says why.
    return {};
  }
}

Made makeOrFind(const QString& path, bool isKept) {
  const QFileInfo file(path);
  const QString cached = QString("%1/sample-%2-%3-%4.png")
                             .arg(RecentFiles::pictureFolder(), file.completeBaseName())
                             .arg(file.lastModified().toSecsSinceEpoch())
                             .arg(pictureVersion);
  if (isKept) {
    const QImage picture(cached);
    if (!picture.isNull()) {
      return {picture, picture.text("triangles").toInt()};
    }
  }
  Made made = make(path);
  if (isKept && !made.picture.isNull() && QDir().mkpath(RecentFiles::pictureFolder())) {
    made.picture.setText("triangles", QString::number(made.triangles));
    made.picture.save(cached);
  }
  return made;
}

}  // namespace

std::vector<Sample> findSamples() {
  static const QStringList order{"creature", "figure", "hand", "bracket", "vase", "bar"};
  const QDir program(QCoreApplication::applicationDirPath());
  std::vector<Sample> samples;
  for (const char* folder : {"../samples", "../share/pbffd-workbench/samples"}) {
    for (const QFileInfo& file :
         QDir(program.filePath(folder)).entryInfoList({"*.obj"}, QDir::Files, QDir::Name)) {
      samples.push_back({file.canonicalFilePath(), file.fileName()});
    }
    if (!samples.empty()) {
      break;
    }
  }
  const auto rank = [](const Sample& sample) {
    const qsizetype at = order.indexOf(QFileInfo(sample.path).completeBaseName());
    return at < 0 ? order.size() : at;
  };
  std::stable_sort(samples.begin(), samples.end(),
                   [&](const Sample& a, const Sample& b) { return rank(a) < rank(b); });
  samples.resize(std::min(samples.size(), mostSamples));
  return samples;
}

SamplePictures::SamplePictures(bool isKept, QObject* parent) : QObject(parent), isKept_(isKept) {
  pool_.setMaxThreadCount(1);
}

SamplePictures::~SamplePictures() {
  isStopped_ = true;
  pool_.waitForDone();
}

void SamplePictures::ask(const std::vector<Sample>& samples) {
  for (const Sample& sample : samples) {
    pool_.start([this, path = sample.path] {
      if (isStopped_) {
        return;
      }
      const Made made = makeOrFind(path, isKept_);
      QMetaObject::invokeMethod(
          this, [this, path, made] { Q_EMIT ready(path, made.picture, made.triangles); }, Qt::QueuedConnection);
    });
  }
}

}  // namespace pbffd::ui

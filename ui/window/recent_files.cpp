#include "ui/window/recent_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace pbffd::ui {
namespace {

constexpr std::size_t mostEntries = 8;

QString pictureFile(const QString& path) {
  const QByteArray digest = QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex();
  return RecentFiles::pictureFolder() + "/" + QString::fromLatin1(digest.left(20)) + ".png";
}

}  // namespace

RecentFiles::RecentFiles(bool isKept, QObject* parent) : QObject(parent), isKept_(isKept) {
  if (!isKept_) {
    return;
  }
  QSettings settings;
  const int count = settings.beginReadArray("recent");
  for (int i = 0; i < count; ++i) {
    settings.setArrayIndex(i);
    entries_.push_back({settings.value("path").toString(), settings.value("time").toDateTime(),
                        settings.value("points").toInt()});
  }
}

QString RecentFiles::pictureFolder() {
  return QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + "/pictures";
}

void RecentFiles::add(const QString& path, int points) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  std::erase_if(entries_, [&](const Entry& entry) { return entry.path == absolute; });
  entries_.insert(entries_.begin(), {absolute, QDateTime::currentDateTime(), points});
  if (entries_.size() > mostEntries) {
    entries_.resize(mostEntries);
  }
  store();
}

void RecentFiles::remove(const QString& path) {
  std::erase_if(entries_, [&](const Entry& entry) { return entry.path == path; });
  store();
}

void RecentFiles::clear() {
  entries_.clear();
  store();
}

void RecentFiles::store() {
  if (isKept_) {
    QSettings settings;
    settings.remove("recent");
    settings.beginWriteArray("recent");
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      settings.setArrayIndex(static_cast<int>(i));
      settings.setValue("path", entries_[i].path);
      settings.setValue("time", entries_[i].time);
      settings.setValue("points", entries_[i].points);
    }
    settings.endArray();
  }
  Q_EMIT changed();
}

void RecentFiles::keepPicture(const QString& path, const QImage& picture) const {
  if (isKept_ && QDir().mkpath(pictureFolder())) {
    picture.save(pictureFile(QFileInfo(path).absoluteFilePath()));
  }
}

QImage RecentFiles::picture(const QString& path) const {
  return isKept_ ? QImage(pictureFile(path)) : QImage();
}

}  // namespace pbffd::ui

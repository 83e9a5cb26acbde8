#pragma once

#include <QDateTime>
#include <QImage>
#include <QObject>

#include <vector>

namespace pbffd::ui {

/// The files opened and saved lately, newest first, kept in the user's settings with small pictures in the
/// cache folder. A list that is not kept is empty at the start and writes nothing.
class RecentFiles : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    QString path;
    QDateTime time;
    int points = 0;
  };

  explicit RecentFiles(bool isKept, QObject* parent = nullptr);

  bool isKept() const { return isKept_; }
  const std::vector<Entry>& entries() const { return entries_; }
  void add(const QString& path, int points);
  void remove(const QString& path);
  void clear();

  void keepPicture(const QString& path, const QImage& picture) const;
  QImage picture(const QString& path) const;

  /// Where pictures of files are kept; empty when the list is not kept.
  static QString pictureFolder();

 Q_SIGNALS:
  void changed();

 private:
  void store();

  bool isKept_;
  std::vector<Entry> entries_;
};

}  // namespace pbffd::ui

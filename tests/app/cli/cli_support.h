#pragma once

#include "core/mesh/mesh.h"

#include <QByteArray>
#include <QJsonObject>
#include <QStringList>
#include <QTemporaryDir>

namespace pbffd::test {

/// What a run of the command line program came to.
struct CommandResult {
  int status = -1;  ///< -1: it crashed, or did not end in time
  QByteArray output;
  QByteArray errors;

  /// Standard output as the JSON object that it is; empty where it is anything else.
  QJsonObject json() const;
};

/// Runs `pbffd` with these arguments and this on its standard input.
CommandResult runPbffd(const QStringList& arguments, const QByteArray& input = {});

/// The path of the program.
QString pbffdProgram();

/// A folder that goes with the test, with the files that a test of the command line needs.
class CommandFolder {
 public:
  QString path(const QString& name) const { return folder_.filePath(name); }

  /// Writes a file and returns its path.
  QString write(const QString& name, const QByteArray& bytes) const;
  QString writeObj(const QString& name, const Mesh& mesh) const;

  /// A project of a sphere with 30 points on 2 levels.
  QString placedSphere(const QString& name) const;

  /// The content of a file; "(no file)" where there is none.
  QByteArray read(const QString& name) const;

 private:
  QTemporaryDir folder_;
};

/// The text of an OBJ file, positions with 17 digits.
QByteArray objOf(const Mesh& mesh);

}  // namespace pbffd::test

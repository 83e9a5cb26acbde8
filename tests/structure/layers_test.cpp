#include "tests/structure/include_rules.h"
#include "tests/support/test_main.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QtTest>

namespace pbffd {

/// Holds the house to its plan: which layer may include which, and which libraries stay where.
class LayersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyIncludeFollowsTheArrows() {
    const QDir root(PBFFD_SOURCE_DIR);
    QStringList violations;
    int files = 0;
    for (const char* folder : {"core", "ui", "app"}) {
      QDirIterator sources(root.filePath(folder), {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
      while (sources.hasNext()) {
        QFile file(sources.next());
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
        const std::string path = root.relativeFilePath(file.fileName()).toStdString();
        for (const std::string& violation : test::includeViolations(path, file.readAll().toStdString())) {
          violations << QString::fromStdString(violation);
        }
        ++files;
      }
    }
    QVERIFY(files > 10);
    QVERIFY2(violations.empty(), qPrintable('\n' + violations.join('\n')));
  }

  void plantedViolationIsFound_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("header");
    const auto row = [](const char* name, const char* path, const char* header) {
      QTest::newRow(name) << path << header;
    };
    row("Qt in core", "core/ffd/basis.cpp", "<QString>");
    row("a Qt module in core", "core/ffd/basis.cpp", "<QtCore/qglobal.h>");
    row("Qt in the command line", "app/cli/info.cpp", "<QCoreApplication>");
    row("VTK in core", "core/mesh/mesh.cpp", "<vtkPolyData.h>");
    row("VTK in the window", "ui/window/main_window.cpp", "<vtkActor.h>");
    row("VTK's widget outside the views", "ui/window/main_window.h", "<QVTKOpenGLNativeWidget.h>");
    row("base looks at mesh", "core/base/file.cpp", "\"core/mesh/mesh.h\"");
    row("mesh looks at its readers", "core/mesh/mesh.cpp", "\"core/mesh/io/mesh_io.h\"");
    row("mesh looks at ffd", "core/mesh/mesh.cpp", "\"core/ffd/basis.h\"");
    row("weights look at the deformation", "core/ffd/weights/reach.cpp", "\"core/ffd/deform/strain.h\"");
    row("placement looks at the levels", "core/ffd/placement/decimation.cpp",
        "\"core/ffd/levels/hierarchy.h\"");
    row("ffd looks at project", "core/ffd/basis.cpp", "\"core/project/edit.h\"");
    row("core looks at ui", "core/project/edit.cpp", "\"ui/document/document.h\"");
    row("document looks at a model", "ui/document/document.cpp", "\"ui/models/scene_tree.h\"");
    row("a model looks at a view", "ui/models/scene_tree.cpp", "\"ui/views/viewport.h\"");
    row("a view looks at a controller", "ui/views/viewport.cpp", "\"ui/controllers/actions.h\"");
    row("a controller looks at the window", "ui/controllers/actions.cpp", "\"ui/window/main_window.h\"");
    row("ui looks at app", "ui/window/main_window.cpp", "\"app/dataset/reader.h\"");
    row("the command line looks at ui", "app/cli/main.cpp", "\"ui/document/document.h\"");
    row("Qhull outside its file", "core/ffd/placement/placement.cpp", "<libqhull_r/qhull_ra.h>");
    row("OpenMesh outside its file", "core/mesh/mesh.cpp", "<OpenMesh/Core/Mesh/TriMesh.hh>");
    row("nanoflann outside its file", "core/mesh/nearest.h", "<nanoflann.hpp>");
    row("TBB outside its file", "core/ffd/deform/deformation.cpp", "<tbb/parallel_for.h>");
    row("OpenSSL outside its file", "core/project/project_file.cpp", "<openssl/evp.h>");
    row("fmt outside its file", "core/base/file.cpp", "<fmt/format.h>");
    row("libzip outside its files", "core/project/edit.cpp", "<zip.h>");
    row("nlohmann-json in ui", "ui/document/document.cpp", "<nlohmann/json.hpp>");
    row("CLI11 in core", "core/project/edit.cpp", "<CLI/CLI.hpp>");
    row("a library nobody listed", "core/mesh/mesh.cpp", "<boost/graph/graph.hpp>");
    row("a header named from its own folder", "core/mesh/mesh.cpp", "\"mesh.h\"");
  }
  void plantedViolationIsFound() {
    QFETCH(QString, path);
    QFETCH(QString, header);
    const QString source = "#pragma once\n\n #  include " + header + "  // why\nint x;\n";
    const auto violations = test::includeViolations(path.toStdString(), source.toStdString());
    QCOMPARE(violations.size(), std::size_t{1});
    const QString place = path + ":3: " + header.mid(1, header.size() - 2);
    QVERIFY2(QString::fromStdString(violations[0]).startsWith(place), violations[0].c_str());
  }

  void fileOutsideTheLayersIsFound() {
    QCOMPARE(test::includeViolations("core/stray.cpp", "").size(), std::size_t{1});
    QCOMPARE(test::includeViolations("ui/extra/stray.cpp", "").size(), std::size_t{1});
  }

  void whatTheArrowsAllowPasses() {
    const auto allowed = [](const char* path, const char* source) {
      return test::includeViolations(path, source).empty();
    };
    QVERIFY(allowed("core/mesh/mesh.cpp", "#include \"core/mesh/mesh.h\"\n#include <vector>\n"));
    QVERIFY(allowed("core/project/edit.cpp", "#include \"core/mesh/io/mesh_io.h\"\n#include <Eigen/LU>\n"));
    QVERIFY(allowed("ui/views/viewport.cpp", "#include <vtkActor.h>\n#include \"viewport.moc\"\n"));
    QVERIFY(allowed("ui/window/main_window.cpp", "#include \"ui/views/viewport.h\"\n#include <QDockWidget>\n"));
    QVERIFY(allowed("app/workbench/main.cpp", "#include \"ui/window/main_window.h\"\n"));
    QVERIFY(allowed("app/cli/main.cpp", "#include <CLI/CLI.hpp>\n#include <nlohmann/json.hpp>\n"));
  }
};

const test::Registration<LayersTest> registration;

}  // namespace pbffd

#include "layers_test.moc"

#pragma once

#include "core/base/file.h"
#include "core/mesh/io/mesh_io.h"
#include "core/project/archive.h"
#include "core/project/project_file.h"
#include "tests/core/project/projects.h"

#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace pbffd::test {

using Json = nlohmann::json;

/// A project with something of everything, saved in a folder of its own, and ways to change the file.
class SavedProject {
 public:
  std::filesystem::path path() const { return folder_.filePath("ball.pbffd").toStdString(); }

  static Project edited() {
    static const Project project = [] {
      const Mesh ball = test::sphere(8, 12);
      auto bytes =
          std::make_shared<const std::string>(encodeMesh(ball, {ball.positions, {}}, MeshFormat::obj));
      Project made = projectWith(40, 3, parseMesh(bytes, "ball.obj"));
      made = after(made,
                   Move{{1, {made.controls.levels[0][0].id}}, {Vec3(0.1, 1.0 / 3.0, 0)}, Follow::frames, {}});
      made = after(made, Rename{3, 2, "Nose \"ä\""});
      made = after(made, Lock{{3, {3}}, true});
      made = after(made, Enable{{3, {5}}, false});
      made = after(made, Strength{{3, {6}}, 1.0 / 7.0});
      made = after(made, SetKernel{{Kernel::gaussian, 2.9}});
      made.placement.points = 40;
      made.placement.sites = 300;
      return made;
    }();
    return project;
  }

  /// Saves the project with its archive and document changed.
  void change(const std::function<void(Archive&, Json&)>& edit) const {
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    Json json = Json::parse(archive.members[0].bytes);
    edit(archive, json);
    archive.members[0].bytes = json.dump();
    writeArchive(path(), archive);
  }

  void changeText(const std::string& from, const std::string& to) const {
    saveProject(path(), edited());
    Archive archive = readArchive(path());
    std::string& text = archive.members[0].bytes;
    text.replace(text.find(from), from.size(), to);
    writeArchive(path(), archive);
  }

  /// The message with which the file is refused; empty where it is not.
  std::string refusal() const {
    try {
      static_cast<void>(loadProject(path()));
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return {};
  }

 protected:
  QTemporaryDir folder_;
};

}  // namespace pbffd::test

#include "core/base/error.h"
#include "core/base/file.h"
#include "resources/samples/generator/sample.h"

#include <cstdio>
#include <filesystem>

/// Writes the sample models as OBJ files into the folder named by the only argument.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("Usage: pbffd-samples FOLDER\n", stderr);
    return 2;
  }
  try {
    using namespace pbffd::samples;
    const std::filesystem::path folder(argv[1]);
    std::filesystem::create_directories(folder);
    for (const auto make : {makeCreature, makeFigure, makeHand, makeBracket, makeVase, makeBar}) {
      const Sample sample = make();
      requireSound(sample);
      pbffd::writeFileAtomically(folder / (sample.name + ".obj"), toObj(sample));
      std::printf("%s.obj: %td vertices, %d faces\n", sample.name.c_str(),
                  static_cast<std::ptrdiff_t>(sample.positions.rows()), sample.faces.size());
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}

#include "core/mesh/io/stl_text.h"

#include "core/base/text.h"

#include <algorithm>

namespace pbffd::io {
namespace {

/// Programs write the keywords in either case.
bool isKeyword(std::string_view word, std::string_view keyword) {
  return std::ranges::equal(word, keyword, [](char a, char b) {
    return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
  });
}

}  // namespace

void StlText::expect(std::string_view keyword) {
  const std::string_view word = text_.wordAnywhere();
  if (word.empty()) {
    text_.fail(format("the file ends where \"{}\" belongs", keyword), adviceCutOff);
  }
  if (!isKeyword(word, keyword)) {
    text_.fail(format("{} stands where \"{}\" belongs", inQuotes(word), keyword));
  }
}

bool StlText::next() {
  for (std::string_view word = text_.wordAnywhere(); !word.empty(); word = text_.wordAnywhere()) {
    if (!isInSolid_ && isKeyword(word, "solid")) {
      isInSolid_ = true;
      text_.skipLine();
    } else if (isInSolid_ && isKeyword(word, "endsolid")) {
      isInSolid_ = false;
      text_.skipLine();
    } else if (isInSolid_ && isKeyword(word, "facet")) {
      readFacet();
      return true;
    } else if (!isInSolid_ && text_.line() == 1) {
      text_.fail(format("the file begins with {} and not with \"solid\"", inQuotes(word)),
                 "Choose an STL file, or give the file the ending of its format.");
    } else {
      text_.fail(format("{} stands where {} belongs", inQuotes(word),
                        isInSolid_ ? "\"facet\" or \"endsolid\"" : "\"solid\""));
    }
  }
  if (isInSolid_) {
    text_.fail("the file ends where \"facet\" or \"endsolid\" belongs", adviceCutOff);
  }
  return false;
}

void StlText::readFacet() {
  facet_.corners.clear();
  expect("normal");
  for (std::string_view& word : facet_.normal) {
    word = text_.wordAnywhere();
  }
  expect("outer");
  expect("loop");
  std::string_view word = text_.wordAnywhere();
  for (; isKeyword(word, "vertex"); word = text_.wordAnywhere()) {
    auto& corner = facet_.corners.emplace_back();
    for (std::string_view& coordinate : corner) {
      coordinate = text_.wordAnywhere();
    }
  }
  if (word.empty()) {
    text_.fail("the file ends within a facet", adviceCutOff);
  }
  if (!isKeyword(word, "endloop")) {
    text_.fail(format("{} stands where \"vertex\" or \"endloop\" belongs", inQuotes(word)));
  }
  if (facet_.corners.size() < 3) {
    text_.fail(format("a facet has {} and needs 3", counted(facet_.corners.size(), "vertex", "vertices")));
  }
  expect("endfacet");
}

}  // namespace pbffd::io

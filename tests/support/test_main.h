#pragma once

#include <QObject>

#include <functional>
#include <memory>

namespace pbffd::test {

/// Makes a test class known to the program's main(): one in each test file, at namespace scope,
///     const pbffd::test::Registration<FooTest> registration;
class Registry {
 public:
  using Factory = std::function<std::unique_ptr<QObject>()>;
  static void add(const char* className, Factory factory);
};

template <class Test>
class Registration {
 public:
  Registration() {
    Registry::add(Test::staticMetaObject.className(), [] { return std::make_unique<Test>(); });
  }
};

}  // namespace pbffd::test

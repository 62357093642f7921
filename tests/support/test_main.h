#pragma once

#include <QCoreApplication>
#include <QTest>

#include <type_traits>

/// Adds a test class to the program of its folder. Each is run in a process of its own. The second argument is what
/// lives while it runs: QCoreApplication, QGuiApplication, QApplication, ui::TestApplication, vr::GlTestApplication,
/// vr::GlxTestApplication or app::OnScreen. Without it there is no application. CMake reads these lines: fettle_tests()
/// makes a test of each, with a display unless it needs none.
#define FETTLE_TEST(TestClass, ...)                                                                                    \
    static const test::Registration registrationOf##TestClass(#TestClass,                                              \
                                                              &test::run<TestClass __VA_OPT__(, ) __VA_ARGS__>);

/// The same for a test that prepares something before its application exists: `function` takes the place of main().
#define FETTLE_TEST_MAIN(TestClass, function)                                                                          \
    static const test::Registration registrationOf##TestClass(#TestClass, &function);

namespace test
{
using Main = int (*)(int argc, char* argv[]);

constexpr int skipped = 77; ///< exit status by which ctest knows that a test was skipped

struct Registration
{
    Registration(const char* className, Main main);
};

/// Returns the class that this process runs: the first argument for a process that a test starts of its own program.
QString runningClass();

struct NoApplication
{
    NoApplication(int /*argc*/, char** /*argv*/) {}
};

/// Returns the exit status. An Application may have a function missing(), which returns why it cannot be had here, or
/// null.
template <class Test, class Application = NoApplication> int run(int argc, char* argv[])
{
    if constexpr (requires { Application::missing(); }) {
        if (const char* missing = Application::missing()) {
            qInfo("SKIP   : %s", missing);
            return skipped;
        }
    }
    [[maybe_unused]] const Application application(argc, argv);
    if constexpr (std::is_base_of_v<QCoreApplication, Application>)
        QCoreApplication::setAttribute(Qt::AA_Use96Dpi); // as QTEST_MAIN does
    Test test;
    return QTest::qExec(&test, argc, argv);
}
} // namespace test

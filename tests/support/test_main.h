#pragma once

#include "tests/support/waiting.h"

#include <QCoreApplication>

#include <type_traits>

/// Adds a test class to the test program of its folder. Each class runs in a process of its own.
/// The second argument is the type of the application object: QCoreApplication, QGuiApplication, QApplication,
/// ui::TestApplication, vr::GlTestApplication, vr::GlxTestApplication or app::OnScreen. Without it the test has none.
/// CMake parses these lines: fettle_tests() adds a ctest entry for each, with a display if the application needs one.
#define FETTLE_TEST(TestClass, ...)                                                                                    \
    static const test::Registration registrationOf##TestClass(#TestClass,                                              \
                                                              &test::run<TestClass __VA_OPT__(, ) __VA_ARGS__>);

/// Variant of FETTLE_TEST for a test that prepares something before its application exists: `function` is run instead
/// of test::run().
#define FETTLE_TEST_MAIN(TestClass, function)                                                                          \
    static const test::Registration registrationOf##TestClass(#TestClass, &function);

namespace test
{
using Main = int (*)(int argc, char* argv[]);

constexpr int skipped = 77; ///< exit status that ctest reports as skipped

struct Registration
{
    Registration(const char* className, Main main);
};

/// Returns the name of the running test class. In a process that a test starts from its own program, this is the first
/// argument.
QString runningClass();
/// Returns the absolute path of the test program, as it was at the start. QCoreApplication::applicationFilePath() is
/// wrong in a chroot after places::SmallDisk has left the mount namespace: it then is the path outside the chroot.
/// Precondition: the program was started by its path and not found by PATH; ctest does so.
QString programPath();

struct NoApplication
{
    NoApplication(int /*argc*/, char** /*argv*/) {}
};

/// Runs the class and returns the exit status. An Application may define missing(), which returns the reason why it is
/// unavailable here, or null.
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
        QCoreApplication::setAttribute(Qt::AA_Use96Dpi); // QTEST_MAIN sets this attribute, too
    Test test;
    return QTest::qExec(&test, argc, argv);
}
} // namespace test

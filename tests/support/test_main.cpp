// main() of every test program:  test_core_mesh [CLASS] [QTEST ARGUMENTS]
// Runs every class if CLASS is missing, each in a process of its own. `--list` prints the names of the classes.
#include "tests/support/test_main.h"

#include <QFileInfo>
#include <QProcess>

#include <algorithm>
#include <cstring>
#include <iostream>
#include <vector>

namespace
{
struct TestClass
{
    const char* name;
    test::Main main;
};

std::vector<TestClass>& testClasses()
{
    static std::vector<TestClass> classes;
    return classes;
}

const char* s_running = "";
QString s_path;

/// Runs every class in a child process. Returns the exit status of the first class that fails, or 0; skipped classes do
/// not fail.
int runAll(char* argv[])
{
    int status = 0;
    for (const TestClass& testClass : testClasses()) {
        QStringList arguments{testClass.name};
        for (char** word = argv + 1; *word; ++word)
            arguments << QString::fromLocal8Bit(*word);
        const int result = QProcess::execute(QString::fromLocal8Bit(argv[0]), arguments);
        if (status == 0 && result != test::skipped)
            status = result;
    }
    return status;
}
} // namespace

test::Registration::Registration(const char* className, Main main)
{
    testClasses().push_back({className, main});
}

QString test::runningClass()
{
    return QString::fromLatin1(s_running);
}

QString test::programPath()
{
    return s_path;
}

int main(int argc, char* argv[])
{
    s_path = QFileInfo(QString::fromLocal8Bit(argv[0])).absoluteFilePath();
    std::ranges::sort(testClasses(),
                      [](const TestClass& a, const TestClass& b) { return std::strcmp(a.name, b.name) < 0; });
    if (argc == 2 && std::strcmp(argv[1], "--list") == 0) {
        for (const TestClass& testClass : testClasses())
            std::cout << testClass.name << '\n';
        return 0;
    }
    if (argc < 2 || argv[1][0] == '-')
        return runAll(argv);
    for (const TestClass& testClass : testClasses()) {
        if (std::strcmp(testClass.name, argv[1]) != 0)
            continue;
        s_running = testClass.name;
        argv[1] = argv[0];
        return testClass.main(argc - 1, argv + 1);
    }
    std::cerr << argv[0] << ": has no test class " << argv[1] << "; if it was renamed, configure the build again\n";
    return 2;
}

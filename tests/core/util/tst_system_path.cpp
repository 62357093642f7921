#include "core/util/system_code.h"
#include "core/util/system_path.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace core;
namespace fs = std::filesystem;

class TestSystemPath : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void codes_haveTheirMeaning();
    void streams_leaveACode();
    void status_isThatOfTheFile();
    void paths_leadToTheSameFile();
};

void TestSystemPath::codes_haveTheirMeaning()
{
    const QTemporaryDir home;
    const fs::path folder = home.path().toStdString();
    std::error_code problem;
    fs::rename(folder / "none", folder / "other", problem);
    QVERIFY(isSystemCode(systemCodeOf(problem), std::errc::no_such_file_or_directory));
    QVERIFY(!isSystemCode(systemCodeOf(problem), std::errc::file_exists));
    QVERIFY(isSystemCode(systemCodeOf(std::make_error_code(std::errc::file_exists)), std::errc::file_exists));
    QCOMPARE(systemCodeOf({}), 0);
}

void TestSystemPath::streams_leaveACode()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / "file";
    std::ofstream(file) << "x";
    clearStreamCode();
    std::ifstream good(file);
    QVERIFY(good.is_open());
    QCOMPARE(streamCode(), 0);
    std::ifstream missing(file / ".." / "none");
    QVERIFY(!missing.is_open());
    QVERIFY(streamCode() != 0);
    clearStreamCode();
    QCOMPARE(streamCode(), 0);
}

void TestSystemPath::status_isThatOfTheFile()
{
    const QTemporaryDir home;
    const fs::path folder = home.path().toStdString(), file = folder / "file";
    QCOMPARE(fileStatus(file).type, fs::file_type::not_found);
    QCOMPARE(fileStatus(folder).type, fs::file_type::directory);
    std::ofstream(file) << "four";
    const FileStatus status = fileStatus(file);
    QCOMPARE(status.type, fs::file_type::regular);
    QCOMPARE(status.size, std::uint64_t(4));
    QCOMPARE(status.systemCode, 0);
}

void TestSystemPath::paths_leadToTheSameFile()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / fs::path(u8"\u82b1\u74f6.stl");
    std::ofstream(systemPath(file)) << "vase";
    QVERIFY(fs::exists(file));
    QCOMPARE(fileStatus(file).size, std::uint64_t(4));
}

FETTLE_TEST(TestSystemPath)
#include "tst_system_path.moc"

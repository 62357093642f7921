#include "core/io/mesh_io.h"
#include "core/io/numbered_backup.h"
#include "core/util/atomic_file.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

using namespace core;
namespace fs = std::filesystem;

namespace
{
std::string read(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void save(const fs::path& file, std::string_view text, int versions = 3)
{
    NumberedBackup before(file, versions);
    AtomicFile out(file);
    out.write(text);
    out.commit();
    before.commit();
}
} // namespace

class TestNumberedBackup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lastThree_stayBesideTheFile();
    void without_nothingStays();
    void savingThatFails_changesNothing();
    void links_areFollowed();
    void keptModels_areReadByTheirFormat();

private:
    std::vector<std::string> names(const QTemporaryDir& home) const
    {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(home.path().toStdString()))
            found.push_back(entry.path().filename().string());
        std::ranges::sort(found);
        return found;
    }
};

void TestNumberedBackup::lastThree_stayBesideTheFile()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / "vase.glb";
    for (int i = 1; i <= 6; ++i) {
        save(file, "version " + std::to_string(i));
        QCOMPARE(read(file), "version " + std::to_string(i));
        for (int back = 1; back <= 3; ++back)
            QCOMPARE(read(NumberedBackup::nameOf(file, back)),
                     back < i ? "version " + std::to_string(i - back) : std::string());
    }
    QVERIFY(names(home) == std::vector<std::string>({"vase.glb", "vase.glb~1", "vase.glb~2", "vase.glb~3"}));
}

void TestNumberedBackup::without_nothingStays()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / "vase.glb";
    save(file, "one", 0);
    save(file, "two", 0);
    QVERIFY(names(home) == std::vector<std::string>({"vase.glb"}));
}

/// Backups are rotated only after the new file is complete.
void TestNumberedBackup::savingThatFails_changesNothing()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / "vase.glb";
    for (const char* text : {"one", "two", "three"})
        save(file, text);
    {
        NumberedBackup before(file, 3);
        AtomicFile out(file);
        out.write("half");
    }
    QCOMPARE(read(file), std::string("three"));
    QCOMPARE(read(NumberedBackup::nameOf(file, 1)), std::string("two"));
    QVERIFY(names(home) == std::vector<std::string>({"vase.glb", "vase.glb~1", "vase.glb~2"}));
}

void TestNumberedBackup::links_areFollowed()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / "vase.glb",
                   link = fs::path(home.path().toStdString()) / "link.glb";
    save(file, "one");
    fs::create_symlink(file, link);
    save(link, "two");
    QVERIFY(fs::is_symlink(link));
    QCOMPARE(read(file), std::string("two"));
    QCOMPARE(read(NumberedBackup::nameOf(file, 1)), std::string("one"));
}

void TestNumberedBackup::keptModels_areReadByTheirFormat()
{
    const QTemporaryDir home;
    const fs::path file = fs::path(home.path().toStdString()) / "ball.ply";
    writeMesh(file, icosphere(1, 10));
    NumberedBackup before(file, 3);
    writeMesh(file, icosphere(2, 10));
    before.commit();
    QCOMPARE(readMesh(NumberedBackup::nameOf(file, 1)).points.size(), icosphere(1, 10).points.size());
    QVERIFY(!meshFormatOf("ball.ply~") && !meshFormatOf("ball~1") && meshFormatOf("ball.ply~12") == MeshFormat::Ply);
}

FETTLE_TEST(TestNumberedBackup)
#include "tst_numbered_backup.moc"

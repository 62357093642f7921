// Tests files of more than a few thousand elements, which several cores read and write in parts. Results must equal
// those of one core.

#include "core/io/mesh_io.h"
#include "core/util/file_error.h"
#include "core/util/parallel.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstring>
#include <fstream>
#include <map>
#include <random>

namespace
{
using core::FileError;
using core::Rgb;
using core::Slot;
using core::Triangle;
using core::TriangleMesh;
using core::Vec3f;

constexpr unsigned largeModelSeed = 20261122;

/// Returns a mesh of 180,000 triangles in random order.
TriangleMesh largeModel()
{
    TriangleMesh mesh = shapes::noisy(shapes::torus({30, 10, 300, 300}), 0.01F, largeModelSeed);
    std::mt19937 random(largeModelSeed);
    std::ranges::shuffle(mesh.triangles, random);
    std::ranges::generate(mesh.colors = std::vector<Rgb>(mesh.points.size()), [&random] {
        return Rgb{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()),
                   static_cast<std::uint8_t>(random())};
    });
    return mesh;
}

/// Returns the large model with separate corners for each triangle. About half of the points have z = 0 or -0.
TriangleMesh looseModel()
{
    const TriangleMesh mesh = largeModel();
    TriangleMesh loose;
    for (const Triangle& t : mesh.triangles)
        for (const Slot corner : t) {
            loose.points.push_back(mesh.points[corner]);
            if (corner % 2 == 0)
                loose.points.back().z() = loose.points.size() % 2 == 0 ? 0.0F : -0.0F;
            loose.colors.push_back(mesh.colors[corner]);
        }
    for (Slot i = 0; i < loose.points.size(); i += 3)
        loose.triangles.push_back({i, i + 1, i + 2});
    return loose;
}

/// Welds equal points sequentially: each is replaced by the first equal point.
TriangleMesh weldedOneByOne(const TriangleMesh& mesh)
{
    TriangleMesh welded;
    std::map<std::array<float, 3>, Slot> known;
    std::vector<Slot> numbers;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const Vec3f& p = mesh.points[i];
        const auto [place, isNew] = known.try_emplace({p.x(), p.y(), p.z()}, static_cast<Slot>(welded.points.size()));
        numbers.push_back(place->second);
        if (!isNew)
            continue;
        welded.points.push_back(p);
        if (!mesh.colors.empty())
            welded.colors.push_back(mesh.colors[i]);
    }
    for (const Triangle& t : mesh.triangles)
        welded.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
    return welded;
}

template <typename Value> void put(std::ofstream& file, Value value)
{
    file.write(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Writes a binary PLY in which each face has a flag before its corners.
void writePolygons(const std::filesystem::path& path, const TriangleMesh& mesh,
                   const std::vector<std::vector<std::int32_t>>& faces)
{
    std::ofstream file(path, std::ios::binary);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.points.size()
         << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << faces.size()
         << "\nproperty uchar flags\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3f& p : mesh.points)
        for (int k = 0; k < 3; ++k)
            put(file, p[k]);
    for (const auto& face : faces) {
        put(file, std::uint8_t(7));
        put(file, static_cast<std::uint8_t>(face.size()));
        for (const std::int32_t corner : face)
            put(file, corner);
    }
}

std::vector<std::vector<std::int32_t>> facesOf(const TriangleMesh& mesh)
{
    std::vector<std::vector<std::int32_t>> faces;
    for (const Triangle& t : mesh.triangles)
        faces.push_back(
            {static_cast<std::int32_t>(t[0]), static_cast<std::int32_t>(t[1]), static_cast<std::int32_t>(t[2])});
    return faces;
}

bool samePoints(const std::vector<Vec3f>& a, const std::vector<Vec3f>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3f)) == 0;
}
} // namespace

class TestLargeFiles : public QObject
{
    Q_OBJECT

private:
    std::filesystem::path path(const std::string& name) const { return m_folder.path().toStdString() + '/' + name; }

    QTemporaryDir m_folder;

private Q_SLOTS:
    void cleanup() { core::WorkerPool::shared().setThreads(0); }

    void comesBack_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("threads");
        for (const char* const ending : {"ply", "glb", "obj", "off"})
            for (const int threads : {1, 2, 5})
                QTest::addRow("%s, %d threads", ending, threads)
                    << QStringLiteral("model.") + QLatin1String(ending) << threads;
    }
    void comesBack()
    {
        QFETCH(QString, name);
        QFETCH(int, threads);
        core::WorkerPool::shared().setThreads(static_cast<std::size_t>(threads));
        const TriangleMesh mesh = largeModel();
        core::writeMesh(path(name.toStdString()), mesh);
        const TriangleMesh read = core::readMesh(path(name.toStdString()));
        QVERIFY(samePoints(read.points, mesh.points));
        QVERIFY(read.colors == mesh.colors);
        QVERIFY(read.triangles == mesh.triangles);
    }

    /// Separate corners must be welded as a sequential weld does it.
    void weldsInOrder_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("holdsColors");
        QTest::addRow("stl") << "loose.stl" << false;
        QTest::addRow("ply") << "loose.ply" << true;
        QTest::addRow("glb") << "loose.glb" << true;
    }
    void weldsInOrder()
    {
        QFETCH(QString, name);
        QFETCH(bool, holdsColors);
        core::WorkerPool::shared().setThreads(3);
        TriangleMesh loose = looseModel();
        core::writeMesh(path(name.toStdString()), loose, {.up = core::UpAxis::Y});
        if (!holdsColors)
            loose.colors.clear();
        const TriangleMesh expected = weldedOneByOne(loose);
        const TriangleMesh read = core::readMesh(path(name.toStdString()), {.up = core::UpAxis::Y});
        QCOMPARE(read.points.size(), expected.points.size());
        QVERIFY(read.points == expected.points); // 0 and -0 compare equal
        QVERIFY(read.colors == expected.colors);
        QVERIFY(read.triangles == expected.triangles);
    }

    /// Only polygons of equal size are read in parts. Both ways must give the same triangles.
    void polygonsOfOneSizeOrOfMany()
    {
        core::WorkerPool::shared().setThreads(3);
        const TriangleMesh mesh = largeModel();
        auto faces = facesOf(mesh);
        writePolygons(path("triangles.ply"), mesh, faces);
        const TriangleMesh triangles = core::readMesh(path("triangles.ply"));
        QVERIFY(triangles.triangles == mesh.triangles);
        faces.push_back({0, 1, 301, 300});
        writePolygons(path("mixed.ply"), mesh, faces);
        TriangleMesh mixed = core::readMesh(path("mixed.ply"));
        QCOMPARE(mixed.triangles.size(), mesh.triangles.size() + 2);
        mixed.triangles.resize(mesh.triangles.size());
        QVERIFY(mixed.triangles == mesh.triangles);
    }

    void quadsComeAsTheirTriangles()
    {
        core::WorkerPool::shared().setThreads(3);
        const TriangleMesh mesh = shapes::torus({30, 10, 400, 400});
        std::vector<std::vector<std::int32_t>> quads;
        for (std::int32_t i = 0; i + 1 < 400; ++i)
            for (std::int32_t k = 0; k + 1 < 400; ++k)
                quads.push_back({400 * i + k, 400 * i + k + 1, 400 * (i + 1) + k + 1, 400 * (i + 1) + k});
        writePolygons(path("quads.ply"), mesh, quads);
        const TriangleMesh read = core::readMesh(path("quads.ply"));
        quads.push_back({0, 1, 2}); // the triangle forces reading face by face
        writePolygons(path("quads_and_more.ply"), mesh, quads);
        TriangleMesh oneByOne = core::readMesh(path("quads_and_more.ply"));
        oneByOne.triangles.pop_back();
        QCOMPARE(read.triangles.size(), 2 * std::size_t(399 * 399));
        QVERIFY(read.triangles == oneByOne.triangles);
    }

    /// The first error in file order is reported, whichever core finds it.
    void wrongElementIsNamed()
    {
        core::WorkerPool::shared().setThreads(3);
        const TriangleMesh mesh = largeModel();
        auto faces = facesOf(mesh);
        faces[170'000][1] = 1'000'000;
        faces[90'000][2] = -5;
        writePolygons(path("wrong.ply"), mesh, faces);
        try {
            core::readMesh(path("wrong.ply"));
            QFAIL("read");
        } catch (const FileError& error) {
            QCOMPARE(error.kind, core::FileErrorKind::IndexOutOfRange);
            QCOMPARE(error.token, std::string("-5"));
        }
    }

    void firstNumberOfStlThatIsNoneIsNamed()
    {
        core::WorkerPool::shared().setThreads(3);
        core::writeMesh(path("wrong.stl"), largeModel());
        std::fstream file(path("wrong.stl"), std::ios::binary | std::ios::in | std::ios::out);
        constexpr std::uint64_t first = 84 + 50 * 100'000 + 12 + 16, second = 84 + 50 * 170'000 + 12;
        for (const std::uint64_t place : {second, first}) {
            file.seekp(static_cast<std::streamoff>(place));
            const float none = std::numeric_limits<float>::quiet_NaN();
            file.write(reinterpret_cast<const char*>(&none), sizeof none);
        }
        file.close();
        try {
            core::readMesh(path("wrong.stl"));
            QFAIL("read");
        } catch (const FileError& error) {
            QCOMPARE(error.kind, core::FileErrorKind::NotANumber);
            QCOMPARE(error.place.number, first);
        }
    }

    /// A million equal points must not slow the weld down.
    void pointsThatAreAllOne()
    {
        TriangleMesh mesh;
        mesh.points.assign(1'000'000, Vec3f(1, 2, 3));
        mesh.triangles.push_back({0, 1, 2}); // a degenerate face, which is removed
        mesh.triangles.push_back({999'999, 1'000'000, 1'000'001});
        mesh.points.emplace_back(4.0F, 5.0F, 6.0F);
        mesh.points.emplace_back(7.0F, 8.0F, 10.0F);
        core::writeMesh(path("one.ply"), mesh);
        const core::ReadResult read = core::readModel(path("one.ply"));
        QCOMPARE(read.mesh.points.size(), std::size_t(3));
        QVERIFY((read.mesh.triangles == std::vector<Triangle>{{0, 1, 2}}));
        QCOMPARE(read.remarks.facesOfFewer, std::size_t(1));
    }

    /// Takes half a minute if each element's name is compared with all others.
    void plyOfManyElements()
    {
        std::ofstream file(path("elements.ply"), std::ios::binary);
        file << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                "element face 1\nproperty list uchar int vertex_indices\n";
        for (int i = 0; i < 200'000; ++i)
            file << "element e" << i << " 0\nproperty int a\n";
        file << "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
        file.close();
        QCOMPARE(core::readMesh(path("elements.ply")).triangles.size(), std::size_t(1));
    }

    void stopsWhenAsked()
    {
        core::writeMesh(path("stopped.stl"), largeModel());
        std::stop_source source;
        source.request_stop();
        QVERIFY_EXCEPTION_THROWN(core::readMesh(path("stopped.stl"), {.stop = source.get_token()}),
                                 core::ReadingCancelled);
    }
};

FETTLE_TEST(TestLargeFiles)
#include "tst_large_files.moc"

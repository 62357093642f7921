#include "core/drawing/model_thumbnail.h"
#include "core/io/mesh_io.h"

#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

namespace
{
constexpr int side = 64;

core::ModelThumbnail pictureOf(const core::TriangleMesh& mesh)
{
    return core::drawThumbnail(mesh, side, {}).value();
}

std::size_t inked(const core::ModelThumbnail& picture)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(picture.rgba, [](const auto& pixel) { return pixel[3] > 0; }));
}

/// Range of rows and columns that contain drawn pixels.
struct Extent
{
    explicit Extent(const core::ModelThumbnail& picture)
    {
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                if (picture.rgba[static_cast<std::size_t>(y * picture.width + x)][3] > 0) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                    top = std::min(top, y);
                    bottom = std::max(bottom, y);
                }
    }

    int left = side, right = -1, top = side, bottom = -1;
};
} // namespace

class TestModelThumbnail : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itFillsThePictureAndStandsInItsMiddle()
    {
        for (const float size : {1e-6F, 1.0F, 40.0F, 1e9F}) {
            core::TriangleMesh mesh = core::icosphere(3, 1);
            for (core::Vec3f& p : mesh.points)
                p = p * size + core::Vec3f(size, -3 * size, 7 * size);
            const core::ModelThumbnail picture = pictureOf(mesh);
            QCOMPARE(picture.rgba.size(), std::size_t(side * side));
            const Extent extent(picture);
            QVERIFY(extent.right - extent.left >= side - 6 && extent.bottom - extent.top >= side - 6);
            QVERIFY(std::abs(extent.left - (side - 1 - extent.right)) <= 1 &&
                    std::abs(extent.top - (side - 1 - extent.bottom)) <= 1);
            QCOMPARE(picture.rgba.front()[3], std::uint8_t(0));
        }
    }

    void whatIsUpIsBrighterAndUp()
    {
        const core::ModelThumbnail picture = pictureOf(core::icosphere(4, 10));
        const auto row = [&](int y) { return picture.rgba[static_cast<std::size_t>(y * side + side / 2)]; };
        QVERIFY(row(side / 4)[0] > row(side * 3 / 4)[0]);
        core::TriangleMesh lower = core::icosphere(2, 1);
        for (const core::Vec3f& p : core::icosphere(2, 1).points)
            lower.points.push_back(core::Vec3f(0, 10, 0) + 0.1F * p); // unused vertices, far above the model
        QCOMPARE(pictureOf(lower).rgba, pictureOf(core::icosphere(2, 1)).rgba);
    }

    void anyTrianglesWillDo()
    {
        const core::TriangleMesh ball = core::icosphere(3, 10);
        const std::size_t whole = inked(pictureOf(ball));
        core::TriangleMesh insideOut = ball, mixed = ball, open = ball;
        for (std::size_t i = 0; i < ball.triangles.size(); ++i) {
            std::swap(insideOut.triangles[i][1], insideOut.triangles[i][2]);
            if (i % 2 == 0)
                std::swap(mixed.triangles[i][1], mixed.triangles[i][2]);
        }
        open.triangles.resize(open.triangles.size() / 2);
        QCOMPARE(pictureOf(insideOut).rgba, pictureOf(ball).rgba);
        QCOMPARE(inked(pictureOf(mixed)), whole);
        QVERIFY(inked(pictureOf(open)) > whole / 4);
        core::TriangleMesh crossed = shapes::cube(10);
        for (core::Vec3f p : shapes::cube(10).points)
            crossed.points.push_back(p + core::Vec3f(3, 4, 5));
        for (core::Triangle t : shapes::cube(10).triangles)
            crossed.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        QVERIFY(inked(pictureOf(crossed)) > 0);
    }

    void withoutExtentItIsEmpty()
    {
        core::TriangleMesh point;
        point.points.assign(3, core::Vec3f(1, 2, 3));
        point.triangles = {{0, 1, 2}};
        QCOMPARE(inked(pictureOf(point)), std::size_t(0));
        QCOMPARE(inked(pictureOf({})), std::size_t(0));
    }

    void itsColoursAreTheModels()
    {
        core::TriangleMesh ball = core::icosphere(3, 10);
        ball.colors.assign(ball.points.size(), core::Rgb{0, 0, 255});
        for (const auto& pixel : pictureOf(ball).rgba)
            QVERIFY(pixel[0] == 0 && pixel[1] == 0 && pixel[2] <= pixel[3]);
        QVERIFY(pictureOf(ball).rgba != pictureOf(core::icosphere(3, 10)).rgba);
    }

    void whoStopsGetsNothing()
    {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!core::drawThumbnail(core::icosphere(3, 10), side, stop.get_token()));
    }

    /// A ball of radius 10 mm is at the target. Its outline is that of the cone from the eye.
    void aCameraSeesWhatItSees_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("outline"); // radius in mm in the plane through the target
        QTest::newRow("parallel") << 0.0 << 10.0;
        QTest::newRow("far") << 100.0 << 10.0 * 100 / std::sqrt(100.0 * 100 - 100);
        QTest::newRow("near") << 20.0 << 10.0 * 20 / std::sqrt(20.0 * 20 - 100);
    }

    void aCameraSeesWhatItSees()
    {
        QFETCH(double, distance);
        QFETCH(double, outline);
        core::TriangleMesh mesh = core::icosphere(5, 10);
        for (core::Vec3f& p : mesh.points)
            p += core::Vec3f(5, -7, 3);
        core::ThumbnailView view{Eigen::Matrix3d::Identity(), core::Vec3(5, -7, 3), distance, 40, 160, 120};
        const core::ModelThumbnail picture = core::drawThumbnail(mesh, view, {}).value();
        QCOMPARE(picture.width, 160);
        QCOMPARE(picture.height, 120);
        int left = 160, right = -1, top = 120, bottom = -1;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 160; ++x)
                if (picture.rgba[static_cast<std::size_t>(y * 160 + x)][3] > 127) {
                    left = std::min(left, x), right = std::max(right, x);
                    top = std::min(top, y), bottom = std::max(bottom, y);
                }
        const double pixels = 2 * outline * 120 / 40;
        QVERIFY(std::abs(right - left + 1 - pixels) <= 2 && std::abs(bottom - top + 1 - pixels) <= 2);
        QVERIFY(std::abs(left + right + 1 - 160) <= 2 && std::abs(top + bottom + 1 - 120) <= 2);

        view.target = core::Vec3(-5, -17, 3); // moves the ball up and to the right, beyond the borders
        const core::ModelThumbnail cut = core::drawThumbnail(mesh, view, {}).value();
        const auto alpha = [&cut](int x, int y) { return cut.rgba[static_cast<std::size_t>(y * 160 + x)][3]; };
        QCOMPARE(alpha(110, 30), std::uint8_t(255));
        QCOMPARE(alpha(50, 90), std::uint8_t(0));
    }

    void whatIsBehindTheEyeOrBesideThePictureIsNotSeen()
    {
        const core::TriangleMesh mesh = core::icosphere(4, 10);
        core::ThumbnailView view{Eigen::Matrix3d::Identity(), core::Vec3(0, 0, -30), 5, 10, 80, 60};
        const auto inkOf = [&] { return inked(core::drawThumbnail(mesh, view, {}).value()); };
        QCOMPARE(inkOf(), std::size_t(0)); // the ball is behind the eye
        view.target = {0, 0, -4};
        QCOMPARE(inkOf(), std::size_t(80 * 60)); // the eye is inside the ball, which fills the picture
        view.target = {1e6, 0, 0};
        view.distance = 0;
        QCOMPARE(inkOf(), std::size_t(0));
    }

    void readingStopsInEachFormat()
    {
        const QTemporaryDir folder;
        for (const char* name : {"a.stl", "b.obj", "c.ply"})
            for (const bool ascii : {false, true}) {
                const std::filesystem::path path = folder.filePath(QLatin1StringView(name)).toStdString();
                core::writeMesh(path, core::icosphere(6, 10), {.up = {}, .ascii = ascii});
                std::stop_source stop;
                QVERIFY(!core::readMesh(path, {.stop = stop.get_token()}).triangles.empty());
                stop.request_stop();
                QVERIFY_EXCEPTION_THROWN((void)core::readMesh(path, {.stop = stop.get_token()}),
                                         core::ReadingCancelled);
            }
    }
};

FETTLE_TEST(TestModelThumbnail)
#include "tst_model_thumbnail.moc"

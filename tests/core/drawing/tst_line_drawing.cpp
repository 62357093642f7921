// Tests drawings against the model: drawn lines must be on its edges, and a ray to the eye decides whether a line is
// visible.

#include "core/drawing/line_drawing.h"
#include "core/mesh/dirty_slots.h"
#include "tests/support/mesh_asserts.h"
#include "tests/support/shapes.h"
#include "tests/support/test_main.h"

#include <QTest>

#include <cmath>
#include <map>
#include <numbers>

using core::DrawArrays;
using core::DrawnLine;
using core::DrawnSide;
using core::LineDrawing;
using core::Slot;
using core::Vec2f;
using core::Vec3f;

namespace
{
DrawArrays arraysOf(const core::TriangleMesh& mesh)
{
    DrawArrays arrays;
    arrays.apply(core::wholePatchOf(*mesh_asserts::sculptable(mesh)));
    return arrays;
}

LineDrawing drawn(const DrawArrays& model, const core::DrawingDetail& detail = {})
{
    return core::drawLines(model, detail, {}).value();
}

double length(const std::vector<DrawnLine>& lines)
{
    double sum = 0;
    for (const DrawnLine& line : lines)
        for (std::size_t i = 1; i < line.size(); ++i)
            sum += static_cast<double>((line[i] - line[i - 1]).norm());
    return sum;
}

core::TriangleMesh turned(core::TriangleMesh mesh, double radians)
{
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(radians, core::Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vec3f& p : mesh.points)
        p = (turn * p.cast<double>()).cast<float>();
    return mesh;
}

/// A slow reference for the drawing of one side of a model.
class Judge
{
public:
    Judge(const DrawArrays& model, DrawnSide side, float tolerance) : m_tolerance(tolerance)
    {
        for (const core::DrawVertex& v : model.vertices)
            m_points.push_back(core::onPaper(side, v.position));
        std::map<std::pair<Slot, Slot>, std::size_t> faces;
        m_faces = model.faces;
        for (std::size_t f = 0; f < m_faces.size(); ++f)
            for (std::size_t i = 0; i < 3; ++i)
                faces[{m_faces[f][i], m_faces[f][(i + 1) % 3]}] = f;
        for (const auto& [edge, f] : faces)
            if (const auto& [a, b] = edge; a < b)
                addEdge(a, b, normal(f), normal(faces.at({b, a})));
    }

    struct Edge
    {
        Vec3f a, b;
    };
    std::vector<Edge> lines; ///< outlines and creases that only other parts of the model can hide

    /// Returns whether nothing hides `at` or any point within the tolerance of it.
    bool isClearlySeen(const Vec3f& at) const
    {
        return !around(at, [this](const Vec3f& p) { return isHidden(p); });
    }
    /// Returns whether something hides `at` and every point within the tolerance of it.
    bool isClearlyHidden(const Vec3f& at) const
    {
        return !around(at, [this](const Vec3f& p) { return !isHidden(p); });
    }

private:
    Vec3f normal(std::size_t f) const
    {
        const auto& [a, b, c] = m_faces[f];
        return (m_points[b] - m_points[a]).cross(m_points[c] - m_points[a]).normalized();
    }

    void addEdge(Slot a, Slot b, const Vec3f& one, const Vec3f& other)
    {
        const bool isOutline = (one.z() > 0) != (other.z() > 0),
                   isCrease = one.dot(other) < static_cast<float>(core::creaseCosine);
        if (isOutline || (isCrease && one.z() > 0))
            lines.push_back({m_points[a], m_points[b]});
    }

    template <class What> bool around(const Vec3f& at, What what) const
    {
        if (what(at))
            return true;
        for (int i = 0; i < 12; ++i) {
            const double angle = i * std::numbers::pi / 6;
            if (what(at +
                     m_tolerance * Vec3f(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0)))
                return true;
        }
        return false;
    }

    bool isHidden(const Vec3f& at) const
    {
        return std::ranges::any_of(m_faces, [&](const core::Triangle& t) { return isBefore(t, at); });
    }

    bool isBefore(const core::Triangle& t, const Vec3f& at) const
    {
        const Vec3f &a = m_points[t[0]], &b = m_points[t[1]], &c = m_points[t[2]];
        const auto side = [&at](const Vec3f& p, const Vec3f& q) {
            return (q.x() - p.x()) * (at.y() - p.y()) - (q.y() - p.y()) * (at.x() - p.x());
        };
        const float toC = side(a, b), toA = side(b, c), toB = side(c, a), sum = toA + toB + toC;
        if (sum <= 0 || toA < 0 || toB < 0 || toC < 0)
            return false;
        return (toA * a.z() + toB * b.z() + toC * c.z()) / sum > at.z() + 8 * m_tolerance;
    }

    float m_tolerance;
    std::vector<Vec3f> m_points; ///< vertices in the coordinates of the drawing
    std::vector<core::Triangle> m_faces;
};

float distance(const Vec2f& at, const Vec2f& a, const Vec2f& b)
{
    const float length2 = (b - a).squaredNorm();
    const float share = length2 > 0 ? std::clamp((at - a).dot(b - a) / length2, 0.0F, 1.0F) : 0;
    return (a + share * (b - a) - at).norm();
}

bool isDrawn(const core::DrawnView& view, const Vec2f& at, float within)
{
    for (const auto* lines : {&view.outlines, &view.creases})
        for (const DrawnLine& line : *lines)
            for (std::size_t i = 1; i < line.size(); ++i)
                if (distance(at, line[i - 1], line[i]) < within)
                    return true;
    return false;
}
} // namespace

class TestLineDrawing : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aCubesSideIsItsFourEdges()
    {
        const LineDrawing drawing = drawn(arraysOf(shapes::cube(40)));
        for (const core::DrawnView& view : drawing.views) {
            QVERIFY(std::abs(length(view.outlines) - 160) < 1e-3);
            QVERIFY(view.creases.empty()); // hidden creases coincide with the outline
            QCOMPARE(view.outlines.size(), std::size_t(1));
            QCOMPARE(view.outlines[0].front(), view.outlines[0].back());
            for (const Vec2f& p : view.outlines[0])
                QCOMPARE(p.cwiseAbs(), Vec2f(20, 20));
        }
        QCOMPARE(drawing.box.sizes(), core::Vec3(40, 40, 40));
        QVERIFY(std::abs(drawing.volume - 64000) < 1e-6);
    }

    void aTurnedCubeShowsNineOfItsTwelveEdges()
    {
        const LineDrawing drawing = drawn(arraysOf(turned(shapes::cube(40), 0.6)));
        for (const core::DrawnView& view : drawing.views) {
            std::size_t edges = 0;
            for (const auto* lines : {&view.outlines, &view.creases})
                for (const DrawnLine& line : *lines)
                    edges += line.size() - 1;
            QCOMPARE(edges, std::size_t(9));
        }
    }

    void aBallsOutlineIsACircle()
    {
        const LineDrawing drawing = drawn(arraysOf(core::icosphere(5, 50)));
        for (const core::DrawnView& view : drawing.views) {
            QVERIFY(view.creases.empty());
            std::vector<bool> isReached(360, false);
            for (const DrawnLine& line : view.outlines)
                for (const Vec2f& p : line) {
                    QVERIFY(std::abs(p.norm() - 50) < 0.1F);
                    const double degrees = std::atan2(p.y(), p.x()) * 180 / std::numbers::pi;
                    for (int i = -2; i <= 2; ++i)
                        isReached[static_cast<std::size_t>(degrees + 540 + i) % 360] = true;
                }
            QVERIFY(std::ranges::all_of(isReached, [](bool is) { return is; }));
            QVERIFY(length(view.outlines) > 0.99 * std::numbers::pi * 100);
        }
    }

    void aTorusHidesWhatLiesBehind()
    {
        const LineDrawing drawing = drawn(arraysOf(shapes::torus({30, 10, 96, 48})));
        const double around = 2 * std::numbers::pi;
        QVERIFY(std::abs(length(drawing.view(DrawnSide::Top).outlines) - around * (40 + 20)) < 0.02 * around * 60);
        // an outline consists of two half circles and two straight lines
        for (const DrawnLine& line : drawing.view(DrawnSide::Front).outlines)
            for (const Vec2f& p : line) {
                const float fromMiddle = (p - Vec2f(std::clamp(p.x(), -30.0F, 30.0F), 0)).norm();
                QVERIFY(std::abs(fromMiddle - 10) < 0.1F);
            }
    }

    void linesAreWhatARayToTheEyeSays_data()
    {
        QTest::addColumn<int>("shape");
        for (int i = 0; i < 4; ++i)
            QTest::addRow("%d", i) << i;
    }

    void linesAreWhatARayToTheEyeSays()
    {
        QFETCH(int, shape);
        const core::TriangleMesh meshes[] = {
            turned(shapes::torus({30, 10, 48, 24}), 1.1),
            turned(shapes::together(shapes::cube(40), shapes::moved(shapes::cube(20), {0, 15, 35})), 0.4),
            shapes::noisy(core::icosphere(3, 50), 2, 7),
            turned(shapes::together(shapes::torus({30, 6, 24, 8}), core::icosphere(2, 20)), 0.8)};
        const DrawArrays model = arraysOf(meshes[shape]);
        const LineDrawing drawing = drawn(model);
        std::size_t hidden = 0;
        for (const DrawnSide side : core::drawnSides) {
            const core::DrawnView& view = drawing.view(side);
            const Judge judge(model, side, 3 * drawing.pixel);
            std::size_t seen = 0;
            for (const auto& [a, b] : judge.lines) {
                const Vec3f middle = (a + b) / 2;
                if (judge.isClearlySeen(middle)) {
                    ++seen;
                    QVERIFY(isDrawn(view, middle.head<2>(), drawing.pixel));
                }
                hidden += judge.isClearlyHidden(middle) ? 1 : 0;
            }
            QVERIFY(seen > 3);
            for (const auto* lines : {&view.outlines, &view.creases})
                for (const DrawnLine& line : *lines)
                    for (std::size_t i = 1; i < line.size(); ++i)
                        QVERIFY(isSomethingSeen(judge, (line[i] + line[i - 1]) / 2));
        }
        QVERIFY(hidden > 0);
    }

    void colorsAreTheModels()
    {
        core::TriangleMesh ball = core::icosphere(4, 50);
        ball.colors.assign(ball.points.size(), {200, 0, 0});
        const LineDrawing drawing = drawn(arraysOf(ball), {256, true});
        const core::DrawnImage& image = drawing.view(DrawnSide::Top).shaded;
        QCOMPARE(image.pixels.size(), static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
        double covered = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const auto& [r, g, b, alpha] = image.pixels[static_cast<std::size_t>(y * image.width + x)];
                covered += alpha == 255 ? 1 : 0;
                QVERIFY(g == 0 && b == 0);
                const Vec2f at =
                    image.topLeft + image.pixel * Vec2f(static_cast<float>(x) + 0.5F, -static_cast<float>(y) - 0.5F);
                if (std::abs(at.norm() - 50) > 0.5F)
                    QCOMPARE(alpha, std::uint8_t(at.norm() < 50 ? 255 : 0));
                QCOMPARE(r > 0, alpha > 0);
            }
        QVERIFY(covered > 0);
        QVERIFY(drawn(arraysOf(ball)).view(DrawnSide::Top).shaded.pixels.empty());
    }

    void tooManyCreasesAreLeftOutAndThatIsSaid()
    {
        const DrawArrays model = arraysOf(shapes::noisy(core::icosphere(4, 50), 1, 3));
        const LineDrawing whole = drawn(model), coarse = drawn(model, {2048, false, 1000});
        QVERIFY(whole.hasCreases && !whole.view(DrawnSide::Front).creases.empty());
        QVERIFY(!coarse.hasCreases && coarse.view(DrawnSide::Front).creases.empty());
        QCOMPARE(coarse.view(DrawnSide::Front).outlines, whole.view(DrawnSide::Front).outlines);
    }

    void itCanBeStoppedAndThereMayBeNothing()
    {
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!core::drawLines(arraysOf(shapes::cube(1)), {}, stop.get_token()));
        QVERIFY(drawn({}).box.isEmpty());
    }

private:
    static bool isSomethingSeen(const Judge& judge, const Vec2f& at)
    {
        return std::ranges::any_of(judge.lines, [&](const Judge::Edge& edge) {
            const Vec2f a = edge.a.head<2>(), b = edge.b.head<2>();
            if (distance(at, a, b) > 1e-3F)
                return false;
            const float share = std::clamp((at - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-12F), 0.0F, 1.0F);
            return !judge.isClearlyHidden(edge.a + share * (edge.b - edge.a));
        });
    }
};

FETTLE_TEST(TestLineDrawing)
#include "tst_line_drawing.moc"

// Tests the exact predicates against CGAL's exact-predicates kernel.

#include "core/geometry/predicates.h"

#include "tests/support/test_main.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <QElapsedTimer>
#include <QTest>

#include <bit>
#include <random>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using core::FloatPredicates;
using core::LatticePoint;
using core::LatticePredicates;
using core::Vec3f;

constexpr unsigned seed = 20240812;

template <typename Point> Kernel::Point_3 judged(const Point& p)
{
    return {static_cast<double>(p.x()), static_cast<double>(p.y()), static_cast<double>(p.z())};
}

template <typename Point> int judgedOrient3d(const Point& a, const Point& b, const Point& c, const Point& d)
{
    return static_cast<int>(CGAL::orientation(judged(a), judged(b), judged(c), judged(d)));
}

template <typename Point> int judgedOrient2d(const Point& a, const Point& b, const Point& c, int axis)
{
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const auto flat = [i, j](const Point& p) {
        return Kernel::Point_2(static_cast<double>(p[i]), static_cast<double>(p[j]));
    };
    return static_cast<int>(CGAL::orientation(flat(a), flat(b), flat(c)));
}

class LatticeSource
{
public:
    /// Returns a uniformly distributed point, each coordinate in [-range, range].
    LatticePoint point(int range)
    {
        std::uniform_int_distribution<int> coordinate(-range, range);
        return {coordinate(m_engine), coordinate(m_engine), coordinate(m_engine)};
    }
    /// Returns a random affine combination of three points, which rounding moves off their plane.
    LatticePoint near(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
    {
        std::uniform_real_distribution<double> weight(-0.2, 1.2);
        const double s = weight(m_engine), t = weight(m_engine);
        const core::Vec3 p = a.cast<double>() + s * (b - a).cast<double>() + t * (c - a).cast<double>();
        return p.array().round().cwiseMax(-core::Lattice::limit).cwiseMin(core::Lattice::limit).cast<int>();
    }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_engine); }

private:
    std::mt19937 m_engine{seed};
};

class FloatSource
{
public:
    /// Returns a random finite float32, with every exponent equally likely.
    float any()
    {
        for (;;) {
            const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(m_engine()));
            if (std::isfinite(x))
                return x;
        }
    }
    Vec3f anyPoint() { return {any(), any(), any()}; }
    Vec3f point(float size)
    {
        std::uniform_real_distribution<float> coordinate(-size, size);
        return {coordinate(m_engine), coordinate(m_engine), coordinate(m_engine)};
    }
    Vec3f near(const Vec3f& a, const Vec3f& b, const Vec3f& c)
    {
        std::uniform_real_distribution<float> weight(-0.2f, 1.2f);
        return a + weight(m_engine) * (b - a) + weight(m_engine) * (c - a);
    }
    int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_engine); }

private:
    std::mt19937 m_engine{seed};
};

template <typename Predicates> QByteArray describe(const char* what, const std::array<typename Predicates::Point, 4>& p)
{
    QByteArray text = QByteArray(what) + " disagrees, seed " + QByteArray::number(seed) + ":";
    for (const auto& q : p)
        for (int i = 0; i < 3; ++i)
            text += ' ' + QByteArray::number(static_cast<double>(q[i]), 'g', 17);
    return text;
}

/// Returns a description of the first disagreement with CGAL on these four points, or an empty text.
template <typename Predicates> QByteArray disagreement(const std::array<typename Predicates::Point, 4>& p)
{
    if (Predicates::orient3d(p[0], p[1], p[2], p[3]) != judgedOrient3d(p[0], p[1], p[2], p[3]))
        return describe<Predicates>("orient3d", p);
    for (int axis = 0; axis < 3; ++axis)
        if (Predicates::orient2d(p[0], p[1], p[2], axis) != judgedOrient2d(p[0], p[1], p[2], axis))
            return describe<Predicates>("orient2d", p);
    const bool collinear = CGAL::collinear(judged(p[0]), judged(p[1]), judged(p[2]));
    if (Predicates::collinear(p[0], p[1], p[2]) != collinear)
        return describe<Predicates>("collinear", p);
    const typename Predicates::Plane plane(p[0], p[1], p[2]);
    if (!collinear && judgedOrient2d(p[0], p[1], p[2], plane.projectionAxis()) == 0)
        return describe<Predicates>("projectionAxis", p);
    return {};
}
} // namespace

class TestPredicates : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lattice_agreesWithJudge_data();
    void lattice_agreesWithJudge();
    void lattice_isExactAtTheCornersOfItsVolume();
    void float_agreesWithJudge_data();
    void float_agreesWithJudge();
    void float_isExactAtTheEndsOfItsRange();
    void speed();
};

void TestPredicates::lattice_agreesWithJudge_data()
{
    QTest::addColumn<int>("range");
    QTest::addColumn<bool>("nearPlane");
    QTest::newRow("tiny integers") << 3 << false;
    QTest::newRow("whole volume") << core::Lattice::limit << false;
    QTest::newRow("whole volume, near a plane") << core::Lattice::limit << true;
    QTest::newRow("small, near a plane") << 1000 << true;
}

void TestPredicates::lattice_agreesWithJudge()
{
    QFETCH(int, range);
    QFETCH(bool, nearPlane);
    LatticeSource source;
    for (int i = 0; i < 300'000; ++i) {
        std::array p{source.point(range), source.point(range), source.point(range), source.point(range)};
        if (nearPlane)
            p[3] = source.near(p[0], p[1], p[2]);
        if (i % 8 == 0)
            p[2] = source.near(p[0], p[1], p[0]); // nearly collinear points
        const QByteArray wrong = disagreement<LatticePredicates>(p);
        QVERIFY2(wrong.isEmpty(), wrong.constData());
    }
}

void TestPredicates::lattice_isExactAtTheCornersOfItsVolume()
{
    LatticeSource source;
    const auto extreme = [&source] {
        constexpr std::array values{-core::Lattice::limit, -core::Lattice::limit + 1, core::Lattice::limit - 1,
                                    core::Lattice::limit};
        return LatticePoint(values[static_cast<std::size_t>(source.below(4))],
                            values[static_cast<std::size_t>(source.below(4))],
                            values[static_cast<std::size_t>(source.below(4))]);
    };
    for (int i = 0; i < 300'000; ++i) {
        const QByteArray wrong = disagreement<LatticePredicates>({extreme(), extreme(), extreme(), extreme()});
        QVERIFY2(wrong.isEmpty(), wrong.constData());
    }
}

void TestPredicates::float_agreesWithJudge_data()
{
    QTest::addColumn<QString>("kind");
    for (const char* kind :
         {"any exponent", "near a plane", "small integers", "tenths", "planes of any exponent", "mixed scales"})
        QTest::newRow(kind) << QString::fromLatin1(kind);
}

void TestPredicates::float_agreesWithJudge()
{
    QFETCH(QString, kind);
    FloatSource source;
    const auto tenths = [&source](float unit) {
        return Vec3f(static_cast<float>(source.below(7) - 3) * unit, static_cast<float>(source.below(7) - 3) * unit,
                     static_cast<float>(source.below(7) - 3) * unit);
    };
    for (int i = 0; i < 200'000; ++i) {
        std::array<Vec3f, 4> p;
        if (kind == "near a plane") {
            p = {source.point(100), source.point(100), source.point(100), Vec3f::Zero()};
            p[3] = source.near(p[0], p[1], p[2]);
        } else if (kind == "small integers") {
            p = {tenths(1), tenths(1), tenths(1), tenths(1)};
        } else if (kind == "tenths") {
            p = {tenths(0.1f), tenths(0.1f), tenths(0.1f), tenths(0.1f)};
        } else if (kind == "planes of any exponent") { // exactly in the plane x = y
            for (Vec3f& q : p) {
                q = source.anyPoint();
                q.y() = q.x();
            }
        } else if (kind == "mixed scales") {
            p = {tenths(1e-30f), tenths(1e20f), tenths(1), tenths(1e-42f)};
        } else {
            p = {source.anyPoint(), source.anyPoint(), source.anyPoint(), source.anyPoint()};
        }
        const QByteArray wrong = disagreement<FloatPredicates>(p);
        QVERIFY2(wrong.isEmpty(), wrong.constData());
    }
}

void TestPredicates::float_isExactAtTheEndsOfItsRange()
{
    FloatSource source;
    constexpr float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
    constexpr std::array values{-most, -1.0f, -least, 0.0f, least, 2 * least, 1.0f, most};
    const auto extreme = [&] {
        return Vec3f(values[static_cast<std::size_t>(source.below(8))],
                     values[static_cast<std::size_t>(source.below(8))],
                     values[static_cast<std::size_t>(source.below(8))]);
    };
    for (int i = 0; i < 200'000; ++i) {
        const QByteArray wrong = disagreement<FloatPredicates>({extreme(), extreme(), extreme(), extreme()});
        QVERIFY2(wrong.isEmpty(), wrong.constData());
    }
}

/// Prints the duration of each predicate. Fails only at grossly excessive times.
void TestPredicates::speed()
{
    constexpr std::size_t count = 1 << 12, rounds = 500;
    LatticeSource lattice;
    FloatSource floats;
    std::vector<LatticePoint> latticePoints;
    std::vector<Vec3f> floatPoints, flatPoints;
    for (std::size_t i = 0; i < count + 3; ++i) {
        latticePoints.push_back(lattice.point(core::Lattice::limit));
        floatPoints.push_back(floats.point(100));
        flatPoints.push_back(floats.point(100));
        flatPoints.back().y() = flatPoints.back().x();
    }
    const auto measure = [](const char* name, const auto& points, auto orient) {
        QElapsedTimer timer;
        timer.start();
        int sum = 0;
        for (std::size_t round = 0; round < rounds; ++round)
            for (std::size_t i = 0; i < count; ++i)
                sum += orient(points[i], points[i + 1], points[i + 2], points[i + 3]);
        const double each = static_cast<double>(timer.nsecsElapsed()) / double(count * rounds);
        qInfo("%s: %.1f ns (sum %d)", name, each, sum);
        return each;
    };
    QVERIFY(measure("orient3d, lattice", latticePoints, LatticePredicates::orient3d) < 1000);
    QVERIFY(measure("orient3d, float", floatPoints, FloatPredicates::orient3d) < 1000);
    QVERIFY(measure("orient3d, float, coplanar", flatPoints, FloatPredicates::orient3d) < 20000);
}

FETTLE_TEST(TestPredicates)
#include "tst_predicates.moc"

// Tests intersection of triangle pairs against CGAL: do_intersect() for pairs without common corners, the kind of the
// exact intersection for pairs with common corners.

#include "core/geometry/triangle_intersection.h"

#include "tests/support/test_main.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <QElapsedTimer>
#include <QTest>

#include <boost/variant/get.hpp>

#include <algorithm>
#include <random>
#include <string>
#include <variant>

namespace
{
using core::CornerTriangle;
using core::FloatPredicates;
using core::LatticePredicates;
using Inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_predicates_exact_constructions_kernel;

constexpr unsigned pairSeed = 20240812;

template <typename Kernel, typename Predicates>
typename Kernel::Triangle_3 judgedTriangle(const CornerTriangle<Predicates>& t)
{
    const auto point = [](const auto& p) {
        return typename Kernel::Point_3(static_cast<double>(p.x()), static_cast<double>(p.y()),
                                        static_cast<double>(p.z()));
    };
    return {point(t.points[0]), point(t.points[1]), point(t.points[2])};
}

/// Returns whether an intersection is of this kind. CGAL 5 returns Boost's variant, CGAL 6 that of the standard.
template <typename Kind, typename First, typename... Others>
bool isOfKind(const boost::variant<First, Others...>& intersection)
{
    return boost::get<Kind>(&intersection);
}
template <typename Kind, typename... Kinds> bool isOfKind(const std::variant<Kinds...>& intersection)
{
    return std::holds_alternative<Kind>(intersection);
}

template <typename Predicates> bool judgedMeet(const CornerTriangle<Predicates>& s, const CornerTriangle<Predicates>& t)
{
    int shared = 0;
    for (const core::Slot id : s.ids)
        shared += static_cast<int>(std::count(t.ids.begin(), t.ids.end(), id));
    if (shared == 0)
        return CGAL::do_intersect(judgedTriangle<Inexact>(s), judgedTriangle<Inexact>(t));
    if (shared == 3)
        return true;
    const auto common = CGAL::intersection(judgedTriangle<Exact>(s), judgedTriangle<Exact>(t));
    return shared == 1 ? !isOfKind<Exact::Point_3>(*common) : !isOfKind<Exact::Segment_3>(*common);
}

template <typename Predicates>
QByteArray describePair(const CornerTriangle<Predicates>& s, const CornerTriangle<Predicates>& t)
{
    QByteArray text = "seed " + QByteArray::number(pairSeed) + ":";
    for (const auto* triangle : {&s, &t})
        for (std::size_t i = 0; i < 3; ++i) {
            text += " [" + QByteArray::number(triangle->ids[i]) + "]";
            for (int k = 0; k < 3; ++k)
                text += ' ' + QByteArray::number(static_cast<double>(triangle->points[i][k]), 'g', 17);
        }
    return text;
}

/// Returns two triangles that share `shared` corners, at random positions in each triangle.
template <typename Predicates, typename MakePoint>
std::pair<CornerTriangle<Predicates>, CornerTriangle<Predicates>> randomPair(std::mt19937& engine, int shared,
                                                                             MakePoint make)
{
    CornerTriangle<Predicates> s, t;
    do {
        s = {{0, 1, 2}, {make(), make(), make()}};
    } while (Predicates::collinear(s.points[0], s.points[1], s.points[2]));
    std::array<std::size_t, 3> order{0, 1, 2};
    std::shuffle(order.begin(), order.end(), engine);
    do {
        t = {{3, 4, 5}, {make(), make(), make()}};
        for (std::size_t i = 0; i < static_cast<std::size_t>(shared); ++i) {
            t.ids[order[i]] = s.ids[i];
            t.points[order[i]] = s.points[i];
        }
    } while (Predicates::collinear(t.points[0], t.points[1], t.points[2]));
    std::array<std::size_t, 3> turn{0, 1, 2};
    std::shuffle(turn.begin(), turn.end(), engine);
    const CornerTriangle<Predicates> turned{{s.ids[turn[0]], s.ids[turn[1]], s.ids[turn[2]]},
                                            {s.points[turn[0]], s.points[turn[1]], s.points[turn[2]]}};
    return {turned, t};
}

/// Random points of a kind. The kind determines how often triangles of such points meet or nearly meet.
template <typename Predicates> class PointSource
{
public:
    PointSource(QString kind, std::mt19937& engine) : m_kind(std::move(kind)), m_engine(engine) {}

    typename Predicates::Point operator()()
    {
        using Number = typename Predicates::Point::Scalar;
        using Point = typename Predicates::Point;
        const auto integer = [this](int n) {
            return static_cast<Number>(std::uniform_int_distribution<int>(-n, n)(m_engine));
        };
        if (m_kind == "tiny integers")
            return Point(integer(2), integer(2), integer(2));
        if (m_kind == "flat")
            return Point(integer(3), integer(3), Number(0));
        if (m_kind == "slanted flat") { // in the plane x + y + z = 0
            const Number x = integer(3), y = integer(3);
            return Point(x, y, -x - y);
        }
        if (m_kind == "thin") // nearly in a plane
            return Point(integer(1000), integer(1000), integer(1));
        return Point(integer(core::Lattice::limit), integer(core::Lattice::limit), integer(core::Lattice::limit));
    }

private:
    QString m_kind;
    std::mt19937& m_engine;
};

template <typename Predicates> QByteArray firstDisagreement(const QString& kind, int shared, int count)
{
    std::mt19937 engine(pairSeed + static_cast<unsigned>(shared));
    PointSource<Predicates> source(kind, engine);
    int met = 0;
    for (int i = 0; i < count; ++i) {
        const auto [s, t] = randomPair<Predicates>(engine, shared, source);
        const bool expected = judgedMeet(s, t);
        met += expected;
        if (core::trianglesIntersect(s, t) != expected || core::trianglesIntersect(t, s) != expected)
            return describePair(s, t);
    }
    qInfo("%d of %d pairs meet", met, count);
    return {};
}
} // namespace

class TestTriangleIntersection : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithJudge_data();
    void agreesWithJudge();
    void sameCorners_meet();
    void foldedOver_meetsOnlyWhenFlatOnItself();
    void doesNotDependOnWinding();
    void speed();
};

void TestTriangleIntersection::agreesWithJudge_data()
{
    QTest::addColumn<QString>("kind");
    QTest::addColumn<int>("shared");
    for (const char* kind : {"tiny integers", "flat", "slanted flat", "thin", "whole volume"})
        for (int shared = 0; shared < 3; ++shared)
            QTest::newRow((std::string(kind) + ", " + std::to_string(shared) + " shared").c_str())
                << QString::fromLatin1(kind) << shared;
}

void TestTriangleIntersection::agreesWithJudge()
{
    QFETCH(QString, kind);
    QFETCH(int, shared);
    const int count = shared == 0 ? 200'000 : 15'000; // fewer pairs, because CGAL's exact constructions are slow
    QByteArray wrong = firstDisagreement<LatticePredicates>(kind, shared, count);
    QVERIFY2(wrong.isEmpty(), wrong.constData());
    wrong = firstDisagreement<FloatPredicates>(kind, shared, count);
    QVERIFY2(wrong.isEmpty(), wrong.constData());
}

void TestTriangleIntersection::sameCorners_meet()
{
    const CornerTriangle<LatticePredicates> s{{0, 1, 2}, {core::LatticePoint(0, 0, 0), {1, 0, 0}, {0, 1, 0}}};
    const CornerTriangle<LatticePredicates> t{{2, 1, 0}, {s.points[2], s.points[1], s.points[0]}};
    QVERIFY(core::trianglesIntersect(s, t));
}

void TestTriangleIntersection::foldedOver_meetsOnlyWhenFlatOnItself()
{
    const core::LatticePoint a(0, 0, 0), b(10, 0, 0), c(5, 10, 0);
    const CornerTriangle<LatticePredicates> s{{0, 1, 2}, {a, b, c}};
    const auto beside = [&](const core::LatticePoint& d) {
        return core::trianglesIntersect(s, CornerTriangle<LatticePredicates>{{1, 0, 3}, {b, a, d}});
    };
    QVERIFY(beside({5, 9, 0}));
    QVERIFY(!beside({5, 9, 1}));
    QVERIFY(!beside({5, -9, 0}));
}

void TestTriangleIntersection::doesNotDependOnWinding()
{
    std::mt19937 engine(pairSeed);
    PointSource<LatticePredicates> source("tiny integers", engine);
    for (int i = 0; i < 300'000; ++i) {
        const auto [s, t] = randomPair<LatticePredicates>(engine, i % 3, source);
        const CornerTriangle<LatticePredicates> reversed{{s.ids[0], s.ids[2], s.ids[1]},
                                                         {s.points[0], s.points[2], s.points[1]}};
        QCOMPARE(core::trianglesIntersect(reversed, t), core::trianglesIntersect(s, t));
    }
}

void TestTriangleIntersection::speed()
{
    const auto measure = []<typename Predicates>(const char* name, int shared, Predicates) {
        constexpr int count = 2000, rounds = 200;
        std::mt19937 engine(pairSeed);
        std::vector<std::pair<CornerTriangle<Predicates>, CornerTriangle<Predicates>>> pairs;
        PointSource<Predicates> source("whole volume", engine);
        for (int i = 0; i < count; ++i)
            pairs.push_back(randomPair<Predicates>(engine, shared, source));
        QElapsedTimer timer;
        timer.start();
        int met = 0;
        for (int round = 0; round < rounds; ++round)
            for (const auto& [s, t] : pairs)
                met += core::trianglesIntersect(s, t);
        qInfo("%s, %d shared: %.1f ns a pair, %.0f %% meet", name, shared,
              static_cast<double>(timer.nsecsElapsed()) / (count * rounds), 100.0 * met / (count * rounds));
    };
    for (int shared = 0; shared < 3; ++shared) {
        measure("lattice", shared, LatticePredicates());
        measure("float", shared, FloatPredicates());
    }
}

FETTLE_TEST(TestTriangleIntersection)
#include "tst_triangle_intersection.moc"

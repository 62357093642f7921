// Tests the box tree of the wall search against a test of each single box in double.

#include "tests/support/test_main.h"

#include "core/print/wall_tree.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

using core::BoxTree;
using core::FaceBox;
using core::Slot;
using core::Vec3;
using core::WallTree;

namespace
{
constexpr double nowhere = std::numeric_limits<double>::infinity();

class RandomBoxes
{
public:
    explicit RandomBoxes(unsigned start) : m_engine(start) {}

    double between(double min, double max) { return std::uniform_real_distribution<double>(min, max)(m_engine); }
    /// Returns a point of a coarse grid, so that some rays run exactly along the sides of boxes.
    Vec3 point(double size) { return size * Vec3(grid(), grid(), grid()); }
    std::vector<FaceBox> boxes(std::size_t count, double size, const Vec3& place)
    {
        std::vector<FaceBox> boxes(count);
        for (FaceBox& box : boxes) {
            const Vec3 p = place + point(size);
            box.extend(p.cast<float>().array());
            box.extend((p + 0.1 * point(size)).cast<float>().array());
        }
        return boxes;
    }

private:
    double grid() { return std::round(16 * between(-1, 1)) / 16; }

    std::mt19937 m_engine;
};

/// Returns the distance at which a ray enters a box, or infinity if it misses the box.
double entryOf(const FaceBox& box, const Vec3& origin, const Vec3& direction)
{
    double enter = 0, leave = nowhere;
    for (int i = 0; i < 3; ++i) {
        const double low = double(box.min[i]) - origin[i], high = double(box.max[i]) - origin[i];
        if (direction[i] == 0) {
            if (low > 0 || high < 0)
                return nowhere;
            continue;
        }
        enter = std::max(enter, std::min(low / direction[i], high / direction[i]));
        leave = std::min(leave, std::max(low / direction[i], high / direction[i]));
    }
    return enter <= leave ? enter : nowhere;
}

double squaredDistance(const FaceBox& box, const Vec3& p)
{
    const Vec3 gap = (box.min.cast<double>().matrix() - p).cwiseMax(p - box.max.cast<double>().matrix());
    return gap.cwiseMax(0.0).squaredNorm();
}

template <typename Reach> std::set<Slot> visited(const WallTree& tree, const Reach& reach, double bound)
{
    std::set<Slot> found;
    tree.forEachNear(reach, bound, [&](Slot position) {
        found.insert(position);
        return bound;
    });
    return found;
}
} // namespace

class TestWallTree : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void boxes_areNeverMissed_data();
    void boxes_areNeverMissed();
    void boxes_oppositeAreVisited();
};

void TestWallTree::boxes_areNeverMissed_data()
{
    QTest::addColumn<int>("count");
    QTest::addColumn<double>("size");
    QTest::addColumn<double>("away"); ///< distance of the boxes from the origin
    for (const int count : {1, 7, 8, 9, 65, 700})
        for (const double size : {0.01, 50.0})
            for (const double away : {0.0, 3000.0})
                QTest::addRow("%d of %g, %g away", count, size, away) << count << size << away;
}

void TestWallTree::boxes_areNeverMissed()
{
    QFETCH(const int, count);
    QFETCH(const double, size);
    QFETCH(const double, away);
    RandomBoxes random(static_cast<unsigned>(count));
    const Vec3 place = away * Vec3(0.6, -0.7, 0.4);
    const BoxTree boxes(random.boxes(static_cast<std::size_t>(count), size, place));
    const WallTree tree(boxes, std::vector<FaceBox>(boxes.size()));
    const double error = 64 * 1.2e-7 * (away + size);
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = place + random.point(size), direction = random.point(1) + Vec3(0, 0, 1e-3);
        const double bound = random.between(0, 2);
        std::set<Slot> hit, near;
        for (Slot position = 0; position < boxes.size(); ++position) {
            if (entryOf(boxes.box(position), p, direction) < bound)
                hit.insert(position);
            if (squaredDistance(boxes.box(position), p) < bound * size)
                near.insert(position);
        }
        const std::set<Slot> seen = visited(tree, WallTree::Ray(tree, p, direction), bound);
        QVERIFY(std::ranges::includes(seen, hit));
        const std::set<Slot> reached = visited(tree, WallTree::Point(tree, p), bound * size);
        QVERIFY(std::ranges::includes(reached, near));
        for (const Slot position : reached) // few boxes beyond the bound are visited
            QVERIFY(std::sqrt(squaredDistance(boxes.box(position), p)) < std::sqrt(bound * size) * 1.0001 + error);
    }
}

/// Checks that boxes are visited if a corner of their box of normals is opposite, and only these.
void TestWallTree::boxes_oppositeAreVisited()
{
    constexpr double maxCosine = -0.5;
    RandomBoxes random(1);
    const BoxTree boxes(random.boxes(700, 50, Vec3::Zero()));
    std::vector<FaceBox> normals(boxes.size());
    for (Slot position = 0; position < boxes.size(); ++position) {
        // neighbouring boxes have similar normals, so that whole nodes are skipped
        const Vec3 normal = Vec3(boxes.box(position).min.cast<double>()) / 50;
        normals[position].extend(normal.cast<float>().array());
        normals[position].extend((normal + 0.2 * random.point(1)).cast<float>().array());
    }
    const WallTree tree(boxes, normals);
    for (int i = 0; i < 100; ++i) {
        const Vec3 direction = (random.point(1) + Vec3(0, 0, 1e-3)).normalized();
        const auto leastCosine = [&](Slot position) {
            const Eigen::Array3d min = normals[position].min.cast<double>() * direction.array();
            return min.min(normals[position].max.cast<double>() * direction.array()).sum();
        };
        const WallTree::Opposite opposite(direction, maxCosine);
        const WallTree::Point point(tree, Vec3::Zero());
        const std::set<Slot> seen = visited(
            tree, [&](const WallTree::Node& node) { return opposite(node, point(node)); }, nowhere);
        for (Slot position = 0; position < boxes.size(); ++position) {
            const double least = leastCosine(position);
            QVERIFY(seen.contains(position) ? least < maxCosine + 1e-4 : least >= maxCosine);
        }
    }
}

FETTLE_TEST(TestWallTree)

#include "tst_wall_tree.moc"

#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace core
{
/// The area-weighted squared distance of a point from the planes of triangles, in N dimensions: the position and
/// further attributes such as colour (Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997;
/// with colours: "Simplifying Surfaces with Color and Texture using Quadric Error Metrics", 1998).
template <int N> class Quadric
{
public:
    using Point = Eigen::Matrix<double, N, 1>;
    using Square = Eigen::Matrix<double, N, N>;

    Quadric() = default;

    static Quadric ofTriangle(const Point& p, const Point& q, const Point& r)
    {
        const Point e1 = (q - p).normalized();
        const Point aside = (r - p) - (r - p).dot(e1) * e1;
        const double height = aside.norm(), area = height * (q - p).norm() / 2;
        if (!(height > 0))
            return {};
        const Point e2 = aside / height;
        const double p1 = p.dot(e1), p2 = p.dot(e2);
        Quadric result;
        result.setSquare(area * (Square::Identity() - e1 * e1.transpose() - e2 * e2.transpose()));
        result.m_b = area * (p1 * e1 + p2 * e2 - p);
        result.m_c = area * (p.squaredNorm() - p1 * p1 - p2 * p2);
        result.m_weight = area;
        return result;
    }

    Quadric& operator+=(const Quadric& other)
    {
        m_a += other.m_a;
        m_b += other.m_b;
        m_c += other.m_c;
        m_weight += other.m_weight;
        return *this;
    }
    friend Quadric operator+(Quadric a, const Quadric& b) { return a += b; }

    double weight() const { return m_weight; }
    /// Returns the value at p, never below 0.
    double at(const Point& p) const { return std::max(0.0, p.dot(square() * p) + 2 * m_b.dot(p) + m_c); }
    /// Returns the point at which the quadric is least. Where it is flat, the point nearest to `target` is preferred:
    /// `pull` is the weight of `target` as a share of the planes' weight.
    Point minimizer(const Point& target, double pull) const
    {
        const double w = pull * m_weight;
        const Square a = square() + w * Square::Identity();
        return a.ldlt().solve(w * target - m_b);
    }

private:
    static constexpr int packed = N * (N + 1) / 2;

    void setSquare(const Square& a)
    {
        for (int i = 0, k = 0; i < N; ++i)
            for (int j = 0; j <= i; ++j)
                m_a[k++] = a(i, j);
    }
    Square square() const
    {
        Square a;
        for (int i = 0, k = 0; i < N; ++i)
            for (int j = 0; j <= i; ++j)
                a(i, j) = a(j, i) = m_a[k++];
        return a;
    }

    /// Lower triangle of the symmetric matrix, row by row.
    Eigen::Matrix<double, packed, 1> m_a = Eigen::Matrix<double, packed, 1>::Zero();
    Point m_b = Point::Zero();
    double m_c = 0, m_weight = 0;
};
} // namespace core

// Exact signs for float32 points, where doubles cannot decide.
//
// A float32 is m x 2^e with an integer |m| < 2^24 and e >= -149. The determinant of four points, expanded without taking
// differences, is a sum of 24 signed products of three coordinates (6 products of two in the plane). Each product is an
// integer of 72 bits times 2^(e1 + e2 + e3), and all are added in one long fixed-point number that holds every exponent
// that can occur (after Kulisch's long accumulator).

#include "predicates.h"

#include <array>
#include <bit>

namespace core
{
namespace
{
struct Decomposed
{
    std::int64_t mantissa; ///< signed, |mantissa| < 2^24
    int exponent;          ///< counted from the least one, 2^-149: 0 to 253
};

Decomposed decompose(float x)
{
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const int biased = static_cast<int>((bits >> 23) & 0xff);
    std::int64_t mantissa = bits & 0x7fffff;
    if (biased != 0)
        mantissa |= 0x800000;
    return {(bits >> 31) != 0 ? -mantissa : mantissa, biased == 0 ? 0 : biased - 1};
}

/// Sum of products of three float32 numbers, exact. Limbs of 32 bits in signed 64-bit cells: carries are settled once.
class ExactSum
{
public:
    void add(float x, float y, float z, bool negative)
    {
        const Decomposed a = decompose(x), b = decompose(y), c = decompose(z);
        if (a.mantissa == 0 || b.mantissa == 0 || c.mantissa == 0)
            return;
        const int shift = a.exponent + b.exponent + c.exponent;
        const std::int64_t product = negative ? -(a.mantissa * b.mantissa) : a.mantissa * b.mantissa; // < 2^48
        addShifted((product >> half) * c.mantissa, shift + half);
        addShifted((product & halfMask) * c.mantissa, shift);
    }

    int sign()
    {
        for (std::size_t i = 0; i + 1 < m_limbs.size(); ++i) {
            m_limbs[i + 1] += m_limbs[i] >> 32;
            m_limbs[i] &= limbMask;
        }
        if (m_limbs.back() != 0)
            return signOf(m_limbs.back());
        for (const std::int64_t limb : m_limbs)
            if (limb != 0)
                return 1;
        return 0;
    }

private:
    static constexpr int half = 24;
    static constexpr std::int64_t halfMask = (std::int64_t(1) << half) - 1;
    static constexpr std::int64_t limbMask = 0xffffffff;

    /// |value| <= 2^48. Cut into 24 bits and the rest, so that each shifted by up to 31 fits 63 bits.
    void addShifted(std::int64_t value, int shift)
    {
        addPiece(value & halfMask, shift);
        addPiece(value >> half, shift + half);
    }

    void addPiece(std::int64_t piece, int shift)
    {
        const auto limb = static_cast<std::size_t>(shift) / 32;
        const std::int64_t shifted = piece * (std::int64_t(1) << (shift % 32));
        m_limbs[limb] += shifted & limbMask;
        m_limbs[limb + 1] += shifted >> 32;
    }

    /// Exponents reach 3 x 253, products add 72 bits and the sum of 24 another 5: 836 bits. At most 24 x 4 pieces of less
    /// than 2^33 meet in a cell.
    std::array<std::int64_t, 28> m_limbs{};
};

/// Adds the determinant of the rows a, b, c.
void addDeterminant(ExactSum& sum, const Vec3f& a, const Vec3f& b, const Vec3f& c, bool negative)
{
    sum.add(a.x(), b.y(), c.z(), negative);
    sum.add(a.y(), b.z(), c.x(), negative);
    sum.add(a.z(), b.x(), c.y(), negative);
    sum.add(a.x(), b.z(), c.y(), !negative);
    sum.add(a.y(), b.x(), c.z(), !negative);
    sum.add(a.z(), b.y(), c.x(), !negative);
}
} // namespace

int FloatPredicates::exactOrient3d(const Point& a, const Point& b, const Point& c, const Point& d)
{
    ExactSum sum;
    addDeterminant(sum, b, c, d, false);
    addDeterminant(sum, a, c, d, true);
    addDeterminant(sum, a, b, d, false);
    addDeterminant(sum, a, b, c, true);
    return sum.sign();
}

int FloatPredicates::exactOrient2d(const Point& a, const Point& b, const Point& c, int axis)
{
    const int i = axis == 2 ? 0 : axis + 1, j = axis == 0 ? 2 : axis - 1;
    ExactSum sum;
    for (const auto& [p, q] : {std::pair{&a, &b}, std::pair{&b, &c}, std::pair{&c, &a}}) {
        sum.add((*p)[i], (*q)[j], 1.0f, false);
        sum.add((*p)[j], (*q)[i], 1.0f, true);
    }
    return sum.sign();
}

int FloatPredicates::Plane::projectionAxis() const
{
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(m_normal[axis]) > detail::roundingBound * m_size[axis])
            return axis;
    for (int axis = 0; axis < 2; ++axis)
        if (m_size[axis] != 0 && exactOrient2d(m_a, m_b, m_c, axis) != 0)
            return axis;
    return 2;
}

bool FloatPredicates::Plane::isPlane() const
{
    return orient2d(m_a, m_b, m_c, projectionAxis()) != 0;
}
} // namespace core

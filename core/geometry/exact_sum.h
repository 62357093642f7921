#pragma once

#include "core/geometry/predicates.h"

#include <array>
#include <bit>

namespace core
{
/// An exact sum of products of three finite float32 numbers of any magnitude.
///
/// A float32 is m x 2^e with an integer |m| < 2^24 and e >= -149. A product is an integer of 72 bits times 2^(e1 + e2 +
/// e3). Products are added in one fixed-point number that covers every possible exponent (Kulisch's long accumulator):
/// 32-bit limbs in signed 64-bit cells, so that carries are propagated only once in maxUnsettled products.
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
        if (++m_unsettled == maxUnsettled)
            settle();
    }

    /// Adds the determinant of the rows a, b, c.
    void addDeterminant(const Vec3f& a, const Vec3f& b, const Vec3f& c, bool negative = false)
    {
        add(a.x(), b.y(), c.z(), negative);
        add(a.y(), b.z(), c.x(), negative);
        add(a.z(), b.x(), c.y(), negative);
        add(a.x(), b.z(), c.y(), !negative);
        add(a.y(), b.x(), c.z(), !negative);
        add(a.z(), b.y(), c.x(), !negative);
    }

    int sign()
    {
        settle();
        if (m_limbs.back() != 0)
            return signOf(m_limbs.back());
        for (const std::int64_t limb : m_limbs)
            if (limb != 0)
                return 1;
        return 0;
    }

private:
    struct Decomposed
    {
        std::int64_t mantissa; ///< signed, |mantissa| < 2^24
        int exponent;          ///< exponent above the least one, 2^-149: 0 to 253
    };

    static constexpr int half = 24;
    static constexpr std::int64_t halfMask = (std::int64_t(1) << half) - 1;
    static constexpr std::int64_t limbMask = 0xffffffff;
    /// Number of products between two propagations of carries. Each product adds four pieces below 2^33: the cells stay
    /// far below 2^63.
    static constexpr int maxUnsettled = 1 << 20;

    static Decomposed decompose(float x)
    {
        const auto bits = std::bit_cast<std::uint32_t>(x);
        const int biased = static_cast<int>((bits >> 23) & 0xff);
        std::int64_t mantissa = bits & 0x7fffff;
        if (biased != 0)
            mantissa |= 0x800000;
        return {(bits >> 31) != 0 ? -mantissa : mantissa, biased == 0 ? 0 : biased - 1};
    }

    /// Precondition: |value| <= 2^48. Adds value x 2^shift as two pieces, split at bit 24; each fits in 63 bits after a
    /// shift by up to 31 bits.
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

    void settle()
    {
        for (std::size_t i = 0; i + 1 < m_limbs.size(); ++i) {
            m_limbs[i + 1] += m_limbs[i] >> 32;
            m_limbs[i] &= limbMask;
        }
        m_unsettled = 0;
    }

    /// Limbs for 891 bits: 3 x 253 for the exponents, 72 for a product and 60 for a sum of 2^60 products.
    std::array<std::int64_t, 28> m_limbs{};
    int m_unsettled = 0;
};
} // namespace core

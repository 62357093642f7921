#include "vr/input/haptics.h"

#include "tests/support/test_main.h"
#include "tests/vr/input/hand_motion.h"

#include <QTest>

#include <functional>
#include <random>
#include <set>

using vr::HapticInput;
using vr::HapticLevels;
using vr::HapticPulse;
using vr::Haptics;
using vr::Sensation;
using vr::Side;

namespace
{
using Feelings = std::array<HapticInput, vr::sideCount>;

struct TimedPulse
{
    double time;
    HapticPulse pulse;
};

std::vector<TimedPulse> feel(Haptics haptics, const std::function<HapticInput(double)>& right, double seconds,
                             double rate)
{
    std::vector<TimedPulse> all;
    for (const double time : frameTimes(seconds, rate))
        for (const HapticPulse& pulse : haptics.step(time, {HapticInput(), right(time)}))
            all.push_back({time, pulse});
    return all;
}

HapticInput sculpting(double pressure)
{
    HapticInput feeling;
    feeling.touches = true;
    feeling.pressure = pressure;
    return feeling;
}

/// Returns the input of one frame with a single sensation.
HapticInput one(Sensation what)
{
    HapticInput feeling;
    feeling.touches = what == Sensation::Contact || what == Sensation::Texture;
    feeling.pressure = what == Sensation::Texture ? 1 : 0;
    feeling.fused = what == Sensation::Fusion;
    feeling.refused = what == Sensation::Refusal;
    feeling.stepped = what == Sensation::MenuStep;
    feeling.hold = what == Sensation::Hold ? 1 : 0;
    return feeling;
}

/// Returns the pulses of a sensation that lasts for two steps. Two are needed because texture is felt only
/// after contact.
std::vector<HapticPulse> pulsesOf(Sensation what, const HapticLevels& levels = {})
{
    Haptics haptics(levels);
    std::vector<HapticPulse> pulses;
    haptics.step(1, {HapticInput(), HapticInput()});
    for (const double time : {2.0, 3.0})
        for (const HapticPulse& pulse : haptics.step(time, {HapticInput(), one(what)}))
            pulses.push_back(pulse);
    return pulses;
}

HapticLevels silent(Sensation what)
{
    HapticLevels levels;
    levels.of[static_cast<std::size_t>(what)] = 0;
    return levels;
}

constexpr Sensation sensations[] = {Sensation::Contact, Sensation::Texture,  Sensation::Fusion,
                                    Sensation::Refusal, Sensation::MenuStep, Sensation::Hold};
constexpr Sensation events[] = {Sensation::Contact, Sensation::Fusion, Sensation::Refusal, Sensation::MenuStep,
                                Sensation::Hold};

/// Returns the fraction of the time during which a pulse is active. A pulse ends when the next begins.
double filled(const std::vector<TimedPulse>& pulses, double seconds)
{
    double sum = 0;
    for (std::size_t i = 0; i < pulses.size(); ++i) {
        const double next = i + 1 < pulses.size() ? pulses[i + 1].time : seconds;
        sum += std::min(pulses[i].pulse.seconds, next - pulses[i].time);
    }
    return sum / seconds;
}
} // namespace

class TestHaptics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whoDoesNothingFeelsNothing()
    {
        QVERIFY(feel(
                    Haptics(), [](double) { return HapticInput(); }, 5, 90)
                    .empty());
        HapticInput hovering;
        hovering.pressure = 1; // a stroke in the air
        QVERIFY(feel(
                    Haptics(), [&](double) { return hovering; }, 5, 90)
                    .empty());
    }

    void eachKindHasAFeelOfItsOwn()
    {
        std::set<std::pair<double, double>> feels;
        for (const Sensation what : events) {
            const HapticPulse pulse = pulsesOf(what).at(0);
            QCOMPARE(pulse.side, Side::Right);
            QVERIFY(pulse.amplitude > 0 && pulse.amplitude <= 1 && pulse.frequency > 0 && pulse.seconds > 0 &&
                    pulse.seconds < 0.3);
            QVERIFY(feels.insert({pulse.frequency, pulse.seconds}).second);
        }
    }

    void eachKindCanBeTurnedDownAndOff()
    {
        for (const Sensation what : sensations) {
            const double full = pulsesOf(what).back().amplitude;
            HapticLevels half;
            half.of[static_cast<std::size_t>(what)] = 0.5;
            QCOMPARE(pulsesOf(what, half).back().amplitude, full / 2);
            const std::size_t felt = pulsesOf(what).size();
            for (const Sensation off : sensations) {
                const std::size_t left = pulsesOf(what, silent(off)).size();
                const bool beginsIt = what == Sensation::Texture && off == Sensation::Contact;
                QVERIFY(off == what ? left < felt : beginsIt ? left <= felt : left == felt);
            }
            HapticLevels only;
            only.of.fill(0);
            QVERIFY(pulsesOf(what, only).empty());
            only.of[static_cast<std::size_t>(what)] = 1;
            QVERIFY(!pulsesOf(what, only).empty());
        }
    }

    /// Checks pulses per second, limited by the frame rate, and the active fraction of the time, which must not depend
    /// on it.
    void theTextureFeelsTheSameAtAnyFrameRate()
    {
        Haptics haptics(silent(Sensation::Contact));
        for (const double rate : frameRates) {
            const auto pulses = feel(
                haptics, [](double) { return sculpting(0.7); }, 10, rate);
            const double aSecond = double(pulses.size()) / 10;
            QVERIFY(aSecond >= std::min(0.99 * rate, 17.5) && aSecond <= 20.1);
            QVERIFY(std::abs(filled(pulses, 10) - 0.3) < 0.02);
            for (const TimedPulse& timed : pulses)
                QCOMPARE(timed.pulse.amplitude, pulses[0].pulse.amplitude);
        }
    }

    void itsStrengthFollowsTheTrigger()
    {
        double before = 0;
        for (const double pressure : {0.05, 0.3, 0.6, 1.0}) {
            const auto pulses = feel(
                Haptics(), [&](double) { return sculpting(pressure); }, 1, 90);
            const double amplitude = pulses.back().pulse.amplitude;
            QVERIFY(amplitude > before && amplitude <= 1);
            before = amplitude;
        }
    }

    void itIsOfTheSurface()
    {
        const auto pulses = feel(
            Haptics(),
            [](double time) {
                return isWithin(time, 1, 2) ? sculpting(1) : HapticInput{false, 1, false, false, false, 0};
            },
            3, 90);
        QVERIFY(!pulses.empty());
        for (const TimedPulse& timed : pulses)
            QVERIFY(isWithin(timed.time, 1, 2));
    }

    void aContactIsFeltOnceAndDoesNotRattle()
    {
        const auto hovering = [](double) { return HapticInput{true, 0, false, false, false, 0}; };
        QCOMPARE(feel(Haptics(), hovering, 2, 90).size(), std::size_t(1));
        int frame = 0;
        const auto grazing = [&](double) { return HapticInput{frame++ % 2 == 0, 0, false, false, false, 0}; };
        const std::size_t felt = feel(Haptics(), grazing, 3, 90).size();
        QVERIFY(felt > 10 && felt <= 21);
    }

    /// Checks that fusion during sculpting gives one clear pulse, which texture pulses do not cut short.
    void theTextureWaitsForWhatMatters()
    {
        for (const double rate : frameRates) {
            bool isDue = true;
            const auto fusing = [&](double time) {
                HapticInput feeling = sculpting(1);
                feeling.fused = time >= 1 && std::exchange(isDue, time < 1);
                return feeling;
            };
            const auto pulses = feel(Haptics(), fusing, 2, rate);
            const auto fusion = std::max_element(pulses.begin(), pulses.end(), [](const auto& a, const auto& b) {
                return a.pulse.amplitude < b.pulse.amplitude;
            });
            QCOMPARE(fusion->pulse.seconds, pulsesOf(Sensation::Fusion)[0].seconds);
            QVERIFY(fusion + 1 != pulses.end() && (fusion + 1)->time >= fusion->time + fusion->pulse.seconds);
            QCOMPARE(std::count_if(pulses.begin(), pulses.end(),
                                   [&](const auto& timed) { return timed.pulse.frequency == fusion->pulse.frequency; }),
                     1);
        }
    }

    /// Checks four ticks of increasing strength while the ring of a long press fills, the last when it is full, and
    /// none while it empties.
    void aHoldTicksAsItsRingFills()
    {
        for (const double rate : frameRates) {
            const auto holding = [](double time) {
                return HapticInput{false, 0, false, false, false, time < 2 ? std::min(time / 0.8, 1.0) : 0};
            };
            const auto pulses = feel(Haptics(), holding, 3, rate);
            QCOMPARE(pulses.size(), std::size_t(4));
            for (std::size_t i = 1; i < pulses.size(); ++i)
                QVERIFY(pulses[i].pulse.amplitude > pulses[i - 1].pulse.amplitude);
            QVERIFY(std::abs(pulses[3].time - 0.8) <= 1 / rate);
        }
    }

    /// Checks that a continuing sensation is felt only at its beginning, as of clay that refuses every dab.
    void whatGoesOnIsFeltWhenItBegins()
    {
        for (const Sensation what : {Sensation::Fusion, Sensation::Refusal})
            for (const double rate : {20.0, 90.0}) {
                const auto pushing = [&](double time) {
                    const bool happens = time < 2 || time > 3;
                    return HapticInput{.fused = happens && what == Sensation::Fusion,
                                       .refused = happens && what == Sensation::Refusal};
                };
                QCOMPARE(feel(Haptics(), pushing, 4, rate).size(), std::size_t(2));
            }
    }

    void whatFailsIsFeltAboveAll()
    {
        HapticInput everything{true, 1, true, true, true, 1};
        const auto pulses = Haptics().step(1, {everything, everything});
        QCOMPARE(pulses.size(), vr::sideCount);
        QVERIFY(pulses[0].side != pulses[1].side);
        for (const HapticPulse& pulse : pulses)
            QCOMPARE(pulse.frequency, pulsesOf(Sensation::Refusal)[0].frequency);
    }

    void handsFeelWhatIsTheirs()
    {
        constexpr unsigned seed = 20261122;
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0, 1);
        const auto any = [&] {
            HapticInput feeling;
            feeling.touches = share(random) < 0.7;
            feeling.pressure = share(random) < 0.7 ? share(random) : 0;
            feeling.fused = share(random) < 0.02;
            feeling.refused = share(random) < 0.02;
            feeling.stepped = share(random) < 0.05;
            feeling.hold = share(random) < 0.3 ? share(random) : 0;
            return feeling;
        };
        Haptics both, left, right;
        double time = 0;
        for (int i = 0; i < 20000; ++i) {
            time += 0.05 * share(random);
            const Feelings feelings{any(), any()};
            const auto pulses = both.step(time, feelings);
            auto alone = left.step(time, {feelings[0], HapticInput()});
            for (const HapticPulse& pulse : right.step(time, {HapticInput(), feelings[1]}))
                alone.push_back(pulse);
            bool isSame = pulses.size() == alone.size();
            for (std::size_t k = 0; isSame && k < pulses.size(); ++k)
                isSame = pulses[k].side == alone[k].side && pulses[k].amplitude == alone[k].amplitude &&
                         pulses[k].amplitude > 0 && pulses[k].amplitude <= 1 && pulses[k].seconds > 0;
            QVERIFY2(isSame, qPrintable(QStringLiteral("seed %1, frame %2").arg(seed).arg(i)));
        }
    }
};

FETTLE_TEST(TestHaptics, QCoreApplication)
#include "tst_haptics.moc"

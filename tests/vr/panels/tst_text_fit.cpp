#include "vr/panels/text_fit.h"

#include "tests/support/test_main.h"

#include <QFontMetricsF>
#include <QTest>

#include <random>

using vr::fitted;
using vr::FittedText;
using vr::TextStyle;

namespace
{
const QString sentence = QStringLiteral("The ball would be too close to the model: move away from it.");
constexpr double wide = 1e5;

double widest(const FittedText& text)
{
    double width = 0;
    for (const QString& line : text.lines)
        width = std::max(width, QFontMetricsF(text.font).horizontalAdvance(line));
    return width;
}

QString joined(const FittedText& text)
{
    return QStringList(text.lines.begin(), text.lines.end()).join(QLatin1Char(' '));
}

double widthOf(const QString& text, const TextStyle& style)
{
    return fitted(text, wide, style).width;
}
} // namespace

class TestTextFit : public QObject
{
    Q_OBJECT

public:
    static void initMain() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

private Q_SLOTS:
    void whatFits_isWholeAndLarge();
    void whatIsALittleTooWide_shrinks();
    void whatIsMuchTooWide_takesMoreLines();
    void whatDoesNotFit_isCut();
    void itNeverLeavesItsRoom();
    void chinese_breaksWithoutSpaces();
    void nothing_isNothing();
};

void TestTextFit::whatFits_isWholeAndLarge()
{
    const TextStyle style;
    const FittedText text = fitted(sentence, wide, style);
    QCOMPARE(text.lines.size(), std::size_t(1));
    QCOMPARE(text.lines.front(), sentence);
    QCOMPARE(text.font.pixelSize(), 40);
    QCOMPARE(text.width, widest(text));
    QVERIFY(text.width > 10 * 40);
}

void TestTextFit::whatIsALittleTooWide_shrinks()
{
    const TextStyle style{.height = 40, .minHeight = 30, .lines = 3};
    const FittedText text = fitted(sentence, 0.9 * widthOf(sentence, style), style);
    QCOMPARE(joined(text), sentence);
    QVERIFY(text.lines.size() > 1 || text.font.pixelSize() < 40);
    const TextStyle one{.height = 40, .minHeight = 30};
    const FittedText shrunk = fitted(sentence, 0.9 * widthOf(sentence, one), one);
    QCOMPARE(shrunk.lines, std::vector{sentence});
    QVERIFY(shrunk.font.pixelSize() < 40 && shrunk.font.pixelSize() >= 34);
}

void TestTextFit::whatIsMuchTooWide_takesMoreLines()
{
    const TextStyle style{.lines = 3};
    const FittedText text = fitted(sentence, 0.45 * widthOf(sentence, style), style);
    QCOMPARE(text.lines.size(), std::size_t(3));
    QCOMPARE(joined(text), sentence);
    TextStyle low = style;
    low.maxBlockHeight = 2.5 * text.lineSpacing();
    QCOMPARE(fitted(sentence, 0.45 * widthOf(sentence, style), low).lines.size(), std::size_t(2));
}

void TestTextFit::whatDoesNotFit_isCut()
{
    const TextStyle right{.lines = 2}, middle{.cut = Qt::ElideMiddle};
    const FittedText first = fitted(sentence, 0.3 * widthOf(sentence, right), right);
    QVERIFY(sentence.startsWith(first.lines.front()));
    QVERIFY(first.lines.back().endsWith(QChar(0x2026)));
    QCOMPARE(first.font.pixelSize(), 36);
    const FittedText ends = fitted(sentence, 0.5 * widthOf(sentence, middle), middle);
    QVERIFY(ends.lines.front().startsWith(QLatin1Char('T')) && ends.lines.front().endsWith(QLatin1Char('.')));
    QVERIFY(ends.lines.front().contains(QChar(0x2026)));
}

void TestTextFit::itNeverLeavesItsRoom()
{
    std::mt19937 random(3);
    const auto number = [&](int min, int max) { return std::uniform_int_distribution(min, max)(random); };
    for (int i = 0; i < 500; ++i) {
        QString text;
        for (int letters = number(0, 60); letters > 0; --letters)
            text += number(0, 6) == 0   ? QChar(QLatin1Char(' '))
                    : number(0, 9) == 0 ? QChar(0x4e00 + number(0, 500))
                                        : QChar('a' + number(0, 25));
        const TextStyle style{.height = static_cast<double>(number(20, 60)),
                              .minHeight = 20,
                              .lines = number(1, 4),
                              .maxBlockHeight = static_cast<double>(number(30, 300))};
        const double width = number(60, 900);
        const FittedText fit = fitted(text, width, style);
        QVERIFY(widest(fit) <= width && fit.width == widest(fit));
        QVERIFY(fit.lines.size() <= static_cast<std::size_t>(style.lines));
        QVERIFY(fit.lines.size() <= 1 ||
                static_cast<double>(fit.lines.size()) * fit.lineSpacing() <= style.maxBlockHeight);
        QVERIFY(fit.font.pixelSize() <= style.height && fit.font.pixelSize() >= style.minHeight);
    }
}

void TestTextFit::chinese_breaksWithoutSpaces()
{
    const QString text = QStringLiteral("球体离模型太近：请移开一些，或缩小笔刷。");
    const TextStyle style{.lines = 2};
    const FittedText fit = fitted(text, 0.6 * widthOf(text, style), style);
    QCOMPARE(fit.lines.size(), std::size_t(2));
    QCOMPARE(fit.lines.front() + fit.lines.back(), text);
}

void TestTextFit::nothing_isNothing()
{
    const FittedText text = fitted({}, 100, {});
    QCOMPARE(text.width, 0.0);
    QVERIFY(joined(text).isEmpty());
}

FETTLE_TEST(TestTextFit, QGuiApplication)
#include "tst_text_fit.moc"

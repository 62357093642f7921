#include "ui/model/primitive_dialog.h"

#include "ui/model/command_dialog.h"
#include "ui/model/primitive_messages.h"
#include "ui/widgets/named.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ui
{
namespace
{
using core::Primitive;
using Measure = core::Primitive::Measure;

constexpr double shareOfModel = 0.25; ///< size of a new primitive, in longest sides of the model
constexpr int pointLines = 5;         ///< number of lines of a profile or path that are shown

/// Places in the order of the list.
constexpr core::Insert::Place placeChoices[] = {core::Insert::Place::Beside, core::Insert::Place::Centre,
                                                core::Insert::Place::Floor};
/// Axes in the order of the list.
constexpr int axisChoices[] = {1, 0, 2};

/// Returns the user's locale without separators between thousands.
QLocale plainLocale()
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

/// Returns a point as a line of text.
template <class Text> QString lineOf(const std::vector<double>& point, const Text& textOf)
{
    QStringList words;
    for (const double number : point)
        words << textOf(number);
    return words.join(u' ');
}

/// Reads a number whose decimal mark is a point or a comma.
double numberOf(QString word, bool& isNumber)
{
    return QLocale::c().toDouble(word.replace(u',', u'.'), &isNumber);
}

/// Returns the points that were typed, of `size` numbers each. A line of anything else becomes a point of numbers
/// that no measure may be.
std::vector<std::vector<double>> pointsIn(const QPlainTextEdit& field, qsizetype size)
{
    static const QRegularExpression space(QStringLiteral("[\\s;]+"));
    std::vector<std::vector<double>> points;
    for (const QString& line : field.toPlainText().split(u'\n', Qt::SkipEmptyParts)) {
        const QStringList words = line.split(space, Qt::SkipEmptyParts);
        if (words.isEmpty())
            continue;
        std::vector<double>& point = points.emplace_back(static_cast<std::size_t>(size), -1);
        bool isRead = words.size() == size;
        for (qsizetype i = 0; i < size && isRead; ++i)
            point[static_cast<std::size_t>(i)] = numberOf(words[i], isRead);
        if (!isRead)
            point.assign(point.size(), -1);
    }
    return points;
}

class PrimitiveDialog : public CommandDialog
{
    Q_DECLARE_TR_FUNCTIONS(ui::PrimitiveDialog)

public:
    PrimitiveDialog(QWidget* parent, double size, const std::shared_ptr<PrimitiveMemory>& memory)
        : CommandDialog(parent, "primitiveDialog", tr("Insert a Primitive"),
                        tr("Measures, place, and how it is combined with the present model:"))
        , m_memory(memory)
    {
        addShape(size);
        addPlace();
        m_problem = addText({});
        m_problem->setObjectName(QStringLiteral("problem"));
        m_start = insertion();
        m_kind->setCurrentIndex(static_cast<int>(memory->kind));
        connect(m_kind, &QComboBox::currentIndexChanged, this, [this] { beginKind(); });
        beginKind();
    }

    void ask(const CommandCallback& callback)
    {
        m_accept = openFor(ModelDialogs::tr("Insert"), callback, [this] {
            m_memory->kind = kind();
            return m_memory->inserted[kind()] = insertion();
        });
        judge();
    }

private:
    void addShape(double size)
    {
        QStringList kinds;
        for (std::size_t i = 0; i < Primitive::kinds; ++i)
            kinds << PrimitiveMessages::kind(static_cast<Primitive::Kind>(i));
        m_kind = addList("kind", tr("Shape"), kinds);
        const double defaults[] = {size, size, size, size / 2, 0, size / 8}; // a capsule's height is set by showKind()
        for (std::size_t i = 0; i < Primitive::measures; ++i) {
            const auto measure = static_cast<Measure>(i);
            m_measures[i] = addNumber(core::name(measure).data(), PrimitiveMessages::measure(measure),
                                      millimetreField(defaults[i], 0));
        }
        m_profile = addPoints("profile", tr("Profile: radius, height"),
                              tr("One point a line: its distance from the axis and its height, in millimetres."), size,
                              {{0.3, 0}, {0.5, 0.4}, {0.25, 0.8}, {0.35, 1}});
        m_path = addPoints("path", tr("Path: X, Y, Z, radius"),
                           tr("One point a line: its place, and the radius of the tube there, in millimetres."), size,
                           {{-0.5, 0, 0, 0.1}, {-0.2, 0.4, 0, 0.12}, {0.2, 0.4, 0, 0.12}, {0.5, 0, 0, 0.06}});
        m_axis = addList(
            "axis", tr("Its axis"),
            {ModelDialogs::tr("Y, upwards"), ModelDialogs::tr("X, to the right"), ModelDialogs::tr("Z, to the front")});
        m_edge = addNumber("edge", tr("Edge length"), millimetreField(0, 0));
        m_edge->setSpecialValueText(tr("Automatic"));
        for (QDoubleSpinBox* box : m_measures)
            connect(box, &QDoubleSpinBox::valueChanged, this, [this] { judge(); });
        connect(m_edge, &QDoubleSpinBox::valueChanged, this, [this] { judge(); });
    }

    /// Adds a field of points, each a line of numbers. `points`: the first text, in sizes.
    QPlainTextEdit* addPoints(const char* name, const QString& label, const QString& tip, double size,
                              std::initializer_list<std::vector<double>> points)
    {
        auto* field = named(new QPlainTextEdit, name, tip);
        field->setTabChangesFocus(true);
        field->setAccessibleDescription(tip);
        field->setFixedHeight(pointLines * fontMetrics().lineSpacing() + 2 * fontMetrics().height() / 2);
        QStringList lines;
        for (const std::vector<double>& point : points)
            lines << lineOf(point, [size](double number) { return plainLocale().toString(number * size, 'f', 2); });
        field->setPlainText(lines.join(u'\n'));
        form()->addRow(label, field);
        connect(field, &QPlainTextEdit::textChanged, this, [this] { judge(); });
        return field;
    }

    void addPlace()
    {
        m_place = addList("place", tr("Place"),
                          {ModelDialogs::tr("Beside the present model"), ModelDialogs::tr("With its middle at"),
                           tr("With the middle of its bottom at")});
        m_at = addCoordinates(this);
        m_at.setEnabled(false);
        m_combination = addCombinations(this);
        connect(m_place, &QComboBox::currentIndexChanged, this, [this](int place) { m_at.setEnabled(place > 0); });
        connect(m_combination, &QComboBox::currentIndexChanged, this, [this] { leaveSide(); });
        leaveSide();
    }

    /// Chooses another place than beside the model if there would be nothing to combine there.
    void leaveSide()
    {
        if (needsOverlap(m_combination) && m_place->currentIndex() == 0)
            m_place->setCurrentIndex(1);
    }

    Primitive::Kind kind() const { return static_cast<Primitive::Kind>(m_kind->currentIndex()); }

    bool hasAxis() const
    {
        return kind() != Primitive::Kind::Cuboid && kind() != Primitive::Kind::Ball && kind() != Primitive::Kind::Tube;
    }

    /// Shows what the shape was inserted with. A shape that was not begins as the dialog did, if another was recalled.
    void beginKind()
    {
        const auto last = m_memory->inserted.find(kind());
        const bool wasRecalled = std::exchange(m_isRecalled, last != m_memory->inserted.end());
        if (m_isRecalled)
            recall(last->second);
        else if (wasRecalled)
            recall(m_start);
        showKind();
    }

    /// Shows the measures and the place of a shape that was inserted before.
    void recall(const core::Insert& insert)
    {
        const Primitive& shape = *insert.primitive;
        for (std::size_t i = 0; i < Primitive::measures; ++i)
            m_measures[i]->setValue(shape.lengths[i]);
        const auto exact = [](double number) {
            return plainLocale().toString(number, 'g', QLocale::FloatingPointShortest);
        };
        QStringList profile, path;
        for (const auto& [radius, height] : shape.profile)
            profile << lineOf({radius, height}, exact);
        for (const auto& [at, radius] : shape.path)
            path << lineOf({at.x(), at.y(), at.z(), radius}, exact);
        if (!profile.isEmpty())
            m_profile->setPlainText(profile.join(u'\n'));
        if (!path.isEmpty())
            m_path->setPlainText(path.join(u'\n'));
        m_edge->setValue(shape.edge);
        const auto axis = std::ranges::find_if(axisChoices, [&](int choice) { return shape.axis[choice] == 1; });
        m_axis->setCurrentIndex(static_cast<int>(axis - std::begin(axisChoices)));
        const auto place = std::ranges::find(placeChoices, insert.place);
        if (place != std::end(placeChoices))
            m_place->setCurrentIndex(static_cast<int>(place - std::begin(placeChoices)));
        m_at.setValue(insert.centre);
        leaveSide();
    }

    /// Shows the rows of the shape's measures.
    void showKind()
    {
        const auto measures = core::measuresOf(kind());
        for (std::size_t i = 0; i < Primitive::measures; ++i)
            form()->setRowVisible(m_measures[i], std::ranges::count(measures, static_cast<Measure>(i)) > 0);
        form()->setRowVisible(m_profile, kind() == Primitive::Kind::Lathe);
        form()->setRowVisible(m_path, kind() == Primitive::Kind::Tube);
        form()->setRowVisible(m_axis, hasAxis());
        const bool isTube = kind() == Primitive::Kind::Tube; // lies where its path is
        m_place->setEnabled(!isTube);
        m_at.setEnabled(!isTube && m_place->currentIndex() > 0);
        QDoubleSpinBox* height = m_measures[static_cast<std::size_t>(Measure::Height)];
        const double diameter = 2 * m_measures[static_cast<std::size_t>(Measure::Radius)]->value();
        if (kind() == Primitive::Kind::Capsule && height->value() <= diameter)
            height->setValue(2 * diameter);
        judge();
        adjustSize();
    }

    Primitive primitive() const
    {
        Primitive result;
        result.kind = kind();
        for (std::size_t i = 0; i < Primitive::measures; ++i)
            result.lengths[i] = m_measures[i]->value();
        if (result.kind == Primitive::Kind::Lathe) {
            for (const std::vector<double>& p : pointsIn(*m_profile, 2))
                result.profile.push_back({p[0], p[1]});
        }
        if (result.kind == Primitive::Kind::Tube) {
            for (const std::vector<double>& p : pointsIn(*m_path, 4))
                result.path.push_back({{p[0], p[1], p[2]}, p[3]});
        }
        result.edge = m_edge->value();
        if (hasAxis())
            result.axis = core::Vec3::Unit(axisChoices[m_axis->currentIndex()]);
        return result;
    }

    core::Insert insertion() const
    {
        core::Insert insert;
        insert.place =
            kind() == Primitive::Kind::Tube ? core::Insert::Place::AsItIs : placeChoices[m_place->currentIndex()];
        insert.centre = m_at.value();
        insert.combination = combinationOf(m_combination);
        insert.primitive = primitive();
        if (insert.combination == core::Insert::Combination::Part)
            insert.name = PrimitiveMessages::kind(kind()).toStdString();
        return insert;
    }

    void judge()
    {
        const QString problem = PrimitiveMessages::problem(core::judgePrimitive(primitive()));
        m_problem->setText(problem);
        if (m_accept)
            m_accept->setEnabled(problem.isEmpty());
    }

    QComboBox *m_kind, *m_axis, *m_place, *m_combination;
    std::array<QDoubleSpinBox*, Primitive::measures> m_measures;
    QPlainTextEdit *m_profile, *m_path;
    QDoubleSpinBox* m_edge;
    Coordinates m_at;
    std::shared_ptr<PrimitiveMemory> m_memory;
    core::Insert m_start;      ///< what the dialog shows first
    bool m_isRecalled = false; ///< whether it shows what was inserted before
    QLabel* m_problem;
    QPushButton* m_accept = nullptr;
};
} // namespace

void askForPrimitive(QWidget* parent, const ModelInfo& modelInfo, const std::shared_ptr<PrimitiveMemory>& memory,
                     const CommandCallback& callback)
{
    const double size = std::clamp(shareOfModel * modelInfo.size.maxCoeff(), 0.01, maxCoordinate);
    // three significant digits look like a choice
    const double digit = std::pow(10, std::floor(std::log10(size)) - 1);
    (new PrimitiveDialog(parent, std::round(size / digit) * digit, memory))->ask(callback);
}
} // namespace ui

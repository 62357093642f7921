#pragma once

#include "core/operations/model_command.h"

#include <QCoreApplication>
#include <QDialog>
#include <QString>
#include <QStringList>

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace ui
{
inline constexpr double maxCoordinate = 1e6; ///< mm; largest coordinate that can be typed

/// Gives the texts of the dialogs of this folder their context.
class ModelDialogs
{
    Q_DECLARE_TR_FUNCTIONS(ui::ModelDialogs)
};

struct Number
{
    double value = 0, min = -maxCoordinate, max = maxCoordinate;
    int decimals = 3;
    QString unit;
};

Number millimetreField(double value, double min = -maxCoordinate, double max = maxCoordinate);

/// A dialog with an explanation, a few rows of controls, and a button named by the command's verb. Thread: gui.
class CommandDialog : public QDialog
{
public:
    CommandDialog(QWidget* parent, const char* name, const QString& title, const QString& sentence);

    QFormLayout* form() { return m_form; }
    QDoubleSpinBox* addNumber(const char* name, const QString& label, const Number& number);
    /// Adds radio buttons; the first is checked.
    QButtonGroup* addChoice(const QString& label, const QStringList& choices);
    /// Adds a combo box; the first entry is selected.
    QComboBox* addList(const char* name, const QString& label, const QStringList& choices);
    /// Adds a sentence below the rows.
    QLabel* addText(const QString& sentence);

    /// Adds the buttons and opens the dialog. `callback` gets the value of `makeCommand` if the user accepts. Returns
    /// the accepting button.
    template <class Callback, class MakeCommand>
    QPushButton* openFor(const QString& verb, const Callback& callback, const MakeCommand& makeCommand)
    {
        connect(this, &QDialog::accepted, this, [callback, makeCommand] { callback(makeCommand()); });
        return openWith(verb);
    }

private:
    QPushButton* openWith(const QString& verb);

    QFormLayout* m_form;
};

struct Coordinates
{
    QDoubleSpinBox *x, *y, *z;

    core::Vec3 value() const;
    void setValue(const core::Vec3& value) const;
    void setEnabled(bool enabled) const;
};

Coordinates addCoordinates(CommandDialog* dialog);

/// Fills a list with the ways to combine an inserted model with the present one, and selects the last choice.
void fillCombinations(QComboBox* list);
/// Stores the choice in the settings.
void storeCombination(const QComboBox* list);
/// Adds such a list. The choice is stored when the dialog is accepted.
QComboBox* addCombinations(CommandDialog* dialog);
/// Returns the choice in such a list.
core::Insert::Combination combinationOf(const QComboBox* list);
/// Returns whether the choice only has an effect where the two models overlap.
bool needsOverlap(const QComboBox* list);
} // namespace ui

#pragma once

#include "vr/input/wand_commands.h"

#include <QString>

/// Names of commands for comparison in tests. Amounts are reduced to their sign.
struct CommandNames
{
    static QString sign(double value)
    {
        return value > 0 ? QStringLiteral("+") : value < 0 ? QStringLiteral("-") : QStringLiteral("0");
    }
    static QString isOn(bool on) { return on ? QStringLiteral(" yes") : QStringLiteral(" no"); }

    QString operator()(const vr::BeginStroke& begin) const
    {
        return QStringLiteral("begin smooth") + isOn(begin.smooths);
    }
    QString operator()(const vr::StrokePoint&) const { return QStringLiteral("point"); }
    QString operator()(const vr::EndStroke&) const { return QStringLiteral("end"); }
    QString operator()(const vr::Undo&) const { return QStringLiteral("undo"); }
    QString operator()(const vr::Redo&) const { return QStringLiteral("redo"); }
    QString operator()(const vr::SaveModel&) const { return QStringLiteral("save"); }
    QString operator()(const vr::RestoreModel&) const { return QStringLiteral("restore"); }
    QString operator()(const vr::ToggleTopology&) const { return QStringLiteral("topology"); }
    QString operator()(const vr::ToggleBrushShape&) const { return QStringLiteral("shape"); }
    QString operator()(const vr::ToggleSymmetry&) const { return QStringLiteral("symmetry"); }
    QString operator()(const vr::ToggleInverse&) const { return QStringLiteral("inverse"); }
    QString operator()(const vr::StepTool& step) const { return QStringLiteral("tool %1").arg(step.by); }
    QString operator()(const vr::ScaleRadius& scale) const
    {
        return QStringLiteral("radius ") + sign(scale.factor - 1);
    }
    QString operator()(const vr::SelectChannel& select) const
    {
        return QStringLiteral("channel %1").arg(select.channel);
    }
    QString operator()(const vr::ChangeChannel& change) const
    {
        return QStringLiteral("color %1 ").arg(change.channel) + sign(change.by);
    }
    QString operator()(const vr::TurnModel& turn) const { return QStringLiteral("turn ") + sign(turn.angle); }
    QString operator()(const vr::ScaleModel& scale) const { return QStringLiteral("scale ") + sign(scale.factor - 1); }
    QString operator()(const vr::MoveModel&) const { return QStringLiteral("move"); }
    QString operator()(const vr::StretchModel&) const { return QStringLiteral("stretch"); }
    QString operator()(const vr::OpenToolMenu& open) const { return QStringLiteral("tool menu") + isOn(open.isOpen); }
    QString operator()(const vr::OpenColorPanel& open) const
    {
        return QStringLiteral("color panel") + isOn(open.isOpen);
    }
    QString operator()(const vr::UseTip&) const { return QStringLiteral("use tip"); }
    QString operator()(const vr::MovePart&) const { return QStringLiteral("move part"); }
    QString operator()(const vr::ReleasePart&) const { return QStringLiteral("release part"); }
    QString operator()(const vr::PressPanel&) const { return QStringLiteral("press panel"); }
    QString operator()(const vr::ReleasePanel& release) const
    {
        return QStringLiteral("release panel") + isOn(release.isClick);
    }
    QString operator()(const vr::Refuse&) const { return QStringLiteral("refuse"); }
};

inline QString commandName(const vr::WandCommand& command)
{
    return std::visit(CommandNames(), command.action);
}

#pragma once

#include "ui/model/model_dialogs.h"

#include <map>
#include <memory>

namespace ui
{
/// The primitives that were inserted last, by their kind.
struct PrimitiveMemory
{
    std::map<core::Primitive::Kind, core::Insert> inserted;
    core::Primitive::Kind kind = core::Primitive::Kind::Cuboid; ///< kind of the last one
};

/// Asks for a primitive with its measures, its place, and how it is combined with the model. Returns at once;
/// `callback` gets a core::Insert if the user accepts. Measures that are not possible cannot be accepted. `memory`:
/// shapes begin with the measures and the place that it has of their kind; must not be null.
void askForPrimitive(QWidget* parent, const ModelInfo& modelInfo, const std::shared_ptr<PrimitiveMemory>& memory,
                     const CommandCallback& callback);
} // namespace ui

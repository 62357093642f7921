#include "model_trial.h"

#include "model_loader.h"
#include "model_words.h"

#include "core/mesh_io.h"
#include "ui/messages.h"

namespace app
{
std::shared_ptr<core::Mesh> ModelTrial::copyOf(const core::Mesh& mesh)
{
    try {
        return std::make_shared<core::Mesh>(mesh);
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

ModelOutcome ModelTrial::run(const std::shared_ptr<core::Mesh>& copy, core::ModelCommand& command, const QString& insertedPath,
                             const core::JobWatch& watch)
{
    ModelOutcome outcome;
    try {
        if (!copy)
            throw std::bad_alloc();
        if (auto* insertion = std::get_if<core::Insert>(&command))
            insertion->model = core::readMesh(toPath(insertedPath));
        outcome.change = core::tryOn(std::move(*copy), command, watch);
        outcome.problem = ModelWords::refusal(outcome.change, insertedPath);
    } catch (const core::FileError& error) {
        outcome.problem = ui::Messages::sentence(error);
    } catch (const std::bad_alloc&) {
        outcome.problem = tr("There is not enough memory for that; the model stays as it is.");
    }
    return outcome;
}
} // namespace app

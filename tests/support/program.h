#pragma once

#include "app/document/document.h"
#include "app/window/connections.h"
#include "app/worker/sculpt_worker.h"
#include "core/sculpt/sculptor.h"
#include "ui/window/main_window.h"

namespace app
{
/// The program as main() puts it together.
struct Program
{
    Program() { connectAll(window, document, worker, inbox); }

    SculptWorker worker;
    std::shared_ptr<PatchInbox> inbox = std::make_shared<PatchInbox>();
    Document document{&worker};
    ui::MainWindow window;
};
} // namespace app

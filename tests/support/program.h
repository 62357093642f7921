#pragma once

#include "app/document/document.h"
#include "app/window/connections.h"
#include "app/worker/sculpt_worker.h"
#include "core/sculpt/sculptor.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace app
{
/// The program as main() puts it together. Its view of the model is small, because the processor draws it here, which
/// took most of the time of the tests of the window.
struct Program
{
    static constexpr QSize smallView{320, 240}, anyView{QWIDGETSIZE_MAX, QWIDGETSIZE_MAX};

    explicit Program(const QSize& largestView = smallView)
    {
        window.viewport()->setMaximumSize(largestView);
        connectAll(window, document, worker, inbox);
    }

    SculptWorker worker;
    std::shared_ptr<PatchInbox> inbox = std::make_shared<PatchInbox>();
    Document document{&worker};
    ui::MainWindow window;
};
} // namespace app

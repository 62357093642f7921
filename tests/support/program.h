#pragma once

#include "app/document/document.h"
#include "app/window/connections.h"
#include "app/worker/sculpt_worker.h"
#include "core/sculpt/sculptor.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace app
{
/// The program as main() assembles it. Its view of the model is small by default, because drawing it in software took
/// most of the time of window tests.
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

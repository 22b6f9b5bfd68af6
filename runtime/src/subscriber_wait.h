#pragma once

namespace tws_runtime {

class RosBus;
struct LiveOptions;

/// Waits until each topic has as many subscribers as it stands in `options.wait_for`, whichever nodes publish it, and
/// serves the Bus meanwhile; until `options.wait_timeout` is over, which a warning says with what is missing, or
/// bus.ok() says false.
void waitForSubscribers(RosBus& bus, const LiveOptions& options);

}  // namespace tws_runtime

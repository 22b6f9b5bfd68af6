#pragma once

#include "graph_description.h"
#include "graph_file.h"
#include "run_input.h"
#include "tracker_choices.h"

namespace tws_launch {

// Choices of trackers that cannot be meant. All throw std::runtime_error, and tell what could be.

/// A choice of a node that no row describes.
void refuseUnknownChoices(const GraphFile& file, const TrackerChoices& chosen);
/// A choice of a node that is no part of the graph.
void refuseIdleChoices(const GraphFile& file, const GraphDescription& graph, const TrackerChoices& chosen);
/// A tracker of a radar that the input has not: it would wait for it in silence.
void refuseUnknownRadars(const GraphFile& file, const RunInput& input, const GraphDescription& graph,
                         const TrackerChoices& chosen);
/// Two nodes on one topic of tracks: neither can be told from the other.
void refuseTwoOnOneTopic(const GraphDescription& graph);

}  // namespace tws_launch

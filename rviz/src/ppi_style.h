#pragma once

#include "drawing.h"

namespace tws_rviz {

/// Sizes and colours of a PPI, so that it looks the same at any range. All sizes in metres on the ground.
struct PpiStyle {
  /// `range` is the radius of the picture [m]; `text` scales all text, 1 is readable when the picture fills 900 pixels.
  explicit PpiStyle(double range, double text = 1.0)
      : range(range),
        line(0.0026 * range),
        symbol(0.017 * range),
        dot(0.006 * range),
        plot(0.016 * range),
        clutter_mark(0.03 * range),
        text(0.034 * range * text),
        small_text(0.03 * range * text) {}

  double range;
  double line;          // width of thin lines
  double symbol;        // radius of a firm track's symbol
  double dot;           // size of a trail's dots
  double plot;          // length of a detection
  double clutter_mark;  // length of its strokes
  double text;          // line height of scales and status
  double small_text;    // line height of track labels and ring distances

  Rgba ring{0.0f, 0.42f, 0.10f, 1.0f};
  Rgba spoke{0.0f, 0.26f, 0.07f, 1.0f};
  Rgba scale_text{0.25f, 0.75f, 0.35f, 1.0f};
  Rgba tentative{0.95f, 0.85f, 0.20f, 1.0f};
  Rgba firm{1.0f, 1.0f, 1.0f, 1.0f};
  Rgba secondary{0.35f, 0.90f, 1.0f, 1.0f};  // a firm track of which only a secondary radar knows
  Rgba coasting{1.0f, 0.50f, 0.10f, 1.0f};
  Rgba ordered{0.25f, 0.80f, 1.0f, 1.0f};  // marks of what an operator has ordered
  Rgba iff{0.45f, 1.0f, 0.45f, 1.0f};      // mark of tracks that answer interrogations
  Rgba clutter{0.75f, 0.50f, 0.28f, 1.0f};
  Rgba blind{0.35f, 0.35f, 0.50f, 0.25f};  // where a radar sees hardly anything
  Rgba truth{0.80f, 0.30f, 0.80f, 1.0f};
};

}  // namespace tws_rviz

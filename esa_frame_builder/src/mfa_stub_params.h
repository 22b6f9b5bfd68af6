#pragma once

#include <cstddef>

namespace esa_frame_builder {

/// Parameters of the frame tracker that decides at once.
struct MfaStubParams {
  std::size_t window_frames = 8;          // N of the window
  int initiation_hits = 4;                // M measurements
  int initiation_frames = 8;              // within so many frames, the first one included, make a track firm
  double gate_chi2 = 16.3;                // of an innovation, χ² with three degrees of freedom
  double acceleration_density = 5.0;      // q [m²/s³]
  double speed_sigma = 200.0;             // of each velocity component of a new track [m/s]
  double extraneous_density = 1e-10;      // measurements of no track, a frame [1/m³]
  double false_alarm_probability = 1e-6;  // of the radar, from which and from the SNR the detection probability follows
  double least_detection_probability = 0.05;  // less: out of view
  double range_resolution = 30.0;             // plots of one dwell closer in range than this merge [m]
  double drop_score = 16.0;                   // a track is dropped when its score falls so far below its best
  double greatest_coast = 15.0;               // or when it was not seen for so long [s]
  double duplicate_chi2 = 11.3;               // two measurements of a frame so close are one target's
  double tentative_revisit = 0.1;             // wanted time between dwells on a track that is not firm [s]
  double firm_revisit = 0.5;                  // and on one that is [s]
};

}  // namespace esa_frame_builder

#pragma once

#include <complex>
#include <vector>

#include <tws_core/rotation.h>

namespace tws {

/// How well plots agree with a beam of some frequency [1/s]: 1 when all lie where one beam was, 0 when no more of them
/// do than by chance.
struct CoherencePeak {
  double frequency;
  double coherence;
};

/// Plots in order of time, of which every stride-th is used.
class PlotWindow {
 public:
  /// Thins to at most 300 plots: more make the coherence no clearer.
  PlotWindow(const TimedAzimuth* first, const TimedAzimuth* last);
  std::size_t count() const { return (size_ + stride_ - 1) / stride_; }
  /// Σ exp(i(azimuth - 2π·frequency·time)); its argument is the beam's azimuth at time 0.
  std::complex<double> resultant(double frequency) const;

 private:
  const TimedAzimuth* first_;
  std::size_t size_;
  std::size_t stride_;
};

/// The first of the plots, which are in order of time, that is not before the time [s].
const TimedAzimuth* firstNotBefore(const TimedAzimuth* first, const TimedAzimuth* last, double time);

/// How long plots in order of time were seen [s], without gaps of a hundred turns of `period` [s] or more.
double seenSpan(const TimedAzimuths& plots, double period);

/// The most coherent frequency within the share `tolerance` of `frequency`, of plots in order of time;
/// `frequency` itself when they last less than three turns.
CoherencePeak peakNear(const TimedAzimuth* first, const TimedAzimuth* last, double frequency, double tolerance);

/// The frequency of a beam with a period of 0.2..120 s, from plots in order of time with times near zero. Throws
/// std::invalid_argument that says why when there are too few or they do not show one.
double findFrequency(const TimedAzimuths& plots);
/// The same near a known period [s].
double findFrequency(const TimedAzimuths& plots, double period);

}  // namespace tws

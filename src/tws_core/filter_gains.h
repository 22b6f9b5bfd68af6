#pragma once

namespace tws {

/// Gains of the α, α-β and α-β-γ filters for one interval T between measurements. The innovation (measured minus
/// predicted) goes into the position by alpha, into the velocity by beta/T, into the acceleration by gamma/T². Without
/// beta and gamma it is the α filter, without gamma the α-β filter (Henery 1985, eqs. (3.5) and (3.9)). Some authors
/// write γ/(2T²) or 2γ/T²: their γ is twice, or half, of ours.
struct FilterGains {
  double alpha = 0.0;
  double beta = 0.0;
  double gamma = 0.0;
};

/// 0: the α filter; 1: α-β; 2: α-β-γ. The degree of the polynomial that the filter follows without lag.
int degreeOf(const FilterGains& gains);

/// Whether the filter forgets its start. α: 0 < α < 2. α-β: α, β > 0 and 4 - 2α - β > 0 (Henery 1985, figure 3.5).
/// α-β-γ: these, and 0 < γ·(2 - α) < 2αβ (Jury's criterion on z³ + (α+β+γ/2-3)z² + (3-2α-β+γ/2)z + α-1).
bool isStable(const FilterGains& gains);

/// By how much the smoothed position of a settled filter falls behind a target whose lowest derivative that the filter
/// does not know is constant [m]: velocity [m/s] for α, acceleration [m/s²] for α-β, jerk [m/s³] for α-β-γ. For α it is
/// (3.7): ẋT(1-α)/α. The prediction of the next measurement falls behind by 1/(1-α) times as much.
double smoothedLag(const FilterGains& gains, double derivative, double T);
/// The same of the prediction one interval ahead, which is the innovation of a settled filter without noise [m].
double predictedLag(const FilterGains& gains, double derivative, double T);

/// Average age of the data in the α filter's memory, in intervals: (1-α)/α (Henery 1985, section 3.3.1). α in (0, 2).
double meanAge(double alpha);

/// Variance of a settled, stable filter's estimates over that of the measurements (white noise). Position: no unit;
/// velocity [1/s²]; acceleration [1/s⁴]. Simpson, "Performance measures and optimization condition for a third-order
/// sampled-data tracker", IEEE Trans. AC-8, 1963.
struct NoiseReduction {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};
NoiseReduction noiseReduction(const FilterGains& gains, double T);

/// Expanding memory (Henery 1985, section 3.2.3; Morrison 1969): with these gains at its n-th measurement, counted from
/// 1, the filter is the least-squares polynomial of that degree through all n. With fewer measurements than the
/// polynomial has coefficients, of the greatest degree that they determine. degree 0..2, n ≥ 1.
FilterGains expandingGains(int degree, int n);

/// Fading memory (the same sources): the least-squares polynomial whose data lose weight by the factor `theta` each
/// interval, settled. degree 0..2, theta in [0, 1). Degree 0 is the α filter with α = 1 - θ, degree 1 the critically
/// damped α-β filter.
FilterGains fadingGains(int degree, double theta);

/// Kalata's target tracking index Λ = σ_w·T²/σ_v, for a target whose acceleration (degree 2: its change) has the
/// standard deviation σ_w and is constant over each interval T, and measurements of standard deviation σ_v.
double trackingIndex(double acceleration_sigma, double measurement_sigma, double T);

/// The gains in which the Kalman filter settles for this tracking index ≥ 0 (Kalata, "The tracking index: a generalized
/// parameter for α-β and α-β-γ target trackers", IEEE Trans. AES-20, 1984). degree 0: position moves by w·T²/2 each
/// interval; 1: constant velocity; 2: constant acceleration.
FilterGains steadyGains(int degree, double tracking_index);

}  // namespace tws

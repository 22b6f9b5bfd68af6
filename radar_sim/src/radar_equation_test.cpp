#include "radar_equation.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

double decibels(double ratio) { return 10.0 * std::log10(ratio); }

RadarParams freeSpaceRadar() {
  RadarParams radar;
  radar.antenna_height = 30.0;
  radar.sea_reflection = 0.0;
  radar.beams = {ElevationBeam{0.0, tws::radians(60.0), 0.0}};
  radar.peak_power = 1e6;              // 60 dBW
  radar.antenna_gain = 1000.0;         // 30 dB, twice
  radar.wavelength = 0.1;              // -20 dB m²
  radar.pulse_width = 1e-6;            // B = 60 dB Hz
  radar.noise_figure = 4.0;            // 6.02 dB
  radar.losses = 4.0;                  // 6.02 dB
  radar.pulses = 20.0;                 // 13.01 dB
  radar.integration_efficiency = 0.5;  // -3.01 dB
  return radar;
}

// By hand, in dB: 60 + 60 - 20 + 0 (1 m²) - 32.98 ((4π)³) - 200 (100 km)⁴ + 203.98 - 60 (k T0 B) - 12.04 + 10 = 8.96;
// the beam's Gaussian takes 2 · 0.018 dB at 2.3°. A wrong figure here moves the whole coverage.
TEST(RadarEquation, AgreesWithTheBudgetByHand) {
  EXPECT_NEAR(decibels(meanSnr(freeSpaceRadar(), 1.0, 100e3, 4650.0)), 8.92, 0.03);
}

TEST(RadarEquation, FollowsCrossSectionAndTheFourthPowerOfRange) {
  const RadarParams radar = freeSpaceRadar();
  const double near = meanSnr(radar, 2.0, 50e3, 30.0 + 50e3 * 50e3 / (2.0 * 8494667.0));  // both at elevation 0
  const double far = meanSnr(radar, 1.0, 100e3, 30.0 + 100e3 * 100e3 / (2.0 * 8494667.0));
  EXPECT_NEAR(near / far, 32.0, 0.01);
}

TEST(RadarEquation, SeesNothingBeyondTheHorizon) { EXPECT_EQ(meanSnr(freeSpaceRadar(), 1e6, 100e3, 100.0), 0.0); }

// 12 dB gain in the lobe's maximum (F⁴ = 16), the whole signal gone in the null. Antenna at 25 m, λ 0.25 m: see
// propagation_test.
TEST(RadarEquation, CarriesTheLobesToTheFourthPower) {
  RadarParams radar = freeSpaceRadar();
  radar.antenna_height = 25.0;
  radar.wavelength = 0.25;
  const double range = 50e3;
  const auto heightAt = [&](double sine) {  // from the triangle of propagation.cpp
    const double a = 4.0 / 3.0 * 6371000.0 + 25.0;
    return std::sqrt(a * a + range * range + 2.0 * a * range * sine) - a + 25.0;
  };
  const double free_space = meanSnr(radar, 1.0, range, heightAt(0.0025));
  radar.sea_reflection = 1.0;
  EXPECT_NEAR(meanSnr(radar, 1.0, range, heightAt(0.0025)) / free_space, 16.0, 0.05);
  EXPECT_NEAR(meanSnr(radar, 1.0, range, heightAt(0.0050)) / free_space, 0.0, 1e-6);
}

TEST(ElevationGain, IsOneHalfAtTheBeamsEdges) {
  const ElevationBeam beam{tws::radians(5.0), tws::radians(2.0), 0.0};
  EXPECT_DOUBLE_EQ(elevationGain(beam, tws::radians(5.0)), 1.0);
  EXPECT_NEAR(elevationGain(beam, tws::radians(4.0)), 0.5, 1e-12);
  EXPECT_NEAR(elevationGain(beam, tws::radians(6.0)), 0.5, 1e-12);
}

// What the cosecant-squared pattern is for: at one height, the signal (G² / R⁴) stays the same from far to near.
TEST(ElevationGain, KeepsTheSignalOfConstantHeightWithACosecantPattern) {
  const ElevationBeam beam{tws::radians(2.0), tws::radians(6.0), tws::radians(40.0)};
  const auto signal = [&](double elevation_deg) {
    const double range = 5000.0 / std::sin(tws::radians(elevation_deg));
    return std::pow(elevationGain(beam, tws::radians(elevation_deg)), 2) / std::pow(range, 4);
  };
  EXPECT_NEAR(signal(30.0) / signal(6.0), 1.0, 1e-9);
  EXPECT_EQ(elevationGain(beam, tws::radians(41.0)), 0.0);
}

// A 3-D set in search looks with two beams; a target between them is seen by the nearer one, once.
TEST(TwoBeams, GiveEachTargetItsBetterBeam) {
  RadarParams radar = freeSpaceRadar();
  const ElevationBeam low{tws::radians(1.0), tws::radians(2.0), 0.0};
  const ElevationBeam high{tws::radians(4.0), tws::radians(2.0), 0.0};
  radar.beams = {low, high};
  const double both = meanSnr(radar, 1.0, 50e3, 3500.0);  // at 3.8°
  radar.beams = {high};
  EXPECT_DOUBLE_EQ(both, meanSnr(radar, 1.0, 50e3, 3500.0));
}

TEST(NoiseSigma, IsTheFloorUnlessItDependsOnTheSignal) {
  RadarParams radar;
  EXPECT_DOUBLE_EQ(noiseSigma(radar, 100.0, 150.0, 2.0), 100.0);
  radar.snr_dependent_noise = true;
  EXPECT_NEAR(noiseSigma(radar, 30.0, 128.0, 2.0), 50.0, 1e-9);  // hypot(30, 128 / (1.6 · 2)) = hypot(30, 40)
}

TEST(RangeCell, OfAMicrosecondIs150Metres) { EXPECT_NEAR(rangeCell(RadarParams{}), 149.9, 0.01); }

}  // namespace
}  // namespace radar_sim

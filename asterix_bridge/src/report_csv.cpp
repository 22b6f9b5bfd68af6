#include "report_csv.h"

#include <cmath>
#include <cstdio>
#include <ostream>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

std::string number(double value, const char* format) {
  if (std::isnan(value)) return "";
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}
std::string exact(double value) { return number(value, "%.12g"); }
std::string nauticalMiles(double metres) { return exact(tws::nauticalMilesFromMetres(metres)); }
std::string degrees(double radians) { return exact(tws::degrees(radians)); }

std::string octal(const ModeCode& code) {
  char text[8] = "";
  if (code.present) std::snprintf(text, sizeof text, "%04o", code.value);
  return text;
}

std::string hex(std::optional<std::uint32_t> address) {
  char text[12] = "";
  if (address) std::snprintf(text, sizeof text, "%06X", *address);
  return text;
}

/// V, G and L as three digits.
std::string bits(const ModeCode& code) {
  if (!code.present) return "";
  return std::string(code.validated ? "0" : "1") + (code.garbled ? "1" : "0") + (code.smoothed ? "1" : "0");
}
std::string bits(const FlightLevel& level) {
  if (!level.present) return "";
  return std::string(level.validated ? "0" : "1") + (level.garbled ? "1" : "0");
}

template <class Reply>
bool isSound(const Reply& reply) {
  return reply.validated && !reply.garbled;
}

class Line {
 public:
  explicit Line(std::ostream& out) : out_(out) {}
  ~Line() { out_ << '\n'; }
  Line& operator<<(const std::string& text) {
    out_ << (first_ ? "" : ",") << text;
    first_ = false;
    return *this;
  }
  Line& operator<<(int value) { return *this << std::to_string(value); }

 private:
  std::ostream& out_;
  bool first_ = true;
};

}  // namespace

std::string radarName(SourceId source) {
  return "radar_" + std::to_string(source.sac) + "_" + std::to_string(source.sic);
}

PlotCsv::PlotCsv(std::ostream& out, std::map<SourceId, double> periods) : out_(out), periods_(std::move(periods)) {
  out_ << "t_s,radar,scan,range_m,az_deg,mode3a,fl,address,callsign,track\n";
}

long PlotCsv::scanOf(const TargetReport& report, double time) {
  Turns& turns = turns_[*report.source];
  if (!turns.started) turns.unwrapped = report.azimuth;
  const double further = turns.started ? tws::angularDifference(report.azimuth, turns.azimuth) : 0.0;
  const auto period = periods_.find(*report.source);
  double whole = 0.0;  // turns between the two
  if (turns.started && period != periods_.end())
    whole = std::round((time - turns.time) / period->second - further / tws::kTwoPi);
  turns.unwrapped += further + whole * tws::kTwoPi;
  turns.started = true;
  turns.time = time;
  turns.azimuth = report.azimuth;
  return std::lround(std::floor(turns.unwrapped / tws::kTwoPi));
}

void PlotCsv::add(const TargetReport& report, double time) {
  if (std::isnan(time) || std::isnan(report.range) || !report.source || !(report.primary || report.secondary)) {
    ++left_out_;
    return;
  }
  if (!start_) start_ = time;
  ++count_;
  Line(out_) << number(time - *start_, "%.4f") << radarName(*report.source) << std::to_string(scanOf(report, time))
             << number(report.range, "%.1f") << number(tws::degrees(report.azimuth), "%.4f")
             << (isSound(report.mode_3a) ? octal(report.mode_3a) : "")
             << (isSound(report.flight_level) ? exact(report.flight_level.level_100ft) : "")
             << hex(report.aircraft_address) << report.callsign.data()
             << (report.track_number ? std::to_string(*report.track_number) : "");
}

RecordCsv::RecordCsv(std::ostream& out) : out_(out) {
  out_ << "category,sac,sic,type,is_track,time,time_of_day,rho_nm,theta_deg,x_nm,y_nm,mode3a,mode3a_vgl,mode2,mode1,"
          "fl,fl_vg,address,callsign,track,speed_nm_s,heading_deg,doppler_m_s,height_3d_ft,power_dbm,sim,test,spi,rab,"
          "srl_deg,srr,sam_dbm,prl_deg,pam_dbm,rpd_nm,apd_deg,i001_130,sector_deg,period_s,lat_deg,lon_deg,height_m,"
          "nogo\n";
}

void RecordCsv::add(const TargetReport& r, double time) {
  const PlotCharacteristics& c = r.characteristics;
  Line line(out_);
  line << r.category << r.source->sac << r.source->sic << r.type << r.is_track << number(time, "%.7f")
       << exact(r.time_of_day) << nauticalMiles(r.range) << degrees(r.azimuth) << nauticalMiles(r.x)
       << nauticalMiles(r.y) << octal(r.mode_3a) << bits(r.mode_3a) << octal(r.mode_2) << octal(r.mode_1)
       << exact(r.flight_level.level_100ft) << bits(r.flight_level) << hex(r.aircraft_address) << r.callsign.data()
       << (r.track_number ? std::to_string(*r.track_number) : "") << nauticalMiles(r.ground_speed) << degrees(r.heading)
       << exact(r.range_rate) << exact(tws::feetFromMetres(r.height_3d)) << exact(r.received_power_dbm) << r.simulated
       << r.test_target << r.special_identification << r.fixed_transponder;
  line << degrees(c.ssr_run_length) << exact(c.ssr_replies) << exact(c.ssr_amplitude_dbm)
       << degrees(c.primary_run_length) << exact(c.primary_amplitude_dbm) << nauticalMiles(c.primary_less_ssr_range)
       << degrees(c.primary_less_ssr_azimuth) << r.raw_characteristics;
  for (int i = 0; i < 6; ++i) line << "";
}

void RecordCsv::add(const ServiceMessage& m, double time) {
  Line line(out_);
  line << m.category << m.source->sac << m.source->sic << m.type << "" << number(time, "%.7f") << exact(m.time_of_day);
  for (int i = 0; i < 30; ++i) line << "";
  line << degrees(m.sector_azimuth) << exact(m.antenna_period);
  if (m.position)
    line << degrees(m.position->latitude) << degrees(m.position->longitude) << exact(m.position->altitude);
  else
    line << ""
         << ""
         << "";
  line << (m.is_operational ? (*m.is_operational ? "0" : "1") : "");
}

}  // namespace asterix_bridge

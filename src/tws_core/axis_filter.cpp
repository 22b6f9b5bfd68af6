#include <tws_core/axis_filter.h>

#include <functional>
#include <map>

#include <tws_core/axis_checks.h>

namespace tws {
namespace {

using Choice = std::variant<FixedGainFilter, AdaptiveAlphaBeta, FixedMemoryFilter, AxisKalman<2>, AxisKalman<3>>;
using Make = std::function<Choice(const AxisFilterParams&)>;
using P = AxisFilterParams;

const std::map<std::string, Make>& makers() {
  static const std::map<std::string, Make> table{
      {"alpha",
       [](const P& p) {
         return FixedGainFilter::withGains({p.alpha, 0.0, 0.0});
       }},
      {"alpha_beta",
       [](const P& p) {
         return FixedGainFilter::withGains({p.alpha, p.beta, 0.0});
       }},
      {"alpha_beta_gamma",
       [](const P& p) {
         return FixedGainFilter::withGains({p.alpha, p.beta, p.gamma});
       }},
      {"alpha_index", [](const P&) { return FixedGainFilter::byTrackingIndex(0); }},
      {"alpha_beta_index", [](const P&) { return FixedGainFilter::byTrackingIndex(1); }},
      {"alpha_beta_gamma_index", [](const P&) { return FixedGainFilter::byTrackingIndex(2); }},
      {"adaptive_alpha_beta", [](const P& p) { return AdaptiveAlphaBeta(p.adaptive); }},
      {"kalman_cv", [](const P&) { return AxisKalman<2>(); }},
      {"kalman_ca", [](const P&) { return AxisKalman<3>(); }},
      {"fixed_memory", [](const P& p) { return FixedMemoryFilter(p.degree, p.length); }},
      {"expanding_memory", [](const P& p) { return FixedGainFilter::expandingMemory(p.degree); }},
      {"fading_memory", [](const P& p) { return FixedGainFilter::fadingMemory(p.degree, p.theta); }}};
  return table;
}

Choice make(const AxisFilterParams& params) {
  const auto found = makers().find(params.kind);
  if (found == makers().end()) throw std::invalid_argument("there is no filter '" + params.kind + "'");
  if (params.kind == "alpha_beta") requireNumber(params.beta != 0.0, "beta", params.beta, "above 0");
  if (params.kind == "alpha_beta_gamma") requireNumber(params.gamma != 0.0, "gamma", params.gamma, "above 0");
  return found->second(params);
}

}  // namespace

const std::vector<std::string>& axisFilterKinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names;
    for (const auto& [name, maker] : makers()) names.push_back(name);
    return names;
  }();
  return kinds;
}

AxisFilter::AxisFilter(const AxisFilterParams& params) : filter_(make(params)) {}

AxisFilter::State AxisFilter::start(double position, const AxisNoise& noise) const {
  return std::visit([&](const auto& filter) -> State { return filter.start(position, noise); }, filter_);
}

AxisMotion AxisFilter::motion(const State& state) {
  struct {
    AxisMotion operator()(const FixedGainState& s) const { return FixedGainFilter::motion(s); }
    AxisMotion operator()(const AlphaBetaState& s) const { return AdaptiveAlphaBeta::motion(s); }
    AxisMotion operator()(const FixedMemoryState& s) const { return FixedMemoryFilter::motion(s); }
    AxisMotion operator()(const AxisKalmanState<2>& s) const { return AxisKalman<2>::motion(s); }
    AxisMotion operator()(const AxisKalmanState<3>& s) const { return AxisKalman<3>::motion(s); }
  } of;
  return std::visit(of, state);
}

void AxisFilter::update(State& state, double innovation, double dt, const AxisNoise& noise) const {
  std::visit(
      [&](const auto& filter) {
        using Filter = std::decay_t<decltype(filter)>;
        filter.update(std::get<typename Filter::State>(state), innovation, dt, noise);
      },
      filter_);
}

}  // namespace tws

#include "secondary_radar.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <tws_core/angles.h>

#include "propagation.h"
#include "reported_place.h"

namespace radar_sim {
namespace {

using ModeOf = std::function<Mode(std::int64_t interrogation)>;
using Replies = std::array<std::vector<DecodedReply>, kModes>;

/// All replies of a group, by mode.
Replies repliesOf(const ReplyGroup& group, const ModeOf& mode_of) {
  std::int64_t first = group.members.front()->first_interrogation, end = first;
  for (const Illumination* member : group.members) {
    first = std::min(first, member->first_interrogation);
    end = std::max(end, member->endOfInterrogations());
  }
  Replies replies;
  for (std::int64_t interrogation = first; interrogation < end; ++interrogation) {
    const Mode mode = mode_of(interrogation);
    if (const auto reply = decodeReply(group, interrogation, mode)) replies[index(mode)].push_back(*reply);
  }
  return replies;
}

/// In the middle between those that look like one, with the first one's errors and no codes yet.
SecondaryPlot placeOf(const ReplyGroup& group) {
  const Illumination& own = *group.members.front();
  SecondaryPlot plot{own.time, own.range + own.range_error, own.azimuth + own.azimuth_error, {}};
  const double share = 1.0 / static_cast<double>(group.members.size());
  for (const Illumination* member : group.members) {
    plot.time += share * (member->time - own.time);
    plot.range += share * (member->range - own.range);
    plot.azimuth += share * tws::angularDifference(member->azimuth, own.azimuth);
  }
  return plot;
}

/// Nothing when the replies are too few.
std::optional<SecondaryPlot> plotOf(const ReplyGroup& group, const SecondaryParams& params, const ModeOf& mode_of) {
  const Replies replies = repliesOf(group, mode_of);
  std::size_t count = 0;
  for (const auto& of_mode : replies) count += of_mode.size();
  if (static_cast<long>(count) < params.needed_replies) return std::nullopt;
  SecondaryPlot plot = placeOf(group);
  for (std::size_t mode = 0; mode < kModes; ++mode)
    plot.readings[mode] = readCode(replies[mode], params.needed_code_replies);
  return plot;
}

}  // namespace

SecondaryRadar::SecondaryRadar(SecondaryParams params, const Eigen::Isometry3d& map_to_site,
                               const std::vector<Target>& targets, std::vector<Fault> faults, std::uint64_t seed,
                               double start_time)
    : params_(std::move(params)),
      map_to_antenna_(params_.errors.toAntenna(map_to_site)),
      targets_(targets),
      faults_(std::move(faults)),
      seed_(seed),
      start_time_(start_time),
      mast_(params_.rotation_period, params_.start_azimuth, params_.time_lsb, start_time, params_.errors),
      crossings_(
          mast_.antenna(), targets, [this](std::size_t target, double time) { return polarOf(target, time).azimuth; },
          start_time) {
  for (const Target& target : targets) target_streams_.push_back(RandomStream::hash(params_.name + "/" + target.name));
}

SecondarySector SecondaryRadar::closeSector() {
  const SectorSpan span = mast_.closeSector();
  const double until = antenna().entryTime(mast_.nextSector());
  // A group that begins in this sector may go on for one beam's time, and those that garble it for two.
  while (const auto crossing = crossings_.next(until + 2.0 * beamTime())) illuminate(*crossing);
  extract(until);
  drawFruit(span.running);
  return {span, takePlots(span, until)};
}

bool SecondaryRadar::isInCover(double range, double height) const {
  return range >= params_.min_range && range <= params_.max_range &&
         !isBeyondHorizon(params_.antenna_height, height, range);
}

tws::Polar SecondaryRadar::polarOf(std::size_t target, double time) const {
  return tws::polarFromEnu(map_to_antenna_ * targets_[target].trajectory->at(time).position);
}

Mode SecondaryRadar::modeOf(std::int64_t interrogation) const {
  return params_.interlace[static_cast<std::size_t>(interrogation) % params_.interlace.size()];
}

std::int64_t SecondaryRadar::firstInterrogationAfter(double time) const {
  const double count = std::ceil((time - start_time_) * params_.interrogation_rate);
  return std::max<std::int64_t>(0, std::llround(count));
}

void SecondaryRadar::illuminate(const BeamCrossings::Crossing& crossing) {
  const Target& target = targets_[crossing.target];
  const tws::Polar polar = polarOf(crossing.target, crossing.time);
  const double height = target.trajectory->at(crossing.time).height;
  if (isBlindAt(crossing.time) || target.transponder.isSilentAt(crossing.time) || !isInCover(polar.range, height))
    return;
  Illumination it;
  it.time = crossing.time;
  it.range = polar.range + params_.errors.delayOf(params_.antenna_height, height, polar.range);
  it.azimuth = polar.azimuth;
  for (const Mode mode : {Mode::k1, Mode::k2, Mode::k3A, Mode::kC})
    it.codes[index(mode)] = target.transponder.reply(mode, height);
  const double turns = (antenna().angleAt(crossing.time) - polar.azimuth) / tws::kTwoPi;
  RandomStream random(seed_, target_streams_[crossing.target], static_cast<std::uint64_t>(std::lround(turns)));
  drawReplies(it, random);
  illuminations_.push_back(std::move(it));
}

void SecondaryRadar::drawReplies(Illumination& it, RandomStream& random) const {
  std::normal_distribution<> error;
  it.range_error = params_.range_sigma * error(random);
  it.azimuth_error = params_.azimuth_sigma * error(random);
  it.first_interrogation = firstInterrogationAfter(it.time - beamTime() / 2.0);
  const std::int64_t end = firstInterrogationAfter(it.time + beamTime() / 2.0);
  std::bernoulli_distribution is_missed(params_.missed_reply_probability);
  for (std::int64_t i = it.first_interrogation; i < end; ++i) it.received.push_back(!is_missed(random));
}

void SecondaryRadar::extract(double until) {
  const auto mode = [this](std::int64_t interrogation) { return modeOf(interrogation); };
  while (const auto group = takeGroup(illuminations_, until, params_.azimuth_beamwidth))
    if (const auto plot = plotOf(*group, params_, mode)) extracted_.push_back(*plot);
  while (!illuminations_.empty() && illuminations_.front().time < until - beamTime()) illuminations_.pop_front();
}

// One aircraft that another interrogator asks: what it replies is taken for a reply in the mode just asked for.
void SecondaryRadar::drawFruit(std::int64_t sector) {
  const double enter = antenna().entryTime(sector);
  const double leave = antenna().entryTime(sector + 1);
  const double mean = params_.fruit_plots_per_scan * (leave - enter) / params_.rotation_period;
  if (mean <= 0.0) return;
  RandomStream random(seed_, params_.name + "/fruit", static_cast<std::uint64_t>(sector));
  std::uniform_real_distribution<> when(enter, leave), how_far(params_.min_range, params_.max_range);
  for (int left = std::poisson_distribution<>(mean)(random); left > 0; --left) {
    const double time = when(random);
    SecondaryPlot plot{time, how_far(random), antenna().azimuthAt(time), {}};
    const Mode mode = modeOf(firstInterrogationAfter(time));
    plot.readings[index(mode)].code = static_cast<Code>(std::uniform_int_distribution<>(0, kAllPulses)(random));
    if (!isBlindAt(time)) extracted_.push_back(plot);
  }
}

std::vector<SecondaryPlot> SecondaryRadar::takePlots(const SectorSpan& span, double until) {
  const auto isEarlier = [](const SecondaryPlot& a, const SecondaryPlot& b) { return a.time < b.time; };
  std::stable_sort(extracted_.begin(), extracted_.end(), isEarlier);
  const auto isDue = [until](const SecondaryPlot& plot) { return plot.time < until; };
  const auto due = std::partition_point(extracted_.begin(), extracted_.end(), isDue);
  std::vector<SecondaryPlot> plots;
  for (auto plot = extracted_.begin(); plot != due; ++plot) plots.push_back(measured(*plot, span));
  extracted_.erase(extracted_.begin(), due);
  return plots;
}

SecondaryPlot SecondaryRadar::measured(SecondaryPlot plot, const SectorSpan& span) const {
  const ReportedPlace place(params_.errors.rangeMeasured(plot.range),
                            antenna().measured(plot.azimuth, plot.time) + params_.beam_offset, params_.range_lsb,
                            params_.azimuth_lsb);
  plot.time = mast_.stampWithin(span, plot.time);
  plot.range = place.range;
  plot.azimuth = place.azimuth;
  return plot;
}

}  // namespace radar_sim

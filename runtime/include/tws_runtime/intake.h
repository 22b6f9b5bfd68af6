#pragma once

#include <ros/time.h>
#include <tws_core/sectors.h>
#include <tws_runtime/bus.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace tws_runtime {

/// Where a message came from, for the end of a sentence: " in /ssr/plots at 12.300000 s".
std::string whereText(const std::string& topic, ros::Time stamp);

/// Why a message's sector and running number contradict each other; empty: they do not.
template <class M>
std::string sectorFault(const M& message) {
  if (message.sector == message.running_sector % tws::kSectors) return "";
  return "sector " + std::to_string(message.sector) + " with running number " + std::to_string(message.running_sector);
}

/// Which stamps of one topic may follow each other.
enum class StampOrder {
  kAny,          ///< Late data of the run is taken; who cares sorts it (tws::TimeOrder).
  kNotBackward,  ///< A stamp before the newest one of the topic is late.
  kForward       ///< One that is not after it, too.
};

/// What a node wants of one topic.
template <class M>
struct IntakeTopic {
  std::string name;
  std::string radar = {};  ///< The name that its messages should bear; empty: it does not matter.
  StampOrder order = StampOrder::kAny;
  std::function<std::string(const M&)> fault = {};  ///< Why a message cannot be used; empty: it can.
  std::function<ros::Time(const M&)> stamp = {};    ///< By default header.stamp.
};

/// The door through which a node takes the messages of its sensors and trackers. What passes bears the right name, has
/// no fault, and its stamp belongs to the run; all else is counted with topic and stamp, and costs no track:
///
/// - "bad messages": another radar's, or with a fault. Under a remapped topic a radar may have another name than the
///   node was told: the one that its publisher uses counts, and is kept until three messages in a row bear another one.
/// - "stray messages": the stamp is out of line (tws::RunGuard over all topics of the intake; topics of one radar are
///   one source). Such messages are held back, at most 512 of a topic, and given when enough others agree with them:
///   then "new runs" or "pauses" is counted.
/// - "set aside" and "joined again": a topic's clock contradicts the other sources', and agrees with them again.
/// - "messages of a second publisher": of another time, between those of the topic, again and again.
/// - "backlogs": a topic goes on where it was, far behind the others. What it brings is taken.
/// - "late messages": see StampOrder.
///
/// One bad stamp, a day ahead or a day back, in one message or in a detection and its mark together, is thus left out.
/// A bag that is played again begins a new run after a second, and nothing of that second is lost.
class Intake {
 public:
  /// A new run begins at this time [s]: forget the old one. What was held back of the new one is given next.
  using OnNewRun = std::function<void(double time)>;

  /// `restart_limit` [s], > 0: a smaller step back is late data of the same run. `skew_limit` [s], > 0: a radar that
  /// steps this far from the others is set aside already.
  Intake(Bus& bus, double restart_limit, OnNewRun on_new_run = {},
         double skew_limit = std::numeric_limits<double>::infinity());
  ~Intake();

  template <class M>
  void subscribe(IntakeTopic<M> topic, std::function<void(const M&)> on_message) {
    const std::size_t stream = addTopic(topic.name, topic.radar, topic.order);
    const std::string name = topic.name;
    bus_.subscribe<M>(name,
                      [this, stream, topic = std::move(topic), on_message = std::move(on_message)](const M& message) {
                        const ros::Time stamp = topic.stamp ? topic.stamp(message) : message.header.stamp;
                        if (!isFrom(stream, nameOf(message), stamp)) return;
                        const std::string fault = topic.fault ? topic.fault(message) : std::string();
                        if (!fault.empty()) return refuse(stream, fault, stamp);
                        if (judge(stream, stamp)) return on_message(message);
                        if (isHeld(stream)) hold(stream, stamp, [on_message, message] { on_message(message); });
                      });
  }

  /// Is what was held back being given just now? Then much comes at once, however fast the receiver is.
  bool isReleasing() const;
  /// The name that the publisher of a topic uses; before its first message, the one expected.
  const std::string& radarOf(const std::string& topic) const;

 private:
  template <class M, class = void>
  struct HasRadar : std::false_type {};
  template <class M>
  struct HasRadar<M, std::void_t<decltype(std::declval<M>().radar)>> : std::true_type {};
  template <class M>
  static std::string nameOf(const M& message) {
    if constexpr (HasRadar<M>::value)
      return message.radar;
    else
      return "";
  }

  std::size_t addTopic(const std::string& name, const std::string& radar, StampOrder order);
  bool isFrom(std::size_t stream, const std::string& name, ros::Time stamp);
  void refuse(std::size_t stream, const std::string& fault, ros::Time stamp);
  bool judge(std::size_t stream, ros::Time stamp);
  bool isHeld(std::size_t stream) const;
  void hold(std::size_t stream, ros::Time stamp, std::function<void()> give);

  Bus& bus_;
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tws_runtime

// Owner of one radio channel's air: half duplex, no carrier sense, no repetition by the modules. It polls, the vehicles
// answer in their slots; nothing is sent while an answer may be under way. Sans-IO: bytes and time in, bytes and events
// out; the bytes of one output are one frame and are to be written in one go.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "link/air_timing.h"
#include "link/link_event.h"
#include "link/nonce.h"
#include "link/peer.h"
#include "link/schedule.h"

namespace tessera::link {

struct ChannelConfig {
  struct Vehicle {
    VehicleId id;
    wire::Key key{};                     ///< long-term
    std::optional<wire::Key> offered{};  ///< another one that it may have by now: a pairing whose end was never heard
  };
  double airRate = 19200;  ///< bit/s
  int baud = 115200;       ///< between host and module
  std::vector<Vehicle> vehicles;
  std::uint64_t nonceSeed = 1;
  Seconds idlePeriod{0.2};   ///< between Cycles while no vehicle shall drive
  Seconds silentAfter{1.0};  ///< without answers; longer where the channel is slow
};

class Channel {
public:
  explicit Channel(const ChannelConfig& config);

  /// The port is open (again): nothing is under way, sessions are taken up where they were.
  void opened(Seconds now);
  /// Nothing can be sent until opened().
  void closed();
  /// Bytes from the port; now: when the last of them came.
  void ingest(wire::Bytes bytes, Seconds now);
  /// What was heard since it was last asked; what is not fetched here comes with the next poll().
  [[nodiscard]] std::vector<LinkEvent> heard() { return std::exchange(events_, {}); }
  /// What a vehicle shall do from its next Cycle on. Unknown vehicles are ignored.
  void wish(VehicleId vehicle, const Wish& wish);
  /// Queues a request. Get and Set are repeated twice if unanswered, Do is not, as it might be done twice.
  /// False: unknown vehicle, or 32 wait already.
  bool request(VehicleId vehicle, const wire::Request& request);
  /// Queues the giving of another long-term key; PairingEnded tells how it ended. Whoever asks keeps the new key in a
  /// safe place first: once it has been sent, the vehicle may have it. False: as request(), or the vehicle is not
  /// connected, or a pairing is under way.
  bool pair(VehicleId vehicle, const wire::Key& fresh);

  struct Output {
    std::vector<std::uint8_t> bytes;  ///< one frame, or none
    std::vector<LinkEvent> events;
    Seconds wake{kNever};  ///< poll again at this instant at the latest
  };
  [[nodiscard]] Output poll(Seconds now);
  /// True when a frame could leave now: nothing is under way.
  [[nodiscard]] bool idle(Seconds now) const;

  /// Smoothed time between two commands to the same vehicle; an estimate before there were any.
  [[nodiscard]] Seconds cyclePeriod() const;
  /// When a command sent now takes effect on the vehicle.
  [[nodiscard]] Seconds effectiveAt(Seconds now) const;
  [[nodiscard]] const AirTiming& timing() const { return timing_; }
  [[nodiscard]] const wire::FrameDecoder::Counters& counters() const { return decoder_.counters(); }
  /// Nullptr: unknown vehicle.
  [[nodiscard]] const Peer* peer(VehicleId vehicle) const;

private:
  struct Answer {
    std::size_t peer = 0;
    Seconds deadline;
    bool came = false;
  };
  /// The frame that is on the air, or whose answers are awaited.
  struct Flight {
    Turn::Kind kind = Turn::Kind::Nothing;
    std::uint32_t counter = 0;
    std::array<Answer, wire::kMaxCycleEntries> answers{};
    std::size_t count = 0;
  };
  struct Pending {
    std::size_t peer = 0;
    wire::Request request;
    unsigned tries = 0;
    std::optional<wire::Key> newKey;  ///< a Pair; `request` is not looked at
  };
  /// A frame that went out lately, to time its answers even when they are late.
  struct Departure {
    std::uint32_t counter = 0;
    Seconds at;
    std::size_t bytes = 0;
  };

  [[nodiscard]] std::optional<std::size_t> indexOf(VehicleId vehicle) const;
  void hear(const wire::Frame& frame);
  void hearReport(std::size_t index, const wire::Report& report, std::size_t frameBytes);
  void hearIdentity(std::size_t index, const HeardIdentity& heard, std::size_t frameBytes);
  void cameUnlessCalled(std::size_t index);
  void timeCall(Peer& peer, std::uint32_t nonce, std::size_t frameBytes);
  void hearHail(std::size_t index, const HeardHail& heard);
  void hearValue(std::size_t index, const wire::Value& value);
  void hearPairing(std::size_t index);
  void disbelieve(std::size_t index, Disbelief why);
  void came(std::size_t index, std::optional<std::uint16_t> ack);
  void tellNoise();
  [[nodiscard]] Seconds staleAt() const;
  [[nodiscard]] Seconds flightEnd() const;
  void settle(Seconds now);
  void closeFlight();
  void watchSilence(Seconds now);
  void dropHopelessRequests();
  void closeRequest();
  void unanswered(const Pending& pending);
  std::size_t sendCall(const Turn& turn, Seconds now, std::span<std::uint8_t> out);
  std::size_t sendCycle(const Turn& turn, Seconds now, std::span<std::uint8_t> out);
  std::size_t sendRequest(Seconds now, std::span<std::uint8_t> out);
  void departed(Turn::Kind kind, std::span<const std::size_t> peers, std::size_t bytes, Seconds slot, Seconds now);

  std::vector<Peer> peers_;
  AirTiming timing_;
  Schedule schedule_;
  NonceSource nonces_;
  Seconds silentAfter_;
  wire::FrameDecoder decoder_;
  wire::FrameDecoder::Counters told_;
  std::uint32_t foreign_ = 0;
  std::uint32_t counter_ = 0;
  std::optional<Flight> flight_;
  std::deque<Pending> requests_;
  std::array<Departure, 16> departures_{};
  std::size_t departureCount_ = 0;
  std::optional<Seconds> period_;
  Seconds lastByte_{-1e9};
  bool open_ = false;
  std::vector<LinkEvent> events_;
};

}  // namespace tessera::link

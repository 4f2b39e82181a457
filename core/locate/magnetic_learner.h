// What one vehicle's compass teaches of the floor while its place is known: a Kalman filter of the compass' error, of
// what of it belongs to the vehicle, and of the map's nodes within the last half metre. A node that is left behind is
// handed to the map, as what these visits told apart from what the map had said before.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "locate/locator.h"
#include "locate/magnetic_map.h"

namespace tessera::locate {

class MagneticLearner {
public:
  /// One report of the vehicle: the estimate by its motion alone, and with the tags that it told of. What lies between
  /// them is news; the rest was believed before, and teaches nothing.
  void take(const Estimate& moved, const Estimate& known, const MagneticMap& map);
  /// The place was lost or the vehicle was lifted: what was not handed over yet may be wrong.
  void interrupt();
  /// And the compass is another (calibrated, restarted).
  void restart();
  /// Hands over what is left behind. To be called when nobody reads the map. True: something.
  bool teach(MagneticMap& map);

  [[nodiscard]] const OwnDeviation& own() const { return own_; }

private:
  struct Node {
    MagneticNode node;
    double mean = 0.0;  ///< as the map had it when it was taken up
    double variance = 0.0;
    double way = 0.0;  ///< odometer when it last mattered
  };
  struct Lesson {
    MagneticNode node;
    double deviation = 0.0;
    double variance = 0.0;
  };

  void begin(const Estimate& known);
  void move(const Estimate& from, const Estimate& to, const MagneticMap& map);
  void note(const Estimate& moved, const Estimate& known);
  void correct();
  void leaveBehind(double before);
  Eigen::Index indexOf(MagneticNode node, const MagneticMap& map);
  void drop(Eigen::Index index);

  OwnDeviation own_;
  std::optional<Estimate> last_;
  // State: the compass' error, of it the vehicle's own part, then one for each node in use.
  Eigen::VectorXd state_;
  Eigen::MatrixXd covariance_;
  std::vector<Node> nodes_;
  double way_ = 0.0;          ///< m, since it began
  double correctedAt_ = 0.0;  ///< of it, when news was last taken in
  double information_ = 0.0;  ///< rad⁻², news since then ...
  double weighted_ = 0.0;     ///< ... and that times what they say
  std::vector<Lesson> lessons_;
};

}  // namespace tessera::locate

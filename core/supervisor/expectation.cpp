#include "supervisor/expectation.h"

#include <vector>

namespace tessera::supervisor {

Expectation expectedOver(const drive::VehicleState& known, std::span<const CommandHistory::Case> cases, Seconds until,
                         const drive::VehicleAbility& ability) {
  Expectation expected{drive::predict(known, cases.front().commands, until, ability)};
  if (cases.size() == 1) return expected;
  // As differences from the first case: headings are means along the shorter way round.
  const drive::VehicleState first = expected.state;
  std::vector<Eigen::Vector2d> away{Eigen::Vector2d::Zero()};
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  double turn = 0.0;
  double speed = cases.front().chance * first.speed.value();
  for (const CommandHistory::Case& one : cases.subspan(1)) {
    const drive::VehicleState s = drive::predict(known, one.commands, until, ability);
    const Offset off = s.pose.position - first.pose.position;
    away.emplace_back(off.x.value(), off.y.value());
    mean += one.chance * away.back();
    turn += one.chance * turnBetween(first.pose.heading, s.pose.heading).value();
    speed += one.chance * s.speed.value();
  }
  for (std::size_t i = 0; i < away.size(); ++i)
    expected.spread += cases[i].chance * (away[i] - mean) * (away[i] - mean).transpose();
  expected.state.pose.position = first.pose.position + Offset{Metres{mean.x()}, Metres{mean.y()}};
  expected.state.pose.heading = wrapped(first.pose.heading + Radians{turn});
  expected.state.speed = MetresPerSecond{speed};
  return expected;
}

Eigen::Matrix3d rolledOn(const locate::Estimate& from, Offset way) {
  Eigen::Matrix4d known = Eigen::Matrix4d::Zero();
  known.topLeftCorner<3, 3>() = from.covariance;
  known.col(3) = from.scale;
  known.row(3) = from.scale.transpose();
  Eigen::Matrix<double, 3, 4> slope = Eigen::Matrix<double, 3, 4>::Identity();
  slope(0, 2) = -way.y.value();
  slope(1, 2) = way.x.value();
  slope(0, 3) = way.x.value();
  slope(1, 3) = way.y.value();
  return slope * known * slope.transpose();
}

}  // namespace tessera::supervisor

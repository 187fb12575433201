// Where the bodies of a robot are over time: positions change linearly from key to key, and rotations turn the shorter way
// at a steady pace.
import { Quaternion, Vector3 } from 'three'
import { POSE } from './data.js'

/** The last key that is not after `time` */
function keyBefore(times, time) {
  let low = 0
  let high = times.length - 1
  while (low < high) {
    const middle = (low + high + 1) >> 1
    if (times[middle] <= time) low = middle
    else high = middle - 1
  }
  return low
}

export class Motion {
  constructor(robot) {
    this.robot = robot
    this.bodies = robot.bodies.length
    this.nextPosition = new Vector3()
    this.nextQuaternion = new Quaternion()
  }

  /** Write the pose of a body at a time into a position and a quaternion. */
  poseAt(body, time, position, quaternion) {
    const { times, poses } = this.robot
    const before = keyBefore(times, time)
    const after = Math.min(before + 1, times.length - 1)
    const span = times[after] - times[before]
    const fraction = span > 0 ? Math.min(Math.max((time - times[before]) / span, 0), 1) : 0
    const from = (before * this.bodies + body) * POSE
    const to = (after * this.bodies + body) * POSE
    position.fromArray(poses, from).lerp(this.nextPosition.fromArray(poses, to), fraction)
    quaternion.fromArray(poses, from + 3).slerp(this.nextQuaternion.fromArray(poses, to + 3), fraction)
  }
}

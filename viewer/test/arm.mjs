// Where the links of a URDF file are, worked out anew: what the page shows of arms is compared with it.
import { readFileSync } from 'node:fs'
import { Matrix4, Quaternion, Euler, Vector3 } from 'three'

const attribute = (text, name) => text?.match(new RegExp(`\\b${name}="([^"]*)"`))?.[1]
const numbers = (text, ifNone) => (text === undefined ? ifNone : text.trim().split(/\s+/).map(Number))

/** For each link its pose in the frame of the arm's base: a function of joint values by name */
export function forwardKinematics(file) {
  const text = readFileSync(file, 'utf8').replace(/<!--[^]*?-->/g, '')
  const joints = [...text.matchAll(/<joint\s[^>]*>[^]*?<\/joint>/g)].map(([joint]) => {
    const element = (name) => joint.match(new RegExp(`<${name}\\s[^>]*>`))?.[0]
    const [roll, pitch, yaw] = numbers(attribute(element('origin'), 'rpy'), [0, 0, 0])
    return {
      name: attribute(joint, 'name'),
      type: attribute(joint, 'type'),
      parent: attribute(element('parent'), 'link'),
      child: attribute(element('child'), 'link'),
      axis: new Vector3(...numbers(attribute(element('axis'), 'xyz'), [1, 0, 0])),
      origin: new Matrix4()
        .makeRotationFromEuler(new Euler(roll, pitch, yaw, 'ZYX'))
        .setPosition(...numbers(attribute(element('origin'), 'xyz'), [0, 0, 0])),
    }
  })
  const byChild = new Map(joints.map((joint) => [joint.child, joint]))
  const poseOf = (link, base, values) => {
    const joint = byChild.get(link)
    if (!joint) return base.clone()
    const value = values[joint.name] ?? 0
    const motion = new Matrix4()
    if (joint.type === 'prismatic') motion.setPosition(joint.axis.clone().multiplyScalar(value))
    else if (joint.type !== 'fixed') motion.makeRotationFromQuaternion(new Quaternion().setFromAxisAngle(joint.axis, value))
    return poseOf(joint.parent, base, values).multiply(joint.origin).multiply(motion)
  }
  return poseOf
}

// Where the links of a URDF file are, worked out anew: what the page shows of arms is compared with it.
import { readFileSync } from 'node:fs'
import { Matrix4, Quaternion, Euler, Vector3 } from 'three'

const attribute = (text, name) => text?.match(new RegExp(`\\b${name}="([^"]*)"`))?.[1]
const numbers = (text, ifNone) => (text === undefined ? ifNone : text.trim().split(/\s+/).map(Number))

/** The pose that an element with xyz and rpy gives */
function poseOf(element) {
  const [roll, pitch, yaw] = numbers(attribute(element, 'rpy'), [0, 0, 0])
  return new Matrix4()
    .makeRotationFromEuler(new Euler(roll, pitch, yaw, 'ZYX'))
    .setPosition(...numbers(attribute(element, 'xyz'), [0, 0, 0]))
}

/** A function of a link, the pose of the arm's base and the values of joints by name: where the link's first shape is
    @param attached joints of bodies that the arm holds: name, type, parent, child, origin */
export function forwardKinematics(file, attached = []) {
  const text = readFileSync(file, 'utf8').replace(/<!--[^]*?-->/g, '')
  const element = (inside, name) => inside.match(new RegExp(`<${name}\\s[^>]*>`))?.[0]
  const joints = [...text.matchAll(/<joint\s[^>]*>[^]*?<\/joint>/g)].map(([joint]) => ({
    name: attribute(joint, 'name'),
    type: attribute(joint, 'type'),
    parent: attribute(element(joint, 'parent'), 'link'),
    child: attribute(element(joint, 'child'), 'link'),
    axis: new Vector3(...numbers(attribute(element(joint, 'axis'), 'xyz'), [1, 0, 0])),
    origin: poseOf(element(joint, 'origin')),
  }))
  const byChild = new Map([...joints, ...attached].map((joint) => [joint.child, joint]))
  const shapes = new Map(
    [...text.matchAll(/<link\s[^>]*>[^]*?<\/link>/g)].map(([link]) => [
      attribute(link, 'name'),
      poseOf(element(link.match(/<collision>[^]*?<\/collision>/)?.[0] ?? '', 'origin')),
    ]),
  )
  const frameOf = (link, base, values) => {
    const joint = byChild.get(link)
    if (!joint) return base.clone()
    const value = values[joint.name] ?? 0
    const motion = new Matrix4()
    if (joint.type === 'prismatic') motion.setPosition(joint.axis.clone().multiplyScalar(value))
    else if (joint.type !== 'fixed') motion.makeRotationFromQuaternion(new Quaternion().setFromAxisAngle(joint.axis, value))
    return frameOf(joint.parent, base, values).multiply(joint.origin).multiply(motion)
  }
  return (link, base, values) => frameOf(link, base, values).multiply(shapes.get(link) ?? new Matrix4())
}

// Geometries of the plan's shapes: solid ones for space, flat ones for the plane.
import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Matrix4,
  Quaternion,
  Shape,
  ShapeGeometry,
  SphereGeometry,
  Vector2,
  Vector3,
} from 'three'
import { toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js'
import { indices, unquantized, words } from './data.js'

/** Meshes of more triangles are shaded flatly: sharp edges of fine meshes are not worth the time to find them. */
const MOST_CREASED = 40000

const alongZ = (geometry) => geometry.rotateX(Math.PI / 2)

function meshGeometry(shape) {
  const geometry = new BufferGeometry()
  geometry.setAttribute('position', new BufferAttribute(unquantized(shape, words(shape.vertices)), 3))
  geometry.setIndex(new BufferAttribute(indices(shape.triangles, shape.indexBytes), 1))
  return geometry
}

function shaded(geometry) {
  if (geometry.index.count / 3 <= MOST_CREASED) return toCreasedNormals(geometry, Math.PI / 5)
  const flat = geometry.toNonIndexed()
  flat.computeVertexNormals()
  return flat
}

/** Makes each geometry once. A solid shape is a geometry and a scale, so that equal kinds share one. */
export class Shapes {
  constructor(plan) {
    this.shapes = plan.shapes
    // A robot that is a point would be invisible.
    this.least = 0.004 * plan.extent
    this.made = new Map()
  }

  once(key, make) {
    if (!this.made.has(key)) this.made.set(key, make())
    return this.made.get(key)
  }

  radiusOf(shape) {
    return Math.max(shape.radius, this.least)
  }

  /** The geometry of a shape in space, and how it is scaled along x, y and z */
  solid(index) {
    const shape = this.shapes[index]
    const { radius, length } = shape
    switch (shape.kind) {
      case 'ball':
        return { geometry: this.once('ball', () => alongZ(new SphereGeometry(1, 32, 20))), scale: Array(3).fill(this.radiusOf(shape)) }
      case 'box':
        return { geometry: this.once('box', () => new BoxGeometry(1, 1, 1)), scale: shape.size }
      case 'cylinder':
        return {
          geometry: this.once('cylinder', () => alongZ(new CylinderGeometry(1, 1, 1, 40))),
          scale: [radius, radius, length],
        }
      case 'capsule':
        return { geometry: this.once(index, () => alongZ(new CapsuleGeometry(radius, length, 10, 32))), scale: [1, 1, 1] }
      default:
        return { geometry: this.once(index, () => shaded(meshGeometry(shape))), scale: [1, 1, 1] }
    }
  }

  /** What a shape at a pose covers in the plane, and its edges: geometries at z = 0 */
  flat(index, pose) {
    const shape = this.shapes[index]
    const place = new Matrix4().compose(
      new Vector3().fromArray(pose),
      new Quaternion().fromArray(pose, 3),
      new Vector3(1, 1, 1),
    )
    const isMesh = shape.kind === 'mesh'
    const fill = isMesh ? meshGeometry(shape).toNonIndexed() : new ShapeGeometry(this.outline(shape, place), 32).toNonIndexed()
    const edges = new EdgesGeometry(fill, 25)
    for (const geometry of [fill, edges]) {
      if (isMesh || shape.kind === 'polygon') geometry.applyMatrix4(place)
      for (const name of ['normal', 'uv']) geometry.deleteAttribute(name)
      const positions = geometry.getAttribute('position')
      for (let i = 0; i < positions.count; ++i) positions.setZ(i, 0)
    }
    return { fill, edges }
  }

  /** A polygon in its own frame, a round shape in the frame that `place` leads to */
  outline(shape, place) {
    if (shape.kind === 'polygon') {
      const corner = (_, i) => new Vector2().fromArray(shape.points, 2 * i)
      return new Shape(Array.from({ length: shape.points.length / 2 }, corner))
    }
    const half = 0.5 * (shape.length ?? 0)
    const radius = this.radiusOf(shape)
    const from = new Vector3(0, 0, half).applyMatrix4(place)
    const to = new Vector3(0, 0, -half).applyMatrix4(place)
    const angle = half > 0 ? Math.atan2(from.y - to.y, from.x - to.x) : 0
    const outline = new Shape()
    outline.absarc(from.x, from.y, radius, angle - Math.PI / 2, angle + Math.PI / 2, false)
    outline.absarc(to.x, to.y, radius, angle + Math.PI / 2, angle + (3 * Math.PI) / 2, false)
    outline.closePath()
    return outline
  }
}

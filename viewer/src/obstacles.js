// Obstacles: bodies, occupied cells and points. Equal shapes are instances of one geometry.
import {
  BoxGeometry,
  BufferGeometry,
  CircleGeometry,
  Color,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  Group,
  IcosahedronGeometry,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Quaternion,
  Vector3,
} from 'three'
import { mergeGeometries } from 'three/examples/jsm/utils/BufferGeometryUtils.js'
import { POSE } from './data.js'
import { FLAT, isDark, look, ORDER } from './look.js'

/** Edges of more numbers are not drawn. */
const MOST_EDGES = 3e6

/** A pose and a scale along the axes as a matrix */
const matrixOf = (pose, scale) =>
  new Matrix4().compose(new Vector3().fromArray(pose), new Quaternion().fromArray(pose, 3), new Vector3().fromArray(scale))

export class Obstacles {
  constructor(plan, shapes) {
    this.group = new Group()
    this.materials = []
    if (plan.spatial) this.addSolid(plan, shapes)
    else this.addFlat(plan, shapes)
    for (const cells of plan.cells) this.addCells(plan, cells)
    for (const cloud of plan.clouds) this.addCloud(plan, cloud)
  }

  material(plan, color = look.obstacle) {
    const material = plan.spatial
      ? new MeshStandardMaterial({ color, roughness: 0.9, side: DoubleSide })
      : new MeshBasicMaterial({ color, side: DoubleSide, ...FLAT })
    this.materials.push(material)
    return material
  }

  addFlat(plan, shapes) {
    const fills = []
    const edges = []
    for (const { shape, poses } of plan.obstacles)
      for (let i = 0; i < poses.length; i += POSE) {
        const flat = shapes.flat(shape, poses.subarray(i, i + POSE))
        fills.push(flat.fill)
        edges.push(flat.edges)
      }
    if (fills.length === 0) return
    this.add(new Mesh(mergeGeometries(fills), this.material(plan)))
    this.add(new LineSegments(mergeGeometries(edges), new LineBasicMaterial({ color: look.edge, ...FLAT })))
  }

  addSolid(plan, shapes) {
    const instances = new Map()
    for (const { shape, poses } of plan.obstacles) {
      const { geometry, scale } = shapes.solid(shape)
      if (!instances.has(geometry)) instances.set(geometry, [])
      for (let i = 0; i < poses.length; i += POSE) instances.get(geometry).push(matrixOf(poses.subarray(i, i + POSE), scale))
    }
    const material = this.material(plan)
    const lines = []
    for (const [geometry, matrices] of instances) {
      this.addInstances(geometry, material, matrices)
      const edges = new EdgesGeometry(geometry, 30).getAttribute('position')
      if (lines.length + edges.count * 3 * matrices.length > MOST_EDGES) continue
      const point = new Vector3()
      for (const matrix of matrices)
        for (let i = 0; i < edges.count; ++i) lines.push(...point.fromBufferAttribute(edges, i).applyMatrix4(matrix))
    }
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new Float32BufferAttribute(lines, 3))
    this.add(new LineSegments(geometry, new LineBasicMaterial({ color: look.edge, transparent: true, opacity: 0.7 })))
  }

  addInstances(geometry, material, matrices, colors) {
    const mesh = new InstancedMesh(geometry, material, matrices.length)
    matrices.forEach((matrix, i) => mesh.setMatrixAt(i, matrix))
    colors?.forEach((color, i) => mesh.setColorAt(i, color))
    mesh.castShadow = mesh.receiveShadow = true
    this.add(mesh)
  }

  addCells(plan, { edge, origin, low, size }) {
    const matrices = []
    const colors = []
    for (let i = 0; i < low.length; i += 3) {
      const sizes = [0, 1, 2].map((axis) => edge * size[i + axis])
      const middle = [0, 1, 2].map((axis) => origin[axis] + edge * low[i + axis] + 0.5 * sizes[axis])
      if (!plan.spatial) middle[2] = 0
      // In space a little smaller than they are, however many are joined in one box: so one sees where one ends
      const gap = plan.spatial ? 0.015 * edge : 0
      matrices.push(new Matrix4().makeScale(...sizes.map((value) => value - gap)).setPosition(...middle))
      colors.push(this.colorAt(plan, middle[2]))
    }
    this.addInstances(new BoxGeometry(1, 1, 1), this.material(plan, '#ffffff'), matrices, colors)
  }

  addCloud(plan, { points, radius }) {
    const geometry = plan.spatial ? new IcosahedronGeometry(1, 0) : new CircleGeometry(1, 12)
    const size = Math.max(radius, 0.0015 * plan.extent)
    const matrices = []
    const colors = []
    for (let i = 0; i < points.length; i += 3) {
      matrices.push(new Matrix4().makeScale(size, size, size).setPosition(points[i], points[i + 1], points[i + 2]))
      colors.push(this.colorAt(plan, points[i + 2]))
    }
    this.addInstances(geometry, this.material(plan, '#ffffff'), matrices, colors)
  }

  /** Sensed worlds have colors by height: their parts alone do not show their shape. */
  colorAt(plan, z) {
    if (!plan.spatial) return new Color(look.obstacle)
    const height = Math.min(Math.max((z - plan.low[2]) / (plan.high[2] - plan.low[2]), 0), 1)
    return new Color().setHSL(0.6 - 0.42 * height, 0.22, (isDark() ? 0.36 : 0.5) + 0.22 * height)
  }

  add(object) {
    object.renderOrder = ORDER.obstacles
    this.group.add(object)
  }

  /** Let what is behind obstacles of space be seen, or not. */
  setSeeThrough(on) {
    for (const material of this.materials) {
      material.transparent = on || material.depthTest === false
      material.opacity = on ? 0.25 : 1
      material.depthWrite = !on && material.depthTest
      material.needsUpdate = true
    }
  }
}

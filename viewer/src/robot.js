// A robot: its bodies as they are now and at its goal, its path with marks at equal times, a trail of bodies there, the
// zones that it keeps out of, and its part of the planner's tree.
import {
  BufferGeometry,
  CanvasTexture,
  Color,
  DoubleSide,
  EdgesGeometry,
  Float32BufferAttribute,
  FrontSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  Points,
  PointsMaterial,
  Quaternion,
  Vector3,
} from 'three'
import { Line2 } from 'three/examples/jsm/lines/Line2.js'
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js'
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js'
import { POSE } from './data.js'
import { FLAT, isDark, ORDER } from './look.js'
import { Motion } from './motion.js'

/** Into how many parts the marks divide the time, and how many points a path is drawn with */
const MARKS = 12
const POINTS = 360

function discTexture() {
  const canvas = document.createElement('canvas')
  canvas.width = canvas.height = 64
  const context = canvas.getContext('2d')
  context.arc(32, 32, 30, 0, 2 * Math.PI)
  context.fillStyle = '#fff'
  context.fill()
  return new CanvasTexture(canvas)
}
let disc

/** The coordinates of the points at 0, 1 / parts, ..., 1 of a path */
const pointsAt = (parts, pointAt) => Array.from({ length: parts + 1 }, (_, i) => pointAt(i / parts)).flat()

export class Robot {
  constructor(plan, data, shapes) {
    Object.assign(this, { plan, data, shapes })
    this.name = data.name
    this.motion = new Motion(data)
    this.moves = plan.end > 0
    this.group = new Group()
    this.layers = {}
    this.materials = []
    this.flat = plan.spatial ? {} : FLAT
    this.color = new Color(data.color)
    // On a dark page dark colors need some light.
    if (isDark()) this.color.offsetHSL(0, 0, 0.06)

    this.bodies = this.makeBodies(this.bodyMaterial(), ORDER.robot)
    this.group.add(...this.bodies)
    this.addGoal()
    this.addLayer('zones', this.makeBody(data.zones, this.ghostMaterial(0.12), ORDER.zones, this.lineMaterial()))
    if (this.moves) this.addPath()
    if (data.tree.length > 0) this.addTree()
  }

  keep(material) {
    this.materials.push(material)
    return material
  }

  bodyMaterial() {
    return this.keep(
      this.plan.spatial
        ? new MeshStandardMaterial({ color: this.color, roughness: 0.55, metalness: 0.05 })
        : new MeshBasicMaterial({ color: this.color, side: DoubleSide, ...FLAT }),
    )
  }

  ghostMaterial(opacity) {
    const common = { color: this.color, transparent: true, opacity, depthWrite: false }
    return this.keep(new MeshBasicMaterial({ ...common, depthTest: this.plan.spatial, side: this.plan.spatial ? FrontSide : DoubleSide }))
  }

  /** For edges in the robot's color */
  lineMaterial() {
    return this.keep(new LineBasicMaterial({ color: this.color, ...this.flat, transparent: true, opacity: 0.32, depthWrite: false }))
  }

  edgeMaterial() {
    return new LineBasicMaterial({
      color: this.plan.spatial || isDark() ? '#000000' : '#202020',
      ...this.flat,
      transparent: true,
      opacity: this.plan.spatial ? 0.35 : 0.75,
    })
  }

  /** A group for each body, at the origin */
  makeBodies(material, order, edges = true) {
    const line = edges && this.edgeMaterial()
    return this.data.bodies.map((parts) => this.makeBody(parts, material, order, line))
  }

  makeBody(parts, material, order, line) {
    const body = new Group()
    for (const [shape, pose] of parts) {
      const objects = this.plan.spatial ? this.solidPart(shape, pose, material, line) : this.flatPart(shape, pose, material, line)
      for (const object of objects) object.renderOrder = order
      body.add(...objects)
    }
    return body
  }

  solidPart(shape, pose, material, line) {
    const { geometry, scale } = this.shapes.solid(shape)
    const mesh = new Mesh(geometry, material)
    // What is at the goal is not there yet, and has no shadow.
    mesh.castShadow = mesh.receiveShadow = !material.transparent
    const objects = [mesh]
    if (line) objects.push(new LineSegments(this.shapes.once(`edges ${geometry.uuid}`, () => new EdgesGeometry(geometry, 35)), line))
    for (const object of objects) {
      object.position.fromArray(pose)
      object.quaternion.fromArray(pose, 3)
      object.scale.fromArray(scale)
    }
    return objects
  }

  flatPart(shape, pose, material, line) {
    const { fill, edges } = this.shapes.once(`flat ${shape} ${pose}`, () => this.shapes.flat(shape, pose))
    return line ? [new Mesh(fill, material), new LineSegments(edges, line)] : [new Mesh(fill, material)]
  }

  addLayer(name, ...objects) {
    this.layers[name] ??= new Group()
    this.layers[name].add(...objects)
    this.group.add(this.layers[name])
  }

  addGoal() {
    const bodies = this.makeBodies(this.ghostMaterial(0.22), ORDER.goal)
    bodies.forEach((body, i) => {
      body.position.fromArray(this.data.goal, i * POSE)
      body.quaternion.fromArray(this.data.goal, i * POSE + 3)
    })
    this.addLayer('goals', ...bodies)
  }

  addPath() {
    const position = new Vector3()
    const turn = new Quaternion()
    const pointAt = (fraction) => {
      this.motion.poseAt(this.data.traced, fraction * this.plan.end, position, turn)
      return [position.x, position.y, position.z]
    }
    const positions = pointsAt(POINTS, pointAt)
    const line = (linewidth, opacity) => {
      const material = this.keep(new LineMaterial({ color: this.color, linewidth, opacity, ...this.flat, transparent: true }))
      const object = new Line2(new LineGeometry().setPositions(positions), material)
      object.renderOrder = ORDER.path
      return object
    }
    this.travelled = line(3.2, 1)
    this.addLayer('paths', line(1.6, 0.55), this.travelled, this.marks(pointAt))
  }

  /** Dots on the path, at equal times */
  marks(pointAt) {
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new Float32BufferAttribute(pointsAt(MARKS, pointAt), 3))
    disc ??= discTexture()
    const size = 8 * Math.min(devicePixelRatio, 2)
    const material = new PointsMaterial({ color: this.color, size, sizeAttenuation: false, map: disc, alphaTest: 0.5, ...this.flat })
    const dots = new Points(geometry, this.keep(material))
    dots.renderOrder = ORDER.path
    return dots
  }

  addTree() {
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new Float32BufferAttribute(this.data.tree, 3))
    const lines = new LineSegments(geometry, this.lineMaterial())
    lines.renderOrder = ORDER.tree
    this.addLayer('tree', lines)
  }

  /** Bodies at the marks; made when they are first looked at */
  addTrail() {
    const material = this.ghostMaterial(this.plan.spatial ? 0.2 : 0.16)
    for (let i = 0; i <= MARKS; ++i) {
      const bodies = this.makeBodies(material, ORDER.trail, !this.plan.spatial)
      this.placeAt(bodies, (i / MARKS) * this.plan.end)
      this.addLayer('trail', ...bodies)
    }
  }

  show(layer, on) {
    if (layer === 'trail' && on && !this.layers.trail && this.moves) this.addTrail()
    if (this.layers[layer]) this.layers[layer].visible = on
  }

  placeAt(bodies, time) {
    bodies.forEach((body, i) => this.motion.poseAt(i, time, body.position, body.quaternion))
  }

  setTime(time) {
    this.placeAt(this.bodies, time)
    if (this.travelled) {
      const parts = Math.round((POINTS * time) / this.plan.end)
      this.travelled.geometry.instanceCount = parts
      this.travelled.visible = parts > 0
    }
  }

  setColor(color) {
    this.color.set(color)
    for (const material of this.materials) material.color.copy(this.color)
  }
}

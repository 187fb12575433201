// The floor with its grid, the frame of the workspace, and the numbers along its axes.
import {
  BufferGeometry,
  EdgesGeometry,
  BoxGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  Vector3,
} from 'three'
import { FLAT, look, ORDER } from './look.js'

/** A step of 1, 2 or 5 times a power of ten that divides `extent` into some five parts */
function niceStep(extent) {
  const power = 10 ** Math.floor(Math.log10(extent / 5))
  return power * [1, 2, 5, 10].find((factor) => extent / (factor * power) <= 7)
}

/** The multiples of `step` from `low` to `high` */
function ticks(low, high, step) {
  const values = []
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) values.push(i * step)
  return values
}

/** A multiple of `step`, with the digits that it needs */
function numeral(value, step) {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9))
  return value.toFixed(digits).replace(/^-0(?:\.0*)?$/, '0')
}

export class Stage {
  constructor(plan) {
    this.group = new Group()
    this.labels = []
    const { low, high } = plan
    const { origin } = plan.bounds
    const size = high.map((value, axis) => value - low[axis])
    const step = niceStep(plan.extent)
    const values = plan.bounds.low.map((value, axis) => ticks(value, plan.bounds.high[axis], step))
    const text = (value) => numeral(value, step)
    const flat = plan.spatial ? {} : FLAT
    const bottom = low[2] - (plan.spatial ? 0.002 * plan.extent : 0)

    const material = plan.spatial
      ? new MeshStandardMaterial({ color: look.floor, roughness: 1, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 2 })
      : new MeshBasicMaterial({ color: look.floor, ...FLAT })
    const floor = new Mesh(new PlaneGeometry(size[0], size[1]), material)
    floor.position.z = bottom
    floor.receiveShadow = true
    floor.renderOrder = ORDER.floor
    this.group.add(floor)

    const lines = []
    const at = (axis, value) => value - origin[axis]
    for (const x of values[0])
      lines.push(at(0, x), low[1], bottom, at(0, x), high[1], bottom)
    for (const y of values[1])
      lines.push(low[0], at(1, y), bottom, high[0], at(1, y), bottom)
    this.addLines(lines, look.grid, flat)

    const box = new EdgesGeometry(new BoxGeometry(size[0], size[1], plan.spatial ? size[2] : 0))
    const frame = new LineSegments(box, new LineBasicMaterial({ color: look.frame, ...flat }))
    frame.renderOrder = ORDER.grid
    this.group.add(frame)

    // In the plane numbers are some pixels beside the frame, in space some part of it, since they turn with it.
    const away = plan.spatial ? 0.025 * plan.extent : 0
    const pixels = (x, y) => (plan.spatial ? [0, 0] : [x, y])
    this.addLabel('x', [0, low[1] - 3 * away, bottom], pixels(0, 30))
    this.addLabel('y', [low[0] - 3 * away, 0, bottom], pixels(-42, 0))
    for (const x of values[0]) this.addLabel(text(x), [at(0, x), low[1] - away, bottom], pixels(0, 14))
    for (const y of values[1]) this.addLabel(text(y), [low[0] - away, at(1, y), bottom], pixels(-18, 0))
    if (!plan.spatial) return
    this.addLabel('z', [low[0] - 3 * away, high[1] + 2 * away, 0])
    for (const z of values[2]) this.addLabel(text(z), [low[0] - away, high[1] + away, at(2, z)])
  }

  addLines(numbers, color, options) {
    const geometry = new BufferGeometry()
    geometry.setAttribute('position', new Float32BufferAttribute(numbers, 3))
    const lines = new LineSegments(geometry, new LineBasicMaterial({ color, ...options }))
    lines.renderOrder = ORDER.grid
    this.group.add(lines)
  }

  /** @param shift from there, in pixels */
  addLabel(text, position, shift = [0, 0]) {
    this.labels.push({ text, axis: /^[xyz]$/.test(text), position: new Vector3(...position), shift })
  }
}

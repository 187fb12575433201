// The canvas: renderer, light, camera and its controls. Scenes of the plane are seen from above, and do not turn.
import {
  Color,
  DirectionalLight,
  HemisphereLight,
  MOUSE,
  OrthographicCamera,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  TOUCH,
  Vector3,
  WebGLRenderer,
} from 'three'
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js'
import { look } from './look.js'
import { make } from './panel.js'

/** Where a scene of space is seen from at first, from its middle */
const DIRECTION = new Vector3(-0.45, -1, 0.62).normalize()

/** The room around a scene of the plane, in pixels: for the title, and for the numbers along the axes */
const ROOM = { left: 60, right: 24, top: 78, bottom: 46 }

/** Numbers nearer to each other than that are not both shown: across and down, in pixels. */
const APART = [24, 12]

/** Without WebGL there is nothing to see, and that is said. */
function makeRenderer(element) {
  try {
    return new WebGLRenderer({ antialias: true })
  } catch (error) {
    element.append(make('p', { class: 'trouble' }, 'This page needs WebGL, which this browser does not have, or has switched off.'))
    throw error
  }
}

export class View {
  constructor(plan, element) {
    this.plan = plan
    this.element = element
    this.renderer = makeRenderer(element)
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2))
    element.append(this.renderer.domElement)
    this.scene = new Scene()
    this.scene.background = new Color(look.background)
    this.corners = []
    for (const x of [plan.low[0], plan.high[0]])
      for (const y of [plan.low[1], plan.high[1]])
        for (const z of [plan.low[2], plan.high[2]]) this.corners.push(new Vector3(x, y, z))
    this.radius = this.corners[0].length()
    this.camera = plan.spatial
      ? new PerspectiveCamera(35, 1, 0.01 * this.radius, 40 * this.radius)
      : new OrthographicCamera(-1, 1, 1, -1, 0.1, 10 * this.radius)
    if (plan.spatial) this.camera.up.set(0, 0, 1)
    this.addControls()
    if (plan.spatial) this.addLights()
    this.labels = []
    new ResizeObserver(() => this.resize()).observe(element)
    this.resize()
    this.reset()
  }

  addControls() {
    const controls = new OrbitControls(this.camera, this.renderer.domElement)
    controls.zoomToCursor = true
    if (this.plan.spatial) {
      controls.minDistance = 0.05 * this.radius
      controls.maxDistance = 12 * this.radius
    } else {
      controls.enableRotate = false
      controls.mouseButtons = { LEFT: MOUSE.PAN, MIDDLE: MOUSE.DOLLY, RIGHT: MOUSE.PAN }
      controls.touches = { ONE: TOUCH.PAN, TWO: TOUCH.DOLLY_PAN }
      controls.minZoom = 0.3
      controls.maxZoom = 60
    }
    controls.addEventListener('change', () => this.draw())
    controls.addEventListener('start', () => (this.touched = true))
    this.controls = controls
  }

  addLights() {
    this.renderer.shadowMap.enabled = true
    this.renderer.shadowMap.type = PCFShadowMap
    this.scene.add(new HemisphereLight('#ffffff', '#b9b4aa', 2.1))
    const sun = new DirectionalLight('#ffffff', 1.9)
    sun.position.set(-0.5, -0.45, 1).multiplyScalar(2 * this.radius)
    sun.castShadow = true
    sun.shadow.mapSize.set(2048, 2048)
    Object.assign(sun.shadow.camera, {
      left: -this.radius,
      right: this.radius,
      top: this.radius,
      bottom: -this.radius,
      near: 0.1 * this.radius,
      far: 5 * this.radius,
    })
    sun.shadow.normalBias = 0.004 * this.radius
    sun.shadow.intensity = 0.6
    this.scene.add(sun)
  }

  /** Text at places of the workspace */
  addLabels(labels) {
    for (const { text, position, axis, shift } of labels) {
      const element = document.createElement('span')
      element.className = axis ? 'tick axis' : 'tick'
      element.textContent = text
      this.element.append(element)
      this.labels.push({ element, position, shift })
    }
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element
    if (width === 0 || height === 0) return
    this.width = width
    this.height = height
    this.renderer.setSize(width, height)
    const aspect = width / height
    if (this.plan.spatial) this.camera.aspect = aspect
    else {
      const size = (axis) => this.plan.high[axis] - this.plan.low[axis]
      const free = [width - ROOM.left - ROOM.right, height - ROOM.top - ROOM.bottom].map((pixels) => Math.max(pixels, 1))
      this.pixel = Math.max(size(0) / free[0], size(1) / free[1])
      const [right, top] = [0.5 * width * this.pixel, 0.5 * height * this.pixel]
      Object.assign(this.camera, { left: -right, right, top, bottom: -top })
    }
    this.camera.updateProjectionMatrix()
    if (!this.touched) this.reset()
    this.draw()
  }

  /** See all of the workspace, as at first. */
  reset() {
    const { target } = this.controls
    target.set(0, 0, 0)
    if (this.plan.spatial) this.fit()
    else {
      target.set(0.5 * (ROOM.right - ROOM.left) * this.pixel, 0.5 * (ROOM.top - ROOM.bottom) * this.pixel, 0)
      this.camera.position.set(target.x, target.y, 5 * this.radius)
      this.camera.zoom = 1
      this.camera.updateProjectionMatrix()
    }
    this.controls.update()
    this.draw()
  }

  /** Bring the workspace to the middle of the canvas, and as near as it fits. */
  fit() {
    const { camera, corners } = this
    const { target } = this.controls
    let distance = 6 * this.radius
    for (let i = 0; i < 8; ++i) {
      camera.position.copy(DIRECTION).multiplyScalar(distance).add(target)
      camera.lookAt(target)
      camera.updateMatrixWorld()
      const seen = corners.map((corner) => corner.clone().project(camera))
      const [x, y] = ['x', 'y'].map((axis) => seen.map((point) => point[axis]))
      const half = (values) => (Math.max(...values) - Math.min(...values)) / 2
      const middle = (values) => (Math.max(...values) + Math.min(...values)) / 2
      const unit = distance * Math.tan((camera.fov * Math.PI) / 360)
      const [right, up] = [0, 1].map((column) => new Vector3().setFromMatrixColumn(camera.matrixWorld, column))
      target.addScaledVector(right, middle(x) * unit * camera.aspect).addScaledVector(up, middle(y) * unit)
      // Some room for the numbers along the axes
      distance *= Math.max(half(x), half(y)) / 0.86
    }
    camera.position.copy(DIRECTION).multiplyScalar(distance).add(target)
  }

  /** Draw soon: once, however often this is called until then. */
  draw() {
    this.pending ??= requestAnimationFrame(() => {
      this.pending = undefined
      this.renderer.render(this.scene, this.camera)
      this.placeLabels()
    })
  }

  placeLabels() {
    const seen = new Vector3()
    const placed = []
    for (const { element, position, shift } of this.labels) {
      seen.copy(position).project(this.camera)
      const x = (0.5 + 0.5 * seen.x) * this.width + shift[0]
      const y = (0.5 - 0.5 * seen.y) * this.height + shift[1]
      const isOver = ([otherX, otherY]) => Math.abs(x - otherX) < APART[0] && Math.abs(y - otherY) < APART[1]
      element.hidden = seen.z > 1 || x < 0 || y < 0 || x > this.width || y > this.height || placed.some(isOver)
      if (element.hidden) continue
      placed.push([x, y])
      element.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px) translate(-50%, -50%)`
    }
  }
}

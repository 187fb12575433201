// The page: reads its plan, and puts scene, playback and panel together.
import { Quaternion, Raycaster, Vector2, Vector3 } from 'three'
import { Certificates } from './certificates.js'
import { readPlan } from './data.js'
import { Obstacles } from './obstacles.js'
import { keys, layerList, robotList, statistics } from './panel.js'
import { Playback } from './playback.js'
import { Robot } from './robot.js'
import { Shapes } from './shapes.js'
import { Stage } from './stage.js'
import { View } from './view.js'

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4]
const byId = (id) => document.getElementById(id)

const plan = readPlan(byId('plan').textContent)
document.title = `${plan.name} · plan`
byId('title').textContent = plan.name
byId('subtitle').textContent = plan.report ? `${plan.report.planner} · ${plan.robots.length} ${plan.robots.length === 1 ? 'robot' : 'robots'}` : ''

const view = new View(plan, byId('canvas'))
const shapes = new Shapes(plan)
const stage = new Stage(plan)
const obstacles = new Obstacles(plan, shapes)
const robots = plan.robots.map((robot) => new Robot(plan, robot, shapes))
const certificates = new Certificates(plan)
view.scene.add(stage.group, obstacles.group, certificates.group, ...robots.map(({ group }) => group))
view.addLabels(stage.labels)

// Playback

const scrub = byId('scrub')
const playButton = byId('play')
const digits = Math.max(0, 2 - Math.floor(Math.log10(plan.end || 1)))
const playback = new Playback(plan.end, () => {
  for (const robot of robots) robot.setTime(playback.time)
  scrub.value = playback.frame
  scrub.style.setProperty('--done', playback.last > 0 ? playback.frame / playback.last : 0)
  byId('time').textContent = `${playback.time.toFixed(digits)} / ${plan.end.toFixed(digits)}`
  playButton.classList.toggle('playing', playback.playing)
  playButton.setAttribute('aria-label', playback.playing ? 'pause' : 'play')
  view.draw()
})
scrub.max = playback.last
scrub.disabled = playButton.disabled = playback.last === 0
scrub.oninput = () => {
  const frame = Number(scrub.value)
  playback.pause()
  playback.seek(frame)
}
playButton.onclick = () => playback.toggle()
for (const speed of SPEEDS) byId('speed').add(new Option(`${speed} ×`, speed, speed === 1, speed === 1))
byId('speed').onchange = ({ target }) => (playback.speed = Number(target.value))

// Layers

const ofRobots = (name) => (on) => robots.forEach((robot) => robot.show(name, on))
const layers = [
  { name: 'paths', label: 'paths, marked at equal times', key: 'p', on: true, there: plan.end > 0, show: ofRobots('paths') },
  { name: 'trail', label: 'bodies at the marks', key: 'm', on: false, there: plan.end > 0, show: ofRobots('trail') },
  { name: 'goals', label: 'goals', key: 'g', on: true, there: true, show: ofRobots('goals') },
  { name: 'zones', label: 'zones that robots keep out of', key: 'z', on: true, there: plan.robots.some(({ zones }) => zones.length > 0), show: ofRobots('zones') },
  { name: 'tree', label: 'tree', key: 't', on: false, there: plan.robots.some(({ tree }) => tree.length > 0), show: ofRobots('tree') },
  {
    name: 'certificates',
    label: 'certificates: free balls',
    key: 'c',
    on: false,
    there: certificates.number > 0,
    show: (on) => (certificates.group.visible = on),
    slider: { most: certificates.number, value: certificates.few, changed: showCertificates },
  },
  { name: 'seeThrough', label: 'obstacles see-through', key: 'o', on: false, there: plan.spatial, show: (on) => obstacles.setSeeThrough(on) },
].filter(({ there }) => there)

function setLayer(name, on) {
  const layer = layers.find((one) => one.name === name)
  if (!layer) return
  layer.on = on
  layerPanel.boxes[name].checked = on
  layer.show(on)
  view.draw()
}
function showCertificates(count) {
  certificates.setCount(count)
  setLayer('certificates', true)
}
const layerPanel = layerList(layers, setLayer)
certificates.setCount(certificates.few)

// Robots

function setRobot(index, { visible, color }) {
  const robot = robots[index]
  if (!robot) return
  if (visible !== undefined) robotPanel.boxes[index].checked = robot.group.visible = visible
  if (color !== undefined) robot.setColor(color)
  view.draw()
}
const robotPanel = robotList(robots, setRobot)
byId('panel').append(robotPanel.element, layerPanel.element, statistics(plan), keys(plan.spatial))
// On a phone the panel is below the canvas: statistics and keys wait until they are asked for.
if (matchMedia('(max-width: 700px)').matches) for (const part of document.querySelectorAll('#panel details')) part.open = part === layerPanel.element
for (const { name, on } of layers) setLayer(name, on)

// The name of the robot under the pointer

const tip = byId('tip')
const ray = new Raycaster()

/** What is seen at a place of the canvas: the name of a robot, and of its link if it is an arm */
function nameAt(x, y) {
  ray.setFromCamera(new Vector2((2 * x) / view.width - 1, 1 - (2 * y) / view.height), view.camera)
  let nearest = { distance: Infinity }
  for (const { group, bodies, data, name } of robots)
    if (group.visible)
      bodies.forEach((body, i) => {
        const parts = body.children.filter((part) => part.isMesh)
        const hit = ray.intersectObjects(parts, false)[0]
        if (hit && hit.distance < nearest.distance)
          nearest = { distance: hit.distance, name: data.links ? `${name}: ${data.links[i]}` : name }
      })
  return nearest.name
}
view.renderer.domElement.addEventListener('pointermove', ({ offsetX: x, offsetY: y, buttons }) => {
  const name = buttons === 0 && nameAt(x, y)
  tip.hidden = !name
  if (!name) return
  tip.textContent = name
  tip.style.transform = `translate(${x + 12}px, ${y - 28}px)`
})
view.renderer.domElement.addEventListener('pointerleave', () => (tip.hidden = true))

// Keys

/** Whether what has the focus does something with a key itself */
function hasOwnUse({ target, key }) {
  if (target === scrub) return false
  if (key === ' ') return ['BUTTON', 'SUMMARY', 'INPUT', 'SELECT'].includes(target.tagName)
  return key.length > 1 && ['INPUT', 'SELECT'].includes(target.tagName)
}
// What was clicked with a mouse does not keep the keys.
byId('panel').addEventListener('click', ({ detail }) => detail > 0 && document.activeElement.blur())
byId('speed').addEventListener('change', ({ target }) => target.blur())
addEventListener('keydown', (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || hasOwnUse(event)) return
  const step = event.shiftKey ? 30 : 3
  const layer = layers.find(({ key }) => key === event.key.toLowerCase())
  const robot = /^[1-9]$/.test(event.key) ? Number(event.key) - 1 : undefined
  const actions = {
    ' ': () => playback.toggle(),
    ArrowLeft: () => playback.seek(playback.frame - step),
    ArrowRight: () => playback.seek(playback.frame + step),
    Home: () => playback.seek(0),
    End: () => playback.seek(playback.last),
    r: () => view.reset(),
  }
  if (actions[event.key]) actions[event.key]()
  else if (layer) setLayer(layer.name, !layer.on)
  else if (robot !== undefined && robots[robot]) setRobot(robot, { visible: !robots[robot].group.visible })
  else return
  event.preventDefault()
})

// The state of the page, for tests and for the curious

const position = new Vector3()
const turn = new Quaternion()
const poseOf = ({ x, y, z }, quaternion) => [x + plan.bounds.origin[0], y + plan.bounds.origin[1], z + plan.bounds.origin[2], ...quaternion.toArray()]

window.viewer = {
  plan,
  robots: robots.map(({ name }) => name),
  frames: playback.last + 1,
  get frame() {
    return playback.frame
  },
  set frame(frame) {
    playback.seek(frame)
  },
  get time() {
    return playback.time
  },
  get playing() {
    return playback.playing
  },
  get speed() {
    return playback.speed
  },
  play: () => playback.play(),
  pause: () => playback.pause(),
  layers: () => Object.fromEntries(layers.map(({ name, on }) => [name, on])),
  setLayer,
  visible: () => robots.map(({ group }) => group.visible),
  setRobot,
  /** For each robot the poses of its bodies at a time of the path: x, y, z and a quaternion */
  posesAt: (time) =>
    robots.map(({ bodies, motion }) =>
      bodies.map((_, body) => {
        motion.poseAt(body, time, position, turn)
        return poseOf(position, turn)
      }),
    ),
  /** The same as it is drawn now */
  shownPoses: () => robots.map(({ bodies }) => bodies.map((body) => poseOf(body.position, body.quaternion))),
  camera: view.camera,
  target: view.controls.target,
  draw: () => view.draw(),
}
playback.seek(0)
document.body.classList.add('ready')
